// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "silhouette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lithe/bake/compare.h"
#include "shapes.h"

namespace lithe::bake {
namespace {

using test::Shape;
using test::square;

double difference(const Shape& original, const Shape& simplified) {
  return silhouetteDifference(original.positions, original.triangles, simplified.positions, simplified.triangles);
}

Shape stretched(Shape shape, const glm::dvec3& factors, const glm::dvec3& offset = {}) {
  for (glm::dvec3& position : shape.positions) position = position * factors + offset;
  return shape;
}

Shape together(Shape a, const Shape& b) {
  const uint32_t first = static_cast<uint32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const Triangle& t : b.triangles) a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return a;
}

/// x to y, y to z, z to x: maps the icosahedron of the views onto itself.
Shape turned(Shape shape) {
  for (glm::dvec3& position : shape.positions) position = {position.z, position.x, position.y};
  return shape;
}

/// The unit cube, each face cells x cells quads.
Shape cube(uint32_t cells) {
  const Shape low = square(1.0, 0.0, cells), high = square(1.0, 1.0, cells);
  const Shape pair = together(low, high), side = turned(pair);
  return together(together(pair, side), turned(side));
}

TEST(Silhouette, ASurfaceCoversWhatItCovers) {
  EXPECT_EQ(difference(cube(1), cube(1)), 0.0);
  const Shape soup = test::randomSoup(300, 4);
  EXPECT_EQ(difference(soup, soup), 0.0);
}

TEST(Silhouette, TrianglesThatMeetLeaveNoCracks) {
  // Corners at thirds have no exact place on the grid.
  EXPECT_LT(difference(square(1.0, 0.0, 1), square(1.0, 0.0, 27)), 1e-4);
  EXPECT_LT(difference(square(1.0, 0.0, 27), square(1.0, 0.0, 1)), 1e-4);
  EXPECT_LT(difference(cube(1), cube(9)), 1e-4);
}

TEST(Silhouette, HalfASquareLacksHalfOfItInEveryView) {
  const Shape whole = square(1.0, 0.0, 4), half = stretched(whole, {0.5, 1, 1});
  EXPECT_NEAR(difference(whole, half), 0.5, 2e-3);
  EXPECT_NEAR(difference(half, whole), 1.0, 4e-3);
}

TEST(Silhouette, WhatIsLostAndWhatIsAddedBothCount) {
  const Shape whole = square(1.0, 0.0, 4);
  EXPECT_NEAR(difference(whole, stretched(whole, {1, 1, 1}, {0.25, 0, 0})), 0.5, 5e-3);
  EXPECT_NEAR(difference(whole, stretched(whole, {1.25, 1, 1})), 0.25, 2e-3);
}

TEST(Silhouette, ACubeIsSeenFromTheIcosahedronsVertices) {
  // The unit cube's shadow along a unit axis (x, y, z) has the area |x| + |y| + |z| (one face per coordinate), that of
  // a cube a fifth lower 0.8 (|x| + |z|) + |y|, and lies within it. The six axes have the same coordinates in turn.
  const double length = std::sqrt(1.0 + std::numbers::phi * std::numbers::phi);
  const double mean = (1.0 + std::numbers::phi) / length / 3.0;  // of each coordinate, over the views
  const double lost = 0.2 * 2.0 * mean / (3.0 * mean);
  EXPECT_NEAR(difference(cube(1), stretched(cube(1), {1, 0.8, 1})), lost, 2e-3);
}

TEST(Silhouette, DoesNotDependOnWhichAxisIsWhich) {
  const Shape soup = test::randomSoup(60, 2), other = stretched(soup, {1.0, 0.9, 1.1});
  const double share = difference(soup, other);
  EXPECT_GT(share, 0.03);
  EXPECT_NEAR(difference(turned(soup), turned(other)), share, 0.02 * share);
  EXPECT_NEAR(difference(turned(turned(soup)), turned(turned(other))), share, 0.02 * share);
  const Shape opposite = stretched(soup, {-1, -1, -1}), other_opposite = stretched(other, {-1, -1, -1});
  EXPECT_NEAR(difference(opposite, other_opposite), share, 0.02 * share);
}

TEST(Silhouette, DoesNotDependOnTheUnitOrThePlace) {
  const Shape whole = cube(2), other = stretched(whole, {1, 0.7, 0.9});
  const double share = difference(whole, other);
  const glm::dvec3 far(1e4, -3e4, 2e4), large(1e3);
  EXPECT_NEAR(difference(stretched(whole, large, far), stretched(other, large, far)), share, 1e-3);
}

TEST(Silhouette, SmallDifferencesAreNotLostBetweenThePixels) {
  // A twentieth of a pixel all around: seen where it crosses a pixel's centre, as often as it is wide.
  const Shape soup = test::randomSoup(300, 7);
  const double share = difference(soup, stretched(soup, glm::dvec3(1.0005)));
  EXPECT_GT(share, 1e-4);
  EXPECT_NEAR(difference(soup, stretched(soup, glm::dvec3(1.001))), 2.0 * share, 0.4 * share);
}

TEST(Silhouette, WhatIsFarAwayOrNowhereIsNoReasonToFail) {
  const Shape whole = cube(1);
  EXPECT_EQ(difference(whole, stretched(whole, glm::dvec3(1.0), {1e9, 0, 0})), 1.0);
  EXPECT_GT(difference(whole, stretched(whole, glm::dvec3(1e12), glm::dvec3(-5e11))), 1.0);
  const Shape point = stretched(whole, glm::dvec3(0.0)), line = stretched(whole, {1, 0, 0});
  EXPECT_EQ(difference(point, whole), 0.0);
  EXPECT_EQ(difference(line, line), 0.0);
  EXPECT_EQ(difference(line, whole), 1.0);
  EXPECT_EQ(difference(whole, point), 1.0);
}

TEST(Silhouette, IsPartOfTheReport) {
  // A tube at a quarter of its radius, in the rest pose: seen at an angle, most of its silhouette is gone.
  const Model original = test::tube(64, 16);
  Model thin = original;
  for (glm::vec3& position : thin.positions) position *= glm::vec3(0.25f, 0.25f, 1.0f);
  CompareOptions options;
  options.frames = 3;
  options.samples = 100;
  const CompareReport report = compare(original, thin, options);
  double sum = 0.0, largest = 0.0;
  for (const FrameReport& frame : report.frames) {
    EXPECT_GT(frame.silhouette, 0.6);
    EXPECT_LT(frame.silhouette, 0.8);
    sum += frame.silhouette;
    largest = std::max(largest, frame.silhouette);
  }
  EXPECT_DOUBLE_EQ(report.mean_silhouette, sum / 3.0);
  EXPECT_EQ(report.worst_silhouette, largest);
  EXPECT_EQ(compare(original, original, options).worst_silhouette, 0.0);
}

}  // namespace
}  // namespace lithe::bake
