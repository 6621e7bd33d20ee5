// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Normals and neighbours of a child's wedges, by hand and at the ends of their ranges.
#include "lithe/format/further_wedges.h"

#include <gtest/gtest.h>

namespace lithe::format {
namespace {

constexpr Int3 kChild{10, 10, 10};

void add(ChildCorners& corners, uint32_t wedge, uint32_t next, uint32_t previous, Int3 at_next, Int3 at_previous) {
  const uint32_t others[2] = {next, previous};
  const Int3 at[2] = {at_next, at_previous};
  ASSERT_TRUE(corners.add(wedge, others, at));
}

auto all = [](uint32_t) { return true; };

TEST(ChildCorners, NormalIsTheSumOverTheWedgesFaces) {
  ChildCorners corners;
  add(corners, 7, 1, 2, {12, 10, 10}, {10, 13, 10});
  add(corners, 8, 1, 2, {10, 10, 11}, {10, 11, 10});
  add(corners, 7, 2, 3, {10, 13, 10}, {9, 10, 10});
  const AreaNormal n = corners.normalOf(7, kChild);
  EXPECT_EQ(n.x, 0);
  EXPECT_EQ(n.y, 0);
  EXPECT_EQ(n.z, 6 + 3);
  EXPECT_FALSE(n.isZero());
  EXPECT_EQ(corners.normalOf(8, kChild).x, -1);
  EXPECT_TRUE(corners.normalOf(9, kChild).isZero());
  corners.clear();
  EXPECT_TRUE(corners.normalOf(7, kChild).isZero());
}

TEST(ChildCorners, NearestNeighbourIsAmongTheKnown) {
  ChildCorners corners;
  add(corners, 7, 3, 5, {14, 10, 10}, {10, 13, 10});
  add(corners, 7, 5, 4, {10, 13, 10}, {10, 10, 6});
  add(corners, 8, 6, 2, {10, 10, 11}, {10, 11, 10});
  EXPECT_EQ(corners.nearestTo(7, kChild, all), 5u);
  // Equally near: the lower.
  EXPECT_EQ(corners.nearestTo(7, kChild, [](uint32_t wedge) { return wedge != 5; }), 3u);
  EXPECT_EQ(corners.nearestTo(8, kChild, all), 2u);
  EXPECT_EQ(corners.nearestTo(7, kChild, [](uint32_t) { return false; }), kNoIndex);
  EXPECT_EQ(corners.nearestTo(9, kChild, all), kNoIndex);
}

TEST(ChildCorners, TooManyAreNone) {
  ChildCorners corners;
  for (uint32_t i = 0; i < kMaxRing; ++i) add(corners, 7, 1, 2, {12, 10, 10}, {10, 13, 10});
  EXPECT_EQ(corners.normalOf(7, kChild).z, 6 * static_cast<int64_t>(kMaxRing));
  const uint32_t others[2] = {1, 2};
  const Int3 at[2] = {{12, 10, 10}, {10, 13, 10}};
  EXPECT_FALSE(corners.add(7, others, at));
  EXPECT_TRUE(corners.normalOf(7, kChild).isZero());
  EXPECT_EQ(corners.nearestTo(7, kChild, all), kNoIndex);
}

TEST(ChildCorners, HoldTheLargestGrid) {
  ChildCorners corners;
  for (uint32_t i = 0; i < kMaxRing; ++i) add(corners, 7, 1, 2, {65535, 0, 65535}, {0, 65535, 65535});
  EXPECT_GT(octahedralPoint(corners.normalOf(7, {0, 0, 0}), 16383).x, -1);
  EXPECT_EQ(corners.nearestTo(7, {0, 0, 0}, all), 1u);
}

}  // namespace
}  // namespace lithe::format
