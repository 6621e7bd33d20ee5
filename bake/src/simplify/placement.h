// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The places a parent may have, given its children: the bake's side of format/placement.h.
#pragma once

#include <algorithm>
#include <bit>
#include <glm/glm.hpp>

#include "lithe/format/placement.h"

namespace lithe::bake {

inline format::Int3 toInt3(const glm::ivec3& v) { return {v.x, v.y, v.z}; }
inline glm::ivec3 toVec3(const format::Int3& v) { return {v.x, v.y, v.z}; }

/// The edge from child 0 (v, t8 = 0) to child 1 (u, t8 = 8) in grid coordinates.
struct Segment {
  glm::ivec3 v, d;
  int32_t step;  // of the lattice, a power of two
  int32_t step_log2;
  int32_t highest;  // grid coordinate

  Segment(const glm::ivec3& child0, const glm::ivec3& child1, uint32_t shift, uint32_t bits)
      : v(child0),
        d(child1 - child0),
        step(format::latticeStep(toInt3(d), shift)),
        step_log2(std::countr_zero(static_cast<uint32_t>(step))),
        highest((1 << bits) - 1) {}

  glm::ivec3 point(int32_t t8) const { return toVec3(format::pointBetween(toInt3(v), toInt3(d), t8)); }

  /// The eighth whose point is nearest to x; the middle for an edge without length.
  int32_t nearestEighth(const glm::dvec3& x) const {
    const double length2 = glm::dot(glm::dvec3(d), glm::dvec3(d));
    if (length2 == 0.0) return 4;
    const double t = glm::dot(x - glm::dvec3(v), glm::dvec3(d)) / length2;
    return floorOf(std::clamp(8.0 * t + 0.5, 0.0, 8.0));
  }

  /// The lattice point of t8 that is nearest to x among those inside the grid.
  glm::ivec3 snap(const glm::dvec3& x, int32_t t8) const {
    const glm::ivec3 base = point(t8);
    const double inverse = 1.0 / step;
    return {snapComponent(x.x, base.x, inverse), snapComponent(x.y, base.y, inverse),
            snapComponent(x.z, base.z, inverse)};
  }

 private:
  int32_t snapComponent(double x, int32_t base, double inverse_step) const {
    // base lies in the grid: shifts and a product divide as exactly as divisions.
    const double lowest_k = -(base >> step_log2), highest_k = (highest - base) >> step_log2;
    const int32_t k = floorOf(std::clamp((x - base) * inverse_step + 0.5, lowest_k, highest_k));
    return base + k * step;
  }

  /// std::floor is a call where the processor need not have an instruction for it.
  static int32_t floorOf(double x) {
    const auto truncated = static_cast<int32_t>(x);
    return truncated - (truncated > x ? 1 : 0);
  }
};

}  // namespace lithe::bake
