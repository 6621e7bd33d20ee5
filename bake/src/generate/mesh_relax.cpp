// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "mesh_relax.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace lithe::bake {
namespace {

using glm::dvec3;
using Triangle = std::array<uint32_t, 3>;

dvec3 crossOf(const std::vector<dvec3>& p, uint32_t a, uint32_t b, uint32_t c) {
  return glm::cross(p[b] - p[a], p[c] - p[a]);
}

/// cot of the angle at `apex` over the edge a - b.
double cotangent(const std::vector<dvec3>& p, uint32_t apex, uint32_t a, uint32_t b) {
  const dvec3 u = p[a] - p[apex], v = p[b] - p[apex], w = glm::cross(u, v);
  return glm::dot(u, v) / std::sqrt(std::max(1e-40, glm::dot(w, w)));
}

/// An inner edge a -> b of triangle `left` (a, b, c), which is b -> a of triangle `right` (b, a, d).
struct InnerEdge {
  uint32_t a, b, c, d, left, right;
};

std::vector<InnerEdge> innerEdges(const std::vector<Triangle>& triangles) {
  struct Side {
    uint32_t low, high, triangle, apex;
    bool forward;
  };
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (uint32_t t = 0; t < triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const uint32_t a = triangles[t][k], b = triangles[t][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), t, triangles[t][(k + 2) % 3], a < b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
    return std::tie(x.low, x.high, x.triangle) < std::tie(y.low, y.high, y.triangle);
  });
  std::vector<InnerEdge> edges;
  for (size_t i = 0; i + 1 < sides.size(); ++i) {
    const Side &x = sides[i], &y = sides[i + 1];
    if (x.low != y.low || x.high != y.high || x.forward == y.forward) continue;
    const Side &left = x.forward ? x : y, &right = x.forward ? y : x;
    edges.push_back({x.low, x.high, left.apex, right.apex, left.triangle, right.triangle});
  }
  return edges;
}

bool improves(const std::vector<dvec3>& p, const InnerEdge& e) {
  constexpr double kMargin = 1e-6;
  if (cotangent(p, e.c, e.a, e.b) + cotangent(p, e.d, e.a, e.b) > -kMargin) return false;
  // the two new triangles must face the way the two old ones do, near enough
  const dvec3 old_normal = crossOf(p, e.a, e.b, e.c) + crossOf(p, e.b, e.a, e.d);
  const auto faces = [&](const dvec3& n) {
    return glm::dot(n, old_normal) > 0.7 * std::sqrt(glm::dot(n, n) * glm::dot(old_normal, old_normal));
  };
  return faces(crossOf(p, e.c, e.d, e.b)) && faces(crossOf(p, e.d, e.c, e.a));
}

uint32_t flipPass(const std::vector<dvec3>& positions, std::vector<Triangle>& triangles) {
  const Neighbours neighbours = neighboursOf(static_cast<uint32_t>(positions.size()), triangles);
  const auto adjacent = [&](uint32_t a, uint32_t b) {
    return std::binary_search(neighbours.list.begin() + neighbours.first[a],
                              neighbours.list.begin() + neighbours.first[a + 1], b);
  };
  std::vector<bool> touched(positions.size(), false);  // by a flip of this pass: its neighbours are out of date
  uint32_t flips = 0;
  for (const InnerEdge& e : innerEdges(triangles)) {
    if (touched[e.a] || touched[e.b] || touched[e.c] || touched[e.d]) continue;
    if (e.c == e.d || adjacent(e.c, e.d) || !improves(positions, e)) continue;
    triangles[e.left] = {e.c, e.d, e.b};
    triangles[e.right] = {e.d, e.c, e.a};
    touched[e.a] = touched[e.b] = touched[e.c] = touched[e.d] = true;
    ++flips;
  }
  return flips;
}

}  // namespace

std::vector<dvec3> neighbourhoodCenters(const std::vector<dvec3>& positions, const std::vector<Triangle>& triangles) {
  std::vector<dvec3> sum(positions.size(), dvec3(0.0));
  std::vector<double> weight(positions.size(), 0.0);
  for (const auto& [a, b, c] : triangles) {
    const dvec3 n = crossOf(positions, a, b, c);
    const double area = std::sqrt(glm::dot(n, n));
    const dvec3 middle = (positions[a] + positions[b] + positions[c]) / 3.0;
    for (uint32_t vertex : {a, b, c}) {
      sum[vertex] += area * middle;
      weight[vertex] += area;
    }
  }
  for (size_t v = 0; v < sum.size(); ++v) sum[v] = weight[v] > 0.0 ? sum[v] / weight[v] : positions[v];
  return sum;
}

uint32_t flipEdges(const std::vector<dvec3>& positions, std::vector<Triangle>& triangles) {
  uint32_t flips = 0;
  for (int pass = 0; pass < 4; ++pass) {
    const uint32_t made = flipPass(positions, triangles);
    flips += made;
    if (made == 0) break;
  }
  return flips;
}

std::vector<uint32_t> connectedPieces(uint32_t vertex_count, const std::vector<Triangle>& triangles) {
  std::vector<uint32_t> parent(vertex_count);
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const auto& [a, b, c] : triangles) {
    for (uint32_t other : {b, c}) {
      const uint32_t x = root(a), y = root(other);
      parent[std::max(x, y)] = std::min(x, y);
    }
  }
  for (uint32_t v = 0; v < vertex_count; ++v) parent[v] = root(v);
  return parent;
}

Neighbours neighboursOf(uint32_t vertex_count, const std::vector<Triangle>& triangles) {
  std::vector<std::array<uint32_t, 2>> pairs;
  pairs.reserve(6 * triangles.size());
  for (const Triangle& t : triangles) {
    for (int k = 0; k < 3; ++k) {
      pairs.push_back({t[k], t[(k + 1) % 3]});
      pairs.push_back({t[(k + 1) % 3], t[k]});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  Neighbours neighbours;
  neighbours.first.assign(vertex_count + 1, 0);
  for (const auto& [from, to] : pairs) {
    ++neighbours.first[from + 1];
    neighbours.list.push_back(to);
  }
  for (uint32_t v = 0; v < vertex_count; ++v) neighbours.first[v + 1] += neighbours.first[v];
  return neighbours;
}

}  // namespace lithe::bake
