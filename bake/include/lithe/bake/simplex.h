// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The small quadratic program behind every choice of skin weights: least squares over weights >= 0 that sum to 1.
#pragma once

#include <array>
#include <cstdint>

namespace lithe::bake {

inline constexpr uint32_t kMaxSimplexSize = 16;  ///< the union of two skins of eight

/// a^T H a + 2 h^T a over the weights a of `size` joints.
struct WeightObjective {
  uint32_t size = 0;                                                     ///< [limit: 1..kMaxSimplexSize]
  std::array<std::array<double, kMaxSimplexSize>, kMaxSimplexSize> H{};  ///< symmetric, positive semidefinite
  std::array<double, kMaxSimplexSize> h{};
};

using SimplexWeights = std::array<double, kMaxSimplexSize>;

/// The objective's value; weights outside [0, size) are not read.
double objectiveValue(const WeightObjective& objective, const SimplexWeights& weights);

/// Minimises objective + proximity * |a - start|^2 subject to a >= 0, sum a = 1 with a primal active-set method.
/// @param start      a point of the simplex
/// @param proximity  > 0: what makes the answer unique where several joints explain the motion equally well
/// @return the minimiser; entries outside [0, size) are zero. Deterministic: ties go to the lower index.
SimplexWeights minimizeOnSimplex(const WeightObjective& objective, const SimplexWeights& start, double proximity);

/// The same with at most `cap` weights above zero: minimise, keep the `cap` largest, minimise again on those.
/// Not optimal over all subsets (Landreneau and Schaefer 2009, section 4), but near it at a fraction of the work.
SimplexWeights minimizeOnSimplexCapped(const WeightObjective& objective, const SimplexWeights& start, double proximity,
                                       uint32_t cap);

/// A proximity that suits the objective: 1e-4 of its mean diagonal, or 1e-9 of its mean |h| where that is more (an
/// objective of rounding errors); always positive.
double naturalProximity(const WeightObjective& objective);

}  // namespace lithe::bake
