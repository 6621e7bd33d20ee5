// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The pieces of the loop one by one: queue, lists, surface, placement, components.
#include <gtest/gtest.h>

#include "components.h"
#include "edge_queue.h"
#include "list_pool.h"
#include "meshes.h"
#include "placement.h"
#include "random.h"
#include "surface.h"

namespace lithe::bake {
namespace {

using namespace test;

TEST(EdgeQueue, GivesEdgesByKeyThenById) {
  EdgeQueue queue(6);
  const double keys[] = {3.0, 1.0, 2.0, 1.0, 5.0, 1.0};
  for (uint32_t e = 0; e < 6; ++e) queue.set(e, keys[e]);
  queue.set(4, 1.0);
  queue.remove(3);
  for (const uint32_t expected : {1u, 4u, 5u, 2u, 0u}) {
    ASSERT_EQ(queue.top(), expected);
    queue.remove(expected);
  }
  EXPECT_TRUE(queue.empty());
  EXPECT_FALSE(queue.contains(0));
}

TEST(EdgeQueue, StaysOrderedUnderRandomChanges) {
  lithe::test::Random random(7);
  EdgeQueue queue(64);
  std::map<uint32_t, double> mirror;
  for (int step = 0; step < 4000; ++step) {
    const uint32_t edge = random.below(64);
    if (random.chance(30)) {
      queue.remove(edge);
      mirror.erase(edge);
    } else {
      mirror[edge] = random.below(20);
      queue.set(edge, mirror[edge]);
    }
    ASSERT_EQ(queue.empty(), mirror.empty());
    if (mirror.empty()) continue;
    const auto least = std::min_element(mirror.begin(), mirror.end(), [](const auto& a, const auto& b) {
      return a.second != b.second ? a.second < b.second : a.first < b.first;
    });
    ASSERT_EQ(queue.top(), least->first);
  }
}

TEST(EdgeQueue, TellsWhatComesAfterTheTop) {
  lithe::test::Random random(6);
  EdgeQueue queue(60);
  std::vector<std::pair<double, uint32_t>> all;
  for (uint32_t edge = 0; edge < 60; ++edge) {
    const std::array<uint32_t, 3> next = queue.afterTop();
    std::sort(all.begin(), all.end());
    for (uint32_t rank = 0; rank < 3; ++rank)
      EXPECT_EQ(next[rank], rank + 1 < all.size() ? all[rank + 1].second : kNone);
    all.emplace_back(random.below(20) - 10.0, edge);
    queue.set(edge, all.back().first);
  }
}

TEST(ListPool, ListsGrowAndShrinkWithoutDisturbingOthers) {
  const uint32_t capacities[] = {2, 1, 0};
  ListPool pool(capacities);
  pool.append(0, 10);
  pool.append(0, 11);
  pool.append(1, 20);
  const uint32_t longer[] = {1, 2, 3, 4, 5};
  pool.assign(1, longer);
  pool.remove(1, 3);
  EXPECT_EQ(std::vector<uint32_t>(pool[1].begin(), pool[1].end()), (std::vector<uint32_t>{1, 2, 4, 5}));
  EXPECT_EQ(std::vector<uint32_t>(pool[0].begin(), pool[0].end()), (std::vector<uint32_t>{10, 11}));
  EXPECT_TRUE(pool[2].empty());
}

TEST(Segment, SnapsToTheNearestAllowedPlaceInsideTheGrid) {
  lithe::test::Random random(8);
  for (int run = 0; run < 400; ++run) {
    const int32_t highest = 1023;
    const auto point = [&] { return glm::ivec3(random.below(1024), random.below(1024), random.below(1024)); };
    const glm::ivec3 v = point(), u = point();
    const Segment segment(v, u, 3, 10);
    const int32_t t8 = random.between(0, 8);
    const glm::dvec3 x(2400.0 * random.unit() - 700.0, 1023.0 * random.unit(), 1023.0 * random.unit());
    const glm::ivec3 found = segment.snap(x, t8), base = segment.point(t8);
    for (int axis = 0; axis < 3; ++axis) {
      int32_t best = base[axis];
      for (int32_t at = base[axis] % segment.step; at <= highest; at += segment.step) {
        if (std::abs(at - x[axis]) < std::abs(best - x[axis])) best = at;
      }
      EXPECT_EQ(std::abs(found[axis] - x[axis]), std::abs(best - x[axis]));
      EXPECT_EQ((found[axis] - base[axis]) % segment.step, 0);
      EXPECT_GE(found[axis], 0);
      EXPECT_LE(found[axis], highest);
    }
  }
}

TEST(Segment, FindsTheNearestEighth) {
  const Segment segment({0, 0, 0}, {80, 0, 0}, 5, 10);
  EXPECT_EQ(segment.nearestEighth({-30, 5, 0}), 0);
  EXPECT_EQ(segment.nearestEighth({24, 50, 3}), 2);
  EXPECT_EQ(segment.nearestEighth({100, 0, 0}), 8);
  EXPECT_EQ(Segment({5, 5, 5}, {5, 5, 5}, 5, 10).nearestEighth({9, 9, 9}), 4);
}

PosedMesh posedAtRest(const Mesh& mesh) { return poseMesh(mesh, {std::vector<glm::dmat4>(2, glm::dmat4(1.0))}); }

uint8_t kindAt(const Surface& surface, uint32_t a, uint32_t b) {
  for (uint32_t id : surface.facesAt(a)) {
    const Face& face = surface.face(id);
    if (face.has(b)) return face.kind[3 - face.cornerOf(a) - face.cornerOf(b)];
  }
  return 255;
}

TEST(Surface, KnowsBordersSeamsAndFolds) {
  Model model = emptyModel(2, 2);
  const Skin s = oneJoint(0);
  for (const glm::vec3& p :
       {glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(1, 1, 0), glm::vec3(0.9f, 0.1f, 0.05f)}) {
    addVertex(model, p, s);
  }
  addTriangle(model, 0, 1, 2, 0);
  addTriangle(model, 1, 3, 2, 1);  // another part: a seam along 1-2
  addTriangle(model, 2, 4, 0, 0);  // folds back under the first along 0-2
  const Mesh mesh = weldQuietly(model);
  const PosedMesh posed = posedAtRest(mesh);
  Surface surface(mesh);
  surface.classifyEdges(posed);
  EXPECT_EQ(kindAt(surface, 0, 1), kBorder);
  EXPECT_EQ(kindAt(surface, 1, 2), kSeam);
  EXPECT_EQ(kindAt(surface, 0, 2), kFold);
}

TEST(Surface, CollapseDropsTheDyingMergesEqualAndKeepsOpposite) {
  Model model = emptyModel(2);
  const Skin s = oneJoint(0);
  for (int i = 0; i < 5; ++i) addVertex(model, glm::vec3(float(i), float(i * i), float(i % 2)), s);
  addTriangle(model, 0, 1, 2);  // dies when 0 and 1 meet
  addTriangle(model, 0, 3, 4);
  addTriangle(model, 1, 3, 4);  // becomes equal to the one before
  addTriangle(model, 1, 4, 3);  // becomes its opposite
  const Mesh mesh = weldQuietly(model);
  Surface surface(mesh);
  ASSERT_EQ(surface.triangleCount(), 4u);
  std::vector<uint32_t> thirds;
  const uint32_t a = mesh.corner(0, 0), b = mesh.corner(0, 1), third = mesh.corner(0, 2);
  EXPECT_TRUE(surface.wouldOrphan(a, b));
  surface.collapse(a, b, thirds);
  EXPECT_EQ(surface.triangleCount(), 2u);
  EXPECT_EQ(thirds, std::vector<uint32_t>{third});
  EXPECT_TRUE(surface.facesAt(third).empty());
  EXPECT_TRUE(surface.facesAt(b).empty());
  EXPECT_FALSE(surface.hasEdge(a, third));
}

TEST(Surface, UnitesWedgesAcrossTheDyingTriangles) {
  // A strip with a seam along its middle row: the seam's two sides stay two when an edge along it collapses.
  Model model = emptyModel(2, 2);
  addGrid(model, 2, [](double, double) { return oneJoint(0); });
  for (size_t t = 4; t < 8; ++t) model.triangle_part[t] = 1;
  const Mesh mesh = weldQuietly(model);
  const PosedMesh posed = posedAtRest(mesh);
  Surface surface(mesh);
  surface.classifyEdges(posed);
  uint32_t middle[3];
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    if (mesh.positions[v].y > 4000 && mesh.positions[v].y < 12000) middle[mesh.positions[v].x / 8000] = v;
  }
  ASSERT_EQ(kindAt(surface, middle[0], middle[1]), kSeam);
  std::vector<uint32_t> thirds;
  surface.collapse(middle[0], middle[1], thirds);
  surface.classifyAround(middle[0], posed);
  EXPECT_EQ(kindAt(surface, middle[0], middle[2]), kSeam);
  std::set<uint32_t> wedges;
  for (uint32_t id : surface.facesAt(middle[0]))
    wedges.insert(surface.face(id).wedge[surface.face(id).cornerOf(middle[0])]);
  EXPECT_EQ(wedges.size(), 2u);
}

TEST(Components, LossIsAreaTimesSquaredDistanceToTheRest) {
  Model model = emptyModel(2);
  addGrid(model, 4, [](double, double) { return oneJoint(0); });
  addGrid(model, 1, [](double, double) { return oneJoint(0); }, {1.5f, 1.5f, 0.25f});  // a unit square a quarter above
  const Mesh mesh = weldQuietly(model);
  const PosedMesh posed = posedAtRest(mesh);
  Components components(Surface(mesh), posed);
  const uint32_t small = mesh.corner(mesh.triangleCount() - 1, 0);
  const double unit4 = std::pow(posed.unit, 4);
  EXPECT_NEAR(components.lossOf(small) * unit4, 1.0 * 0.25 * 0.25, 1e-4);
  EXPECT_GT(components.lossOf(mesh.corner(0, 0)) * unit4, 1.0);
}

TEST(Components, ALoneComponentIsLostByTheWholeDiagonal) {
  Model model = emptyModel(2);
  addGrid(model, 2, [](double, double) { return oneJoint(0); });
  const Mesh mesh = weldQuietly(model);
  const PosedMesh posed = posedAtRest(mesh);
  Components components(Surface(mesh), posed);
  EXPECT_NEAR(components.lossOf(0) * std::pow(posed.unit, 2), 4.0, 1e-3);
}

}  // namespace
}  // namespace lithe::bake
