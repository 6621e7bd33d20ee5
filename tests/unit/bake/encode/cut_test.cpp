// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "cut.h"

#include <gtest/gtest.h>

#include "small_mesh.h"

namespace lithe::bake {
namespace {

using test::CollapseList;
using Ids = std::vector<uint32_t>;

/// The tetrahedron with 0 and 1 merged into node 4: roots 2, 3, 4 and the faces 2 and 3, back to back.
struct HalfTetrahedron {
  Mesh mesh = test::tetrahedron();
  Hierarchy h = collapsed(mesh);
  Cut cut{h};

  static Hierarchy collapsed(const Mesh& mesh) {
    CollapseList list(mesh);
    list.add(0, 1, 4);
    return buildHierarchy(mesh, list.sequence, 31);
  }

  /// The cut of file nodes 0, 1 and 2: the vertices 2 and 3, and node 4.
  Cut& withItsNodes() {
    for (uint32_t node : {2u, 3u, 4u}) cut.addNode(node, {node});
    return cut;
  }
};

TEST(Cut, NumbersNodesAndWedgesInTheOrderTheyAreAdded) {
  const HalfTetrahedron half;
  Cut cut(half.h);
  EXPECT_EQ(cut.addNode(4, {4}), 0u);
  EXPECT_EQ(cut.addNode(2, {2}), 1u);
  EXPECT_EQ(cut.node_hierarchy, (Ids{4, 2}));
  EXPECT_EQ(cut.file_node, (Ids{kNone, kNone, 1, kNone, 0}));
  EXPECT_EQ(cut.wedge_hierarchy, (Ids{4, 2}));
  EXPECT_EQ(cut.node_first_wedge, (Ids{0, 1, 2}));
}

TEST(Cut, NodeAboveIsTheDeepestOneInTheFile) {
  const HalfTetrahedron half;
  Cut cut(half.h);
  cut.addNode(4, {4});
  EXPECT_EQ(cut.nodeAbove(0), 0u);
  EXPECT_EQ(cut.nodeAbove(1), 0u);
  cut.addNode(1, {1});
  EXPECT_EQ(cut.nodeAbove(0), 0u);
  EXPECT_EQ(cut.nodeAbove(1), 1u);
}

TEST(Cut, FanListsCornersInAscendingOrderWithTheirNeighbours) {
  HalfTetrahedron half;
  Cut& cut = half.withItsNodes();
  cut.addFace(2, 0, {2, 1, 0});  // node 4, node 3, node 2
  cut.addFace(3, 0, {0, 1, 2});
  const format::Fan& fan = cut.fanOf(2);
  ASSERT_EQ(fan.count, 2u);
  EXPECT_EQ(Ids(fan.corner, fan.corner + 2), (Ids{0, 5}));
  EXPECT_EQ(Ids(fan.next, fan.next + 2), (Ids{1, 0}));
  EXPECT_EQ(Ids(fan.previous, fan.previous + 2), (Ids{0, 1}));
}

TEST(Cut, RotatedFacesKnowTheLeavesOfTheirCorners) {
  HalfTetrahedron half;
  Cut& cut = half.withItsNodes();
  cut.addFace(3, 1, {1, 2, 0});  // triangle (2, 3, 0) beginning with its corner 1
  EXPECT_EQ(cut.leafVertex(0), 3u);
  EXPECT_EQ(cut.leafVertex(1), 0u);
  EXPECT_EQ(cut.leafVertex(2), 2u);
  EXPECT_EQ(cut.cornerNode(1), 2u);
}

TEST(Cut, AMovedCornerBelongsToItsNewNode) {
  HalfTetrahedron half;
  Cut& cut = half.withItsNodes();
  cut.addFace(2, 0, {2, 1, 0});
  cut.addNode(0, {0});
  cut.addNode(1, {1});
  cut.clearCorners(2);
  cut.moveCorner(0, 4);
  EXPECT_EQ(cut.cornerNode(0), 4u);
  EXPECT_EQ(cut.fanOf(2).count, 0u);
  EXPECT_EQ(cut.fanOf(4).count, 1u);
}

TEST(Cut, WedgeAtFollowsTheWedgesUp) {
  Mesh mesh = test::emptyMesh({});
  for (int32_t x : {0, 8, 16, 24}) test::addVertex(mesh, {x, x * x, 0});
  const uint32_t left = test::addWedge(mesh, 0), right = test::addWedge(mesh, 0);
  for (uint32_t v = 1; v < 4; ++v) test::addWedge(mesh, v);
  mesh.triangles = {{left, 3, 2}, {right, 4, 3}, {2, 3, 4}};
  CollapseList list(mesh);
  const uint32_t node = list.add(0, 1, 0);  // dies with the first triangle: left and the wedge of 1 become one
  const Hierarchy h = buildHierarchy(mesh, list.sequence, 31);
  Cut cut(h);
  const uint32_t first = h.first_wedge[node];
  ASSERT_EQ(h.first_wedge[node + 1] - first, 2u);
  cut.addNode(node, {first, first + 1});
  EXPECT_EQ(cut.wedgeAt(0, left), 0u);
  EXPECT_EQ(cut.wedgeAt(0, 2), 0u);
  EXPECT_EQ(cut.wedgeAt(0, right), 1u);
}

// ---- Hidden faces ----

struct Sheet {
  Mesh mesh = test::plainMesh({{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {8, 8, 0}},
                              {{0, 1, 2}, {2, 0, 1}, {1, 0, 2}, {0, 1, 3}, {1, 2, 0}});
  Hierarchy h = buildHierarchy(mesh, {}, 31);
  Cut cut{h};
  Sheet() {
    for (uint32_t v = 0; v < 4; ++v) cut.addNode(v, {v});
  }
};

TEST(HiddenFaces, AreThoseEqualToALowerOneInTheSameOrientation) {
  Sheet sheet;
  for (uint32_t t = 0; t < 5; ++t) sheet.cut.addFace(t, 0, sheet.h.face_wedges[t]);
  // 1 and 4 are 0 turned; 2 looks the other way; 3 has another vertex.
  EXPECT_EQ(hiddenFaces(sheet.cut), (Ids{1, 4}));
}

TEST(HiddenFaces, NoneWhereAllDiffer) {
  Sheet sheet;
  for (uint32_t t : {0u, 2u, 3u}) sheet.cut.addFace(t, 0, sheet.h.face_wedges[t]);
  EXPECT_TRUE(hiddenFaces(sheet.cut).empty());
}

}  // namespace
}  // namespace lithe::bake
