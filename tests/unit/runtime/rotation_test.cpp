// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "rotation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lithe::runtime {
namespace {

TEST(Rotation, TheComponentLeftOutComplementsTheOthers) {
  const float kept[3] = {0.5f, -0.5f, 0.5f};
  for (uint32_t left_out = 0; left_out < 4; ++left_out) {
    float q[4];
    wholeRotation(left_out, kept, q);
    for (uint32_t i = 0; i < 4; ++i)
      EXPECT_EQ(q[i], i == left_out ? 0.5f : kept[i < left_out ? i : i - 1]) << left_out << i;
  }
}

TEST(Rotation, RoundingLeavesNoSquareRootOfLessThanNothing) {
  const float kept[3] = {1.0f, 1e-4f, 0.0f};
  float q[4];
  wholeRotation(3, kept, q);
  EXPECT_EQ(q[3], 0.0f);
}

TEST(Rotation, MatrixIsRotationTimesUpperTriangle) {
  const float half = std::sqrt(0.5f), about_z[4] = {0, 0, half, half};  // x to y, y to -x
  const float scale[6] = {2, 3, 5, 7, 11, 13}, translation[3] = {1, 2, 3};
  float rows[12];
  matrixOf(about_z, scale, translation, rows);
  const float expected[12] = {0, -3, -13, 1, 2, 7, 11, 2, 0, 0, 5, 3};
  for (int i = 0; i < 12; ++i) EXPECT_NEAR(rows[i], expected[i], 2e-6f) << i;
}

}  // namespace
}  // namespace lithe::runtime
