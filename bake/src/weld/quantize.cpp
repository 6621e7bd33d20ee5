// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "quantize.h"

#include <algorithm>
#include <cmath>

#include "lithe/format/octahedral.h"

namespace lithe::bake {

namespace {

int32_t roundTo(double value, int32_t highest) {
  return static_cast<int32_t>(std::clamp(std::floor(value + 0.5), 0.0, static_cast<double>(highest)));
}

/// Cosine between a unit vector and a point's direction.
double cosineTo(const glm::dvec3& unit, const format::Int2& point, int32_t center) {
  int32_t d[3];
  format::octahedralDirection(point, center, d);
  const glm::dvec3 direction(d[0], d[1], d[2]);
  return glm::dot(unit, direction) / glm::length(direction);
}

/// Where a unit vector lies in the octahedral square, unrounded.
glm::dvec2 octahedralPoint(const glm::dvec3& unit, int32_t center) {
  const double sum = std::abs(unit.x) + std::abs(unit.y) + std::abs(unit.z);
  double a = unit.x / sum, b = unit.y / sum;
  if (unit.z < 0.0) {
    const double folded_a = (1.0 - std::abs(b)) * (a < 0.0 ? -1.0 : 1.0);
    const double folded_b = (1.0 - std::abs(a)) * (b < 0.0 ? -1.0 : 1.0);
    a = folded_a;
    b = folded_b;
  }
  return {(a + 1.0) * center, (b + 1.0) * center};
}

}  // namespace

Grid positionGrid(const std::vector<glm::vec3>& positions, const std::vector<uint32_t>& vertices, uint32_t bits) {
  glm::dvec3 lower(positions[vertices[0]]), upper = lower;
  for (uint32_t vertex : vertices) {
    lower = glm::min(lower, glm::dvec3(positions[vertex]));
    upper = glm::max(upper, glm::dvec3(positions[vertex]));
  }
  const glm::dvec3 extent = upper - lower;
  const double largest = std::max({extent.x, extent.y, extent.z});
  return {lower, largest > 0.0 ? largest / ((1u << bits) - 1) : 1.0, bits};
}

glm::ivec3 toGrid(const Grid& grid, const glm::vec3& position) {
  const glm::dvec3 exact = (glm::dvec3(position) - grid.origin) / grid.step;
  const int32_t highest = (1 << grid.bits) - 1;
  return {roundTo(exact.x, highest), roundTo(exact.y, highest), roundTo(exact.z, highest)};
}

glm::ivec2 toOctahedral(const glm::vec3& direction, uint32_t bits) {
  const int32_t center = format::octahedralCenter(bits);
  const double length = glm::length(glm::dvec3(direction));
  if (!(length > 0.0) || !std::isfinite(length)) return {center, center};
  const glm::dvec3 unit = glm::dvec3(direction) / length;
  const glm::dvec2 exact = octahedralPoint(unit, center);
  const glm::ivec2 nearest(roundTo(exact.x, 2 * center), roundTo(exact.y, 2 * center));

  format::Int2 best{nearest.x, nearest.y};
  double best_cosine = -2.0;
  for (int32_t dy = -1; dy <= 1; ++dy) {
    for (int32_t dx = -1; dx <= 1; ++dx) {
      const format::Int2 candidate = format::octahedralFold({nearest.x + dx, nearest.y + dy}, center);
      const double cosine = cosineTo(unit, candidate, center);
      if (cosine > best_cosine) {
        best_cosine = cosine;
        best = candidate;
      }
    }
  }
  return {best.x, best.y};
}

UvGrid uvGrid(const glm::dvec2& lower, const glm::dvec2& upper, uint32_t bits) {
  const double range = std::max(upper.x - lower.x, upper.y - lower.y);
  return {lower, range > 0.0 ? range / ((1u << bits) - 1) : 1.0};
}

glm::ivec2 toUv(const UvGrid& grid, const glm::vec2& uv, uint32_t bits) {
  const glm::dvec2 exact = (glm::dvec2(uv) - grid.offset) / grid.scale;
  const int32_t highest = static_cast<int32_t>((1u << bits) - 1);
  return {roundTo(exact.x, highest), roundTo(exact.y, highest)};
}

glm::ivec4 toUnorm8(const glm::vec4& color) {
  return {roundTo(double{color.x} * 255.0, 255), roundTo(double{color.y} * 255.0, 255),
          roundTo(double{color.z} * 255.0, 255), roundTo(double{color.w} * 255.0, 255)};
}

}  // namespace lithe::bake
