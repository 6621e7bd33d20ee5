// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "edge_placer.h"

#include <gtest/gtest.h>

#include "fan.h"
#include "lithe/bake/skin_weights.h"
#include "meshes.h"

namespace lithe::bake {
namespace {

using namespace test;

constexpr double kRounding = 1e-9;  // of energies that are sums of about 1e-3: what floats leave

/// A bending tube's nodes with the quadrics of its triangles; edges of all kinds of skin to place.
struct Bench {
  explicit Bench(uint32_t shift = 5)
      : mesh(weldQuietly(tube(10, 16))),
        nodes{mesh.grid.bits, shift,      mesh.weight_one,           mesh.max_influences,
              mesh.positions, mesh.skins, poseMesh(mesh, palettes())},
        surface(mesh),
        placer(nodes) {
    surface.classifyEdges(nodes.posed);
  }

  static std::vector<std::vector<glm::dmat4>> palettes() {
    std::vector<std::vector<glm::dmat4>> result;
    for (const Pose& pose : bendingPoses(11, 110.0, 2.0)) result.push_back(pose.palette);
    return result;
  }

  void fillQuadric(uint32_t a, uint32_t b) {
    const uint32_t blocks = nodes.posed.blocks;
    std::vector<Symmetric> qa(blocks), qb(blocks);
    std::vector<FanFace> fan;
    gatherFan(surface, a, nodes.posed, EdgeWeights{SimplifyOptions{}}, fan);
    fanQuadric(fan, blocks, qa.data());
    gatherFan(surface, b, nodes.posed, EdgeWeights{SimplifyOptions{}}, fan);
    fanQuadric(fan, blocks, qb.data());
    combineLess({}, qa.data(), qb.data(), nodes.posed.at(a), nodes.posed.at(b), blocks, placer.quadric.data());
  }

  double energyOf(uint32_t a, const glm::ivec3& position, const QuantizedSkin& skin) const {
    const uint32_t blocks = nodes.posed.blocks;
    std::vector<Affine> storage(blocks);
    std::vector<PosedPoint> point(blocks);
    transformPoint(blendSkin(nodes.posed, skin, storage.data()), blocks, glm::vec3(position), point.data());
    return energy(placer.quadric.data(), nodes.posed.at(a), point.data(), blocks);
  }

  template <class Visit>
  void forEdges(const Visit& visit) {
    for (uint32_t id = 0; id < surface.faceCount(); id += 3) {
      const Face& face = surface.face(id);
      fillQuadric(face.corner[0], face.corner[1]);
      visit(face.corner[0], face.corner[1]);
    }
  }

  Mesh mesh;
  NodeState nodes;
  Surface surface;
  EdgePlacer placer;
};

TEST(EdgePlacer, NeverDoesWorseThanTheEndsAndTheMiddle) {
  Bench bench;
  bench.forEdges([&](uint32_t a, uint32_t b) {
    const Placement placement = bench.placer.placeFreely(a, b);
    const Segment segment(bench.nodes.positions[a], bench.nodes.positions[b], 5, bench.nodes.grid_bits);
    for (const int32_t t8 : {0, 4, 8}) {
      EXPECT_LE(placement.cost, bench.energyOf(a, segment.point(t8), bench.placer.skinBetween(a, b, t8)) + kRounding);
    }
    EXPECT_NEAR(placement.cost, bench.energyOf(a, placement.position, bench.placer.skinBetween(a, b, placement.t8)),
                kRounding);
  });
}

TEST(EdgePlacer, FindsNearlyTheBestPlaceOfTheLattice) {
  Bench bench;
  double found = 0.0, best_possible = 0.0;
  bench.forEdges([&](uint32_t a, uint32_t b) {
    const Placement placement = bench.placer.placeFreely(a, b);
    const Segment segment(bench.nodes.positions[a], bench.nodes.positions[b], 5, bench.nodes.grid_bits);
    double best = placement.cost;
    for (int32_t t8 = 0; t8 <= 8; ++t8) {
      const QuantizedSkin skin = bench.placer.skinBetween(a, b, t8);
      for (int32_t i = 0; i < 7 * 7 * 7; ++i) {
        const glm::ivec3 k(i % 7 - 3, i / 7 % 7 - 3, i / 49 - 3);
        const glm::ivec3 near = segment.snap(glm::dvec3(placement.position), t8) + k * segment.step;
        best = std::min(best, std::max(0.0, bench.energyOf(a, near, skin)));
      }
    }
    found += placement.cost;
    best_possible += best;
  });
  EXPECT_LE(found, 1.35 * best_possible);
}

TEST(EdgePlacer, AlternationLowersTheEnergyAndHoldsTheCap) {
  Bench bench;
  uint32_t improved = 0;
  bench.forEdges([&](uint32_t a, uint32_t b) {
    Placement placement = bench.placer.placeFreely(a, b);
    QuantizedSkin skin = bench.placer.skinBetween(a, b, placement.t8);
    const double before = placement.cost;
    bench.placer.optimizeSkin(a, b, 0.0, placement, skin);
    EXPECT_LE(placement.cost, before);
    EXPECT_NEAR(placement.cost, std::max(0.0, bench.energyOf(a, placement.position, skin)), kRounding);
    EXPECT_LE(skin.count, bench.nodes.max_influences);
    improved += placement.cost < before ? 1 : 0;
  });
  EXPECT_GT(improved, 10u);
}

TEST(EdgePlacer, AnEndHasItsOwnPlaceAndSkin) {
  Bench bench;
  bench.forEdges([&](uint32_t a, uint32_t b) {
    const Placement placement = bench.placer.placeAtEnd(a, b);
    ASSERT_TRUE(placement.t8 == 0 || placement.t8 == 8);
    const uint32_t end = placement.t8 == 0 ? a : b;
    EXPECT_EQ(placement.position, bench.nodes.positions[end]);
    EXPECT_EQ(bench.placer.skinBetween(a, b, placement.t8), bench.nodes.skins[end]);
  });
}

}  // namespace
}  // namespace lithe::bake
