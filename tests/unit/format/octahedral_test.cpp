// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/format/octahedral.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <map>
#include <set>

namespace lithe::format {
namespace {

using Direction = std::array<int32_t, 3>;

Direction directionOf(Int2 p, int32_t center) {
  int32_t d[3];
  octahedralDirection(p, center, d);
  return {d[0], d[1], d[2]};
}

TEST(Octahedral, CenterLeavesOnePointOnEitherSide) {
  EXPECT_EQ(octahedralCenter(4), 7);
  EXPECT_EQ(octahedralCenter(10), 511);
  EXPECT_EQ(octahedralCenter(15), 16383);
  for (uint32_t bits = 4; bits <= 15; ++bits) EXPECT_LT(2 * octahedralCenter(bits), 1 << bits);
}

TEST(Octahedral, AxesAreWhereThePaperPutsThem) {
  constexpr int32_t c = 7;
  EXPECT_EQ(directionOf({c, c}, c), (Direction{0, 0, c}));
  EXPECT_EQ(directionOf({2 * c, c}, c), (Direction{c, 0, 0}));
  EXPECT_EQ(directionOf({0, c}, c), (Direction{-c, 0, 0}));
  EXPECT_EQ(directionOf({c, 2 * c}, c), (Direction{0, c, 0}));
  EXPECT_EQ(directionOf({c, 0}, c), (Direction{0, -c, 0}));
  for (Int2 corner : {Int2{0, 0}, Int2{2 * c, 0}, Int2{0, 2 * c}, Int2{2 * c, 2 * c}})
    EXPECT_EQ(directionOf(corner, c), (Direction{0, 0, -c}));
}

TEST(Octahedral, LowerHalfIsFoldedOutwards) {
  // (1, 0.5): |a| + |b| - 1 = 0.5 below the equator; folded to (1 - 0.5, 1 - 1).
  EXPECT_EQ(directionOf({14, 7 + 4}, 7), (Direction{3, 0, -4}));
  // The sign of 0 counts as positive: on the fold line of the lower half.
  EXPECT_EQ(directionOf({7 - 5, 7 + 5}, 7), (Direction{-2, 2, -3}));
}

TEST(Octahedral, EveryPointIsADirectionOfLengthC) {
  for (uint32_t bits = 4; bits <= 7; ++bits) {
    const int32_t c = octahedralCenter(bits);
    for (int32_t y = 0; y <= 2 * c; ++y)
      for (int32_t x = 0; x <= 2 * c; ++x) {
        const Direction d = directionOf({x, y}, c);
        ASSERT_EQ(std::abs(d[0]) + std::abs(d[1]) + std::abs(d[2]), c) << x << " " << y;
      }
  }
}

// Inside the border every direction occurs once; on it the two halves of an edge are the same ones.
TEST(Octahedral, OnlyTheBorderRepeatsDirections) {
  const int32_t c = octahedralCenter(6), size = 2 * c;
  std::map<Direction, std::set<std::pair<int32_t, int32_t>>> points;
  for (int32_t y = 0; y <= size; ++y)
    for (int32_t x = 0; x <= size; ++x) points[directionOf({x, y}, c)].insert({x, y});
  for (const auto& [direction, at] : points)
    for (const auto& [x, y] : at) {
      const bool border = x == 0 || x == size || y == 0 || y == size;
      if (!border) {
        ASSERT_EQ(at.size(), 1u) << x << " " << y;
      } else if (x == 0 || x == size) {
        ASSERT_TRUE(at.count({x, size - y})) << x << " " << y;
      } else {
        ASSERT_TRUE(at.count({size - x, y})) << x << " " << y;
      }
    }
}

TEST(Octahedral, FoldLeavesTheSquareAlone) {
  const int32_t c = octahedralCenter(5);
  for (int32_t y = 0; y <= 2 * c; ++y)
    for (int32_t x = 0; x <= 2 * c; ++x) {
      const Int2 p = octahedralFold({x, y}, c);
      ASSERT_TRUE(p.x == x && p.y == y);
    }
}

TEST(Octahedral, FoldTurnsAboutTheMiddleOfTheEdge) {
  constexpr int32_t c = 7;
  const auto folded = [](int32_t x, int32_t y) {
    const Int2 p = octahedralFold({x, y}, c);
    return std::array<int32_t, 2>{p.x, p.y};
  };
  EXPECT_EQ(folded(-3, 5), (std::array<int32_t, 2>{3, 9}));
  EXPECT_EQ(folded(16, 5), (std::array<int32_t, 2>{12, 9}));
  EXPECT_EQ(folded(5, -3), (std::array<int32_t, 2>{9, 3}));
  EXPECT_EQ(folded(5, 16), (std::array<int32_t, 2>{9, 12}));
  EXPECT_EQ(folded(-2, -3), (std::array<int32_t, 2>{12, 11}));  // (2, 17), then (12, 11)
}

// A step over the border goes on to the neighbouring direction: the fold is the sphere's own continuation.
TEST(Octahedral, FoldContinuesTheSphere) {
  const int32_t c = octahedralCenter(8), size = 2 * c;
  for (int32_t along = 0; along <= size; ++along)
    for (const auto& [inside, outside] :
         {std::pair{Int2{0, along}, Int2{-1, along}}, std::pair{Int2{size, along}, Int2{size + 1, along}},
          std::pair{Int2{along, 0}, Int2{along, -1}}, std::pair{Int2{along, size}, Int2{along, size + 1}}}) {
      const Direction a = directionOf(inside, c), b = directionOf(octahedralFold(outside, c), c);
      for (size_t i = 0; i < 3; ++i) ASSERT_LE(std::abs(a[i] - b[i]), 2) << along;
    }
}

// A sum of a point and a difference of two points lies at most one square away, in any direction.
TEST(Octahedral, FoldBringsEveryPointOneSquareAwayBack) {
  const int32_t c = octahedralCenter(4), size = 2 * c;
  for (int32_t y = -size; y <= 2 * size; ++y)
    for (int32_t x = -size; x <= 2 * size; ++x) {
      const Int2 p = octahedralFold({x, y}, c);
      ASSERT_TRUE(p.x >= 0 && p.x <= size && p.y >= 0 && p.y <= size) << x << " " << y;
    }
}

TEST(Octahedral, PointsOfDirections) {
  for (const int32_t c : {octahedralCenter(4), octahedralCenter(6)})
    for (int32_t y = 0; y <= 2 * c; ++y)
      for (int32_t x = 0; x <= 2 * c; ++x) {
        const Direction direction = directionOf({x, y}, c);
        const Int2 p = octahedralPointOf(direction.data(), c);
        ASSERT_EQ(directionOf(p, c), direction) << x << " " << y;
        const bool border = x == 0 || x == 2 * c || y == 0 || y == 2 * c;
        if (!border) {
          ASSERT_TRUE(p.x == x && p.y == y) << x << " " << y;
        }
      }
}

TEST(Octahedral, OfTwoBorderPointsTheOneOnThePositiveHalf) {
  const auto point = [](Direction d) {
    const Int2 p = octahedralPointOf(d.data(), 7);
    return std::array<int32_t, 2>{p.x, p.y};
  };
  EXPECT_EQ(point({3, 0, -4}), (std::array<int32_t, 2>{14, 11}));
  EXPECT_EQ(point({0, -3, -4}), (std::array<int32_t, 2>{11, 0}));
  EXPECT_EQ(point({0, 0, -7}), (std::array<int32_t, 2>{14, 14}));
}

}  // namespace
}  // namespace lithe::format
