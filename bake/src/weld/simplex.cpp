// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/simplex.h"

#include <algorithm>
#include <cmath>

namespace lithe::bake {

namespace {

/// The joints whose weight is free to move, ascending.
struct FreeSet {
  uint32_t count = 0;
  std::array<uint32_t, kMaxSimplexSize> index{};

  void remove(uint32_t position) {
    for (uint32_t i = position + 1; i < count; ++i) index[i - 1] = index[i];
    --count;
  }
  void insert(uint32_t joint) {
    uint32_t position = count++;
    for (; position > 0 && index[position - 1] > joint; --position) index[position] = index[position - 1];
    index[position] = joint;
  }
};

using Matrix = std::array<std::array<double, kMaxSimplexSize>, kMaxSimplexSize>;

/// L L^T of the free block plus the proximal term, which keeps every pivot positive.
Matrix factorize(const WeightObjective& objective, const FreeSet& free, double proximity) {
  Matrix L{};
  for (uint32_t i = 0; i < free.count; ++i) {
    for (uint32_t j = 0; j <= i; ++j) {
      double sum = objective.H[free.index[i]][free.index[j]] + (i == j ? proximity : 0.0);
      for (uint32_t k = 0; k < j; ++k) sum -= L[i][k] * L[j][k];
      L[i][j] = i == j ? std::sqrt(std::max(sum, 0.5 * proximity)) : sum / L[j][j];
    }
  }
  return L;
}

void solve(const Matrix& L, uint32_t n, SimplexWeights& x) {
  for (uint32_t i = 0; i < n; ++i) {
    for (uint32_t k = 0; k < i; ++k) x[i] -= L[i][k] * x[k];
    x[i] /= L[i][i];
  }
  for (uint32_t i = n; i-- > 0;) {
    for (uint32_t k = i + 1; k < n; ++k) x[i] -= L[k][i] * x[k];
    x[i] /= L[i][i];
  }
}

/// Minimiser on the plane sum a = 1 of the free joints; `multiplier` is half the gradient common to them.
SimplexWeights minimizeOnPlane(const WeightObjective& objective, const SimplexWeights& start, double proximity,
                               const FreeSet& free, double& multiplier) {
  const Matrix L = factorize(objective, free, proximity);
  SimplexWeights unconstrained{}, ones{};
  for (uint32_t i = 0; i < free.count; ++i) {
    unconstrained[i] = proximity * start[free.index[i]] - objective.h[free.index[i]];
    ones[i] = 1.0;
  }
  solve(L, free.count, unconstrained);
  solve(L, free.count, ones);
  double sum_unconstrained = 0.0, sum_ones = 0.0;
  for (uint32_t i = 0; i < free.count; ++i) {
    sum_unconstrained += unconstrained[i];
    sum_ones += ones[i];
  }
  multiplier = (1.0 - sum_unconstrained) / sum_ones;
  SimplexWeights weights{};
  for (uint32_t i = 0; i < free.count; ++i) weights[free.index[i]] = unconstrained[i] + multiplier * ones[i];
  return weights;
}

/// Walks from `a` towards `target` until a free weight reaches zero; returns its position in the free set, or count.
uint32_t walkToBorder(const FreeSet& free, const SimplexWeights& target, SimplexWeights& a) {
  double step = 1.0;
  uint32_t blocking = free.count;
  for (uint32_t i = 0; i < free.count; ++i) {
    const uint32_t joint = free.index[i];
    if (target[joint] >= 0.0) continue;
    const double reach = a[joint] / (a[joint] - target[joint]);
    if (reach < step) {
      step = reach;
      blocking = i;
    }
  }
  for (uint32_t i = 0; i < free.count; ++i) {
    const uint32_t joint = free.index[i];
    a[joint] = std::max(0.0, a[joint] + step * (target[joint] - a[joint]));
  }
  return blocking;
}

/// Joint at zero whose weight should grow: the most negative reduced gradient, or size when none is.
uint32_t mostWanted(const WeightObjective& objective, const SimplexWeights& start, double proximity,
                    const SimplexWeights& a, double multiplier, double tolerance) {
  uint32_t wanted = objective.size;
  double most = -tolerance;
  for (uint32_t i = 0; i < objective.size; ++i) {
    if (a[i] > 0.0) continue;
    double gradient = objective.h[i] - proximity * start[i] - multiplier;
    for (uint32_t k = 0; k < objective.size; ++k) gradient += objective.H[i][k] * a[k];
    if (gradient < most) {
      most = gradient;
      wanted = i;
    }
  }
  return wanted;
}

}  // namespace

double objectiveValue(const WeightObjective& objective, const SimplexWeights& weights) {
  double value = 0.0;
  for (uint32_t i = 0; i < objective.size; ++i) {
    double row = 2.0 * objective.h[i];
    for (uint32_t k = 0; k < objective.size; ++k) row += objective.H[i][k] * weights[k];
    value += row * weights[i];
  }
  return value;
}

double naturalProximity(const WeightObjective& objective) {
  // Where nothing moves, the diagonal is rounding errors, of either sign or zero, and so is h: the proximity must still
  // be positive, and large enough beside h for weights near 1 to be seen in a sum of h / proximity.
  double diagonal = 0.0, linear = 0.0;
  for (uint32_t i = 0; i < objective.size; ++i) {
    diagonal += std::abs(objective.H[i][i]);
    linear += std::abs(objective.h[i]);
  }
  return std::max(1e-4 * diagonal, 1e-9 * linear) / objective.size + 1e-30;
}

SimplexWeights minimizeOnSimplex(const WeightObjective& objective, const SimplexWeights& start, double proximity) {
  SimplexWeights a{};
  FreeSet free;
  for (uint32_t i = 0; i < objective.size; ++i) {
    a[i] = start[i];
    if (a[i] > 0.0) free.index[free.count++] = i;
  }
  // Each pass drops or adds one joint; the objective falls strictly between additions, so the bound is never the reason
  // to stop.
  for (uint32_t pass = 0; pass < 8 * kMaxSimplexSize; ++pass) {
    double multiplier = 0.0;
    const SimplexWeights target = minimizeOnPlane(objective, start, proximity, free, multiplier);
    const uint32_t blocking = walkToBorder(free, target, a);
    if (blocking < free.count) {
      a[free.index[blocking]] = 0.0;
      free.remove(blocking);
      continue;
    }
    const uint32_t wanted = mostWanted(objective, start, proximity, a, multiplier, 1e-9 * proximity);
    if (wanted == objective.size) break;
    free.insert(wanted);
  }
  return a;
}

SimplexWeights minimizeOnSimplexCapped(const WeightObjective& objective, const SimplexWeights& start, double proximity,
                                       uint32_t cap) {
  SimplexWeights a = minimizeOnSimplex(objective, start, proximity);
  std::array<uint32_t, kMaxSimplexSize> order{};
  uint32_t count = 0;
  for (uint32_t i = 0; i < objective.size; ++i) {
    if (a[i] > 0.0) order[count++] = i;
  }
  if (count <= cap) return a;
  std::stable_sort(order.begin(), order.begin() + count, [&](uint32_t x, uint32_t y) { return a[x] > a[y]; });
  std::sort(order.begin(), order.begin() + cap);

  WeightObjective kept;
  kept.size = cap;
  SimplexWeights kept_start{};
  double sum = 0.0;
  for (uint32_t i = 0; i < cap; ++i) sum += a[order[i]];
  for (uint32_t i = 0; i < cap; ++i) {
    kept_start[i] = a[order[i]] / sum;
    kept.h[i] = objective.h[order[i]];
    for (uint32_t k = 0; k < cap; ++k) kept.H[i][k] = objective.H[order[i]][order[k]];
  }
  const SimplexWeights refined = minimizeOnSimplex(kept, kept_start, proximity);
  SimplexWeights result{};
  for (uint32_t i = 0; i < cap; ++i) result[order[i]] = refined[i];
  return result;
}

}  // namespace lithe::bake
