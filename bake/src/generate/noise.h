// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Repeatable irregularity: numbers that depend on a lattice cell and nothing else.
#pragma once

#include <cmath>
#include <cstdint>

#include "exact_math.h"

namespace lithe::bake::noise {

/// In [0, 1), from integer coordinates and a seed; the finalizer of splitmix64.
inline double cell(int64_t x, int64_t y, uint64_t seed) {
  uint64_t h = static_cast<uint64_t>(x) * 0x9e3779b97f4a7c15u + static_cast<uint64_t>(y) * 0xc2b2ae3d27d4eb4fu + seed;
  h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
  h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
  return static_cast<double>((h ^ (h >> 31)) >> 11) * 0x1p-53;
}

/// Round grains of height up to 1, one to a unit cell at a random place and of random size.
inline double grains(double x, double y, uint64_t seed) {
  const auto column = static_cast<int64_t>(std::floor(x)), row = static_cast<int64_t>(std::floor(y));
  double height = 0.0;
  for (int64_t j = row - 1; j <= row + 1; ++j) {
    for (int64_t i = column - 1; i <= column + 1; ++i) {
      const double dx = x - (i + 0.25 + 0.5 * cell(i, j, seed)), dy = y - (j + 0.25 + 0.5 * cell(i, j, seed + 1));
      const double size = 0.3 + 0.4 * cell(i, j, seed + 2);
      height += size * exact::bump(std::sqrt(dx * dx + dy * dy), size);
    }
  }
  return height;
}

}  // namespace lithe::bake::noise
