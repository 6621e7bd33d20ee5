// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The welded, quantised mesh: exactly what the finest level of a .lithe file stores, and what the simplifier works on.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "lithe/bake/model.h"

namespace lithe::bake {

/// position = origin + step * grid, the same step on every axis.
struct Grid {
  glm::dvec3 origin{0.0};
  double step = 1.0;
  uint32_t bits = 14;  ///< grid coordinates are in [0, 2^bits)
};

/// Quantised influences: weights are integers > 0 that sum to exactly `weight_one` of the mesh.
/// Sorted by descending weight, ties by ascending joint. Unused entries are zero.
struct QuantizedSkin {
  uint8_t count = 0;
  std::array<uint16_t, 8> joint{};
  std::array<uint16_t, 8> weight{};

  bool operator==(const QuantizedSkin&) const = default;
};

/// uv = offset + scale * integer, per part and uv set; integers are in [0, 2^uv_bits).
struct UvGrid {
  glm::dvec2 offset{0.0};
  double scale = 1.0;
};

/// A welded mesh. A *vertex* is a position and a skin; a *wedge* is one GPU vertex: a vertex plus attributes, in one
/// part. Vertices that coincide in the input (position and weights) are one vertex, so no level can open a crack
/// between them.
struct Mesh {
  Grid grid;
  uint32_t weight_one = 255;  ///< what the weights of a vertex sum to: 2^weight_bits - 1
  uint32_t max_influences = 4;
  uint32_t normal_bits = 10;  ///< octahedral, per component; tangents too
  uint32_t uv_bits = 12;
  AttributeSet attributes;

  std::vector<glm::ivec3> positions;  ///< per vertex, grid coordinates
  std::vector<QuantizedSkin> skins;   ///< per vertex

  std::vector<uint32_t> wedge_vertex;     ///< per wedge
  std::vector<uint32_t> wedge_part;       ///< per wedge
  std::vector<glm::ivec2> wedge_normal;   ///< octahedral, 0 .. 2^normal_bits - 2 (see format/octahedral.h)
  std::vector<glm::ivec3> wedge_tangent;  ///< octahedral x, y and handedness 0 (negative) or 1
  std::array<std::vector<glm::ivec2>, kMaxUvSets> wedge_uv;
  std::array<std::vector<glm::ivec4>, kMaxColorSets> wedge_color;  ///< 8 bit

  std::vector<std::array<uint32_t, 3>> triangles;       ///< wedge indices; no triangle has two corners on one vertex
  std::vector<std::array<UvGrid, kMaxUvSets>> part_uv;  ///< per part

  std::vector<bool> rigid_vertex;  ///< vertex of a rigid part: never merged with a vertex of another joint

  uint32_t vertexCount() const { return static_cast<uint32_t>(positions.size()); }
  uint32_t wedgeCount() const { return static_cast<uint32_t>(wedge_vertex.size()); }
  uint32_t triangleCount() const { return static_cast<uint32_t>(triangles.size()); }
  uint32_t corner(uint32_t triangle, uint32_t k) const { return wedge_vertex[triangles[triangle][k]]; }
};

/// One edge collapse. Children and parent are node ids: nodes [0, V) are the mesh's vertices, collapse i makes node V +
/// i. The parent's position is placementPosition(children, t8, multiple of the lattice step), see format/placement.h;
/// its skin is any valid QuantizedSkin.
struct Collapse {
  uint32_t child[2] = {0, 0};
  glm::ivec3 position{0};  ///< grid coordinates of the parent
  QuantizedSkin skin;      ///< of the parent
  uint8_t t8 = 4;          ///< where attributes are taken between child[0] (0) and child[1] (8); directions: half way
  double cost = 0.0;       ///< the metric's value, in squared model units times area summed over poses
  uint32_t triangles = 0;  ///< triangles left afterwards, equal ones counted once
};

/// What a simplifier makes of a mesh: collapses, finest first.
struct CollapseSequence {
  std::vector<Collapse> collapses;
};

}  // namespace lithe::bake
