// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// What a split's differences are predicted from, in integers that writer and reader share: the means of the children's
/// neighbourhoods, the slope of an attribute over the ring (least squares), and the children's own area normals.
#pragma once

#include <stdint.h>

#include "lithe/format/octahedral_chart.h"
#include "lithe/format/placement.h"

namespace lithe::format {

/// Number of bits of v >= 0: 0 for 0, 1 for 1, 2 for 2 and 3, ...
constexpr int32_t bitLength(uint64_t v) {
#if defined(__GNUC__)
  return v ? 64 - __builtin_clzll(v) : 0;
#else
  int32_t bits = 0;
  for (; v; v >>= 1) ++bits;
  return bits;
#endif
}

/// floor(a / b) for b > 0.
constexpr int64_t floorDivide(int64_t a, int64_t b) { return a / b - (a % b < 0); }

/// A predicted difference as a fraction; den <= 0: nothing is known.
struct Slope {
  int64_t num = 0, den = 0;
};

/// floor(strength / 16 of a slope), held within what any difference can be; strength is 0 .. 32.
constexpr int32_t scaled(int32_t strength, Slope slope) {
  constexpr int64_t kMost = 1 << 17;
  if (strength == 0 || slope.den <= 0) return 0;
  const int64_t value = floorDivide(strength * slope.num, 16 * slope.den);
  return static_cast<int32_t>(value < -kMost ? -kMost : value > kMost ? kMost : value);
}

/// The difference of the means of two neighbourhoods. den is 0 when a child has no neighbour.
constexpr Slope meanDifference(int64_t sum_a, int64_t count_a, int64_t sum_b, int64_t count_b) {
  return {sum_a * count_b - sum_b * count_a, count_a * count_b};
}

// ---- Least squares ----
//
// With r_i the position of a neighbour relative to the split node, a_i its attribute relative to the node's, and D the
// difference of the children's positions, the predicted difference of the attribute is D^T M^-1 m with M = sum r r^T
// (and a little of its trace on the diagonal) and m = sum r a. M^-1 D is solved for once per ring.

/// Positions are used with ten bits and a sign.
constexpr int32_t gradientShift(uint32_t extent) {
  const int32_t bits = bitLength(extent) - 10;
  return bits < 0 ? 0 : bits;
}

constexpr Int3 shifted(Int3 v, int32_t shift) { return {v.x >> shift, v.y >> shift, v.z >> shift}; }
constexpr Int3 minus(Int3 a, Int3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Int3 doubled(Int3 v) { return {2 * v.x, 2 * v.y, 2 * v.z}; }

/// M, of at most 2^7 shifted positions.
struct GradientSums {
  int64_t xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  constexpr void add(Int3 r) {
    xx += int64_t{r.x} * r.x;
    xy += int64_t{r.x} * r.y;
    xz += int64_t{r.x} * r.z;
    yy += int64_t{r.y} * r.y;
    yz += int64_t{r.y} * r.z;
    zz += int64_t{r.z} * r.z;
  }
};

/// m, of one attribute.
struct Moment {
  int64_t x = 0, y = 0, z = 0;

  constexpr void add(Int3 r, int64_t a) {
    x += r.x * a;
    y += r.y * a;
    z += r.z * a;
  }
};

/// A little is added to M's diagonal, then M^-1 = cofactors / den (Cramer's rule). All in integers: the sums are
/// brought below 2^bits first, by `down` bits.
struct Inverse {
  int32_t down;
  int64_t xx, xy, xz, yy, yz, zz;  ///< cofactors
  int64_t den;

  /// hold: what is added is the 2^hold-th part of the trace, and one.
  constexpr Inverse(const GradientSums& s, int32_t bits, int32_t hold)
      : down(0), xx(0), xy(0), xz(0), yy(0), yz(0), zz(0), den(0) {
    const int64_t trace = s.xx + s.yy + s.zz;
    const int32_t excess = bitLength(static_cast<uint64_t>(trace)) - bits;
    down = excess < 0 ? 0 : excess;
    const int64_t more = (trace >> down >> hold) + 1;
    const int64_t a = (s.xx >> down) + more, b = (s.yy >> down) + more, c = (s.zz >> down) + more;
    const int64_t ab = s.xy >> down, ac = s.xz >> down, bc = s.yz >> down;
    xx = b * c - bc * bc, xy = ac * bc - ab * c, xz = ab * bc - ac * b;
    yy = a * c - ac * ac, yz = ab * ac - a * bc, zz = a * b - ab * ab;
    den = a * xx + ab * xy + ac * xz;
  }

  /// The cofactors times a vector, brought below 2^22; returns by how many bits.
  constexpr int32_t times(int64_t x, int64_t y, int64_t z, int64_t q[3]) const {
    q[0] = xx * x + xy * y + xz * z;
    q[1] = xy * x + yy * y + yz * z;
    q[2] = xz * x + yz * y + zz * z;
    int64_t greatest = 0;
    for (int c = 0; c < 3; ++c) greatest = q[c] > greatest ? q[c] : -q[c] > greatest ? -q[c] : greatest;
    const int32_t over = bitLength(static_cast<uint64_t>(greatest)) - 22, reduce = over < 0 ? 0 : over;
    for (int c = 0; c < 3; ++c) q[c] >>= reduce;
    return reduce;
  }
};

/// M^-1 D as a fraction: q / den.
struct Gradient {
  int64_t q[3] = {0, 0, 0};
  int64_t den = 0;

  constexpr Slope of(Moment m) const { return {q[0] * m.x + q[1] * m.y + q[2] * m.z, den}; }
};

/// d is shifted like the positions. Every step fits 64 bits.
constexpr Gradient solveGradient(const GradientSums& s, Int3 d) {
  const Inverse inverse(s, 17, 6);
  Gradient g;
  const int32_t reduce = inverse.times(d.x, d.y, d.z, g.q), raise = inverse.down - reduce;
  g.den = raise > 0 ? inverse.den << raise : inverse.den >> -raise;
  return g;
}

// ---- Area normals ----

struct AreaNormal {
  int64_t x = 0, y = 0, z = 0;

  constexpr bool isZero() const { return x == 0 && y == 0 && z == 0; }

  /// Adds twice the area vector of the triangle (a, b, c); coordinates below 2^16.
  constexpr void add(Int3 a, Int3 b, Int3 c) {
    const Int3 u = minus(b, a), v = minus(c, a);
    x += int64_t{u.y} * v.z - int64_t{u.z} * v.y;
    y += int64_t{u.z} * v.x - int64_t{u.x} * v.z;
    z += int64_t{u.x} * v.y - int64_t{u.y} * v.x;
  }
};

// ---- Planes ----

/// The plane perpendicular to a vector, as the height over it along the axis in which the vector is longest. Points of
/// the plane have height 0: of a vector v, v[axis] is stored as its height, the other two components as they are.
struct Plane {
  uint32_t axis;       ///< the lowest of the longest
  uint32_t across[2];  ///< the other two, ascending
  int64_t slope[2];    ///< of the plane along them, over ...
  int64_t den;         ///< ... this, > 0; 0 when there is no vector

  constexpr Plane(int64_t x, int64_t y, int64_t z) : axis(0), across{1, 2}, slope{0, 0}, den(0) {
    const int64_t n[3] = {x, y, z};
    auto size = [&](uint32_t c) { return n[c] < 0 ? -n[c] : n[c]; };
    if (size(1) > size(axis)) axis = 1;
    if (size(2) > size(axis)) axis = 2;
    across[0] = axis == 0 ? 1 : 0;
    across[1] = axis == 2 ? 1 : 2;
    const int64_t sign = n[axis] < 0 ? -1 : 1;
    slope[0] = sign * n[across[0]];
    slope[1] = sign * n[across[1]];
    den = sign * n[axis];
  }

  /// What to add to v[axis] for the height; |u|, |v| < 2^18, the vector's components below 2^43.
  constexpr int64_t lift(int64_t u, int64_t v) const {
    return den == 0 ? 0 : floorDivide(slope[0] * u + slope[1] * v, den);
  }
};

/// A normal as the chart has its components.
constexpr AreaNormal turned(AreaNormal n, const OctahedralChart& chart) {
  const int64_t v[3] = {n.x, n.y, n.z};
  return {v[chart.across[0]], v[chart.across[1]], chart.sign * v[chart.axis]};
}

/// The octahedral point of a normal, rounded; the centre (the positive z axis) for no normal.
constexpr Int2 octahedralPoint(AreaNormal n, int32_t center) {
  const int64_t ax = n.x < 0 ? -n.x : n.x, ay = n.y < 0 ? -n.y : n.y, az = n.z < 0 ? -n.z : n.z;
  const int64_t length = ax + ay + az;
  if (length == 0) return {center, center};
  const int32_t px = static_cast<int32_t>((2 * ax * center + length) / (2 * length));
  const int32_t py = static_cast<int32_t>((2 * ay * center + length) / (2 * length));
  const int32_t x = n.z < 0 ? center - py : px, y = n.z < 0 ? center - px : py;
  return {n.x < 0 ? center - x : center + x, n.y < 0 ? center - y : center + y};
}

/// The difference of two normals' points in a chart; 0 where they lie far apart (most likely across a fold).
constexpr Int2 normalDifference(AreaNormal a, AreaNormal b, const OctahedralChart& chart) {
  const int32_t center = chart.center;
  const Int2 pa = octahedralPoint(turned(a, chart), center), pb = octahedralPoint(turned(b, chart), center);
  const Int2 d{pa.x - pb.x, pa.y - pb.y};
  return absolute(d.x) > center || absolute(d.y) > center ? Int2{0, 0} : d;
}

}  // namespace lithe::format
