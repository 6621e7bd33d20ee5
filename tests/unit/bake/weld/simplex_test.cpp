// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/simplex.h"

#include <gtest/gtest.h>

#include <random>

namespace lithe::bake {
namespace {

WeightObjective randomObjective(std::mt19937& random, uint32_t size, uint32_t rank) {
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  WeightObjective objective;
  objective.size = size;
  for (uint32_t r = 0; r < rank; ++r) {
    std::array<double, kMaxSimplexSize> column{};
    const double target = uniform(random);
    for (uint32_t i = 0; i < size; ++i) column[i] = uniform(random);
    for (uint32_t i = 0; i < size; ++i) {
      objective.h[i] -= target * column[i];
      for (uint32_t k = 0; k < size; ++k) objective.H[i][k] += column[i] * column[k];
    }
  }
  return objective;
}

SimplexWeights uniformStart(uint32_t size) {
  SimplexWeights start{};
  for (uint32_t i = 0; i < size; ++i) start[i] = 1.0 / size;
  return start;
}

TEST(Simplex, AgreesWithAFineSearchOfTheTriangle) {
  std::mt19937 random(3);
  for (int run = 0; run < 60; ++run) {
    const WeightObjective objective = randomObjective(random, 3, 1 + run % 4);
    const double found = objectiveValue(objective, minimizeOnSimplex(objective, uniformStart(3), 1e-9));
    double best = 1e300;
    constexpr int kSteps = 400;
    for (int i = 0; i <= kSteps; ++i) {
      for (int k = 0; i + k <= kSteps; ++k) {
        SimplexWeights a{};
        a[0] = double(i) / kSteps;
        a[1] = double(k) / kSteps;
        a[2] = double(kSteps - i - k) / kSteps;
        best = std::min(best, objectiveValue(objective, a));
      }
    }
    EXPECT_LE(found, best + 1e-7);
    EXPECT_GE(found, best - 2e-4);
  }
}

TEST(Simplex, StaysOnTheSimplexAndNeverRises) {
  std::mt19937 random(4);
  for (int run = 0; run < 300; ++run) {
    const uint32_t size = 1 + run % 16;
    const WeightObjective objective = randomObjective(random, size, 1 + run % 5);
    const SimplexWeights start = uniformStart(size);
    const SimplexWeights a = minimizeOnSimplex(objective, start, naturalProximity(objective));
    double sum = 0.0;
    for (uint32_t i = 0; i < size; ++i) {
      EXPECT_GE(a[i], 0.0);
      sum += a[i];
    }
    EXPECT_NEAR(sum, 1.0, 1e-9);
    EXPECT_LE(objectiveValue(objective, a), objectiveValue(objective, start) + 1e-9);
  }
}

TEST(Simplex, ProximityPicksTheNearestOfEqualMinimisers) {
  WeightObjective objective;  // joints 0 and 1 do the same, joint 2 hurts
  objective.size = 3;
  objective.H[2][2] = 1.0;
  SimplexWeights start{0.7, 0.1, 0.2};
  const SimplexWeights a = minimizeOnSimplex(objective, start, 1e-6);
  EXPECT_NEAR(a[2], 0.0, 1e-5);
  EXPECT_NEAR(a[0] - a[1], 0.6, 1e-5);
}

TEST(Simplex, CapIsHeldAndRefined) {
  std::mt19937 random(9);
  for (int run = 0; run < 100; ++run) {
    const WeightObjective objective = randomObjective(random, 8, 10);
    const SimplexWeights a = minimizeOnSimplexCapped(objective, uniformStart(8), naturalProximity(objective), 2);
    uint32_t above_zero = 0, first = 8, second = 8;
    for (uint32_t i = 0; i < 8; ++i) {
      if (a[i] == 0.0) continue;
      (above_zero++ == 0 ? first : second) = i;
    }
    ASSERT_GE(above_zero, 1u);
    ASSERT_LE(above_zero, 2u);
    if (above_zero == 1) continue;
    for (int step = 0; step <= 100; ++step) {  // no better share of the same two joints
      SimplexWeights other{};
      other[first] = step / 100.0;
      other[second] = 1.0 - other[first];
      EXPECT_LE(objectiveValue(objective, a), objectiveValue(objective, other) + 1e-3);
    }
  }
}

// Where nothing moves in any pose the objective is nothing but rounding errors, of either sign or zero.
TEST(Simplex, AnObjectiveOfRoundingErrorsStillHasWeights) {
  for (double diagonal : {0.0, -1e-9, 1e-20})
    for (double linear : {0.0, -2.12788771e-14, 1e-3})
      for (uint32_t size : {1u, 3u}) {
        WeightObjective objective;
        objective.size = size;
        for (uint32_t i = 0; i < size; ++i) {
          objective.H[i][i] = diagonal;
          objective.h[i] = linear * (1.0 - double(i));
        }
        const double proximity = naturalProximity(objective);
        ASSERT_GT(proximity, 0.0);
        const SimplexWeights start = {size == 1 ? 1.0 : 0.5, 0.25, 0.25};
        for (uint32_t cap = 1; cap <= size; ++cap) {
          const SimplexWeights weights = minimizeOnSimplexCapped(objective, start, proximity, cap);
          double sum = 0.0;
          for (uint32_t i = 0; i < size; ++i) {
            EXPECT_GE(weights[i], 0.0);
            sum += weights[i];
          }
          EXPECT_NEAR(sum, 1.0, 1e-6) << diagonal << " " << linear << " " << size << " " << cap;
        }
      }
}

}  // namespace
}  // namespace lithe::bake
