// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The shape of a level, nothing but nodes and triangles, and what says where on it a vertex of the original is likely
/// to be.
#pragma once

#include <span>
#include <vector>

#include "lithe/bake/mesh.h"
#include "lithe/bake/nearest.h"

namespace lithe::bake {

/// For each of some places the triangles at it.
class TrianglesAt {
 public:
  TrianglesAt() = default;
  /// @param place_of  per vertex: its place, below `places`
  TrianglesAt(std::span<const Triangle> triangles, std::span<const uint32_t> place_of, uint32_t places);

  std::span<const uint32_t> operator[](uint32_t place) const {
    return {entries_.data() + begin_[place], entries_.data() + begin_[place + 1]};
  }

 private:
  std::vector<uint32_t> begin_, entries_;
};

/// The nodes that a level's triangles use, and these triangles, equal ones once: the surface of cutToModel() with one
/// vertex for all wedges of a node.
struct LevelSurface {
  Model shape;                    ///< positions, skins and triangles only
  std::vector<uint32_t> node_of;  ///< per vertex of the mesh: the node it has become; kNone where that has no triangle
  std::vector<uint32_t> vertex_near;  ///< per node: the mesh's vertex whose place it has kept best
  TrianglesAt triangles_at;           ///< per node
};

LevelSurface levelSurface(const Mesh& mesh, const CollapseSequence& sequence, uint32_t collapses);

}  // namespace lithe::bake
