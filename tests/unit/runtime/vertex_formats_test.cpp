// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "vertex_formats.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "random.h"

namespace lithe::runtime {
namespace {

double halfValue(uint16_t half) {
  const int exponent = half >> 10 & 31, fraction = half & 1023;
  const double magnitude = exponent == 31  ? (fraction ? std::nan("") : std::numeric_limits<double>::infinity())
                           : exponent == 0 ? std::ldexp(fraction, -24)
                                           : std::ldexp(1024 + fraction, exponent - 25);
  return half & 0x8000 ? -magnitude : magnitude;
}

TEST(Half, EveryHalfSurvives) {
  for (uint32_t half = 0; half < 65536; ++half) {
    const double value = halfValue(static_cast<uint16_t>(half));
    const uint16_t back = toHalf(static_cast<float>(value));
    if (std::isnan(value))
      EXPECT_TRUE(std::isnan(halfValue(back))) << half;
    else
      EXPECT_EQ(back, half);
  }
}

// Between every two neighbours: the middle goes to the even one, a float to either side of it to the nearer one.
TEST(Half, RoundsToNearestTiesToEven) {
  for (uint32_t half = 0; half < 0x7c00; ++half) {
    const double low = halfValue(static_cast<uint16_t>(half));
    const double high = half + 1 == 0x7c00 ? 65536.0 : halfValue(static_cast<uint16_t>(half + 1));
    const float middle = static_cast<float>((low + high) / 2);
    ASSERT_EQ(static_cast<double>(middle), (low + high) / 2);
    const uint32_t even = half % 2 ? half + 1 : half;
    EXPECT_EQ(toHalf(middle), even) << half;
    EXPECT_EQ(toHalf(std::nextafter(middle, 0.0f)), half);
    EXPECT_EQ(toHalf(std::nextafter(middle, 1e9f)), half + 1);
    EXPECT_EQ(toHalf(-middle), even | 0x8000);
  }
  EXPECT_EQ(toHalf(std::numeric_limits<float>::infinity()), 0x7c00);
  EXPECT_EQ(toHalf(std::numeric_limits<float>::max()), 0x7c00);
  EXPECT_EQ(toHalf(std::numeric_limits<float>::denorm_min()), 0);
  EXPECT_EQ(toHalf(-0.0f), 0x8000);
}

TEST(Octahedral, SnormIsTheNearestAndSymmetric) {
  for (uint32_t bits = 4; bits <= 15; ++bits) {
    const int32_t center = format::octahedralCenter(bits);
    for (int32_t grid = 0; grid <= 2 * center; ++grid) {
      const double exact = 32767.0 * (grid - center) / center;
      const int16_t snorm = octahedralSnorm16(grid, center);
      ASSERT_LE(std::abs(snorm - exact), 0.5) << bits << ' ' << grid;
      ASSERT_EQ(octahedralSnorm16(2 * center - grid, center), -snorm);
    }
    EXPECT_EQ(octahedralSnorm16(0, center), -32767);
    EXPECT_EQ(octahedralSnorm16(center, center), 0);
    EXPECT_EQ(octahedralSnorm16(2 * center, center), 32767);
  }
}

TEST(Octahedral, HandedSnormKeepsTheSignAndTheComponent) {
  for (uint32_t bits = 4; bits <= 15; ++bits) {
    const int32_t center = format::octahedralCenter(bits);
    for (int32_t grid = 0; grid <= 2 * center; ++grid)
      for (const bool positive : {false, true}) {
        const int16_t snorm = handedSnorm16(grid, center, positive);
        ASSERT_EQ(snorm > 0, positive);
        ASSERT_NE(snorm, 0);
        const double component = 2 * std::abs(snorm) / 32767.0 - 1;
        ASSERT_LE(std::abs(component - double(grid - center) / center), 2.0 / 32767) << bits << ' ' << grid;
      }
  }
}

TEST(Octahedral, UnitVectorsAreUnitAndDecodeLikeTheSnorm) {
  const int32_t center = format::octahedralCenter(10);
  for (int32_t y = 0; y <= 2 * center; y += 3)
    for (int32_t x = 0; x <= 2 * center; x += 3) {
      float unit[3];
      octahedralUnit(x, y, center, unit);
      ASSERT_NEAR(std::hypot(unit[0], unit[1], unit[2]), 1.0, 1e-6);
      double a = octahedralSnorm16(x, center) / 32767.0, b = octahedralSnorm16(y, center) / 32767.0;
      const double z = 1 - std::abs(a) - std::abs(b);
      if (z < 0) {
        const double folded = (1 - std::abs(b)) * (a < 0 ? -1 : 1);
        b = (1 - std::abs(a)) * (b < 0 ? -1 : 1);
        a = folded;
      }
      const double length = std::hypot(a, b, z);
      ASSERT_NEAR(a / length, unit[0], 1e-4);
      ASSERT_NEAR(b / length, unit[1], 1e-4);
      ASSERT_NEAR(z / length, unit[2], 1e-4);
    }
}

TEST(Unorm16, IsTheNearestAndRefusesWhatLiesOutside) {
  EXPECT_EQ(toUnorm16(0.0f), 0);
  EXPECT_EQ(toUnorm16(1.0f), 65535);
  EXPECT_EQ(toUnorm16(0.5f), 32768);
  EXPECT_EQ(toUnorm16(1.0f + 0.4f / 65535), 65535);
  EXPECT_GT(toUnorm16(1.0f + 0.6f / 65535), 65535);
  EXPECT_LT(toUnorm16(-0.6f / 65535), 0);
  EXPECT_LT(toUnorm16(1e30f), 0);
  EXPECT_LT(toUnorm16(std::nanf("")), 0);
}

// Sum exact, each within one step of its share, order kept.
TEST(Weights, RescaledSumExactlyForEveryPrecision) {
  test::Random random(7);
  for (uint32_t bits = 4; bits <= 16; ++bits)
    for (const uint32_t target : {255u, 65535u})
      for (uint32_t trial = 0; trial < 300; ++trial) {
        const uint32_t one = (1u << bits) - 1, count = 1 + random.below(8);
        std::vector<uint16_t> weights(count);
        uint32_t left = one;
        for (uint32_t i = 0; i < count; ++i) {
          const uint32_t weight = i + 1 == count ? left : random.below(left + 1);
          weights[i] = static_cast<uint16_t>(weight);
          left -= weight;
        }
        std::sort(weights.rbegin(), weights.rend());
        std::vector<uint16_t> scaled(count);
        rescaleWeights(weights.data(), count, one, target, scaled.data());
        ASSERT_EQ(std::accumulate(scaled.begin(), scaled.end(), 0u), target);
        ASSERT_TRUE(std::is_sorted(scaled.rbegin(), scaled.rend()));
        for (uint32_t i = 0; i < count; ++i) ASSERT_LT(std::abs(scaled[i] - double(weights[i]) * target / one), 1.0);
      }
}

TEST(Weights, EightBitsTimesTwoHundredFiftySevenIsSixteen) {
  const uint16_t weights[3] = {200, 54, 1};
  uint16_t scaled[3];
  rescaleWeights(weights, 3, 255, 65535, scaled);
  EXPECT_EQ(scaled[0], 200 * 257);
  EXPECT_EQ(scaled[1], 54 * 257);
  EXPECT_EQ(scaled[2], 257);
}

}  // namespace
}  // namespace lithe::runtime
