// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Unit vectors as points of a folded octahedron (Meyer et al. 2010, "On floating-point normal vectors"), in integers.
///
/// The square [0, 2c] x [0, 2c] with centre c = 2^(bits-1) - 1 holds the sphere: (x - c, y - c) / c = (a, b);
/// inside the diamond |a| + |b| <= 1 the vector is (a, b, 1 - |a| - |b|), outside it is folded to the lower half.
/// Opposite halves of one border edge of the square are the same directions, mirrored about the edge's middle.
#pragma once

#include <stdint.h>

namespace lithe::format {

struct Int2 {
  int32_t x, y;
};

constexpr int32_t octahedralCenter(uint32_t bits) { return (1 << (bits - 1)) - 1; }

/// Brings a point up to one square outside back inside, through the edge it left by (half turn about the edge's
/// middle).
constexpr Int2 octahedralFold(Int2 p, int32_t center) {
  const int32_t size = 2 * center;
  for (int pass = 0; pass < 2; ++pass) {
    if (p.x < 0)
      p = {-p.x, size - p.y};
    else if (p.x > size)
      p = {2 * size - p.x, size - p.y};
    if (p.y < 0)
      p = {size - p.x, -p.y};
    else if (p.y > size)
      p = {size - p.x, 2 * size - p.y};
  }
  return p;
}

/// The direction of a point, not normalised: components in [-c, c] (x, y) and (z) with |x| + |y| + |z| = c.
constexpr void octahedralDirection(Int2 p, int32_t center, int32_t direction[3]) {
  int32_t a = p.x - center, b = p.y - center;
  const int32_t abs_a = a < 0 ? -a : a, abs_b = b < 0 ? -b : b;
  const int32_t z = center - abs_a - abs_b;
  if (z < 0) {
    const int32_t folded_a = (center - abs_b) * (a < 0 ? -1 : 1), folded_b = (center - abs_a) * (b < 0 ? -1 : 1);
    a = folded_a;
    b = folded_b;
  }
  direction[0] = a;
  direction[1] = b;
  direction[2] = z;
}

/// The point of a direction with |x| + |y| + |z| = c: of the two that the border has for some, the one on the positive
/// half of its edge.
constexpr Int2 octahedralPointOf(const int32_t direction[3], int32_t center) {
  const int32_t x = direction[0], y = direction[1];
  if (direction[2] >= 0) return {center + x, center + y};
  const int32_t abs_x = x < 0 ? -x : x, abs_y = y < 0 ? -y : y;
  return {x < 0 ? abs_y : 2 * center - abs_y, y < 0 ? abs_x : 2 * center - abs_x};
}

}  // namespace lithe::format
