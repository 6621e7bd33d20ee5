// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// What one block of poses contributes: written once for both lane types, so that the array type specifies the vector
// type.
#pragma once

#include "kernels.h"

namespace lithe::bake {

/// Adds weight * n n^T.
template <class L>
LITHE_INLINE void addNormal(SymmetricOf<L>& q, const Vec3<L>& n, const L& weight) {
  const L wx = weight * n.x, wy = weight * n.y;
  q.xx += wx * n.x;
  q.xy += wx * n.y;
  q.xz += wx * n.z;
  q.yy += wy * n.y;
  q.yz += wy * n.z;
  q.zz += weight * n.z * n.z;
}

template <class L>
LITHE_INLINE void addSymmetric(QuadricOf<L>& q, const SymmetricOf<L>& added) {
  q.xx += added.xx;
  q.xy += added.xy;
  q.xz += added.xz;
  q.yy += added.yy;
  q.yz += added.yz;
  q.zz += added.zz;
}

/// With m = edge x n the plane through the edge has the unit normal m / (|edge| |n|), so weight |edge|^2 / 2 / 2 needs
/// no root.
template <class L>
LITHE_INLINE void addFanFace(SymmetricOf<L>& q, const Vec3<L>& corner, const Vec3<L>& next, const Vec3<L>& last,
                             float next_weight, float last_weight) {
  const Vec3<L> to_next = next - corner, to_last = last - corner;
  const Vec3<L> n = cross(to_next, to_last);
  const L n2 = dot(n, n);
  addNormal(q, n, positiveReciprocal(squareRoot(n2)) * (0.5f / 3.0f));
  if (next_weight > 0.0f) addNormal(q, cross(to_next, n), positiveReciprocal(n2) * (0.25f * next_weight));
  if (last_weight > 0.0f) addNormal(q, cross(to_last, n), positiveReciprocal(n2) * (0.25f * last_weight));
}

template <class L>
struct alignas(kLanesAlignment) NormalTerms {
  L xx, xy, xz, yy, yz, zz;
  L gx, gy, gz;
};

/// R^T A R and R^T (A r + b) for the linear part R of the blended matrix.
template <class L>
LITHE_INLINE void addNormalTerms(NormalTerms<L>& sum, const QuadricOf<L>& q, const L (&m)[3][4], const Vec3<L>& r) {
  const Vec3<L> x{m[0][0], m[1][0], m[2][0]}, y{m[0][1], m[1][1], m[2][1]}, z{m[0][2], m[1][2], m[2][2]};
  const Vec3<L> g = halfGradient(q, r);
  const Vec3<L> ax{q.xx * x.x + q.xy * x.y + q.xz * x.z, q.xy * x.x + q.yy * x.y + q.yz * x.z,
                   q.xz * x.x + q.yz * x.y + q.zz * x.z};
  const Vec3<L> ay{q.xx * y.x + q.xy * y.y + q.xz * y.z, q.xy * y.x + q.yy * y.y + q.yz * y.z,
                   q.xz * y.x + q.yz * y.y + q.zz * y.z};
  const Vec3<L> az{q.xx * z.x + q.xy * z.y + q.xz * z.z, q.xy * z.x + q.yy * z.y + q.yz * z.z,
                   q.xz * z.x + q.yz * z.y + q.zz * z.z};
  sum.xx += dot(x, ax);
  sum.xy += dot(x, ay);
  sum.xz += dot(x, az);
  sum.yy += dot(y, ay);
  sum.yz += dot(y, az);
  sum.zz += dot(z, az);
  sum.gx += dot(x, g);
  sum.gy += dot(y, g);
  sum.gz += dot(z, g);
}

/// Of a point to an edge, from its squared distances to the edge's ends and the edge's squared length.
template <class L>
LITHE_INLINE L squaredDistanceToEdge(const L& from, const L& to, const L& length) {
  const L along = (from + length - to) * 0.5f;  // the length times the share at which the foot point lies
  const L share = lesser(greater(along * positiveReciprocal(length), L{}), L{} + 1.0f);
  return from - share * (along + along - share * length);
}

/// To the foot point in the plane where it lies inside, else to the nearest edge.
template <class L>
LITHE_INLINE L squaredDistanceToFace(const FaceDistancesOf<L>& f) {
  const L to_edges = lesser(
      squaredDistanceToEdge(f.to[0], f.to[1], f.edge[0]),
      lesser(squaredDistanceToEdge(f.to[0], f.to[2], f.edge[1]), squaredDistanceToEdge(f.to[1], f.to[2], f.edge[2])));
  const L bp = (f.to[0] + f.edge[0] - f.to[1]) * 0.5f, cp = (f.to[0] + f.edge[1] - f.to[2]) * 0.5f;
  const L bc = (f.edge[0] + f.edge[1] - f.edge[2]) * 0.5f;
  const L scale = positiveReciprocal(f.edge[0] * f.edge[1] - bc * bc);
  const L v = (f.edge[1] * bp - bc * cp) * scale, w = (f.edge[0] * cp - bc * bp) * scale;
  const L to_plane = f.to[0] - (v * bp + w * cp) * 2.0f + (v * v * f.edge[0] + v * w * bc * 2.0f + w * w * f.edge[1]);
  return whereNegative(lesser(lesser(v, w), L{} + 1.0f - v - w), to_edges, lesser(to_plane, to_edges));
}

}  // namespace lithe::bake
