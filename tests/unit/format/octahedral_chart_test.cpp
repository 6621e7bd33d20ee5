// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/format/octahedral_chart.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>

namespace lithe::format {
namespace {

using Point = std::array<int32_t, 2>;

Point point(Int2 p) { return {p.x, p.y}; }

TEST(OctahedralChart, ThePoleIsTheLongestAxisTheLowestOfEqualOnes) {
  struct Case {
    int32_t v[3];
    uint32_t axis;
    int32_t sign;
  };
  for (const Case& c : {Case{{3, 2, -2}, 0, 1}, Case{{-3, 2, 2}, 0, -1}, Case{{2, -4, 3}, 1, -1}, Case{{1, 2, 4}, 2, 1},
                        Case{{3, -3, 1}, 0, 1}, Case{{1, -3, 3}, 1, -1}, Case{{0, 0, -7}, 2, -1}}) {
    const OctahedralChart chart(c.v, 7);
    EXPECT_EQ(chart.axis, c.axis);
    EXPECT_EQ(chart.sign, c.sign);
  }
}

TEST(OctahedralChart, AcrossAreTheOtherTwoAscending) {
  const int32_t x[3] = {1, 0, 0}, y[3] = {0, 1, 0}, z[3] = {0, 0, 1};
  const OctahedralChart charts[3] = {{x, 7}, {y, 7}, {z, 7}};
  const uint32_t expected[3][2] = {{1, 2}, {0, 2}, {0, 1}};
  for (int i = 0; i < 3; ++i)
    for (int c = 0; c < 2; ++c) EXPECT_EQ(charts[i].across[c], expected[i][c]);
}

// (-4, 2, 1) from the pole -x: 2 and 1 across. (-1, 4, 2) likewise; (3, 3, 1) is on the other side: folded outwards.
TEST(OctahedralChart, PointsSeenFromAnAxis) {
  constexpr int32_t c = 7;
  const int32_t pole[3] = {-1, 0, 0};
  const OctahedralChart chart(pole, c);
  const auto seen = [&](int32_t x, int32_t y, int32_t z) {
    const int32_t v[3] = {x, y, z};
    return point(chart.fromSquare(octahedralPointOf(v, c)));
  };
  EXPECT_EQ(seen(-7, 0, 0), (Point{c, c}));
  EXPECT_EQ(seen(-4, 2, 1), (Point{c + 2, c + 1}));
  EXPECT_EQ(seen(-1, 4, -2), (Point{c + 4, c - 2}));
  EXPECT_EQ(seen(3, 3, 1), (Point{c + 7 - 1, c + 7 - 3}));
}

TEST(OctahedralChart, EveryDirectionComesBack) {
  constexpr int32_t c = octahedralCenter(5);
  for (int32_t i = 0; i < 6; ++i) {
    int32_t pole[3] = {0, 0, 0};
    pole[i / 2] = i % 2 ? -1 : 1;
    const OctahedralChart chart(pole, c);
    for (int32_t y = 0; y <= 2 * c; ++y)
      for (int32_t x = 0; x <= 2 * c; ++x) {
        int32_t direction[3], back[3];
        octahedralDirection({x, y}, c, direction);
        octahedralDirection(chart.toSquare(chart.fromSquare({x, y})), c, back);
        for (int k = 0; k < 3; ++k) ASSERT_EQ(direction[k], back[k]) << x << " " << y << " pole " << i;
      }
  }
}

// A direction's own chart has it in the inner third of the diamond: what is near it is not folded.
TEST(OctahedralChart, ADirectionIsNearTheMiddleOfItsChart) {
  constexpr int32_t c = octahedralCenter(6);
  for (int32_t y = 0; y <= 2 * c; ++y)
    for (int32_t x = 0; x <= 2 * c; ++x) {
      const Int2 p = OctahedralChart::around({x, y}, c).fromSquare({x, y});
      ASSERT_LE(3 * (std::abs(p.x - c) + std::abs(p.y - c)), 2 * c) << x << " " << y;
    }
}

TEST(DirectionEighths, AreHalfWayUnlessFarApartOrFolded) {
  for (int32_t t8 = 0; t8 <= 8; ++t8) {
    EXPECT_EQ(directionEighths({5, -5}, t8, true, 7), 4);
    const int32_t child = t8 < 4 ? 0 : 8;
    EXPECT_EQ(directionEighths({6, 5}, t8, true, 7), t8 == 4 ? 0 : child);
    EXPECT_EQ(directionEighths({-6, -5}, t8, true, 7), child);
    EXPECT_EQ(directionEighths({3, -4}, t8, false, 7), t8 == 4 ? 0 : child);
    EXPECT_EQ(directionEighths({0, 1}, t8, false, 7), t8 == 4 ? 0 : child);
    EXPECT_EQ(directionEighths({0, -1}, t8, false, 7), child);
  }
}

// The parent (4, 2, 1) has its chart at +x; two steps along y apart, its children are a step away on either side.
TEST(SplitDirection, InTheParentsChart) {
  const int32_t parent[3] = {4, 2, 1}, first[3] = {3, 3, 1}, second[3] = {5, 1, 1};
  const ChildDirections children = splitDirection({octahedralPointOf(parent, 7), 7}, {2, 0}, 1, true);
  EXPECT_TRUE(children.valid);
  EXPECT_EQ(point(children.a), point(octahedralPointOf(first, 7)));
  EXPECT_EQ(point(children.b), point(octahedralPointOf(second, 7)));
}

TEST(SplitDirection, WithoutFacesTheParentIsTheNearerChilds) {
  const int32_t parent[3] = {4, 2, 1}, other[3] = {2, 4, 1};
  const Int2 p = octahedralPointOf(parent, 7);
  const ChildDirections at_b = splitDirection({p, 7}, {2, 0}, 1, false),
                        at_a = splitDirection({p, 7}, {-2, 0}, 7, false);
  EXPECT_EQ(point(at_b.b), point(p));
  EXPECT_EQ(point(at_b.a), point(octahedralPointOf(other, 7)));
  EXPECT_EQ(point(at_a.a), point(p));
  EXPECT_EQ(point(at_a.b), point(octahedralPointOf(other, 7)));
}

TEST(SplitDirection, ADifferenceBeyondEveryFoldIsRefused) {
  EXPECT_FALSE(splitDirection({{7, 7}, 7}, {60, 0}, 0, true).valid);
  EXPECT_FALSE(splitDirection({{7, 7}, 7}, {0, -60}, 8, true).valid);
}

}  // namespace
}  // namespace lithe::format
