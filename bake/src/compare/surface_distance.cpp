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

double largestVertexDistance(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles,
                             const TriangleTree& tree, double at_least) {
  std::vector<bool> seen(positions.size(), false);
  double largest2 = at_least * at_least;
  uint32_t hint = 0;
  for (const Triangle& triangle : triangles) {
    for (const uint32_t vertex : triangle) {
      if (seen[vertex]) continue;
      seen[vertex] = true;
      // The hint's distance bounds the vertex's from above: no search where it cannot raise the maximum.
      if (tree.distance2(positions[vertex], hint) <= largest2) continue;
      const NearestPoint nearest = tree.nearest(positions[vertex], hint);
      hint = nearest.triangle;
      largest2 = std::max(largest2, nearest.distance2);
    }
  }
  return std::max(at_least, std::sqrt(largest2));
}

SurfaceDistance surfaceDistance(std::span<const glm::dvec3> positions_a, std::span<const Triangle> triangles_a,
                                const TriangleTree& tree_b, uint32_t samples, uint64_t seed) {
  std::vector<double> distances;
  distances.reserve(samples);
  uint32_t hint = kNone;
  for (const SurfaceSample& sample : sampleSurface(positions_a, triangles_a, samples, seed)) {
    const glm::dvec3 point = pointOf(positions_a, triangles_a[sample.triangle], sample.barycentric);
    const NearestPoint nearest = tree_b.nearest(point, hint);
    hint = nearest.triangle;
    distances.push_back(std::sqrt(nearest.distance2));
  }
  SurfaceDistance result = summarizeDistances(distances);
  result.max = largestVertexDistance(positions_a, triangles_a, tree_b, result.max);
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
