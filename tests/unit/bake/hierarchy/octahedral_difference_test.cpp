// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/octahedral_difference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

#include "lithe/format/placement.h"
#include "lithe/format/prediction.h"
#include "random.h"

namespace lithe::bake {
namespace {

using format::Int2;

bool same(Int2 p, Int2 q) { return p.x == q.x && p.y == q.y; }

/// A direction with |x| + |y| + |z| = c, and its point.
using Direction = std::array<int32_t, 3>;

Direction directionOf(Int2 p, int32_t center) {
  int32_t d[3];
  format::octahedralDirection(p, center, d);
  return {d[0], d[1], d[2]};
}

Int2 pointOf(Direction d, int32_t center = 7) { return format::octahedralPointOf(d.data(), center); }

/// A reader's formulas (docs/format.md, 4.4), in whole directions.
std::pair<Int2, Int2> decoded(Int2 parent, Int2 d, const DirectionRule& rule) {
  const Direction p = directionOf(parent, rule.center);
  size_t m = 0;
  for (size_t i = 1; i < 3; ++i)
    if (std::abs(p[i]) > std::abs(p[m])) m = i;
  const int32_t sign = p[m] < 0 ? -1 : 1;
  const size_t u = m == 0 ? 1 : 0, v = m == 2 ? 1 : 2;
  const bool far = 2 * (std::abs(d.x) + std::abs(d.y)) > 3 * rule.center;
  int32_t h = 4;
  if (far || !rule.makes_faces) h = rule.t8 < 4 ? 0 : rule.t8 > 4 ? 8 : d.x > 0 || (d.x == 0 && d.y > 0) ? 0 : 8;
  const Int2 x{rule.center + p[u] - format::eighths(d.x, h), rule.center + p[v] - format::eighths(d.y, h)};
  auto turned = [&](Int2 q) {
    const Direction seen = directionOf(format::octahedralFold(q, rule.center), rule.center);
    Direction back{};
    back[u] = seen[0];
    back[v] = seen[1];
    back[m] = sign * seen[2];
    return pointOf(back, rule.center);
  };
  return {turned(x), turned({x.x + d.x, x.y + d.y})};
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

TEST(OctahedralDifference, HalfWayInTheChartOfTheParent) {
  // Around +z, around -y, and across the edge between +x and +y, where the square of +z has a fold's worth between
  // them.
  const struct {
    Direction b, a, parent;
    Int2 d;
  } cases[] = {{{-3, -1, 3}, {1, -3, 3}, {-1, -2, 4}, {4, -2}},
               {{1, -4, 2}, {-1, -4, -2}, {0, -7, 0}, {-2, -4}},
               {{4, 0, 3}, {0, 4, 3}, {2, 2, 3}, {-4, 4}},
               {{4, 3, 0}, {4, -3, 0}, {7, 0, 0}, {-6, 0}}};
  for (const auto& c : cases) {
    const DirectionRule rule{7, 4, true};
    const Int2 parent = octahedralBetween(pointOf(c.b), pointOf(c.a), rule);
    EXPECT_EQ(directionOf(parent, 7), c.parent);
    const auto d = octahedralDifference(parent, pointOf(c.b), pointOf(c.a), rule);
    ASSERT_TRUE(d.has_value());
    EXPECT_TRUE(same(*d, c.d)) << d->x << "," << d->y;
  }
}

TEST(OctahedralDifference, TheNearerChildWhereFarApartOrFolded) {
  const Int2 b = pointOf({5, 1, 1}), near = pointOf({3, 3, 1}), opposite = pointOf({-5, -1, -1});
  for (int32_t t8 = 0; t8 <= 8; ++t8) {
    if (t8 == 4) continue;
    EXPECT_TRUE(same(octahedralBetween(b, near, {7, t8, true}), pointOf({4, 2, 1}))) << t8;
    EXPECT_TRUE(same(octahedralBetween(b, near, {7, t8, false}), t8 < 4 ? b : near)) << t8;
    EXPECT_TRUE(same(octahedralBetween(b, opposite, {7, t8, true}), t8 < 4 ? b : opposite)) << t8;
  }
}

TEST(OctahedralDifference, NothingWhenNoDifferenceFits) {
  // At t8 = 0 the parent is b.
  EXPECT_FALSE(octahedralDifference({7, 7}, {5, 5}, {6, 6}, plainly(0)).has_value());
  // At t8 = 8 it is a.
  EXPECT_FALSE(octahedralDifference({7, 7}, {7, 7}, {6, 6}, plainly(8)).has_value());
}

std::vector<Int2> everyDirection(int32_t center) {
  std::vector<Int2> points;
  for (int32_t y = 0; y <= 2 * center; ++y)
    for (int32_t x = 0; x <= 2 * center; ++x)
      if (same(pointOf(directionOf({x, y}, center), center), {x, y})) points.push_back({x, y});
  return points;
}

TEST(OctahedralDifference, EveryParentOfEveryPairCanBeSplitFromEitherEnd) {
  for (const int32_t center : {3, 7})
    for (Int2 b : everyDirection(center))
      for (Int2 a : everyDirection(center))
        for (int32_t t8 = 0; t8 <= 8; ++t8) {
          expectDecodesFromEitherEnd(b, a, {center, t8, true});
          expectDecodesFromEitherEnd(b, a, {center, t8, false});
          if (HasFatalFailure()) return;
        }
}

TEST(OctahedralDifference, LikewiseInTheFinestSquare) {
  constexpr int32_t kCenter = format::octahedralCenter(15);
  test::Random random(3);
  auto canonical = [](Int2 p) { return pointOf(directionOf(format::octahedralFold(p, kCenter), kCenter), kCenter); };
  for (int i = 0; i < 20000; ++i) {
    // Near each other, far apart, and on the border.
    const Int2 b = canonical({i % 3 ? random.between(0, 2 * kCenter) : 0, random.between(0, 2 * kCenter)});
    const Int2 a = canonical(i % 2 ? Int2{random.between(0, 2 * kCenter), random.between(0, 2 * kCenter)}
                                   : Int2{b.x + random.between(-9, 9), b.y + random.between(-9, 9)});
    expectDecodesFromEitherEnd(b, a, {kCenter, random.between(0, 8), i % 5 != 0});
    if (HasFatalFailure()) return;
  }
}

glm::dvec3 unit(Int2 p, int32_t center) {
  const Direction d = directionOf(p, center);
  return glm::normalize(glm::dvec3(d[0], d[1], d[2]));
}

Int2 nearestPoint(const glm::dvec3& v, int32_t center) {
  const glm::i64vec3 n(1e6 * v);
  return pointOf(directionOf(format::octahedralPoint({n.x, n.y, n.z}, center), center), center);
}

double angleBetween(const glm::dvec3& p, const glm::dvec3& q) { return std::acos(std::min(1.0, glm::dot(p, q))); }

// What the charts are for: wherever two directions lie, their parent is close to half way between them on the sphere.
// The octahedron's faces are flat, so a wide arc's middle is not quite its middle.
TEST(OctahedralDifference, ParentIsHalfWayOnTheSphere) {
  constexpr int32_t kCenter = format::octahedralCenter(12);
  test::Random random(4);
  double worst = 0, sum = 0;
  int count = 0;
  for (int i = 0; i < 20000; ++i) {
    auto component = [&] { return random.between(-1000, 1000) / 1000.0; };
    const glm::dvec3 middle = glm::normalize(glm::dvec3(component(), component(), component()) + 1e-6);
    const glm::dvec3 away = 0.7 * glm::dvec3(component(), component(), component());
    const Int2 b = nearestPoint(middle + away, kCenter), a = nearestPoint(middle - away, kCenter);
    const glm::dvec3 at_b = unit(b, kCenter), at_a = unit(a, kCenter);
    const double arc = angleBetween(at_b, at_a);
    if (arc > 1.5 || arc < 0.02) continue;
    const Int2 parent = octahedralBetween(b, a, {kCenter, 2, true});
    if (same(parent, b) || same(parent, a)) continue;  // see FewParentsOfCloseDirectionsAreAChild
    const double off = angleBetween(unit(parent, kCenter), glm::normalize(at_b + at_a)) / arc;
    worst = std::max(worst, off);
    sum += off;
    ++count;
  }
  EXPECT_LT(worst, 1.0 / 3.0);
  EXPECT_LT(sum / count, 0.1);
}

// A middle that rounds into another chart has no parent there: then a child is the parent. That must stay rare.
TEST(OctahedralDifference, FewParentsOfCloseDirectionsAreAChild) {
  constexpr int32_t kCenter = format::octahedralCenter(10);
  test::Random random(5);
  int children = 0;
  constexpr int kPairs = 50000;
  for (int i = 0; i < kPairs; ++i) {
    const Int2 b{random.between(1, 2 * kCenter - 1), random.between(1, 2 * kCenter - 1)};
    const Int2 near = format::octahedralFold({b.x + random.between(4, 20), b.y + random.between(4, 20)}, kCenter);
    const Int2 a = pointOf(directionOf(near, kCenter), kCenter), parent = octahedralBetween(b, a, {kCenter, 2, true});
    children += same(parent, a) || same(parent, b);
  }
  EXPECT_LT(children, kPairs / 500);
}

}  // namespace
}  // namespace lithe::bake
