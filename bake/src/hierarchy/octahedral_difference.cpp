// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/octahedral_difference.h"

#include <array>
#include <cstdlib>

#include "lithe/format/placement.h"

namespace lithe::bake {
namespace {

using format::Int2;

// A point and its images beyond the square's edges and corners: all of them fold back to it.
std::array<Int2, 9> imagesOf(Int2 p, int32_t center) {
  const int32_t size = 2 * center;
  return {{p,
           {-p.x, size - p.y},
           {2 * size - p.x, size - p.y},
           {size - p.x, -p.y},
           {size - p.x, 2 * size - p.y},
           {p.x - size, p.y - size},
           {p.x - size, p.y + size},
           {p.x + size, p.y - size},
           {p.x + size, p.y + size}}};
}

bool same(Int2 p, Int2 q) { return p.x == q.x && p.y == q.y; }
int32_t length(Int2 d) { return std::abs(d.x) + std::abs(d.y); }

/// The point that rule.eighths(d) of d lead to from `from`.
Int2 along(Int2 from, Int2 d, DirectionRule rule, int32_t sign) {
  const int32_t t8 = rule.eighths(d);
  return {from.x + sign * format::eighths(d.x, t8), from.y + sign * format::eighths(d.y, t8)};
}

bool decodes(Int2 parent, Int2 d, Int2 b, Int2 a, DirectionRule rule) {
  const Int2 x = along(parent, d, rule, -1);
  return same(format::octahedralFold(x, rule.center), b) &&
         same(format::octahedralFold({x.x + d.x, x.y + d.y}, rule.center), a);
}

bool inSquare(Int2 p, int32_t center) { return p.x >= 0 && p.x <= 2 * center && p.y >= 0 && p.y <= 2 * center; }

}  // namespace

std::optional<Int2> octahedralDifference(Int2 parent, Int2 b, Int2 a, DirectionRule rule) {
  std::optional<Int2> best;
  for (Int2 from : imagesOf(b, rule.center))
    for (Int2 to : imagesOf(a, rule.center)) {
      const Int2 d{to.x - from.x, to.y - from.y};
      if ((!best || length(d) < length(*best)) && decodes(parent, d, b, a, rule)) best = d;
    }
  return best;
}

// The images are chosen so that the point lies in the square as it is: folded, its rounding would be mirrored, and a
// reader could not undo it. Straight across always fits; of equal ways the one with the lower point is taken, so that
// either child's order gives the same.
Int2 octahedralBetween(Int2 b, Int2 a, DirectionRule rule) {
  Int2 best = along(b, {a.x - b.x, a.y - b.y}, rule, 1);
  int32_t least = length({a.x - b.x, a.y - b.y});
  for (Int2 from : imagesOf(b, rule.center))
    for (Int2 to : imagesOf(a, rule.center)) {
      const Int2 d{to.x - from.x, to.y - from.y};
      if (length(d) > least) continue;
      const Int2 p = along(from, d, rule, 1);
      if (length(d) == least && !(p.y < best.y || (p.y == best.y && p.x < best.x))) continue;
      if (!inSquare(p, rule.center) || !decodes(p, d, b, a, rule)) continue;
      best = p;
      least = length(d);
    }
  return best;
}

}  // namespace lithe::bake
