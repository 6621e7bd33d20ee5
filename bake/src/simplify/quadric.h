// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Quadrics of eight poses at once: sums of weighted squared distances to planes, about a local origin per pose.
#pragma once

#include "lanes.h"

namespace lithe::bake {

/// E(x) = x^T A x + 2 b^T x + c, A symmetric, x relative to the quadric's origin (Garland and Heckbert 1997).
/// The origin is the posed vertex itself: floats then hold distances of a few edge lengths, never of the whole
/// character.
template <class L>
struct alignas(kLanesAlignment) QuadricOf {
  L xx, xy, xz, yy, yz, zz;
  L bx, by, bz;
  L c;
};
using Quadric = QuadricOf<Lanes>;

/// Adds weight * (n . x + d)^2.
template <class L>
LITHE_INLINE void addPlane(QuadricOf<L>& q, const Vec3<L>& n, const L& d, const L& weight) {
  const L wx = weight * n.x, wy = weight * n.y, wz = weight * n.z, wd = weight * d;
  q.xx += wx * n.x;
  q.xy += wx * n.y;
  q.xz += wx * n.z;
  q.yy += wy * n.y;
  q.yz += wy * n.z;
  q.zz += wz * n.z;
  q.bx += wd * n.x;
  q.by += wd * n.y;
  q.bz += wd * n.z;
  q.c += wd * d;
}

/// Adds weight * |x + d|^2.
template <class L>
LITHE_INLINE void addPoint(QuadricOf<L>& q, const Vec3<L>& d, const L& weight) {
  q.xx += weight;
  q.yy += weight;
  q.zz += weight;
  q.bx += weight * d.x;
  q.by += weight * d.y;
  q.bz += weight * d.z;
  q.c += weight * dot(d, d);
}

/// A x + b: half the gradient.
template <class L>
LITHE_INLINE Vec3<L> halfGradient(const QuadricOf<L>& q, const Vec3<L>& x) {
  return {q.xx * x.x + q.xy * x.y + q.xz * x.z + q.bx, q.xy * x.x + q.yy * x.y + q.yz * x.z + q.by,
          q.xz * x.x + q.yz * x.y + q.zz * x.z + q.bz};
}

template <class L>
LITHE_INLINE L energyAt(const QuadricOf<L>& q, const Vec3<L>& x) {
  const Vec3<L> g = halfGradient(q, x);
  return g.x * x.x + g.y * x.y + g.z * x.z + (q.bx * x.x + q.by * x.y + q.bz * x.z) + q.c;
}

/// The same function about an origin that lies at `shift` from the old one.
template <class L>
LITHE_INLINE QuadricOf<L> shifted(const QuadricOf<L>& q, const Vec3<L>& shift) {
  QuadricOf<L> result = q;
  const Vec3<L> g = halfGradient(q, shift);
  result.bx = g.x;
  result.by = g.y;
  result.bz = g.z;
  result.c = energyAt(q, shift);
  return result;
}

template <class L>
LITHE_INLINE QuadricOf<L> sumOf(const QuadricOf<L>& a, const QuadricOf<L>& b) {
  return {a.xx + b.xx, a.xy + b.xy, a.xz + b.xz, a.yy + b.yy, a.yz + b.yz,
          a.zz + b.zz, a.bx + b.bx, a.by + b.by, a.bz + b.bz, a.c + b.c};
}

}  // namespace lithe::bake
