// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "refit.h"

#include <gtest/gtest.h>

#include "lithe/bake/skin_weights.h"
#include "meshes.h"

namespace lithe::bake {
namespace {

using namespace test;

constexpr uint32_t kAround = 16, kRings = 24;

/// A bending tube of which two neighbours on one ring, with one skin, have met in their middle.
struct Bench {
  explicit Bench(uint32_t ring, double weight_gain)
      : mesh(weldQuietly(tube(kAround, kRings))),
        nodes{mesh.grid.bits, 5,          mesh.weight_one,           mesh.max_influences,
              mesh.positions, mesh.skins, poseMesh(mesh, palettes())},
        surface(mesh),
        refit(nodes, surface, withGain(weight_gain)) {
    surface.classifyEdges(nodes.posed);
    for (slot = 0; heightOf(slot) != 4.0 * ring / kRings; ++slot) continue;
    other = neighbourOnRing(slot);
    skin = nodes.skins[slot];
    const Segment segment(nodes.positions[slot], nodes.positions[other], nodes.placement_shift, nodes.grid_bits);
    refit.merged(slot, other, segment, 4);
    nodes.positions[slot] = segment.point(4);
    std::vector<uint32_t> thirds;
    surface.collapse(slot, other, thirds);
  }

  static SimplifyOptions withGain(double weight_gain) {
    SimplifyOptions options;
    options.weight_gain = weight_gain;
    return options;
  }

  static std::vector<std::vector<glm::dmat4>> palettes() {
    std::vector<std::vector<glm::dmat4>> result;
    for (const Pose& pose : bendingPoses(11, 80.0, 2.0)) result.push_back(pose.palette);
    return result;
  }

  double heightOf(uint32_t vertex) const {
    const double height = mesh.grid.origin.y + mesh.grid.step * mesh.positions[vertex].y;
    return std::round(height * kRings / 4.0) * 4.0 / kRings;
  }

  uint32_t neighbourOnRing(uint32_t vertex) const {
    for (uint32_t id : surface.facesAt(vertex)) {
      for (uint32_t corner : surface.face(id).corner)
        if (corner != vertex && heightOf(corner) == heightOf(vertex)) return corner;
    }
    return vertex;
  }

  /// Gives the node a skin and poses it.
  void reweigh(const QuantizedSkin& to) {
    nodes.skins[slot] = to;
    std::vector<Affine> storage(nodes.posed.blocks);
    transformPoint(blendSkin(nodes.posed, to, storage.data()), nodes.posed.blocks, glm::vec3(nodes.positions[slot]),
                   nodes.posed.at(slot));
  }

  /// Runs the refit; how often it says that the node has changed.
  uint32_t run() {
    uint32_t times = 0;
    refit.run(nodes, surface, [&](uint32_t which, const PosedPoint*) { times += which == slot ? 1 : 100; });
    return times;
  }

  double weightOf(uint16_t joint) const {
    const QuantizedSkin& now = nodes.skins[slot];
    for (uint32_t k = 0; k < now.count; ++k)
      if (now.joint[k] == joint) return now.weight[k] / double(nodes.weight_one);
    return 0.0;
  }

  Mesh mesh;
  NodeState nodes;
  Surface surface;
  Refit refit;
  uint32_t slot = 0, other = 0;
  QuantizedSkin skin;  ///< of both before they met
};

QuantizedSkin moved(const Bench& bench, double by) {
  const double weight = bench.weightOf(1) + by;
  const std::array<uint16_t, 2> joints{0, 1};
  const std::array<double, 2> weights{1.0 - weight, weight};
  return quantizeSkin(joints, weights, bench.nodes.weight_one);
}

TEST(Refit, BringsBackWeightsThatWereTakenAway) {
  for (const double by : {-0.2, 0.2}) {
    Bench bench(kRings / 2, 0.0);
    bench.reweigh(bench.skin);
    const double right = bench.weightOf(1);
    bench.reweigh(moved(bench, by));
    EXPECT_EQ(bench.run(), 1u);
    EXPECT_LT(std::abs(bench.weightOf(1) - right), 0.75 * std::abs(by));
  }
}

TEST(Refit, LeavesWeightsThatWouldGainLessThanItsShare) {
  Bench bench(kRings / 2, 1.0);
  const QuantizedSkin wrong = moved(bench, 0.2);
  bench.reweigh(wrong);
  const glm::ivec3 before = bench.nodes.positions[bench.slot];
  bench.run();
  EXPECT_EQ(bench.nodes.skins[bench.slot], wrong);
  EXPECT_NE(bench.nodes.positions[bench.slot], before) << "positions still move";
}

TEST(Refit, AddsNoJoint) {
  Bench bench(2, 0.0);
  const std::array<uint16_t, 1> joint{1};
  const std::array<double, 1> all{1.0};
  ASSERT_EQ(bench.skin, quantizeSkin(std::array<uint16_t, 1>{0}, all, bench.nodes.weight_one)) << "a rigid end";
  const QuantizedSkin wrong = quantizeSkin(joint, all, bench.nodes.weight_one);
  bench.reweigh(wrong);
  bench.run();
  EXPECT_EQ(bench.nodes.skins[bench.slot], wrong);
}

TEST(Refit, ChangesANodeOnceOnly) {
  Bench bench(kRings / 2, 0.0);
  bench.reweigh(moved(bench, 0.2));
  EXPECT_EQ(bench.run(), 1u);
  const QuantizedSkin after = bench.nodes.skins[bench.slot];
  bench.reweigh(moved(bench, 0.2));
  EXPECT_EQ(bench.run(), 0u) << "levels go on sharing the node";
  EXPECT_NE(bench.nodes.skins[bench.slot], after);
}

}  // namespace
}  // namespace lithe::bake
