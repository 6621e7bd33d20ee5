// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// From a smooth solid to a closed triangle mesh of even, well-shaped triangles.
///
/// 1. A lattice, denser around chosen places, is sampled where the surface passes.
/// 2. Every cell gets one vertex per sheet of the surface in it, every lattice edge that crosses the surface one quad
///    (dual marching cubes: G. Nielson, "Dual Marching Cubes", IEEE Visualization 2004).
/// 3. Vertices are moved along the surface to the middle of their neighbours and back onto it; edges are flipped where
/// that
///    makes the smallest angle larger.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "implicit.h"

namespace lithe::bake {

/// A closed triangle mesh, counter-clockwise seen from outside, with the solid's gradient as normals.
struct ClosedMesh {
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;
  std::vector<uint16_t> labels;  ///< Solid::labelAt the vertex
  std::vector<std::array<uint32_t, 3>> triangles;
};

/// Space around `center` is sampled `magnification` (>= 1) times as densely within `radius`.
struct DenseSpot {
  glm::dvec3 center{0.0};
  double radius = 0.0;
  double magnification = 1.0;
};

struct PolygoniseOptions {
  double cell = 0.01;            ///< edge of a lattice cell, away from dense spots
  std::vector<DenseSpot> spots;  ///< far apart from each other, compared to their radii
  uint32_t relaxations = 10;
};

ClosedMesh polygonise(const implicit::Solid& solid, const PolygoniseOptions& options);

}  // namespace lithe::bake
