// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Directions seen from one of them, and the directions of a split's children.
///
/// The octahedron with |x| + |y| + |z| = c has the same integer points whichever axis is the pole of its square. A
/// chart is the square whose pole is the axis that a direction is closest to: what lies around the direction lies
/// around the chart's middle, far from its folds, and half way between two points of it is close to half way on the
/// sphere.
#pragma once

#include <stdint.h>

#include "lithe/format/octahedral.h"
#include "lithe/format/placement.h"

namespace lithe::format {

struct OctahedralChart {
  uint32_t axis;       ///< the pole's; the lowest of the longest
  uint32_t across[2];  ///< the other two, ascending: the chart's x and y
  int32_t sign;        ///< of the pole, 1 or -1
  int32_t center;

  /// The chart around a vector, of any length.
  constexpr OctahedralChart(const int32_t v[3], int32_t center_in) : axis(0), across{1, 2}, sign(1), center(center_in) {
    if (absolute(v[1]) > absolute(v[axis])) axis = 1;
    if (absolute(v[2]) > absolute(v[axis])) axis = 2;
    across[0] = axis == 0 ? 1 : 0;
    across[1] = axis == 2 ? 1 : 2;
    sign = v[axis] < 0 ? -1 : 1;
  }

  /// The chart around the direction of a point of the square whose pole is +z, which is the one that files hold.
  static constexpr OctahedralChart around(Int2 p, int32_t center) {
    int32_t v[3] = {0, 0, 0};
    octahedralDirection(p, center, v);
    return {v, center};
  }

  constexpr Int2 fromSquare(Int2 p) const {
    int32_t v[3] = {0, 0, 0};
    octahedralDirection(p, center, v);
    const int32_t turned[3] = {v[across[0]], v[across[1]], sign * v[axis]};
    return octahedralPointOf(turned, center);
  }

  constexpr Int2 toSquare(Int2 q) const {
    int32_t turned[3] = {0, 0, 0}, v[3] = {0, 0, 0};
    octahedralDirection(q, center, turned);
    v[across[0]] = turned[0];
    v[across[1]] = turned[1];
    v[axis] = sign * turned[2];
    return octahedralPointOf(v, center);
  }

  constexpr bool operator==(const OctahedralChart& other) const {
    return axis == other.axis && sign == other.sign && center == other.center;
  }
};

/// Where a parent's direction lies between its children's, which are `d` apart in its chart: half way, wherever the
/// parent itself lies, since an average is nearer to what the surface around it shows than the direction of the child
/// that it happens to be close to. Directions too far apart have no average worth showing; and what undoes an
/// absorption (a split that makes no face) has a parent that is all that its host was: those have the direction of the
/// child that t8 is nearer to, and of the one that d says where it is as near to both.
constexpr int32_t directionEighths(Int2 d, int32_t t8, bool makes_faces, int32_t center) {
  if (makes_faces && 2 * (absolute(d.x) + absolute(d.y)) <= 3 * center) return 4;
  if (t8 != 4) return t8 < 4 ? 0 : 8;
  return d.x > 0 || (d.x == 0 && d.y > 0) ? 0 : 8;
}

/// Points of the square.
struct ChildDirections {
  Int2 a, b;
  bool valid;  ///< false: d leads too far out of the square
};

/// A direction, and where it lies in the chart around it.
struct ChartedDirection {
  OctahedralChart chart;
  Int2 point;

  /// Of a point of the square.
  constexpr ChartedDirection(Int2 p, int32_t center)
      : chart(OctahedralChart::around(p, center)), point(chart.fromSquare(p)) {}
};

/// d is the way from b to a in the parent's chart.
constexpr ChildDirections splitDirection(const ChartedDirection& parent, Int2 d, int32_t t8, bool makes_faces) {
  const OctahedralChart& chart = parent.chart;
  const int32_t center = chart.center, size = 2 * center, h = directionEighths(d, t8, makes_faces, center);
  const Int2 x{parent.point.x - eighths(d.x, h), parent.point.y - eighths(d.y, h)};
  const Int2 a = octahedralFold({x.x + d.x, x.y + d.y}, center), b = octahedralFold(x, center);
  const Int2 points[2] = {a, b};
  for (const Int2 q : points)
    if (q.x < 0 || q.x > size || q.y < 0 || q.y > size) return {a, b, false};
  return {chart.toSquare(a), chart.toSquare(b), true};
}

}  // namespace lithe::format
