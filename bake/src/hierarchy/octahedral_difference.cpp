// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/octahedral_difference.h"

#include <array>
#include <cstdlib>

#include "lithe/bake/model.h"

namespace lithe::bake {
namespace {

using format::Int2;
using format::OctahedralChart;

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
bool lower(Int2 p, Int2 q) { return p.y < q.y || (p.y == q.y && p.x < q.x); }
int32_t length(Int2 d) { return std::abs(d.x) + std::abs(d.y); }

/// The point that rule.eighths(d) of d lead to from `from`.
Int2 along(Int2 from, Int2 d, DirectionRule rule) {
  const int32_t t8 = rule.eighths(d);
  return {from.x + format::eighths(d.x, t8), from.y + format::eighths(d.y, t8)};
}

bool splitsInto(Int2 parent, Int2 d, Int2 b, Int2 a, DirectionRule rule) {
  const format::ChildDirections children = rule.split(parent, d);
  return children.valid && same(children.b, b) && same(children.a, a);
}

bool inSquare(Int2 p, int32_t center) { return p.x >= 0 && p.x <= 2 * center && p.y >= 0 && p.y <= 2 * center; }

/// Every way from b to a in a chart, over any fold: visit(image of b, difference).
template <class Visit>
void visitWays(Int2 b, Int2 a, const OctahedralChart& chart, const Visit& visit) {
  for (Int2 from : imagesOf(chart.fromSquare(b), chart.center))
    for (Int2 to : imagesOf(chart.fromSquare(a), chart.center)) visit(from, Int2{to.x - from.x, to.y - from.y});
}

/// The parent in a chart that is d on the way from `from`; nothing where that is another chart's.
std::optional<Int2> parentIn(const OctahedralChart& chart, Int2 from, Int2 d, DirectionRule rule) {
  const Int2 p = along(from, d, rule);
  if (!inSquare(p, rule.center)) return std::nullopt;
  const Int2 parent = chart.toSquare(p);
  if (!(OctahedralChart::around(parent, rule.center) == chart)) return std::nullopt;
  return parent;
}

/// Straight across the chart around the sum of the two directions: nearly always that is their parent's.
std::optional<Int2> straightBetween(Int2 b, Int2 a, DirectionRule rule) {
  int32_t sum[3], of_a[3];
  format::octahedralDirection(b, rule.center, sum);
  format::octahedralDirection(a, rule.center, of_a);
  for (int c = 0; c < 3; ++c) sum[c] += of_a[c];
  const OctahedralChart chart(sum, rule.center);
  const Int2 from = chart.fromSquare(b), to = chart.fromSquare(a), d{to.x - from.x, to.y - from.y};
  const std::optional<Int2> parent = parentIn(chart, from, d, rule);
  return parent && splitsInto(*parent, d, b, a, rule) ? parent : std::nullopt;
}

}  // namespace

std::optional<Int2> octahedralDifference(Int2 parent, Int2 b, Int2 a, DirectionRule rule) {
  const OctahedralChart chart = OctahedralChart::around(parent, rule.center);
  const Int2 from = chart.fromSquare(b), to = chart.fromSquare(a), straight{to.x - from.x, to.y - from.y};
  if (splitsInto(parent, straight, b, a, rule)) return straight;
  std::optional<Int2> best;
  visitWays(b, a, chart, [&](Int2, Int2 d) {
    if ((!best || length(d) < length(*best)) && splitsInto(parent, d, b, a, rule)) best = d;
  });
  return best;
}

// A middle may round into another chart than the one it was taken in, and have none that leads to both children. A
// child itself always has: at a difference so long that it counts as far. Of equal ways the parent with the lower
// point is taken, so that either child's order gives the same.
Int2 octahedralBetween(Int2 b, Int2 a, DirectionRule rule) {
  if (const std::optional<Int2> parent = straightBetween(b, a, rule)) return *parent;
  std::optional<Int2> best;
  int32_t least = 0;
  for (int32_t pole = 0; pole < 6; ++pole) {
    int32_t axis[3] = {0, 0, 0};
    axis[pole / 2] = pole % 2 ? -1 : 1;
    const OctahedralChart chart(axis, rule.center);
    visitWays(b, a, chart, [&](Int2 from, Int2 d) {
      if (best && length(d) > least) return;
      const std::optional<Int2> parent = parentIn(chart, from, d, rule);
      if (!parent || !splitsInto(*parent, d, b, a, rule)) return;
      if (best && length(d) == least && !lower(*parent, *best)) return;
      best = parent;
      least = length(d);
    });
  }
  if (!best) throw Error("two directions have no parent: this is a fault of lithe, please report it");
  return *best;
}

}  // namespace lithe::bake
