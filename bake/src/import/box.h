// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Axis-aligned bounding boxes.
#pragma once

#include <algorithm>
#include <array>
#include <glm/glm.hpp>
#include <limits>

namespace lithe::bake {

struct Box {
  glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};

  bool empty() const { return low.x > high.x; }
  void add(const glm::dvec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  double diagonal() const { return empty() ? 0.0 : glm::length(high - low); }
  std::array<glm::dvec3, 8> corners() const {
    std::array<glm::dvec3, 8> all;
    for (unsigned i = 0; i < 8; ++i) {
      all[i] = {(i & 1) ? high.x : low.x, (i & 2) ? high.y : low.y, (i & 4) ? high.z : low.z};
    }
    return all;
  }
};

/// How far apart two affine maps take any point of a box, at most. 0 for an empty box.
inline double largestDifference(const glm::dmat4& a, const glm::dmat4& b, const Box& box) {
  if (box.empty()) return 0.0;
  double largest = 0.0;
  for (const glm::dvec3& corner : box.corners()) {
    largest = std::max(largest, glm::length(glm::dvec3((a - b) * glm::dvec4(corner, 1.0))));
  }
  return largest;
}

}  // namespace lithe::bake
