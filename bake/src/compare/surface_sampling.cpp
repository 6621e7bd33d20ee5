// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "lithe/bake/nearest.h"

namespace lithe::bake {

namespace {

/// The splitmix64 finaliser (Steele, Lea and Flood 2014): every bit of the result depends on every bit of x.
uint64_t mix(uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// Uniform in [0, 1), a function of (seed, index) alone.
double hashedUnit(uint64_t seed, uint64_t index) {
  return static_cast<double>(mix(mix(seed) + index) >> 11) * 0x1.0p-53;
}

/// Entry i: the area of triangles [0, i]. Counts triangles instead where there is no area.
std::vector<double> cumulatedAreas(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles) {
  std::vector<double> sums;
  sums.reserve(triangles.size());
  double sum = 0.0;
  for (const Triangle& t : triangles) {
    sum += 0.5 * glm::length(glm::cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]));
    sums.push_back(sum);
  }
  if (!(sum > 0.0)) {
    for (size_t i = 0; i < sums.size(); ++i) sums[i] = static_cast<double>(i + 1);
  }
  return sums;
}

/// Maps the unit square to the triangle, area to area.
glm::dvec3 barycentricOf(double u, double v) {
  const double root = std::sqrt(u);
  return {1.0 - root, root * (1.0 - v), root * v};
}

}  // namespace

std::vector<SurfaceSample> sampleSurface(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles,
                                         uint32_t count, uint64_t seed) {
  const std::vector<double> sums = cumulatedAreas(positions, triangles);
  std::vector<SurfaceSample> samples;
  samples.reserve(count);
  size_t triangle = 0;
  for (uint32_t i = 0; i < count; ++i) {
    const double target = (i + hashedUnit(seed, 3ull * i)) / count * sums.back();
    while (triangle + 1 < sums.size() && sums[triangle] <= target) ++triangle;
    samples.push_back({static_cast<uint32_t>(triangle),
                       barycentricOf(hashedUnit(seed, 3ull * i + 1), hashedUnit(seed, 3ull * i + 2))});
  }
  return samples;
}

}  // namespace lithe::bake
