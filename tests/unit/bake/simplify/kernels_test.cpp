// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "kernels.h"

#include <gtest/gtest.h>

#include <cstring>

#include "kernel_templates.h"
#include "random.h"

namespace lithe::bake {
namespace {

Lanes randomLanes(lithe::test::Random& random, double extent) {
  Lanes lanes;
  for (uint32_t i = 0; i < kLanes; ++i) lanes[i] = static_cast<float>(extent * (2.0 * random.unit() - 1.0));
  return lanes;
}

PosedPoint randomPoint(lithe::test::Random& random, double extent = 1.0) {
  return {randomLanes(random, extent), randomLanes(random, extent), randomLanes(random, extent)};
}

ScalarLanes scalar(const Lanes& lanes) {
  ScalarLanes result;
  for (uint32_t i = 0; i < kLanes; ++i) result[i] = lanes[i];
  return result;
}

Vec3<ScalarLanes> scalar(const PosedPoint& p) { return {scalar(p.x), scalar(p.y), scalar(p.z)}; }

QuadricOf<ScalarLanes> scalar(const Quadric& q) {
  return {scalar(q.xx), scalar(q.xy), scalar(q.xz), scalar(q.yy), scalar(q.yz),
          scalar(q.zz), scalar(q.bx), scalar(q.by), scalar(q.bz), scalar(q.c)};
}

void expectSameBits(const Lanes& a, const ScalarLanes& b) {
  for (uint32_t i = 0; i < kLanes; ++i) {
    const float x = a[i], y = b[i];
    EXPECT_EQ(std::memcmp(&x, &y, sizeof x), 0) << x << " and " << y;
  }
}

Quadric randomQuadric(lithe::test::Random& random) {
  Quadric q{};
  for (int i = 0; i < 3; ++i) {
    addPlane(q, randomPoint(random), randomLanes(random, 0.3), randomLanes(random, 1.0) + 1.0f);
  }
  return q;
}

PosedPoint samePoint(float x, float y, float z) {
  const Lanes zero{};
  return {zero + x, zero + y, zero + z};
}

TEST(Kernels, FansMatchTheScalarSpecification) {
  lithe::test::Random random(1);
  for (int run = 0; run < 50; ++run) {
    PosedPoint corner = randomPoint(random), next = randomPoint(random), last = randomPoint(random);
    next.x[3] = corner.x[3];  // lane 3 has no area: its corners coincide
    next.y[3] = corner.y[3];
    next.z[3] = corner.z[3];
    const FanFace face{&corner, &next, &last, run % 2 ? 1.0f : 0.0f, run % 3 ? 0.1f : 0.0f};
    Symmetric fan;
    fanQuadric({&face, 1}, 1, &fan);
    SymmetricOf<ScalarLanes> expected{};
    addFanFace(expected, scalar(corner), scalar(next), scalar(last), face.next_weight, face.last_weight);
    expectSameBits(fan.xx, expected.xx);
    expectSameBits(fan.yz, expected.yz);
    expectSameBits(fan.zz, expected.zz);
    EXPECT_EQ(fan.xx[3], 0.0f);
  }
}

TEST(Kernels, EnergiesMatchTheScalarSpecification) {
  lithe::test::Random random(2);
  for (int run = 0; run < 50; ++run) {
    const Quadric q = randomQuadric(random);
    const PosedPoint origin = randomPoint(random), point = randomPoint(random);
    const float found = energy(&q, &origin, &point, 1);
    EXPECT_EQ(found, laneSum(energyAt(scalar(q), scalar(point) - scalar(origin)) + ScalarLanes{}));
  }
}

TEST(Kernels, WhatIsDoneTogetherIsWhatIsDoneApart) {
  lithe::test::Random random(12);
  for (int run = 0; run < 50; ++run) {
    const std::vector<Quadric> qa{randomQuadric(random), randomQuadric(random)};
    const std::vector<Quadric> qb{randomQuadric(random), randomQuadric(random)};
    const std::vector<PosedPoint> a{randomPoint(random), randomPoint(random)};
    const std::vector<PosedPoint> b{randomPoint(random), randomPoint(random)};
    const std::vector<PosedPoint> point{randomPoint(random), randomPoint(random)};
    const auto [of_a, of_b] = energies(qa.data(), qb.data(), a.data(), b.data(), point.data(), 2);
    EXPECT_EQ(of_a, energy(qa.data(), a.data(), point.data(), 2));
    EXPECT_EQ(of_b, energy(qb.data(), b.data(), point.data(), 2));

    const auto [here, there] = energiesAtEnds(qa.data(), a.data(), b.data(), 2);
    EXPECT_EQ(here, energy(qa.data(), a.data(), a.data(), 2));
    EXPECT_EQ(there, energy(qa.data(), a.data(), b.data(), 2));

    std::vector<Affine> blend(2);
    for (Affine& block : blend) {
      for (auto& row : block.m) {
        for (Lanes& entry : row) entry = randomLanes(random, 1.0);
      }
    }
    std::vector<PosedPoint> together(2), apart(2);
    const glm::vec3 place(3.0f, 4.0f, 5.0f);
    const float found = energyOfPlace(qa.data(), a.data(), blend.data(), place, 2, together.data());
    transformPoint(blend.data(), 2, place, apart.data());
    EXPECT_EQ(found, energy(qa.data(), a.data(), apart.data(), 2));
    EXPECT_EQ(std::memcmp(together.data(), apart.data(), 2 * sizeof(PosedPoint)), 0);
  }
}

TEST(Kernels, TheFacesBetweenTwoVerticesCountOnce) {
  lithe::test::Random random(13);
  const PosedPoint a = randomPoint(random), b = randomPoint(random), third = randomPoint(random);
  const FanFace at_a{&a, &b, &third}, at_b{&b, &third, &a};
  Symmetric qa, qb;
  fanQuadric({&at_a, 1}, 1, &qa);
  fanQuadric({&at_b, 1}, 1, &qb);
  Quadric once;
  combineLess({&at_a, 1}, &qa, &qb, &a, &b, 1, &once);
  const PosedPoint off = randomPoint(random);
  const Quadric expected = withoutLinearTerm(qa);
  EXPECT_NEAR(energy(&once, &a, &off, 1), energy(&expected, &a, &off, 1), 1e-3);
}

TEST(Kernels, NormalEquationsMatchTheScalarSpecification) {
  lithe::test::Random random(3);
  for (int run = 0; run < 50; ++run) {
    const Quadric q = randomQuadric(random);
    const PosedPoint origin = randomPoint(random), point = randomPoint(random);
    Affine blend;
    ScalarLanes m[3][4];
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) {
        blend.m[row][column] = randomLanes(random, 1.0);
        m[row][column] = scalar(blend.m[row][column]);
      }
    }
    const NormalEquations found = normalEquations(&q, &blend, &origin, &point, 1);
    NormalTerms<ScalarLanes> expected{};
    addNormalTerms(expected, scalar(q), m, scalar(point) - scalar(origin));
    EXPECT_EQ(found.xx, laneSum(expected.xx));
    EXPECT_EQ(found.yz, laneSum(expected.yz));
    EXPECT_EQ(found.gz, laneSum(expected.gz));
  }
}

TEST(Kernels, DistancesToFacesMatchTheScalarSpecification) {
  lithe::test::Random random(8);
  for (int run = 0; run < 50; ++run) {
    const PosedPoint corner[3] = {randomPoint(random), randomPoint(random), randomPoint(random)};
    const PosedPoint point = randomPoint(random);
    const auto squared = [](const PosedPoint& a, const PosedPoint& b) { return dot(b - a, b - a); };
    const FaceDistances face{
        {squared(point, corner[0]), squared(point, corner[1]), squared(point, corner[2])},
        {squared(corner[0], corner[1]), squared(corner[0], corner[2]), squared(corner[1], corner[2])}};
    FaceDistancesOf<ScalarLanes> expected;
    for (uint32_t k = 0; k < 3; ++k) {
      expected.to[k] = scalar(face.to[k]);
      expected.edge[k] = scalar(face.edge[k]);
    }
    Lanes found;
    float stored[kLanes];
    squaredDistancesToFaces({&face, 1}, stored);
    std::memcpy(&found, stored, sizeof found);
    expectSameBits(found, squaredDistanceToFace(expected));
  }
}

TEST(Kernels, DistancesToAFaceAreThoseToItsInsideEdgesAndCorners) {
  const PosedPoint corner[3] = {samePoint(0, 0, 0), samePoint(4, 0, 0), samePoint(0, 4, 0)};
  const auto distanceFrom = [&](const PosedPoint& point) {
    const PosedPoint* corners[3] = {&corner[0], &corner[1], &corner[2]};
    float to[3], edge[3] = {16.0f, 16.0f, 32.0f}, result[kLanes];
    squaredDistancesFrom(&point, corners, 1, to);
    FaceDistances face;
    for (uint32_t k = 0; k < 3; ++k) {
      face.to[k] = Lanes{} + to[k] / kLanes;
      face.edge[k] = Lanes{} + edge[k];
    }
    squaredDistancesToFaces({&face, 1}, result);
    return result[0];
  };
  EXPECT_NEAR(distanceFrom(samePoint(1, 1, 2)), 4.0f, 1e-4f);     // inside
  EXPECT_NEAR(distanceFrom(samePoint(2, -3, 0)), 9.0f, 1e-4f);    // an edge at corner 0
  EXPECT_NEAR(distanceFrom(samePoint(3, 3, 0)), 2.0f, 1e-4f);     // the edge opposite
  EXPECT_NEAR(distanceFrom(samePoint(-3, -4, 0)), 25.0f, 1e-4f);  // corner 0
  EXPECT_NEAR(distanceFrom(samePoint(5, -1, 1)), 3.0f, 1e-4f);    // corner 1
}

TEST(Kernels, AFaceCountsAThirdOfItsAreaAtEachCorner) {
  // Corners (0,0), (2,0), (0,3): area 3, in the plane z = 0.
  const PosedPoint a = samePoint(0, 0, 0), b = samePoint(2, 0, 0), c = samePoint(0, 3, 0);
  const FanFace face{&a, &b, &c};
  Symmetric fan;
  fanQuadric({&face, 1}, 1, &fan);
  EXPECT_FLOAT_EQ(fan.zz[0], 1.0f);
  EXPECT_EQ(fan.xx[0], 0.0f);
  EXPECT_EQ(fan.xy[0], 0.0f);
}

TEST(Kernels, ABorderEdgeCountsAQuarterOfItsSquaredLengthAtEachEnd) {
  const PosedPoint a = samePoint(0, 0, 0), b = samePoint(2, 0, 0), c = samePoint(0, 3, 0);
  const FanFace face{&a, &b, &c, 1.0f, 0.0f};  // the edge a-b, along x: its plane is y = 0
  Symmetric fan;
  fanQuadric({&face, 1}, 1, &fan);
  EXPECT_FLOAT_EQ(fan.yy[0], 1.0f);
  EXPECT_FLOAT_EQ(fan.zz[0], 1.0f);
  EXPECT_EQ(fan.xx[0], 0.0f);
}

TEST(Kernels, ShiftingAndSummingKeepTheFunction) {
  lithe::test::Random random(4);
  const Quadric qa = randomQuadric(random), qb = randomQuadric(random);
  const PosedPoint a = randomPoint(random), b = randomPoint(random), parent = randomPoint(random),
                   point = randomPoint(random);
  const float expected = energy(&qa, &a, &point, 1) + energy(&qb, &b, &point, 1);
  Quadric about_a, about_parent;
  combine(&qa, &qb, &a, &b, 1, &about_a);
  accumulate(&qa, &qb, &a, &b, &parent, 1, &about_parent);
  EXPECT_NEAR(energy(&about_a, &a, &point, 1), expected, 1e-4 * expected);
  EXPECT_NEAR(energy(&about_parent, &parent, &point, 1), expected, 1e-4 * expected);
}

TEST(Kernels, WeightTermsAreTheEnergyOfBlends) {
  lithe::test::Random random(5);
  const Quadric q = randomQuadric(random);
  const PosedPoint origin = randomPoint(random);
  const PosedPoint candidates[2] = {randomPoint(random), randomPoint(random)};
  double H[4], h[2];
  weightTerms(&q, &origin, candidates, 2, 1, H, h);
  const double constant = laneSum(q.c);
  for (const double w : {0.0, 0.25, 0.5, 1.0}) {
    const auto f = static_cast<float>(w);
    const PosedPoint blend{candidates[0].x * f + candidates[1].x * (1.0f - f),
                           candidates[0].y * f + candidates[1].y * (1.0f - f),
                           candidates[0].z * f + candidates[1].z * (1.0f - f)};
    const double v = 1.0 - w;
    const double quadratic = w * w * H[0] + 2.0 * w * v * H[1] + v * v * H[3] + 2.0 * (w * h[0] + v * h[1]) + constant;
    EXPECT_NEAR(quadratic, energy(&q, &origin, &blend, 1), 1e-3);
  }
}

TEST(Kernels, CountsThePosesInWhichATriangleTurnsOver) {
  const PosedPoint corner = samePoint(0, 0, 0), next = samePoint(1, 0, 0), last = samePoint(0, 1, 0);
  PosedPoint moved = samePoint(0.1f, 0.1f, 0.0f);
  const FanFace face{&corner, &next, &last};
  EXPECT_EQ(countFlips(face, &moved, 1), 0u);
  for (const uint32_t lane : {1u, 6u}) {
    moved.x[lane] = 2.0f;
    moved.y[lane] = 2.0f;
  }
  EXPECT_EQ(countFlips(face, &moved, 1), 2u);
}

}  // namespace
}  // namespace lithe::bake
