// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Where a parent lies between and beside its children, predicted from their faces.
///
/// The bake puts a parent where the planes of the faces that it replaces are least distant (Garland and Heckbert 1997,
/// equation 3). A reader that has the difference D of the children knows those faces but for where the children are: it
/// takes the split node for their middle, and asks where the planes would have put it. With n a face's area vector and
/// v one of its corners, all relative to the split node,
///
///     x minimises   sum (n . (x - v))^2 + h |x|^2:     (sum n n^T + h) x = sum n (n . v)
///
/// The part of x along D predicts the parameter t8, the rest the lattice index across D.
#pragma once

#include <stdint.h>

#include "lithe/format/prediction.h"

namespace lithe::format {

struct PredictedPlacement {
  int32_t t8 = 4;
  Slope across[3];  ///< of the parent from the line through its children, grid steps
};

/// What is summed over the children's faces: at most kMaxRing and two.
class PlacementSums {
 public:
  /// extent: of the ring and of d, the difference of the children's positions.
  constexpr PlacementSums(Int3 d, uint32_t extent)
      : shift_(kept(extent)),
        d_(shifted(d, shift_)),
        child_{shifted(minus(d, pointBetween({0, 0, 0}, d, 4)), shift_),
               shifted(minus({0, 0, 0}, pointBetween({0, 0, 0}, d, 4)), shift_)} {}

  /// A face of child A (side 0) or B (side 1); its other corners relative to the split node.
  constexpr void addFan(uint32_t side, Int3 next, Int3 previous) {
    addFace(child_[side], shifted(next, shift_), shifted(previous, shift_));
  }

  /// A new face between the children, (A, third, B) or (B, third, A).
  constexpr void addCut(Int3 third, bool first_is_a) {
    addFace(child_[!first_is_a], shifted(third, shift_), child_[first_is_a]);
  }

  constexpr PredictedPlacement solve() const;

 private:
  static constexpr int32_t kPositionBits = 9;

  static constexpr int32_t kept(uint32_t extent) {
    const int32_t bits = bitLength(extent) - kPositionBits;
    return bits < 0 ? 0 : bits;
  }

  // Positions below 2^9 and a sign: n is below 2^21, n . v below 2^32, and 66 faces' sums fit 64 bits.
  constexpr void addFace(Int3 a, Int3 b, Int3 c) {
    const Int3 u = minus(b, a), v = minus(c, a);
    const Int3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    planes_.add(n);
    distances_.add(n, int64_t{n.x} * a.x + int64_t{n.y} * a.y + int64_t{n.z} * a.z);
  }

  int32_t shift_;
  Int3 d_;
  Int3 child_[2];
  GradientSums planes_;
  Moment distances_;
};

constexpr PredictedPlacement PlacementSums::solve() const {
  PredictedPlacement out;
  const Inverse inverse(planes_, 13, 8);
  const int32_t down = inverse.down;
  int64_t q[3] = {};
  const int32_t reduce = inverse.times(distances_.x >> down, distances_.y >> down, distances_.z >> down, q);
  const int64_t den = inverse.den >> reduce;

  // Along D, in eighths of its length, and what is left across it.
  const int64_t length2 = int64_t{d_.x} * d_.x + int64_t{d_.y} * d_.y + int64_t{d_.z} * d_.z;
  if (den <= 0) return out;
  if (length2 > 0) {
    const int64_t along = q[0] * d_.x + q[1] * d_.y + q[2] * d_.z;
    const int64_t eighths_along = floorDivide(16 * along + den * length2, 2 * den * length2);
    out.t8 = static_cast<int32_t>(eighths_along < -4 ? 0 : eighths_along > 4 ? 8 : 4 + eighths_along);
    const int64_t direction[3] = {d_.x, d_.y, d_.z};
    for (int c = 0; c < 3; ++c) q[c] -= floorDivide(along * direction[c], length2);
  }
  for (int c = 0; c < 3; ++c) out.across[c] = {q[c] * (int64_t{1} << shift_), den};
  return out;
}

/// strength / 16 of a predicted offset in steps of the lattice, rounded; strength is 0 .. 32.
constexpr int32_t latticeIndex(int32_t strength, Slope offset, int32_t step) {
  constexpr int64_t kMost = 1 << 17;
  if (offset.den <= 0) return 0;
  const int64_t unit = 16 * offset.den * step;
  const int64_t index = floorDivide(2 * strength * offset.num + unit, 2 * unit);
  return static_cast<int32_t>(index < -kMost ? -kMost : index > kMost ? kMost : index);
}

/// The eighths 0 .. 8 in the order of their distance from a predicted one, of equal ones the greater first.
constexpr int32_t eighthOfRank(int32_t rank, int32_t predicted) {
  const int32_t near = predicted < 4 ? predicted : 8 - predicted;  // eighths on the side that ends first
  if (rank <= 2 * near) return rank % 2 ? predicted + (rank + 1) / 2 : predicted - rank / 2;
  return predicted < 4 ? rank : 8 - rank;
}

constexpr int32_t rankOfEighth(int32_t t8, int32_t predicted) {
  int32_t rank = 0;
  while (eighthOfRank(rank, predicted) != t8) ++rank;
  return rank;
}

}  // namespace lithe::format
