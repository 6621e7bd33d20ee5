// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "split_order.h"

#include <algorithm>
#include <array>
#include <glm/glm.hpp>
#include <queue>
#include <utility>

#include "asset_model.h"
#include "float_vertices.h"
#include "lithe/bake/poses.h"

namespace lithe::tool {
namespace {

constexpr uint32_t kSampledPoses = 4;

/// The sum of weight * (n . p + d)^2 over planes, as a function of p.
struct Quadric {
  glm::dmat3 quadratic{0.0};
  glm::dvec3 linear{0.0};
  double constant = 0.0;

  void addPlane(const glm::dvec3& normal, const glm::dvec3& through, double weight) {
    const double d = -glm::dot(normal, through);
    quadratic += weight * glm::outerProduct(normal, normal);
    linear += weight * d * normal;
    constant += weight * d * d;
  }
  void add(const Quadric& other) {
    quadratic += other.quadratic;
    linear += other.linear;
    constant += other.constant;
  }
  double at(const glm::dvec3& p) const { return glm::dot(p, quadratic * p) + 2 * glm::dot(linear, p) + constant; }
};

/// The finest faces in terms of nodes, and their open edges.
struct FineSurface {
  struct OpenEdge {
    uint32_t from, to, face;
  };
  std::vector<std::array<uint32_t, 3>> faces;
  std::vector<OpenEdge> open_edges;
};

std::vector<FineSurface::OpenEdge> openEdges(const std::vector<std::array<uint32_t, 3>>& faces) {
  std::vector<FineSurface::OpenEdge> edges;
  for (uint32_t face = 0; face < faces.size(); ++face) {
    for (uint32_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(faces[face][k], faces[face][(k + 1) % 3]);
      edges.push_back({low, high, face});
    }
  }
  const auto key = [](const FineSurface::OpenEdge& edge) { return std::pair(edge.from, edge.to); };
  std::sort(edges.begin(), edges.end(),
            [&](const auto& a, const auto& b) { return std::pair(key(a), a.face) < std::pair(key(b), b.face); });
  std::vector<FineSurface::OpenEdge> open;
  for (size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    while (end < edges.size() && key(edges[end]) == key(edges[begin])) ++end;
    if (end - begin == 1) open.push_back(edges[begin]);
  }
  return open;
}

FineSurface fineSurface(const lithe_hierarchy& hierarchy) {
  FineSurface surface;
  surface.faces.resize(hierarchy.face_count);
  for (uint32_t face = 0; face < hierarchy.face_count; ++face) {
    for (uint32_t k = 0; k < 3; ++k) surface.faces[face][k] = hierarchy.wedge_node[hierarchy.face_wedges[3 * face + k]];
  }
  surface.open_edges = openEdges(surface.faces);
  return surface;
}

/// Quadrics of the finest surface at its own nodes, in one pose.
std::vector<Quadric> leafQuadrics(const FineSurface& surface, const std::vector<glm::dvec3>& position) {
  std::vector<Quadric> quadrics(position.size());
  const auto normalOf = [&](uint32_t face) {
    const auto& [a, b, c] = surface.faces[face];
    return glm::cross(position[b] - position[a], position[c] - position[a]);
  };
  for (uint32_t face = 0; face < surface.faces.size(); ++face) {
    const glm::dvec3 normal = normalOf(face);
    const double length = glm::length(normal);
    if (!(length > 0)) continue;
    for (const uint32_t node : surface.faces[face]) {
      quadrics[node].addPlane(normal / length, position[surface.faces[face][0]], length / 6);
    }
  }
  for (const auto& edge : surface.open_edges) {
    const glm::dvec3 along = position[edge.to] - position[edge.from];
    const glm::dvec3 upright = glm::cross(along, normalOf(edge.face));
    const double length = glm::length(upright);
    if (!(length > 0)) continue;
    for (const uint32_t node : {edge.from, edge.to}) {
      quadrics[node].addPlane(upright / length, position[edge.from], glm::dot(along, along) / 2);
    }
  }
  return quadrics;
}

void addCosts(const lithe_hierarchy& hierarchy, const FineSurface& surface, const std::vector<glm::dvec3>& position,
              std::vector<double>& cost) {
  std::vector<Quadric> quadrics = leafQuadrics(surface, position);
  // Children have larger ids than their parents.
  for (uint32_t node = hierarchy.node_count; node-- > 0;) {
    cost[node] += quadrics[node].at(position[node]);
    const uint32_t parent = hierarchy.node_parent[node];
    if (parent != LITHE_NO_INDEX) quadrics[parent].add(quadrics[node]);
  }
}

/// A node's position is that of any of its wedges.
std::vector<glm::dvec3> nodePositions(const lithe_hierarchy& hierarchy, const std::vector<glm::dvec3>& wedges) {
  std::vector<glm::dvec3> nodes(hierarchy.node_count);
  for (uint32_t wedge = 0; wedge < hierarchy.wedge_count; ++wedge) nodes[hierarchy.wedge_node[wedge]] = wedges[wedge];
  return nodes;
}

}  // namespace

std::vector<double> standInCosts(const Asset& asset) {
  lithe_hierarchy hierarchy;
  lithe_asset_hierarchy(asset.get(), &hierarchy);
  const FineSurface surface = fineSurface(hierarchy);
  const bake::Model vertices = modelOfAllVertices(asset);
  std::vector<bake::Pose> poses = bake::sampledPoses(vertices, kSampledPoses);
  poses.push_back(bake::restPose(vertices));
  std::vector<double> cost(hierarchy.node_count, 0.0);
  for (const bake::Pose& pose : poses) {
    addCosts(hierarchy, surface, nodePositions(hierarchy, bake::skinPositions(vertices, pose)), cost);
  }
  return cost;
}

SplitOrder orderSplits(const Asset& asset) {
  lithe_hierarchy hierarchy;
  lithe_asset_hierarchy(asset.get(), &hierarchy);
  const std::vector<double> cost = standInCosts(asset);
  SplitOrder order;
  order.rank.assign(hierarchy.node_count, LITHE_NO_INDEX);
  const auto later = [&](uint32_t a, uint32_t b) { return cost[a] != cost[b] ? cost[a] < cost[b] : a > b; };
  uint32_t before = 0;  // nodes that exist before the level's splits
  for (uint32_t level = 0; level < asset.info().level_count; ++level) {
    lithe_level_extent extent;
    require(lithe_asset_level_extent(asset.get(), level, &extent));
    const auto splitsNow = [&](uint32_t node) {
      const uint32_t child = hierarchy.node_first_child[node];
      return child >= before && child < extent.node_count;
    };
    std::priority_queue<uint32_t, std::vector<uint32_t>, decltype(later)> ready(later);
    for (uint32_t node = 0; node < before; ++node) {
      if (splitsNow(node)) ready.push(node);
    }
    while (!ready.empty()) {
      const uint32_t node = ready.top();
      ready.pop();
      order.rank[node] = order.count++;
      for (const uint32_t child : {hierarchy.node_first_child[node], hierarchy.node_first_child[node] + 1}) {
        if (splitsNow(child)) ready.push(child);
      }
    }
    before = extent.node_count;
  }
  return order;
}

}  // namespace lithe::tool
