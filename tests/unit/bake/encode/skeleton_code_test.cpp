// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "skeleton_code.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lithe/bake/model.h"
#include "lithe/format/file.h"
#include "random.h"

namespace lithe::bake {
namespace {

double unit(lithe::test::Random& random) { return 2e-6 * random.below(1000001) - 1.0; }

glm::dmat3 randomMatrix(lithe::test::Random& random) {
  glm::dmat3 matrix;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) matrix[c][r] = unit(random);
  return matrix;
}

/// What a reader makes of the matrix.
glm::dmat3 readBack(const glm::dmat3& matrix, ScalePool* pool) {
  const RotationAndScale parts = rotationAndScale(matrix);
  const StoredRotation stored = storedRotation(parts.rotation);
  const StoredScale& scale = pool->all()[pool->add(parts.scale)];
  const double left_square = 1.0 - glm::dot(stored.kept, stored.kept);
  std::array<double, 4> q = {};
  for (uint32_t i = 0, from = 0; i < 4; ++i)
    q[i] = i == stored.left_out ? std::sqrt(left_square) : stored.kept[static_cast<int>(from++)];
  const glm::dmat3 upper({scale[0], 0, 0}, {scale[3], scale[1], 0}, {scale[4], scale[5], scale[2]});
  return glm::mat3_cast(glm::dquat(q[3], q[0], q[1], q[2])) * upper;
}

void expectNear(const glm::dmat3& a, const glm::dmat3& b, double tolerance) {
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) EXPECT_NEAR(a[c][r], b[c][r], tolerance) << c << r;
}

TEST(SkeletonCode, AnyMatrixIsReadBack) {
  lithe::test::Random random(3);
  ScalePool pool;
  for (int i = 0; i < 2000; ++i) {
    const glm::dmat3 matrix = randomMatrix(random);
    expectNear(readBack(matrix, &pool), matrix, 6e-6);
  }
}

TEST(SkeletonCode, MirroredFlatAndEmptyMatricesAreReadBack) {
  ScalePool pool;
  const glm::dvec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), zero(0);
  for (const glm::dmat3& matrix :
       {glm::dmat3(x, y, -z), glm::dmat3(-x, y, z), glm::dmat3(x, x, z), glm::dmat3(zero, y, z), glm::dmat3(x, zero, x),
        glm::dmat3(zero, zero, z), glm::dmat3(zero, zero, zero), glm::dmat3(x, y, x + y)})
    expectNear(readBack(matrix, &pool), matrix, 1e-6);
}

TEST(SkeletonCode, RotationsShareOneScale) {
  lithe::test::Random random(4);
  ScalePool pool;
  for (int i = 0; i < 200; ++i) {
    const glm::dquat q = glm::normalize(glm::dquat(unit(random), unit(random), unit(random), 1.5));
    // Products of single precision matrices are off by this much.
    expectNear(readBack(glm::dmat3(glm::mat3(glm::mat3_cast(q))), &pool), glm::mat3_cast(q), 2e-6);
  }
  EXPECT_EQ(pool.all().size(), 1u);
}

TEST(SkeletonCode, TheLargestComponentIsLeftOutAndPositive) {
  const StoredRotation identity = storedRotation(glm::dquat(-1, 0, 0, 0));
  EXPECT_EQ(identity.left_out, 3u);
  EXPECT_EQ(identity.kept, glm::dvec3(0.0));
  const StoredRotation about_y = storedRotation(glm::dquat(0.6, 0.0, -0.8, 0.0));
  EXPECT_EQ(about_y.left_out, 1u);
  EXPECT_EQ(about_y.kept, glm::dvec3(0.0, 0.0, -0.6));
  EXPECT_EQ(storedRotation(glm::dquat(0, 0, 0, 0)).left_out, 3u) << "no rotation";
}

TEST(SkeletonCode, ScalesThatDifferByRoundingAreOne) {
  ScalePool pool;
  const uint32_t one = pool.add(glm::dvec3(1.0 + 0x1p-22)), other = pool.add(glm::dvec3(1.0, 1.0, 1.0 + 0x1p-16));
  EXPECT_NE(one, other);
  EXPECT_EQ(pool.add(glm::dvec3(1.0)), one);
  EXPECT_EQ(pool.all()[one], (StoredScale{1, 1, 1, 0, 0, 0}));
  EXPECT_EQ(pool.all()[other][2], 1.0f + 0x1p-16f);
}

TEST(SkeletonCode, NodesTakeNoShear) {
  ScalePool pool;
  const uint32_t sheared = pool.add({2.0, 2.0, 2.0, 0x1p-24, 0.0, 0.0});
  EXPECT_NE(pool.add(glm::dvec3(2.0)), sheared);
}

TEST(SkeletonCode, TooManyScalesAreRefused) {
  ScalePool pool;
  for (uint32_t i = 0; i < format::limits::kScales; ++i) pool.add(glm::dvec3(1.0, 1.0, 1.0 + i));
  EXPECT_THROW(pool.add(glm::dvec3(2.0)), Error);
  EXPECT_EQ(pool.add(glm::dvec3(1.0)), 0u);
}

}  // namespace
}  // namespace lithe::bake
