// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/format/placement.h"

#include <gtest/gtest.h>

#include "random.h"

namespace lithe::format {
namespace {

TEST(Placement, EighthsRoundTheHalfUp) {
  EXPECT_EQ(eighths(8, 4), 4);
  EXPECT_EQ(eighths(1, 4), 1);    // 0.5
  EXPECT_EQ(eighths(-1, 4), 0);   // -0.5
  EXPECT_EQ(eighths(1, 3), 0);    // 0.375
  EXPECT_EQ(eighths(-1, 5), -1);  // -0.625
  EXPECT_EQ(eighths(-8, 8), -8);
  EXPECT_EQ(eighths(123456, 0), 0);
}

TEST(Placement, EighthsAreExactUpTo27Bits) {
  constexpr int32_t kMost = (1 << 27) - 1;
  for (int32_t t8 = 0; t8 <= 8; ++t8)
    for (int32_t d : {kMost, -kMost}) {
      const int64_t product = int64_t{t8} * d + 4;
      const int64_t expected = product >= 0 ? product / 8 : -((-product + 7) / 8);
      EXPECT_EQ(eighths(d, t8), expected) << d << " " << t8;
    }
}

TEST(Placement, LatticeStepIsAPowerOfTwoOfTheLargestSide) {
  EXPECT_EQ(latticeStep({0, 0, 0}, 0), 1);
  EXPECT_EQ(latticeStep({1, -1, 1}, 0), 1);
  EXPECT_EQ(latticeStep({0, -7, 0}, 0), 4);
  EXPECT_EQ(latticeStep({8, 0, 0}, 0), 8);
  EXPECT_EQ(latticeStep({3, -100, 20}, 2), 16);  // 100 / 4 = 25
  EXPECT_EQ(latticeStep({3, 20, 255}, 4), 8);    // 255 / 16 = 15
  EXPECT_EQ(latticeStep({65535, 65535, 65535}, 31), 1);
  EXPECT_EQ(latticeStep({65535, 65535, 65535}, 30), 1);
}

TEST(Placement, StepIsWhatTheSpecificationSays) {
  for (uint32_t shift = 0; shift <= 31; ++shift)
    for (int32_t extent = 0; extent < 70000; extent = extent < 300 ? extent + 1 : extent * 9 / 8) {
      const int64_t wanted = shift == 31 ? 0 : extent >> shift;
      int64_t step = 1;
      while (step * 2 <= wanted) step *= 2;
      ASSERT_EQ(latticeStep({0, 0, -extent}, shift), step) << extent << " >> " << shift;
    }
}

TEST(Placement, PointBetweenLiesAtItsEighths) {
  const Int3 v{100, -100, 7}, d{16, 8, -3};
  const Int3 start = pointBetween(v, d, 0), end = pointBetween(v, d, 8), middle = pointBetween(v, d, 4);
  EXPECT_EQ(start.x, 100);
  EXPECT_EQ(start.y, -100);
  EXPECT_EQ(start.z, 7);
  EXPECT_EQ(end.x, 116);
  EXPECT_EQ(end.y, -92);
  EXPECT_EQ(end.z, 4);
  EXPECT_EQ(middle.x, 108);
  EXPECT_EQ(middle.y, -96);
  EXPECT_EQ(middle.z, 6);  // 5.5
}

// What makes a split undo a collapse: the reader's formula gives both children back, whichever of them is called u.
TEST(Placement, ChildrenFollowFromTheirParent) {
  test::Random random(2);
  const auto point = [&] { return Int3{random.between(0, 65535), random.between(0, 65535), random.between(0, 65535)}; };
  for (int i = 0; i < 20000; ++i) {
    const Int3 v = point(), u = i % 7 ? point() : Int3{v.x + random.between(-2, 2), v.y, v.z};
    const int32_t t8 = random.between(0, 8), k = random.between(-5, 5);
    const uint32_t shift = random.below(32);
    const Int3 d{u.x - v.x, u.y - v.y, u.z - v.z}, back{-d.x, -d.y, -d.z};
    const int32_t step = latticeStep(d, shift);
    ASSERT_EQ(step, latticeStep(back, shift));
    const Int3 w = pointBetween(v, d, t8), same = pointBetween(u, back, 8 - t8);
    ASSERT_TRUE(w.x == same.x && w.y == same.y && w.z == same.z);
    const int32_t parent = w.x + k * step, child_v = parent - k * step - eighths(d.x, t8);
    ASSERT_EQ(child_v, v.x);
    ASSERT_EQ(child_v + d.x, u.x);
  }
}

}  // namespace
}  // namespace lithe::format
