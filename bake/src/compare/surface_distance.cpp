// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "surface_distance.h"

#include <algorithm>
#include <cmath>

namespace lithe::bake {

double percentile(std::vector<double>& values, double share) {
  const double rank = std::ceil(share * static_cast<double>(values.size()));
  const size_t position = static_cast<size_t>(std::clamp(rank, 1.0, static_cast<double>(values.size()))) - 1;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(position), values.end());
  return values[position];
}

SurfaceDistance summarizeDistances(std::vector<double>& distances) {
  SurfaceDistance result;
  double sum = 0.0, sum2 = 0.0;
  for (const double distance : distances) {
    sum += distance;
    sum2 += distance * distance;
    result.max = std::max(result.max, distance);
  }
  const double count = static_cast<double>(distances.size());
  result.mean = sum / count;
  result.rms = std::sqrt(sum2 / count);
  result.p999 = percentile(distances, 0.999);
  return result;
}

double farthestVertex(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles,
                      const TriangleTree& tree, double at_least, const TrianglesNear& near) {
  std::vector<bool> seen(positions.size(), false);
  double largest2 = at_least * at_least;
  uint32_t hint = 0;
  // Any triangle bounds the distance from above: no search where that cannot raise the maximum.
  const auto isWithin = [&](uint32_t vertex) {
    double least2 = tree.distance2(positions[vertex], hint);
    if (least2 <= largest2 || !near) return least2 <= largest2;
    for (const uint32_t triangle : near(vertex)) {
      const double distance2 = tree.distance2(positions[vertex], triangle);
      if (distance2 <= largest2) return true;
      if (distance2 < least2) {
        least2 = distance2;
        hint = triangle;
      }
    }
    return false;
  };
  for (const Triangle& triangle : triangles) {
    for (const uint32_t vertex : triangle) {
      if (seen[vertex]) continue;
      seen[vertex] = true;
      if (isWithin(vertex)) continue;
      const NearestPoint nearest = tree.nearest(positions[vertex], hint);
      hint = nearest.triangle;
      largest2 = std::max(largest2, nearest.distance2);
    }
  }
  return std::max(at_least, std::sqrt(largest2));
}

namespace {

uint32_t nearestOf(std::span<const uint32_t> triangles, const glm::dvec3& point, const TriangleTree& tree,
                   uint32_t best) {
  double least2 = tree.distance2(point, best);
  for (const uint32_t triangle : triangles) {
    const double distance2 = tree.distance2(point, triangle);
    if (distance2 >= least2) continue;
    least2 = distance2;
    best = triangle;
  }
  return best;
}

}  // namespace

SurfaceDistance sampledDistance(std::span<const glm::dvec3> positions_a, std::span<const Triangle> triangles_a,
                                const TriangleTree& tree_b, uint32_t samples, uint64_t seed,
                                const TrianglesNear& near) {
  std::vector<double> distances;
  distances.reserve(samples);
  uint32_t hint = 0;
  for (const SurfaceSample& sample : sampleSurface(positions_a, triangles_a, samples, seed)) {
    const glm::dvec3 point = pointOf(positions_a, triangles_a[sample.triangle], sample.barycentric);
    if (near)
      hint = nearestOf(near(triangles_a[sample.triangle][largestShare(sample.barycentric)]), point, tree_b, hint);
    const NearestPoint nearest = tree_b.nearest(point, hint);
    hint = nearest.triangle;
    distances.push_back(std::sqrt(nearest.distance2));
  }
  return summarizeDistances(distances);
}

SurfaceDistance surfaceDistance(std::span<const glm::dvec3> positions_a, std::span<const Triangle> triangles_a,
                                const TriangleTree& tree_b, uint32_t samples, uint64_t seed) {
  SurfaceDistance result = sampledDistance(positions_a, triangles_a, tree_b, samples, seed);
  result.max = farthestVertex(positions_a, triangles_a, tree_b, result.max);
  return result;
}

SurfaceDistance surfaceDistance(std::span<const glm::dvec3> positions_a, std::span<const Triangle> triangles_a,
                                std::span<const glm::dvec3> positions_b, std::span<const Triangle> triangles_b,
                                uint32_t samples, uint64_t seed) {
  return surfaceDistance(positions_a, triangles_a, TriangleTree(positions_b, triangles_b), samples, seed);
}

SurfaceDistances surfaceDistances(std::span<const glm::dvec3> positions_a, std::span<const Triangle> triangles_a,
                                  std::span<const glm::dvec3> positions_b, std::span<const Triangle> triangles_b,
                                  uint32_t samples, uint64_t seed) {
  SurfaceDistances result;
  result.a_to_b = surfaceDistance(positions_a, triangles_a, positions_b, triangles_b, samples, seed);
  result.b_to_a = surfaceDistance(positions_b, triangles_b, positions_a, triangles_a, samples, seed + 1);
  result.symmetric = {std::max(result.a_to_b.rms, result.b_to_a.rms), std::max(result.a_to_b.mean, result.b_to_a.mean),
                      std::max(result.a_to_b.max, result.b_to_a.max), std::max(result.a_to_b.p999, result.b_to_a.p999)};
  return result;
}

}  // namespace lithe::bake
