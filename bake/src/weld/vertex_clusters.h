// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Which source vertices are one vertex: near in position and in skin, bound to the same rigid node.
#pragma once

#include <cstdint>
#include <vector>

#include "lithe/bake/model.h"

namespace lithe::bake {

inline constexpr double kWeldDistance = 1e-6;          // of the bounding box's diagonal
inline constexpr double kWeldWeightDifference = 0.02;  // L1

struct VertexClusters {
  std::vector<uint32_t> cluster;     // per source vertex; kNone where no triangle uses it
  std::vector<uint32_t> first;       // per cluster: the source vertex that gives position and skin
  std::vector<uint32_t> rigid_node;  // per cluster; kNone for skinned
};

// Clusters are numbered by their first vertex, which is the lowest.
VertexClusters clusterVertices(const Model& model);

}  // namespace lithe::bake
