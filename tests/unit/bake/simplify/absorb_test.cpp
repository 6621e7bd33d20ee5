// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "absorb.h"

#include <gtest/gtest.h>

#include "lithe/bake/cut.h"
#include "meshes.h"
#include "random.h"

namespace lithe::bake {
namespace {

using namespace test;

/// `count` triangles of edge 1 anywhere in a cube of edge `side`, each on its own, of `parts` parts in turn.
Model confetti(uint32_t count, float side, uint32_t parts, uint32_t seed) {
  lithe::test::Random random(seed);
  Model model = emptyModel(2, parts);
  for (uint32_t i = 0; i < count; ++i) {
    const glm::vec3 corner = side * glm::vec3(random.unit(), random.unit(), random.unit());
    const Skin skin = twoJoints(corner.y / side);
    const uint32_t a = addVertex(model, corner, skin);
    addVertex(model, corner + glm::vec3(1, 0, 0), skin);
    addVertex(model, corner + glm::vec3(0, 1, 0), skin);
    addTriangle(model, a, a + 1, a + 2, i % parts);
  }
  return model;
}

NodeState stateOf(const Mesh& mesh) {
  return {mesh.grid.bits, 4, mesh.weight_one, mesh.max_influences, mesh.positions, mesh.skins, {}};
}

int64_t squaredDistance(const Mesh& mesh, uint32_t a, uint32_t b) {
  int64_t sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const int64_t d = mesh.positions[a][axis] - mesh.positions[b][axis];
    sum += d * d;
  }
  return sum;
}

uint32_t partOf(const Mesh& mesh, uint32_t vertex) {
  for (uint32_t wedge = 0; wedge < mesh.wedgeCount(); ++wedge) {
    if (mesh.wedge_vertex[wedge] == vertex) return mesh.wedge_part[wedge];
  }
  return kNone;
}

/// What absorb.h promises, by looking at every slot.
uint32_t hostByHand(uint32_t slot, const Mesh& mesh, const Surface& surface, bool any_part) {
  uint32_t best = kNone;
  for (uint32_t host = 0; host < mesh.vertexCount(); ++host) {
    if (surface.facesAt(host).empty() || (!any_part && partOf(mesh, host) != partOf(mesh, slot))) continue;
    if (best == kNone || squaredDistance(mesh, slot, host) < squaredDistance(mesh, slot, best)) best = host;
  }
  return best;
}

/// Takes away every triangle whose index is in question.
std::vector<uint32_t> removeTriangles(const Mesh& mesh, Surface& surface, const std::function<bool(uint32_t)>& gone) {
  std::vector<uint32_t> thirds, faceless;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    if (!gone(t)) continue;
    surface.collapse(mesh.corner(t, 0), mesh.corner(t, 1), thirds);
    for (uint32_t k = 0; k < 3; ++k) faceless.push_back(mesh.corner(t, k));
  }
  return faceless;
}

TEST(NearestHosts, AreTheNearestSlotsOfTheSamePart) {
  for (uint32_t seed = 1; seed < 6; ++seed) {
    const Mesh mesh = weldQuietly(confetti(200, 20.0f, 3, seed));
    Surface surface(mesh);
    const std::vector<uint32_t> faceless = removeTriangles(mesh, surface, [](uint32_t t) { return t % 5 < 3; });
    const std::vector<uint32_t> hosts = nearestHosts(faceless, mesh, stateOf(mesh), surface);
    ASSERT_EQ(hosts.size(), faceless.size());
    for (size_t i = 0; i < faceless.size(); ++i)
      EXPECT_EQ(hosts[i], hostByHand(faceless[i], mesh, surface, false)) << "seed " << seed << ", " << i;
  }
}

TEST(NearestHosts, AreOfAnotherPartWhenTheirOwnIsGone) {
  const Mesh mesh = weldQuietly(confetti(120, 20.0f, 3, 9));
  Surface surface(mesh);
  const std::vector<uint32_t> faceless =
      removeTriangles(mesh, surface, [&](uint32_t t) { return partOf(mesh, mesh.corner(t, 0)) == 1; });
  ASSERT_EQ(faceless.size(), 120u);
  const std::vector<uint32_t> hosts = nearestHosts(faceless, mesh, stateOf(mesh), surface);
  for (size_t i = 0; i < faceless.size(); ++i) EXPECT_EQ(hosts[i], hostByHand(faceless[i], mesh, surface, true)) << i;
}

TEST(NearestHosts, AreNoneWhereNoTriangleIsLeft) {
  const Mesh mesh = weldQuietly(confetti(4, 3.0f, 1, 2));
  Surface surface(mesh);
  const std::vector<uint32_t> faceless = removeTriangles(mesh, surface, [](uint32_t) { return true; });
  for (uint32_t host : nearestHosts(faceless, mesh, stateOf(mesh), surface)) EXPECT_EQ(host, kNone);
}

TEST(Absorption, EveryNodeOfALevelHasTriangles) {
  const Mesh mesh = weldQuietly(confetti(150, 12.0f, 2, 4));
  SimplifyOptions options;
  options.levels = {90, 40, 12};
  options.min_triangles = 12;
  const CollapseSequence sequence = simplify(mesh, std::vector<Joint>(2), bendingPoses(3, 60.0, 6.0), options);
  expectValid(mesh, sequence, options);
  for (uint32_t level : options.levels) {
    const uint32_t count = collapsesToReach(sequence, mesh, level);
    std::set<uint32_t> used;
    for (const auto& triangle : trianglesAfter(mesh, sequence, count)) used.insert(triangle.begin(), triangle.end());
    EXPECT_LE(sequence.collapses[count - 1].triangles, level);
    EXPECT_EQ(used.size(), mesh.vertexCount() - count) << level;
  }
}

TEST(Absorption, ChangesNoTriangle) {
  const Mesh mesh = weldQuietly(confetti(60, 8.0f, 2, 5));
  SimplifyOptions options;
  options.levels = {20};
  options.min_triangles = 20;
  const CollapseSequence sequence = simplify(mesh, std::vector<Joint>(2), bendingPoses(3, 60.0, 4.0), options);
  uint32_t absorptions = 0;
  for (uint32_t i = 1; i < sequence.collapses.size(); ++i) {
    const Collapse& absorption = sequence.collapses[i];
    if (absorption.triangles != sequence.collapses[i - 1].triangles) continue;
    ++absorptions;
    const uint32_t host = absorption.child[0];
    const bool is_vertex = host < mesh.vertexCount();
    EXPECT_EQ(absorption.t8, 0);
    EXPECT_EQ(absorption.position,
              is_vertex ? mesh.positions[host] : sequence.collapses[host - mesh.vertexCount()].position);
    EXPECT_EQ(absorption.skin, is_vertex ? mesh.skins[host] : sequence.collapses[host - mesh.vertexCount()].skin);
  }
  EXPECT_GT(absorptions, 0u);
}

TEST(Absorption, IsNotDoneWhereNothingIsLeft) {
  const Mesh mesh = weldQuietly(confetti(5, 4.0f, 1, 7));
  const CollapseSequence sequence = simplify(mesh, std::vector<Joint>(2), bendingPoses(3, 60.0, 2.0), {});
  EXPECT_EQ(sequence.collapses.back().triangles, 0u);
  EXPECT_EQ(sequence.collapses.size(), 5u);
}

}  // namespace
}  // namespace lithe::bake
