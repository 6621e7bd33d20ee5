// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <set>

#include "lithe/bake/generate.h"
#include "lithe/bake/poses.h"
#include "model_checks.h"

namespace lithe::bake {
namespace {

constexpr uint32_t kSegments = 20, kLegs = 40, kBristlesPerLeg = 12;

class CentipedeTest : public testing::Test {
 protected:
  static const Model& centipede() { return checks::character("centipede"); }
};

TEST_F(CentipedeTest, KeepsThePromisesOfEveryCharacter) { EXPECT_EQ(checks::brokenPromise(centipede(), 4), ""); }

TEST_F(CentipedeTest, IsDenseAndManyJointed) {
  EXPECT_NEAR(static_cast<double>(centipede().triangles.size()), 200e3, 15e3);
  EXPECT_GE(centipede().joints.size(), 40u);
  EXPECT_LE(centipede().joints.size(), 256u);  // an unsigned byte names a joint
  ASSERT_EQ(centipede().parts.size(), 2u);
  EXPECT_EQ(centipede().parts[0].name, "shell");
  EXPECT_EQ(centipede().parts[1].name, "flesh");
}

TEST_F(CentipedeTest, IsMadeOfClosedPieces) {
  const checks::Topology topology = checks::measureTopology(centipede());
  // trunk, head, 8 eyes, 2 antennae, 2 fangs, legs with their bristles; each piece a sphere
  const uint32_t pieces = 1 + 1 + 8 + 2 + 2 + kLegs * (1 + kBristlesPerLeg);
  EXPECT_EQ(topology.components, pieces);
  EXPECT_EQ(topology.boundary_edges + topology.crowded_edges + topology.flipped_edges, 0u);
  EXPECT_EQ(topology.pinched_vertices + topology.degenerate_triangles, 0u);
  EXPECT_EQ(topology.vertices + topology.triangles, topology.edges + 2u * pieces);
  EXPECT_GT(checks::signedVolume(centipede()), 0.0);
  EXPECT_GT(checks::outwardNormals(centipede()), 0.99);
}

TEST_F(CentipedeTest, ShellAndFleshShareTheFlanksPositionsAndWeights) {
  const std::vector<uint32_t> welded = checks::weldByPosition(centipede());
  uint32_t shared = 0;
  for (uint32_t vertex = 0; vertex < welded.size(); ++vertex) {
    const Skin &a = centipede().skins[vertex], &b = centipede().skins[welded[vertex]];
    ASSERT_EQ(a.count, b.count) << vertex;
    ASSERT_EQ(a.joint, b.joint) << vertex;
    ASSERT_EQ(a.weight, b.weight) << vertex;
    shared += welded[vertex] != vertex;
  }
  EXPECT_GT(shared, 2u * kSegments * 24u);
}

TEST_F(CentipedeTest, MirrorsItsSkeleton) {
  std::multiset<std::array<long, 3>> left, right;
  for (const Joint& joint : centipede().joints) {
    const glm::dvec3 p = -glm::dvec3(joint.inverse_bind[3]) * 1e6;
    if (p.x > 1.0) left.insert({std::lround(p.x), std::lround(p.y), std::lround(p.z)});
    if (p.x < -1.0) right.insert({std::lround(-p.x), std::lround(p.y), std::lround(p.z)});
  }
  EXPECT_GT(left.size(), 80u);
  EXPECT_EQ(left, right);
}

TEST_F(CentipedeTest, WalksInALoopOnTheGround) {
  const Clip* walk = checks::findClip(centipede(), "walk");
  ASSERT_TRUE(walk);
  for (const Channel& channel : walk->channels) {
    EXPECT_NEAR(glm::length(channel.values.front() - channel.values.back()), 0.0f, 1e-5f)
        << centipede().nodes[channel.node].name;
  }
  const checks::Box rest = checks::restBox(centipede());
  for (int frame = 0; frame < 32; frame += 4) {
    const checks::Box box = checks::posedBox(centipede(), "walk", frame / 30.0);
    EXPECT_GT(box.low.y, rest.low.y - 0.05) << frame;
    EXPECT_LT(box.low.y, rest.low.y + 0.05) << frame;
    EXPECT_LT(checks::diagonal(box), 1.1 * checks::diagonal(rest)) << frame;
  }
}

TEST_F(CentipedeTest, CurlsUp) {
  const checks::Box start = checks::posedBox(centipede(), "curl", 0.0);
  const checks::Box end = checks::posedBox(centipede(), "curl", 1.5);
  EXPECT_NEAR(checks::diagonal(start), checks::diagonal(checks::restBox(centipede())), 0.2);
  EXPECT_LT(end.high.z - end.low.z, 0.65 * (start.high.z - start.low.z));
}

}  // namespace
}  // namespace lithe::bake
