// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Where a parent may lie, as a function of its two children: the integer rule that the bake and the reader share.
///
/// With children u and v (grid coordinates), D = u - v, a parameter t8 in 0..8 and a lattice index k:
///
///     w = floor((8 v + t8 D + 4) / 8) + k * step(D, shift)
///
/// A reader that knows w, D, t8 and k gets v = w - k * step - floor((t8 D + 4) / 8) and u = v + D, without loss.
/// Exchanging the children (D -> -D, t8 -> 8 - t8) gives the same w: the rounding is of the absolute sum.
#pragma once

#include <stdint.h>

namespace lithe::format {

struct Int3 {
  int32_t x, y, z;
};

/// floor((t8 * d + 4) / 8): the rounded t8 eighths of d. Exact for |d| < 2^27.
constexpr int32_t eighths(int32_t d, int32_t t8) { return (t8 * d + 4) >> 3; }

constexpr int32_t absolute(int32_t x) { return x < 0 ? -x : x; }

/// The absolute value of the longest component.
constexpr int32_t longest(Int3 v) {
  const int32_t xy = absolute(v.x) > absolute(v.y) ? absolute(v.x) : absolute(v.y);
  return absolute(v.z) > xy ? absolute(v.z) : xy;
}

/// The placement lattice's step for a difference D: the largest power of two that is at most max(|D|) / 2^shift, and at
/// least 1. shift is a property of the file (the bake's --precision); a large shift means that every grid point can be
/// hit.
constexpr int32_t latticeStep(Int3 d, uint32_t shift) {
  const int32_t extent = longest(d);
  if (shift > 30) return 1;
  int32_t step = 1;
  while (step <= (extent >> shift) / 2) step *= 2;
  return step;
}

/// The point at t8 eighths from v (0) to u (8): where the lattice of parents is centred.
constexpr Int3 pointBetween(Int3 v, Int3 d, int32_t t8) {
  return {v.x + eighths(d.x, t8), v.y + eighths(d.y, t8), v.z + eighths(d.z, t8)};
}

}  // namespace lithe::format
