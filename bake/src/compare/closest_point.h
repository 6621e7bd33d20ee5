// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The point of one triangle nearest to a query.
#pragma once

#include <algorithm>
#include <glm/glm.hpp>

namespace lithe::bake {

struct ClosestPoint {
  double distance2 = 0.0;
  glm::dvec3 barycentric{0};
};

namespace closest_detail {

/// Nearest point of the edge between corners `from` and `to` (0..2); `a` and `b` are relative to the query.
inline ClosestPoint onEdge(const glm::dvec3& a, const glm::dvec3& b, int from, int to) {
  const glm::dvec3 edge = b - a;
  const double length2 = glm::dot(edge, edge);
  const double t = length2 > 0.0 ? std::clamp(-glm::dot(a, edge) / length2, 0.0, 1.0) : 0.0;
  ClosestPoint result;
  result.barycentric[from] = 1.0 - t;
  result.barycentric[to] = t;
  const glm::dvec3 offset = a * (1.0 - t) + b * t;
  result.distance2 = glm::dot(offset, offset);
  return result;
}

}  // namespace closest_detail

/// Exact to rounding. Where the query projects outside the triangle, the nearest point lies on an edge that faces the
/// query, so only the edges with a negative barycentric coordinate are looked at; slivers, whose plane is unreliable,
/// look at all three.
inline ClosestPoint closestPoint(const glm::dvec3& query, const glm::dvec3& corner_a, const glm::dvec3& corner_b,
                                 const glm::dvec3& corner_c) {
  const glm::dvec3 a = corner_a - query, b = corner_b - query, c = corner_c - query;
  const glm::dvec3 ab = b - a, ac = c - a;
  const glm::dvec3 normal = glm::cross(ab, ac);
  const double area2 = glm::dot(normal, normal);
  const double extent2 = std::max(glm::dot(ab, ab), glm::dot(ac, ac));
  constexpr double kSliver2 = 1e-20;  // height below 1e-10 of the longest edge
  const bool sliver = !(area2 > kSliver2 * extent2 * extent2);
  const double weight_b = glm::dot(glm::cross(ac, a), normal);
  const double weight_c = glm::dot(glm::cross(a, ab), normal);
  const double weight_a =
      area2 - weight_b - weight_c;  // not a third cross product: the query may be far from all corners
  if (!sliver && weight_a >= 0.0 && weight_b >= 0.0 && weight_c >= 0.0) {
    const glm::dvec3 barycentric = glm::dvec3(weight_a, weight_b, weight_c) / area2;
    const glm::dvec3 offset = a * barycentric.x + b * barycentric.y + c * barycentric.z;
    return {glm::dot(offset, offset), barycentric};
  }
  ClosestPoint best{-1.0, {}};
  const auto consider = [&](const ClosestPoint& candidate) {
    if (best.distance2 < 0.0 || candidate.distance2 < best.distance2) best = candidate;
  };
  if (sliver || weight_c < 0.0) consider(closest_detail::onEdge(a, b, 0, 1));
  if (sliver || weight_a < 0.0) consider(closest_detail::onEdge(b, c, 1, 2));
  if (sliver || weight_b < 0.0) consider(closest_detail::onEdge(c, a, 2, 0));
  return best;
}

}  // namespace lithe::bake
