// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/nearest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "shapes.h"

namespace lithe::bake {
namespace {

using test::randomPoint;
using test::randomSoup;
using test::Shape;
using test::square;

glm::dvec3 pointAt(const Shape& shape, const NearestPoint& point) {
  const Triangle& t = shape.triangles[point.triangle];
  return shape.positions[t[0]] * point.barycentric.x + shape.positions[t[1]] * point.barycentric.y +
         shape.positions[t[2]] * point.barycentric.z;
}

/// The distance by another method than the library's: along edge ab the distance to the segment from c to the edge's
/// point has one minimum (the ball around the query meets a convex set), which ever finer scans close in on.
double distanceBySearch(const glm::dvec3& query, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const auto distanceToSegmentAt = [&](double t) {
    const glm::dvec3 from = glm::mix(a, b, t), edge = c - from;
    const double length2 = glm::dot(edge, edge);
    const double u = length2 > 0.0 ? std::clamp(glm::dot(query - from, edge) / length2, 0.0, 1.0) : 0.0;
    return glm::distance(query, from + edge * u);
  };
  double low = 0.0,
         high = 1.0;  // the distance to the segment from c to a point of ab is convex in the point? not always: scan
  double best = std::numeric_limits<double>::infinity(), best_t = 0.0;
  for (int pass = 0; pass < 12; ++pass) {
    const double step = (high - low) / 64;
    for (int i = 0; i <= 64; ++i) {
      const double t = std::clamp(low + i * step, 0.0, 1.0), distance = distanceToSegmentAt(t);
      if (distance < best) {
        best = distance;
        best_t = t;
      }
    }
    low = std::max(0.0, best_t - step);
    high = std::min(1.0, best_t + step);
  }
  return best;
}

double bruteForce(const Shape& shape, const glm::dvec3& query) {
  double best = std::numeric_limits<double>::infinity();
  for (const Triangle& t : shape.triangles) {
    best = std::min(best, distanceBySearch(query, shape.positions[t[0]], shape.positions[t[1]], shape.positions[t[2]]));
  }
  return best;
}

TEST(TriangleTree, AgreesWithBruteForceOverAllTriangles) {
  for (const uint32_t size : {1u, 3u, 40u, 300u}) {
    const Shape soup = randomSoup(size, size);
    const TriangleTree tree(soup.positions, soup.triangles);
    std::mt19937_64 random(7);
    for (int i = 0; i < 60; ++i) {
      const glm::dvec3 query = randomPoint(random, 1.5);
      const NearestPoint nearest = tree.nearest(query);
      EXPECT_NEAR(std::sqrt(nearest.distance2), bruteForce(soup, query), 1e-9) << size << " triangles, query " << i;
    }
  }
}

TEST(TriangleTree, TheNearestPointLiesOnItsTriangleAtTheStatedDistance) {
  const Shape soup = randomSoup(2000, 3);
  const TriangleTree tree(soup.positions, soup.triangles);
  std::mt19937_64 random(8);
  for (int i = 0; i < 500; ++i) {
    const glm::dvec3 query = randomPoint(random, 2.0);
    const NearestPoint nearest = tree.nearest(query);
    EXPECT_GE(std::min({nearest.barycentric.x, nearest.barycentric.y, nearest.barycentric.z}), 0.0);
    EXPECT_NEAR(nearest.barycentric.x + nearest.barycentric.y + nearest.barycentric.z, 1.0, 1e-12);
    EXPECT_NEAR(glm::distance(pointAt(soup, nearest), query), std::sqrt(nearest.distance2), 1e-12);
    EXPECT_NEAR(tree.distance2(query, nearest.triangle), nearest.distance2, 1e-15);
  }
}

TEST(TriangleTree, AHintChangesNoDistance) {
  const Shape soup = randomSoup(1000, 4);
  const TriangleTree tree(soup.positions, soup.triangles);
  std::mt19937_64 random(9);
  for (uint32_t i = 0; i < 300; ++i) {
    const glm::dvec3 query = randomPoint(random, 1.2);
    EXPECT_EQ(tree.nearest(query, (i * 37) % 1000).distance2, tree.nearest(query).distance2);
  }
}

TEST(TriangleTree, FindsTheOnlyTriangleFromFarAndNear) {
  const std::vector<glm::dvec3> corners{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
  const std::vector<Triangle> one{{0, 1, 2}};
  const TriangleTree tree(corners, one);
  EXPECT_DOUBLE_EQ(tree.nearest({0.5, 0.5, 3}).distance2, 9.0);  // above the face
  EXPECT_DOUBLE_EQ(tree.nearest({1, -4, 3}).distance2, 25.0);    // beside an edge
  EXPECT_DOUBLE_EQ(tree.nearest({-2, -3, 6}).distance2, 49.0);   // beyond a corner
  EXPECT_NEAR(tree.nearest({1e9, 1e9, 0}).distance2, 2 * 999999999.0 * 999999999.0, 1e3);
}

TEST(TriangleTree, NearestWithinReportsAllTrianglesAtASharedVertexInOrder) {
  const Shape shape = square(1.0, 0.0, 2);
  const TriangleTree tree(shape.positions, shape.triangles);
  std::vector<NearestPoint> found;
  tree.nearestWithin({0.5, 0.5, 0.25}, 1e-9, found);
  ASSERT_EQ(found.size(), 6u);  // the middle vertex of a 2 x 2 grid with equal diagonals
  for (size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i].distance2, 0.0625, 1e-15);
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end(), [](const NearestPoint& a, const NearestPoint& b) {
    return a.distance2 < b.distance2 || (a.distance2 == b.distance2 && a.triangle < b.triangle);
  }));
  tree.nearestWithin({0.5, 0.5, 0.25}, 10.0, found, 3);
  EXPECT_EQ(found.size(), 8u);
}

TEST(TriangleTree, ManyEqualTrianglesBuildAndTieToTheFirst) {
  Shape shape = square(1.0, 0.0, 1);
  shape.triangles.assign(5000, shape.triangles[0]);
  const TriangleTree tree(shape.positions, shape.triangles);
  EXPECT_EQ(tree.nearest({0.9, 0.1, 1.0}).triangle, 0u);
}

TEST(TriangleTree, MovedItAnswersAsOneBuiltThere) {
  const Shape soup = randomSoup(800, 12);
  TriangleTree moved(soup.positions, soup.triangles);
  Shape bent = soup;
  for (glm::dvec3& p : bent.positions) p = {p.x + 0.4 * p.z * p.z, 1.5 * p.y, p.z - 0.3 * p.x};
  moved.move(bent.positions, bent.triangles);
  const TriangleTree built(bent.positions, bent.triangles);
  std::mt19937_64 random(13);
  for (int i = 0; i < 300; ++i) {
    const glm::dvec3 query = randomPoint(random, 1.5);
    EXPECT_EQ(moved.nearest(query).distance2, built.nearest(query).distance2);
    EXPECT_EQ(moved.nearest(query).triangle, built.nearest(query).triangle);
  }
}

TEST(FarthestVertex, DoesNotDependOnWhatIsSaidToBeNear) {
  const Shape a = randomSoup(400, 31), b = randomSoup(400, 32);
  const TriangleTree tree(b.positions, b.triangles);
  double largest2 = 0.0;
  for (const Triangle& t : a.triangles)
    for (const uint32_t vertex : t) largest2 = std::max(largest2, tree.nearest(a.positions[vertex]).distance2);
  const double expected = std::sqrt(largest2);
  EXPECT_EQ(farthestVertex(a.positions, a.triangles, tree, 0.0), expected);
  const std::vector<uint32_t> some{3, 99, 17, 300};
  const auto bad = [&](uint32_t vertex) { return std::span<const uint32_t>(some).subspan(vertex % 4); };
  EXPECT_EQ(farthestVertex(a.positions, a.triangles, tree, 0.0, bad), expected);
  const auto none = [](uint32_t) { return std::span<const uint32_t>(); };
  EXPECT_EQ(farthestVertex(a.positions, a.triangles, tree, 0.5 * expected, none), expected);
  EXPECT_EQ(farthestVertex(a.positions, a.triangles, tree, 2.0 * expected, bad), 2.0 * expected);
  EXPECT_EQ(sampledDistance(a.positions, a.triangles, tree, 500, 3, bad).rms,
            sampledDistance(a.positions, a.triangles, tree, 500, 3).rms);
}

TEST(SurfaceSampling, FollowsTheArea) {
  Shape shape = square(1.0, 0.0, 1);  // one large triangle pair, and one pair of a quarter of the area
  const Shape small = square(0.5, 1.0, 1);
  for (const Triangle& t : small.triangles) shape.triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
  shape.positions.insert(shape.positions.end(), small.positions.begin(), small.positions.end());
  std::array<uint32_t, 4> count{};
  for (const SurfaceSample& sample : sampleSurface(shape.positions, shape.triangles, 10000, 5))
    ++count[sample.triangle];
  // Strata: at most one sample of difference per border between triangles.
  EXPECT_NEAR(count[0], 4000, 1);
  EXPECT_NEAR(count[1], 4000, 1);
  EXPECT_NEAR(count[2], 1000, 1);
  EXPECT_NEAR(count[3], 1000, 1);
}

TEST(SurfaceSampling, IsUniformInsideATriangle) {
  const std::vector<glm::dvec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<Triangle> one{{0, 1, 2}};
  constexpr uint32_t kCount = 200000;
  std::array<double, 4> quarter{};  // the four congruent triangles between edge midpoints
  glm::dvec3 mean(0.0);
  for (const SurfaceSample& sample : sampleSurface(corners, one, kCount, 11)) {
    const glm::dvec3& w = sample.barycentric;
    ++quarter[w.x > 0.5 ? 0 : w.y > 0.5 ? 1 : w.z > 0.5 ? 2 : 3];
    mean += w / static_cast<double>(kCount);
  }
  for (const double count : quarter) EXPECT_NEAR(count / kCount, 0.25, 0.005);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(mean[k], 1.0 / 3.0, 0.003);
}

TEST(SurfaceSampling, ASurfaceWithoutAreaIsSampledOverItsTriangles) {
  const std::vector<glm::dvec3> points{{0, 0, 0}, {1, 0, 0}};
  const std::vector<Triangle> flat{{0, 0, 0}, {1, 1, 1}};
  std::array<uint32_t, 2> count{};
  for (const SurfaceSample& sample : sampleSurface(points, flat, 100, 1)) ++count[sample.triangle];
  EXPECT_EQ(count[0], 50u);
  EXPECT_EQ(count[1], 50u);
}

TEST(SurfaceDistance, OfASurfaceFromItselfIsZero) {
  const Shape soup = randomSoup(500, 6);
  const SurfaceDistances d = surfaceDistances(soup.positions, soup.triangles, soup.positions, soup.triangles, 5000, 1);
  EXPECT_LT(d.symmetric.rms, 1e-12);
  EXPECT_LT(d.symmetric.max, 1e-12);
}

TEST(SurfaceDistance, OfParallelPlanesIsTheirOffset) {
  const Shape a = square(3.0, 0.0, 7), b = square(3.0, 0.25, 4);
  const SurfaceDistances d = surfaceDistances(a.positions, a.triangles, b.positions, b.triangles, 3000, 2);
  for (const SurfaceDistance& side : {d.a_to_b, d.b_to_a, d.symmetric}) {
    EXPECT_NEAR(side.rms, 0.25, 1e-12);
    EXPECT_NEAR(side.mean, 0.25, 1e-12);
    EXPECT_NEAR(side.max, 0.25, 1e-12);
    EXPECT_NEAR(side.p999, 0.25, 1e-12);
  }
}

TEST(SurfaceDistance, IsOneSidedAndTheSymmetricOneIsTheLarger) {
  const Shape small = square(1.0, 0.0, 2), large = square(2.0, 0.0, 2);
  const SurfaceDistances d =
      surfaceDistances(small.positions, small.triangles, large.positions, large.triangles, 40000, 3);
  EXPECT_LT(d.a_to_b.max, 1e-12);
  EXPECT_DOUBLE_EQ(d.b_to_a.max, std::sqrt(2.0));  // the far corner, a vertex
  // Over the 2 x 2 square: the strips contribute 2 * 1/3, the corner square 2/3, of an area of 4.
  EXPECT_NEAR(d.b_to_a.rms, std::sqrt((2.0 / 3.0 + 2.0 / 3.0) / 4.0), 0.003);
  EXPECT_DOUBLE_EQ(d.symmetric.max, d.b_to_a.max);
  EXPECT_DOUBLE_EQ(d.symmetric.rms, d.b_to_a.rms);
}

TEST(SurfaceDistance, TheHausdorffDistanceSeesASpikeThatNoSampleHits) {
  Shape plane = square(1.0, 0.0, 1), spiked = square(1.0, 0.0, 1);
  spiked.positions.push_back({0.5, 0.5, 0.7});
  spiked.positions.push_back({0.5, 0.5, 0.7});
  spiked.triangles.push_back({0, 4, 5});  // without area
  const SurfaceDistance d =
      surfaceDistance(spiked.positions, spiked.triangles, plane.positions, plane.triangles, 1000, 4);
  EXPECT_DOUBLE_EQ(d.max, 0.7);
  EXPECT_LT(d.p999, 1e-12);
}

TEST(SurfaceDistance, ThePercentileLeavesOutTheLastThousandth) {
  // 0.15 % of the area lies far away: the 99.9th percentile sees it, a 99.8th would not.
  Shape near = square(1.0, 0.0, 1);
  const Shape patch = square(std::sqrt(0.0015), 0.5, 1);
  Shape with_patch = near;
  for (const Triangle& t : patch.triangles) with_patch.triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
  with_patch.positions.insert(with_patch.positions.end(), patch.positions.begin(), patch.positions.end());
  const auto measure = [&](const Shape& shape) {
    return surfaceDistance(shape.positions, shape.triangles, near.positions, near.triangles, 20000, 5);
  };
  EXPECT_NEAR(measure(with_patch).p999, 0.5, 1e-12);
  EXPECT_LT(measure(near).p999, 1e-12);
}

TEST(SurfaceDistance, DependsOnTheSeedAndNothingElse) {
  const Shape a = randomSoup(300, 20), b = randomSoup(300, 21);
  const auto rms = [&](uint64_t seed) {
    return surfaceDistance(a.positions, a.triangles, b.positions, b.triangles, 2000, seed).rms;
  };
  EXPECT_EQ(rms(1), rms(1));
  EXPECT_NE(rms(1), rms(2));
  EXPECT_NEAR(rms(1), rms(2), 0.05 * rms(1));
}

}  // namespace
}  // namespace lithe::bake
