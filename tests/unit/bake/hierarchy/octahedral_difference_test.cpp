// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/octahedral_difference.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lithe/format/placement.h"
#include "random.h"

namespace lithe::bake {
namespace {

using format::Int2;

bool same(Int2 p, Int2 q) { return p.x == q.x && p.y == q.y; }

/// A reader's two formulas (docs/format.md, 4.4).
std::pair<Int2, Int2> decoded(Int2 parent, Int2 d, const DirectionRule& rule) {
  const bool far = std::abs(d.x) + std::abs(d.y) > rule.center;
  const int32_t h = far || !rule.makes_faces ? rule.t8 : 4;
  const Int2 x{parent.x - format::eighths(d.x, h), parent.y - format::eighths(d.y, h)};
  return {format::octahedralFold(x, rule.center), format::octahedralFold({x.x + d.x, x.y + d.y}, rule.center)};
}

void expectDecodes(Int2 parent, Int2 b, Int2 a, const DirectionRule& rule) {
  const std::optional<Int2> d = octahedralDifference(parent, b, a, rule);
  ASSERT_TRUE(d.has_value()) << b.x << "," << b.y << " " << a.x << "," << a.y << " t8 " << rule.t8;
  const auto [of_b, of_a] = decoded(parent, *d, rule);
  ASSERT_TRUE(same(of_b, b) && same(of_a, a)) << b.x << "," << b.y << " " << a.x << "," << a.y << " t8 " << rule.t8;
}

DirectionRule plainly(int32_t t8, int32_t center = 7) { return {center, t8, false}; }

/// Whichever child comes first.
void expectDecodesFromEitherEnd(Int2 b, Int2 a, const DirectionRule& rule) {
  const Int2 parent = octahedralBetween(b, a, rule);
  ASSERT_TRUE(parent.x >= 0 && parent.x <= 2 * rule.center && parent.y >= 0 && parent.y <= 2 * rule.center);
  expectDecodes(parent, b, a, rule);
  expectDecodes(parent, a, b, {rule.center, 8 - rule.t8, rule.makes_faces});
}

TEST(OctahedralDifference, StraightWhereThatIsShort) {
  const Int2 b{4, 5}, a{8, 3}, parent = octahedralBetween(b, a, plainly(4));
  EXPECT_TRUE(same(parent, {6, 4}));
  const auto d = octahedralDifference(parent, b, a, plainly(4));
  ASSERT_TRUE(d.has_value());
  EXPECT_TRUE(same(*d, {4, -2}));
}

TEST(OctahedralDifference, OverTheFoldWhereThatIsShorter) {
  // (1, 9) is also (-1, 5) beyond the left edge: two steps from (1, 5) instead of four.
  const Int2 b{1, 5}, a{1, 9}, parent = octahedralBetween(b, a, plainly(4));
  EXPECT_TRUE(same(parent, {0, 5}));
  const auto d = octahedralDifference(parent, b, a, plainly(4));
  ASSERT_TRUE(d.has_value());
  EXPECT_TRUE(same(*d, {-2, 0}));
}

TEST(OctahedralDifference, OverTheFoldWithARoundingThatIsNoMirrorImage) {
  // Over the left edge: five steps; their middle lies beyond it and must be rounded as it lies inside.
  const Int2 b{1, 5}, a{4, 10}, parent = octahedralBetween(b, a, plainly(4));
  EXPECT_TRUE(same(parent, {2, 10}));  // from (-1, 9), the image of b, half of (5, 1) on
  const auto d = octahedralDifference(parent, b, a, plainly(4));
  ASSERT_TRUE(d.has_value());
  EXPECT_TRUE(same(*d, {5, 1}));
}

TEST(OctahedralDifference, HalfWayUnlessFarApartOrFolded) {
  const Int2 b{4, 5}, near{8, 3}, far{8, 1};
  for (int32_t t8 = 0; t8 <= 8; ++t8) {
    EXPECT_TRUE(same(octahedralBetween(b, near, {7, t8, true}), {6, 4})) << t8;
    EXPECT_TRUE(same(octahedralBetween(b, near, {7, t8, false}), octahedralBetween(b, near, plainly(t8)))) << t8;
    EXPECT_TRUE(same(octahedralBetween(b, far, {7, t8, true}), octahedralBetween(b, far, plainly(t8)))) << t8;
  }
  EXPECT_TRUE(same(octahedralBetween(b, near, plainly(0)), b));
  EXPECT_TRUE(same(octahedralBetween(b, far, {7, 8, true}), far));
}

TEST(OctahedralDifference, NothingWhenNoDifferenceFits) {
  // At t8 = 0 the parent is b.
  EXPECT_FALSE(octahedralDifference({7, 7}, {5, 5}, {6, 6}, plainly(0)).has_value());
  // At t8 = 8 it is a.
  EXPECT_FALSE(octahedralDifference({7, 7}, {7, 7}, {6, 6}, plainly(8)).has_value());
}

TEST(OctahedralDifference, EndsAreTheChildrenThemselves) {
  for (Int2 b : {Int2{0, 3}, Int2{7, 7}, Int2{14, 14}})
    for (Int2 a : {Int2{2, 2}, Int2{13, 7}}) {
      EXPECT_TRUE(same(octahedralBetween(b, a, plainly(0)), b));
      EXPECT_TRUE(same(octahedralBetween(b, a, plainly(8)), a));
    }
}

TEST(OctahedralDifference, EveryParentOfEveryPairCanBeSplitFromEitherEnd) {
  constexpr int32_t kCenter = 3, kSize = 2 * kCenter;
  for (int32_t i = 0; i < (kSize + 1) * (kSize + 1); ++i)
    for (int32_t j = 0; j < (kSize + 1) * (kSize + 1); ++j)
      for (int32_t t8 = 0; t8 <= 8; ++t8) {
        const Int2 b{i % (kSize + 1), i / (kSize + 1)}, a{j % (kSize + 1), j / (kSize + 1)};
        for (const bool makes_faces : {false, true}) expectDecodesFromEitherEnd(b, a, {kCenter, t8, makes_faces});
        if (HasFatalFailure()) return;
      }
}

TEST(OctahedralDifference, LikewiseInTheFinestSquare) {
  constexpr int32_t kCenter = format::octahedralCenter(15);
  test::Random random(3);
  for (int i = 0; i < 20000; ++i) {
    // Near each other, far apart, and on the border.
    const Int2 b{i % 3 ? random.between(0, 2 * kCenter) : 0, random.between(0, 2 * kCenter)};
    const Int2 a = i % 2 ? Int2{random.between(0, 2 * kCenter), random.between(0, 2 * kCenter)}
                         : format::octahedralFold({b.x + random.between(-9, 9), b.y + random.between(-9, 9)}, kCenter);
    expectDecodesFromEitherEnd(b, a, {kCenter, random.between(0, 8), i % 5 != 0});
    if (HasFatalFailure()) return;
  }
}

double angleBetween(Int2 p, Int2 q, int32_t center) {
  int32_t a[3], b[3];
  format::octahedralDirection(p, center, a);
  format::octahedralDirection(q, center, b);
  double dot = 0, aa = 0, bb = 0;
  for (int i = 0; i < 3; ++i) {
    dot += double(a[i]) * b[i];
    aa += double(a[i]) * a[i];
    bb += double(b[i]) * b[i];
  }
  return std::acos(std::min(1.0, dot / std::sqrt(aa * bb)));
}

// What the fold is for: a parent of two close directions is close to both, on the lower half's seams and at its corner
// too.
TEST(OctahedralDifference, ParentOfCloseDirectionsIsCloseToThem) {
  constexpr int32_t kCenter = format::octahedralCenter(10);
  test::Random random(4);
  for (int i = 0; i < 20000; ++i) {
    const Int2 b{i % 2 ? random.between(1, 12) : random.between(1, 2 * kCenter - 1),
                 i % 3 ? random.between(1, 2 * kCenter - 1) : random.between(1, 12)};
    const Int2 a = format::octahedralFold({b.x + random.between(-20, 20), b.y + random.between(-20, 20)}, kCenter);
    if (a.x % (2 * kCenter) == 0 || a.y % (2 * kCenter) == 0) continue;
    const Int2 parent = octahedralBetween(b, a, plainly(random.between(1, 7), kCenter));
    ASSERT_LT(angleBetween(parent, b, kCenter), 0.2) << b.x << "," << b.y << " " << a.x << "," << a.y;
    ASSERT_LT(angleBetween(parent, a, kCenter), 0.2) << b.x << "," << b.y << " " << a.x << "," << a.y;
  }
}

}  // namespace
}  // namespace lithe::bake
