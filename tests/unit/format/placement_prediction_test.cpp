// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/format/placement_prediction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <vector>

#include "random.h"

namespace lithe::format {
namespace {

// ---- Eighths by rank ----

TEST(EighthRank, NearestFirstAndOfEqualOnesTheGreater) {
  for (int32_t predicted = 0; predicted <= 8; ++predicted) {
    std::set<int32_t> seen;
    for (int32_t rank = 0; rank <= 8; ++rank) {
      const int32_t t8 = eighthOfRank(rank, predicted);
      ASSERT_TRUE(t8 >= 0 && t8 <= 8 && seen.insert(t8).second) << predicted << " " << rank;
      EXPECT_EQ(rankOfEighth(t8, predicted), rank);
      if (rank == 0) continue;
      const int32_t before = eighthOfRank(rank - 1, predicted);
      const int32_t distance = std::abs(t8 - predicted), distance_before = std::abs(before - predicted);
      EXPECT_TRUE(distance_before < distance || (distance_before == distance && before > t8)) << predicted << rank;
    }
  }
}

// ---- Where the planes put a parent ----

/// A fan around a split node at the origin: `side` of each of its faces, and the new faces' third nodes.
struct Patch {
  Int3 d{};
  std::vector<Int3> ring;      ///< closed; face i has ring[i] and ring[i + 1]
  std::vector<uint32_t> side;  ///< of face i

  uint32_t extent() const {
    int32_t low[3] = {}, high[3] = {};
    for (const Int3& p : ring) {
      const int32_t v[3] = {p.x, p.y, p.z};
      for (int c = 0; c < 3; ++c) low[c] = std::min(low[c], v[c]), high[c] = std::max(high[c], v[c]);
    }
    int32_t most = longest(d);
    for (int c = 0; c < 3; ++c) most = std::max(most, high[c] - low[c]);
    return static_cast<uint32_t>(most);
  }
  Int3 at(size_t i) const { return ring[i % ring.size()]; }

  PredictedPlacement predict() const {
    PlacementSums sums(d, extent());
    for (size_t i = 0; i < ring.size(); ++i) {
      sums.addFan(side[i], at(i), at(i + 1));
      if (side[i] != side[(i + 1) % ring.size()]) sums.addCut(at(i + 1), side[i] == 0);
    }
    return sums.solve();
  }

  /// The same in floating point and without shifts: where the planes are least distant, times their areas.
  std::vector<double> solveExactly() const {
    const double a[3] = {d.x / 2.0, d.y / 2.0, d.z / 2.0}, b[3] = {-a[0], -a[1], -a[2]};
    double m[3][4] = {};
    auto add = [&](const double* p, const double* q, const double* r) {
      double u[3], v[3];
      for (int c = 0; c < 3; ++c) u[c] = q[c] - p[c], v[c] = r[c] - p[c];
      const double n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) m[i][j] += n[i] * n[j];
        m[i][3] += n[i] * (n[0] * p[0] + n[1] * p[1] + n[2] * p[2]);
      }
    };
    for (size_t i = 0; i < ring.size(); ++i) {
      const double p[3] = {1.0 * at(i).x, 1.0 * at(i).y, 1.0 * at(i).z};
      const double q[3] = {1.0 * at(i + 1).x, 1.0 * at(i + 1).y, 1.0 * at(i + 1).z};
      add(side[i] ? b : a, p, q);
      if (side[i] != side[(i + 1) % ring.size()]) add(side[i] ? b : a, q, side[i] ? a : b);
    }
    const double hold = (m[0][0] + m[1][1] + m[2][2]) / 256.0;
    for (int i = 0; i < 3; ++i) m[i][i] += hold;
    for (int i = 0; i < 3; ++i)
      for (int r = 0; r < 3; ++r) {
        if (r == i) continue;
        const double factor = m[r][i] / m[i][i];
        for (int c = i; c < 4; ++c) m[r][c] -= factor * m[i][c];
      }
    return {m[0][3] / m[0][0], m[1][3] / m[1][1], m[2][3] / m[2][2]};
  }
};

/// A bent, uneven ring around an edge along `d`.
Patch randomPatch(test::Random& random, int32_t size) {
  Patch patch;
  const auto jitter = [&] { return random.between(-size / 5, size / 5); };
  patch.d = {size + jitter(), jitter(), jitter()};
  const uint32_t count = 4 + random.below(6);
  for (uint32_t i = 0; i < count; ++i) {
    const double angle = 6.283185307 * (i + 0.5 * random.unit()) / count;
    const auto x = static_cast<int32_t>(size * std::cos(angle)), y = static_cast<int32_t>(size * std::sin(angle));
    patch.ring.push_back({x + jitter(), y + jitter(), -(x * x + y * y) / (3 * size) + jitter()});
    const double middle = angle + 3.14159 / count;
    patch.side.push_back(std::cos(middle) < 0.0 ? 1u : 0u);
  }
  return patch;
}

TEST(PlacementPrediction, AgreesWithTheEquationInFloatingPoint) {
  test::Random random(4);
  for (int trial = 0; trial < 3000; ++trial) {
    const int32_t size = 40 + static_cast<int32_t>(random.octave(12000));
    const Patch patch = randomPatch(random, size);
    const PredictedPlacement found = patch.predict();
    const std::vector<double> x = patch.solveExactly();
    const double d[3] = {1.0 * patch.d.x, 1.0 * patch.d.y, 1.0 * patch.d.z};
    const double length2 = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    const double along = (x[0] * d[0] + x[1] * d[1] + x[2] * d[2]) / length2;
    EXPECT_NEAR(found.t8, std::clamp(4.0 + 8.0 * along, 0.0, 8.0), 0.5 + 0.2) << trial;
    for (int c = 0; c < 3; ++c) {
      ASSERT_GT(found.across[c].den, 0);
      const double offset = static_cast<double>(found.across[c].num) / static_cast<double>(found.across[c].den);
      EXPECT_NEAR(offset, x[static_cast<size_t>(c)] - along * d[c], 1.0 + 0.02 * size) << trial << " " << c;
    }
  }
}

TEST(PlacementPrediction, KnowsNothingOfAFlatPatchAndLittleWithoutFaces) {
  const Patch flat{{80, 0, 0}, {{100, 0, 0}, {0, 100, 0}, {-100, 0, 0}, {0, -100, 0}}, {0, 1, 1, 0}};
  const PredictedPlacement of_flat = flat.predict();
  EXPECT_EQ(of_flat.t8, 4);
  for (const Slope& offset : of_flat.across) EXPECT_EQ(latticeIndex(32, offset, 1), 0);
  const PredictedPlacement of_none = PlacementSums({80, 0, 0}, 80).solve();
  EXPECT_EQ(of_none.t8, 4);
  for (const Slope& offset : of_none.across) EXPECT_EQ(latticeIndex(32, offset, 1), 0);
}

TEST(PlacementPrediction, AParentLiesOutsideAConvexPatch) {
  // A roof along y: the children stand on its ridge, below which the ring lies. Planes of its slopes meet above.
  const Patch roof{
      {0, 64, 0},
      {{100, 0, -100}, {60, 120, -40}, {-60, 120, -40}, {-100, 0, -100}, {-60, -120, -40}, {60, -120, -40}},
      {0, 0, 0, 1, 1, 1}};
  const PredictedPlacement found = roof.predict();
  EXPECT_GT(latticeIndex(16, found.across[2], 1), 0);
}

TEST(PlacementPrediction, NoInputOverflows) {
  // What a hostile file can have at most: 66 faces between the grid's corners. Sums are held by the sanitizer.
  test::Random random(6);
  for (int trial = 0; trial < 2000; ++trial) {
    const auto end = [&] { return random.chance(50) ? 65535 : -65535; };
    PlacementSums sums({end(), end(), end()}, 2 * 65535u);
    for (int face = 0; face < 64; ++face) sums.addFan(random.below(2), {end(), end(), end()}, {end(), end(), end()});
    for (int cut = 0; cut < 2; ++cut) sums.addCut({end(), end(), end()}, cut == 0);
    const PredictedPlacement found = sums.solve();
    ASSERT_TRUE(found.t8 >= 0 && found.t8 <= 8);
    for (const Slope& offset : found.across)
      for (const int32_t step : {1, 32768}) ASSERT_LE(std::abs(latticeIndex(32, offset, step)), 1 << 17);
  }
}

TEST(PlacementPrediction, IndicesAreRoundedSharesOfTheOffset) {
  for (const int32_t strength : {0, 5, 16, 32})
    for (int64_t num = -700; num <= 700; num += 7)
      for (const int32_t step : {1, 4, 64}) {
        const double exact = strength / 16.0 * static_cast<double>(num) / 3.0 / step;
        EXPECT_EQ(latticeIndex(strength, {num, 3}, step), static_cast<int32_t>(std::floor(exact + 0.5)));
      }
  EXPECT_EQ(latticeIndex(16, {100, 0}, 1), 0);
}

}  // namespace
}  // namespace lithe::format
