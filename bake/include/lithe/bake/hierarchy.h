// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The binary forest of nodes that a collapse sequence makes of a mesh, with the wedges and faces of every node.
///
/// Ids here are in collapse order (vertices first, then one node per collapse); the file numbers nodes anew, coarse to
/// fine, when it is encoded. Everything in this header depends on the forest alone, not on the order of its collapses.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lithe/bake/mesh.h"

namespace lithe::bake {

/// Where a wedge's attributes lie in its record of 16-bit values (stored as int32 here); kNone when absent.
struct WedgeRecord {
  uint32_t stride = 0;
  uint32_t normal = kNone;
  uint32_t tangent = kNone;
  std::array<uint32_t, kMaxUvSets> uv;
  std::array<uint32_t, kMaxColorSets> color;
};

WedgeRecord wedgeRecord(const AttributeSet& attributes);

struct Hierarchy {
  uint32_t vertex_count = 0;  ///< nodes [0, vertex_count) are the mesh's vertices: the leaves

  // Per node.
  std::vector<uint32_t> parent;                   ///< kNone for roots
  std::vector<std::array<uint32_t, 2>> children;  ///< kNone for leaves
  std::vector<uint8_t> t8;                        ///< from child 0 (0) to child 1 (8)
  std::vector<glm::ivec3> position;
  std::vector<QuantizedSkin> skin;
  std::vector<std::array<uint32_t, 2>> leaves;  ///< [begin, end) in the depth-first order of the leaves
  std::vector<uint32_t> first_wedge;            ///< node_count + 1 entries: a node's wedges are consecutive

  // Per wedge. Children wedges of a node's wedge belong to the node's two children.
  WedgeRecord record;
  std::vector<uint32_t> wedge_node;
  std::vector<uint32_t> wedge_parent;  ///< kNone at roots
  std::vector<uint32_t> wedge_part;
  std::vector<int32_t> wedge_attributes;  ///< record.stride per wedge

  // Per face (the mesh's triangles).
  std::vector<std::array<uint32_t, 3>> face_wedges;  ///< leaf wedges of the corners
  std::vector<uint32_t> birth_node;  ///< the node whose split brings the face; kNone: it is in every cut
  std::vector<uint32_t> born_begin;  ///< node_count + 1: faces of a node in `born`
  std::vector<uint32_t> born;        ///< ascending per node

  uint32_t nodeCount() const { return static_cast<uint32_t>(parent.size()); }
  bool isLeaf(uint32_t node) const { return children[node][0] == kNone; }
  /// Whether a vertex lies below (or is) a node.
  bool contains(uint32_t node, uint32_t vertex) const {
    return leaves[node][0] <= leaves[vertex][0] && leaves[vertex][1] <= leaves[node][1];
  }
};

/// Builds the forest. Throws Error when a collapse names a node that is gone or a position the placement rule cannot
/// give.
Hierarchy buildHierarchy(const Mesh& mesh, const CollapseSequence& sequence, uint32_t placement_shift);

}  // namespace lithe::bake
