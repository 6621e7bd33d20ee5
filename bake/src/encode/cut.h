// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The cut that a reader has at some point of the file: nodes, wedges and faces in the file's numbering, each with the
/// hierarchy's node, wedge or triangle it stands for.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lithe/bake/hierarchy.h"
#include "lithe/format/page.h"

namespace lithe::bake {

struct Cut {
  explicit Cut(const Hierarchy& hierarchy);

  /// Adds a node and its wedges (hierarchy ids, in the file's order) to the file's numbering.
  uint32_t addNode(uint32_t hierarchy_node, const std::vector<uint32_t>& wedges);

  /// Adds a face: corner k is the hierarchy triangle's corner (k + rotation) % 3.
  void addFace(uint32_t triangle, uint32_t rotation, std::array<uint32_t, 3> wedges);

  /// The deepest node of the file so far above a vertex.
  uint32_t nodeAbove(uint32_t vertex) const;

  /// The wedge of file node `node` that a leaf wedge below it belongs to.
  uint32_t wedgeAt(uint32_t node, uint32_t leaf_wedge) const;

  /// The corners at a node, ascending, with the nodes of their faces' next and previous corners. Valid until the next
  /// call.
  const format::Fan& fanOf(uint32_t node);

  uint32_t leafWedge(uint32_t corner) const {
    const uint32_t face = corner / 3;
    return h.face_wedges[face_triangle[face]][(corner % 3 + face_rotation[face]) % 3];
  }
  uint32_t leafVertex(uint32_t corner) const { return h.wedge_node[leafWedge(corner)]; }
  uint32_t cornerNode(uint32_t corner) const { return wedge_node[face_wedges[corner / 3][corner % 3]]; }

  // Of the hierarchy's nodes and wedges, and of the file's.
  format::Int3 positionOf(uint32_t hierarchy_node) const {
    const glm::ivec3& p = h.position[hierarchy_node];
    return {p.x, p.y, p.z};
  }
  format::Int3 filePosition(uint32_t node) const { return positionOf(node_hierarchy[node]); }
  const int32_t* attributes(uint32_t hierarchy_wedge) const {
    return h.wedge_attributes.data() + size_t{hierarchy_wedge} * h.record.stride;
  }
  /// Two entries of a wedge's record.
  format::Int2 pairAt(uint32_t hierarchy_wedge, uint32_t at) const {
    return {attributes(hierarchy_wedge)[at], attributes(hierarchy_wedge)[at + 1]};
  }

  /// Moves a corner to a child's wedge.
  void moveCorner(uint32_t corner, uint32_t wedge);
  void clearCorners(uint32_t node) { node_corners[node].clear(); }

  const Hierarchy& h;
  std::vector<uint32_t> node_hierarchy;    ///< per file node
  std::vector<uint32_t> node_first_wedge;  ///< node count + 1
  std::vector<char> node_split;
  std::vector<std::vector<uint32_t>> node_corners;    ///< unordered
  std::vector<uint32_t> file_node;                    ///< per hierarchy node; kNone while it is not in the file
  std::vector<uint32_t> wedge_node, wedge_hierarchy;  ///< per file wedge
  std::vector<uint32_t> file_wedge;                   ///< per hierarchy wedge; kNone while it is not in the file
  std::vector<std::array<uint32_t, 3>> face_wedges;   ///< file wedges
  std::vector<uint32_t> face_triangle;
  std::vector<uint8_t> face_rotation;

 private:
  std::vector<uint32_t> fan_corner_, fan_next_, fan_previous_;
  format::Fan fan_{};
};

/// Faces of the cut that are equal to one with a lower id (same nodes, same orientation), ascending.
std::vector<uint32_t> hiddenFaces(const Cut& cut);

}  // namespace lithe::bake
