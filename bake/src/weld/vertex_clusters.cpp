// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "vertex_clusters.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace lithe::bake {

namespace {

struct Box {
  glm::dvec3 lower{0.0}, upper{0.0};
};

Box boundingBox(const std::vector<glm::vec3>& positions) {
  if (positions.empty()) return {};
  Box box{positions[0], positions[0]};
  for (const glm::vec3& position : positions) {
    box.lower = glm::min(box.lower, glm::dvec3(position));
    box.upper = glm::max(box.upper, glm::dvec3(position));
  }
  return box;
}

/// A hash of cells four tolerances wide, so that a vertex's neighbourhood is one cell, rarely up to eight.
class CellMap {
 public:
  CellMap(const Box& box, double tolerance)
      : lower_(box.lower), tolerance_(tolerance), cell_(tolerance > 0.0 ? 4.0 * tolerance : 1.0) {}

  void insert(const glm::dvec3& position, uint32_t cluster) {
    const auto [entry, inserted] = head_.try_emplace(key(cellOf(position)), cluster);
    next_.push_back(inserted ? kNone : entry->second);
    entry->second = cluster;
  }

  template <class Visit>
  void visitNear(const glm::dvec3& position, const Visit& visit) const {
    const glm::i64vec3 low = cellOf(position - tolerance_), high = cellOf(position + tolerance_);
    for (int64_t z = low.z; z <= high.z; ++z) {
      for (int64_t y = low.y; y <= high.y; ++y) {
        for (int64_t x = low.x; x <= high.x; ++x) visitCell({x, y, z}, visit);
      }
    }
  }

 private:
  glm::i64vec3 cellOf(const glm::dvec3& position) const {
    return glm::i64vec3(glm::floor((position - lower_) / cell_));
  }

  // 20 bits would do for 1e-6 of the diagonal; cells one below the box wrap harmlessly, the distance decides.
  static uint64_t key(const glm::i64vec3& cell) {
    constexpr uint64_t kMask = (1u << 21) - 1;
    return (static_cast<uint64_t>(cell.x) & kMask) | (static_cast<uint64_t>(cell.y) & kMask) << 21 |
           (static_cast<uint64_t>(cell.z) & kMask) << 42;
  }

  template <class Visit>
  void visitCell(const glm::i64vec3& cell, const Visit& visit) const {
    const auto entry = head_.find(key(cell));
    if (entry == head_.end()) return;
    for (uint32_t cluster = entry->second; cluster != kNone; cluster = next_[cluster]) visit(cluster);
  }

  glm::dvec3 lower_;
  double tolerance_, cell_;
  std::unordered_map<uint64_t, uint32_t> head_;  // cell -> its newest cluster
  std::vector<uint32_t> next_;                   // per cluster, within its cell
};

double weightOf(const Skin& skin, uint16_t joint) {
  for (uint32_t k = 0; k < skin.count; ++k) {
    if (skin.joint[k] == joint) return skin.weight[k];
  }
  return 0.0;
}

double weightDifference(const Skin& a, const Skin& b) {
  double difference = 0.0;
  for (uint32_t k = 0; k < a.count; ++k) difference += std::abs(a.weight[k] - weightOf(b, a.joint[k]));
  for (uint32_t k = 0; k < b.count; ++k) {
    if (weightOf(a, b.joint[k]) == 0.0) difference += b.weight[k];
  }
  return difference;
}

/// Per source vertex the rigid node of the parts that use it; `used` says whether any does.
std::vector<uint32_t> rigidNodes(const Model& model, std::vector<bool>& used) {
  std::vector<uint32_t> node(model.positions.size(), kNone);
  used.assign(model.positions.size(), false);
  for (size_t t = 0; t < model.triangles.size(); ++t) {
    for (uint32_t vertex : model.triangles[t]) {
      if (!used[vertex]) node[vertex] = model.parts[model.triangle_part[t]].rigid_node;
      used[vertex] = true;
    }
  }
  return node;
}

}  // namespace

VertexClusters clusterVertices(const Model& model) {
  std::vector<bool> used;
  const std::vector<uint32_t> rigid_node = rigidNodes(model, used);
  const Box box = boundingBox(model.positions);
  const double tolerance = kWeldDistance * glm::length(box.upper - box.lower);
  CellMap cells(box, tolerance);

  VertexClusters clusters;
  clusters.cluster.assign(model.positions.size(), kNone);
  for (uint32_t v = 0; v < model.positions.size(); ++v) {
    if (!used[v]) continue;
    const glm::dvec3 position = model.positions[v];
    uint32_t match = kNone;
    cells.visitNear(position, [&](uint32_t cluster) {
      const uint32_t first = clusters.first[cluster];
      if (cluster < match && clusters.rigid_node[cluster] == rigid_node[v] &&
          glm::distance(position, glm::dvec3(model.positions[first])) <= tolerance &&
          weightDifference(model.skins[v], model.skins[first]) < kWeldWeightDifference) {
        match = cluster;
      }
    });
    if (match == kNone) {
      match = static_cast<uint32_t>(clusters.first.size());
      clusters.first.push_back(v);
      clusters.rigid_node.push_back(rigid_node[v]);
      cells.insert(position, match);
    }
    clusters.cluster[v] = match;
  }
  return clusters;
}

}  // namespace lithe::bake
