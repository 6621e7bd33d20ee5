// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// What differences are predicted from, by hand and at the ends of every range (the sanitizer build sees an overflow).
#include "lithe/format/prediction.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace lithe::format {
namespace {

int32_t meansDiffer(int64_t sum_a, int64_t count_a, int64_t sum_b, int64_t count_b, int32_t strength) {
  return scaled(strength, meanDifference(sum_a, count_a, sum_b, count_b));
}

TEST(Prediction, FloorDivideRoundsTowardsMinusInfinity) {
  EXPECT_EQ(floorDivide(7, 2), 3);
  EXPECT_EQ(floorDivide(-7, 2), -4);
  EXPECT_EQ(floorDivide(-8, 2), -4);
  EXPECT_EQ(floorDivide(-1, 1000), -1);
  EXPECT_EQ(floorDivide(0, 5), 0);
  for (int64_t b = 1; b <= 17; ++b)
    for (int64_t a = -200; a <= 200; ++a) {
      const int64_t q = floorDivide(a, b);
      ASSERT_TRUE(q * b <= a && a < (q + 1) * b) << a << " / " << b;
    }
}

TEST(Prediction, OfTheMeansIsTheirDifference) {
  // Means 10 and 4; all sixteen sixteenths, a half, none.
  EXPECT_EQ(meansDiffer(40, 4, 8, 2, 16), 6);
  EXPECT_EQ(meansDiffer(40, 4, 8, 2, 8), 3);
  EXPECT_EQ(meansDiffer(40, 4, 8, 2, 0), 0);
  EXPECT_EQ(meansDiffer(8, 2, 40, 4, 8), -3);
  EXPECT_EQ(meansDiffer(8, 2, 41, 4, 8), -4);  // -3.125
  EXPECT_EQ(meansDiffer(40, 4, 0, 0, 16), 0);
  EXPECT_EQ(meansDiffer(0, 0, 40, 4, 16), 0);
}

TEST(Prediction, OfTheMeansHoldsTheLargestFan) {
  // 2^18 corners at 2^16: the sums of 4.3 at their largest.
  constexpr int64_t kCount = 2 << 18, kSum = kCount * 65535;
  EXPECT_EQ(meansDiffer(kSum, kCount, 0, kCount, 32), 2 * 65535);
  EXPECT_EQ(meansDiffer(0, kCount, kSum, kCount, 32), -2 * 65535);
}

TEST(Prediction, IsHeldWithinWhatADifferenceCanBe) {
  EXPECT_EQ(scaled(16, {int64_t{1} << 40, 1}), 1 << 17);
  EXPECT_EQ(scaled(16, {-(int64_t{1} << 40), 1}), -(1 << 17));
  EXPECT_EQ(scaled(16, {5, 0}), 0);
  EXPECT_EQ(scaled(16, {5, -1}), 0);
}

/// An attribute that is linear in the position is predicted to within the damping of the diagonal.
TEST(Prediction, OfALinearFieldIsNearlyExact) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int32_t> coordinate(-300, 300), factor(-5, 5);
  for (int trial = 0; trial < 200; ++trial) {
    const int32_t field[3] = {factor(random), factor(random), factor(random)};
    const Int3 d{coordinate(random), coordinate(random), coordinate(random)};
    GradientSums sums;
    Moment moment;
    for (int i = 0; i < 12; ++i) {
      const Int3 r{coordinate(random), coordinate(random), coordinate(random)};
      sums.add(r);
      moment.add(r, field[0] * r.x + field[1] * r.y + field[2] * r.z);
    }
    const int32_t expected = field[0] * d.x + field[1] * d.y + field[2] * d.z;
    const int32_t found = scaled(16, solveGradient(sums, d).of(moment));
    EXPECT_NEAR(found, expected, 0.12 * (std::abs(field[0]) + std::abs(field[1]) + std::abs(field[2])) * 300 + 2);
  }
}

TEST(Prediction, WithoutNeighboursIsNothing) {
  EXPECT_EQ(scaled(16, solveGradient({}, {100, -50, 20}).of({})), 0);
  EXPECT_EQ(scaled(16, solveGradient({}, {0, 0, 0}).of({})), 0);
}

/// Neighbours on a line say nothing about what is across it.
TEST(Prediction, OfALineIsAlongIt) {
  GradientSums sums;
  Moment moment;
  for (int32_t x = -4; x <= 4; ++x) {
    const Int3 r{100 * x, 0, 0};
    sums.add(r);
    moment.add(r, 10 * x);
  }
  EXPECT_NEAR(scaled(16, solveGradient(sums, {200, 0, 0}).of(moment)), 20, 1);
  EXPECT_EQ(scaled(16, solveGradient(sums, {0, 300, 0}).of(moment)), 0);
}

/// 128 neighbours at the corners of the shifted range, attributes of 16 bits: nothing overflows.
TEST(Prediction, HoldsTheLargestRing) {
  for (int32_t reach : {1, 3, 1023, 1024}) {
    for (uint32_t signs = 0; signs < 8; ++signs) {
      const Int3 corner{signs & 1 ? reach : -reach, signs & 2 ? reach : -reach, signs & 4 ? reach : -reach};
      GradientSums line, cube;
      Moment along, spread;
      for (uint32_t i = 0; i < 128; ++i) {
        const Int3 r{i & 1 ? reach : -reach, i & 2 ? reach : -reach, i & 4 ? reach : -reach};
        line.add(corner);
        along.add(corner, 65535);
        cube.add(r);
        spread.add(r, i & 1 ? 65535 : -65535);
      }
      const int32_t of_line = scaled(32, solveGradient(line, corner).of(along));
      EXPECT_NEAR(of_line, 131070, 131070 / 20) << reach;
      const int32_t of_cube = scaled(16, solveGradient(cube, corner).of(spread));
      EXPECT_NEAR(of_cube, corner.x < 0 ? -65535 : 65535, 65535 / 8) << reach;
    }
  }
}

TEST(Prediction, PositionsAreShiftedToTenBits) {
  EXPECT_EQ(gradientShift(0), 0);
  EXPECT_EQ(gradientShift(1023), 0);
  EXPECT_EQ(gradientShift(1024), 1);
  EXPECT_EQ(gradientShift(65535), 6);
  EXPECT_EQ(shifted({1024, -1024, -1}, 1).x, 512);
  EXPECT_EQ(shifted({1024, -1024, -1}, 1).y, -512);
  EXPECT_EQ(shifted({1024, -1024, -1}, 1).z, -1);
}

TEST(Plane, AxisIsTheLongestAndTheFirstOfEquals) {
  EXPECT_EQ(Plane(3, -5, 4).axis, 1u);
  EXPECT_EQ(Plane(-2, 2, 2).axis, 0u);
  EXPECT_EQ(Plane(1, 1, 2).axis, 2u);
  EXPECT_EQ(Plane(0, 1, 1).axis, 1u);
}

/// v minus the height is a vector of the plane, to the nearest integer below.
TEST(Plane, HeightOfAVectorInThePlaneIsNothing) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int32_t> component(-1000, 1000);
  for (int trial = 0; trial < 1000; ++trial) {
    const int64_t n[3] = {component(random), component(random), component(random)};
    const Plane plane(n[0], n[1], n[2]);
    if (plane.den == 0) continue;
    const int64_t u = component(random), v = component(random);
    const double exact =
        -static_cast<double>(n[plane.across[0]] * u + n[plane.across[1]] * v) / static_cast<double>(n[plane.axis]);
    EXPECT_GE(exact + static_cast<double>(plane.lift(u, v)), -1.0);
    EXPECT_LE(exact + static_cast<double>(plane.lift(u, v)), 1e-9);
  }
  EXPECT_EQ(Plane(0, 0, 0).lift(5, -7), 0);
}

TEST(Plane, HoldsTheLargestVectors) {
  constexpr int64_t kLong = int64_t{1} << 43, kFar = int64_t{1} << 18;
  EXPECT_EQ(Plane(kLong, kLong, kLong).lift(kFar, kFar), 2 * kFar);
  EXPECT_EQ(Plane(-kLong, kLong, kLong).lift(kFar, kFar), -2 * kFar);
}

TEST(AreaNormal, IsTwiceTheArea) {
  AreaNormal normal;
  normal.add({0, 0, 0}, {3, 0, 0}, {0, 5, 0});
  EXPECT_EQ(normal.x, 0);
  EXPECT_EQ(normal.y, 0);
  EXPECT_EQ(normal.z, 15);
  normal.add({0, 0, 0}, {0, 5, 0}, {3, 0, 0});
  EXPECT_EQ(normal.z, 0);
}

/// Every direction of the grid comes back as its own point, whatever its length.
TEST(AreaNormal, OctahedralPointIsTheDirections) {
  for (const uint32_t bits : {4u, 7u}) {
    const int32_t center = octahedralCenter(bits);
    for (int32_t x = 0; x <= 2 * center; ++x)
      for (int32_t y = 0; y <= 2 * center; ++y)
        for (int64_t length : {int64_t{1}, int64_t{1} << 36}) {
          int32_t direction[3], back[3];
          octahedralDirection({x, y}, center, direction);
          const Int2 point =
              octahedralPoint({direction[0] * length, direction[1] * length, direction[2] * length}, center);
          octahedralDirection(point, center, back);
          ASSERT_TRUE(back[0] == direction[0] && back[1] == direction[1] && back[2] == direction[2])
              << x << " " << y << " became " << point.x << " " << point.y;
        }
  }
}

TEST(AreaNormal, DifferenceAcrossAFoldIsNothing) {
  const int32_t up[3] = {0, 0, 1}, along_x[3] = {1, 0, 0};
  const OctahedralChart chart(up, octahedralCenter(10));
  const Int2 near = normalDifference({1000, 0, 50}, {1000, 0, 100}, chart);
  EXPECT_GT(near.x, 0);
  EXPECT_EQ(near.y, 0);
  const Int2 across = normalDifference({-100, 5, -1000}, {100, 5, -1000}, chart);
  EXPECT_EQ(across.x, 0);
  EXPECT_EQ(across.y, 0);
  // From +x the same two are no fold apart where they lie: z is the chart's second axis.
  const Int2 seen = normalDifference({1000, 0, 50}, {1000, 0, 100}, OctahedralChart(along_x, octahedralCenter(10)));
  EXPECT_EQ(seen.x, 0);
  EXPECT_LT(seen.y, 0);
}

}  // namespace
}  // namespace lithe::format
