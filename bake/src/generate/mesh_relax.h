// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Neighbourhoods of a closed mesh, and making its triangles rounder.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace lithe::bake {

/// Per vertex, the mean of the middles of its triangles weighted by their areas.
std::vector<glm::dvec3> neighbourhoodCenters(const std::vector<glm::dvec3>& positions,
                                             const std::vector<std::array<uint32_t, 3>>& triangles);

/// Flips edges whose opposite angles sum to more than 180 degrees (Delaunay's criterion), unless that would fold the
/// surface or join two vertices twice. Repeats a few times; returns the number of flips.
uint32_t flipEdges(const std::vector<glm::dvec3>& positions, std::vector<std::array<uint32_t, 3>>& triangles);

/// Per vertex, the smallest vertex that a path of edges leads to.
std::vector<uint32_t> connectedPieces(uint32_t vertex_count, const std::vector<std::array<uint32_t, 3>>& triangles);

/// The vertices next to each vertex: neighbours of v are list[first[v]] .. list[first[v + 1] - 1], ascending.
struct Neighbours {
  std::vector<uint32_t> first, list;
};
Neighbours neighboursOf(uint32_t vertex_count, const std::vector<std::array<uint32_t, 3>>& triangles);

}  // namespace lithe::bake
