// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Bases and splits of tiny meshes whose symbols can be worked out by hand.
#include "split_encoder.h"

#include <gtest/gtest.h>

#include "base_encoder.h"
#include "small_mesh.h"

namespace lithe::bake {
namespace {

using test::CollapseList;
using Ids = std::vector<uint32_t>;
using Values = std::vector<int32_t>;

constexpr format::WedgeAttributes kPlain{false, false, 0, 0};

/// A mesh collapsed, its base encoded, and an encoder at work on the cut.
struct Encoding {
  Mesh mesh;
  Hierarchy h;
  Cut cut;
  SplitSettings settings;
  PageData base;
  SplitEncoder encoder;

  Encoding(const Mesh& from, const CollapseSequence& sequence, uint32_t shift = 31)
      : mesh(from),
        h(buildHierarchy(mesh, sequence, shift)),
        cut(h),
        base(encodeBase(cut, kPlain)),
        encoder(cut, settings) {
    settings.placement_shift = shift;
  }

  Values first(uint32_t stream, uint32_t attribute = 0) {
    return encoder.page().streams[stream].attributes[attribute].values;
  }
  Values ofBase(uint32_t stream, uint32_t attribute = 0) const {
    return base.streams[stream].attributes[attribute].values;
  }
};

// ---- The base ----

TEST(BaseEncoder, WritesRootsTheirSkinsAndStandingFaces) {
  Mesh mesh = test::tetrahedron();
  mesh.skins[3] = test::skinOf({{2, 155}, {5, 100}});
  CollapseList list(mesh);
  list.add(0, 1, 4);
  const Encoding e(mesh, list.sequence);
  // Roots in the order of their ids: vertices 2 (0, 8, 0) and 3 (0, 0, 8), node 4 (4, 0, 0).
  EXPECT_EQ(e.cut.node_hierarchy, (Ids{2, 3, 4}));
  EXPECT_EQ(e.ofBase(format::kBaseNodes, 0), (Values{0, 8, 0, 0, -8, 8, 4, 0, -8}));
  EXPECT_EQ(e.ofBase(format::kBaseNodes, 1), (Values{0, 0, 0}));  // wedges - 1
  EXPECT_EQ(e.ofBase(format::kBaseNodes, 2), (Values{0, 1, 0}));  // influences - 1
  EXPECT_EQ(e.ofBase(format::kBaseInfluences, 0), (Values{0, 2, 5, 0}));
  EXPECT_EQ(e.ofBase(format::kBaseInfluences, 1), (Values{0, 155, 0, 0}));  // a node's last is derived
  EXPECT_EQ(e.ofBase(format::kBaseWedges, 0), (Values{0, 0, 0}));
  // Triangles (1, 3, 2) and (2, 3, 0): wedges (2, 1, 0) and (0, 1, 2).
  EXPECT_EQ(e.cut.face_triangle, (Ids{2, 3}));
  EXPECT_EQ(e.ofBase(format::kBaseFaces, 0), (Values{2, -1, -2, -2, 1, 2}));
}

TEST(BaseEncoder, WedgesAreDifferencesOfTheirRecords) {
  Mesh mesh = test::emptyMesh({false, false, 1, 1}, 2);
  for (int32_t x : {0, 8}) test::addVertex(mesh, {x, 0, 0});
  test::addVertex(mesh, {0, 8, 0});
  for (uint32_t v = 0; v < 3; ++v) test::addWedge(mesh, v, {100 - 10 * int32_t(v), 7}, v == 2 ? 1u : 0u);
  mesh.wedge_color[0] = {{1, 2, 3, 4}, {5, 5, 5, 5}, {5, 5, 5, 6}};
  mesh.triangles = {{0, 1, 2}};
  const Hierarchy h = buildHierarchy(mesh, {}, 31);
  Cut cut(h);
  const PageData base = encodeBase(cut, {false, false, 1, 1});
  const auto& wedges = base.streams[format::kBaseWedges].attributes;
  EXPECT_EQ(wedges[0].values, (Values{0, 0, 1}));
  EXPECT_EQ(wedges[1].values, (Values{100, 7, -10, 0, -10, 0}));
  EXPECT_EQ(wedges[2].values, (Values{1, 2, 3, 4, 4, 3, 2, 1, 0, 0, 0, 1}));
}

TEST(BaseEncoder, RefusesABaseBeyondTheFormat) {
  Mesh mesh = test::emptyMesh({});
  for (int32_t i = 0; i <= (1 << 17); ++i) test::addWedge(mesh, test::addVertex(mesh, {i % 128, i / 128, 0}));
  mesh.triangles = {{0, 1, 2}};
  const Hierarchy h = buildHierarchy(mesh, {}, 31);
  Cut cut(h);
  try {
    encodeBase(cut, kPlain);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()),
              "the coarsest level still has 131073 vertices: collapse further (the simplifier stopped early)");
  }
}

// ---- Splits ----

/// The tetrahedron collapsed to one node.
struct Tetrahedron {
  Mesh mesh = test::tetrahedron();
  Encoding encoding{mesh, sequence(mesh)};

  static CollapseSequence sequence(const Mesh& mesh) {
    CollapseList list(mesh);
    list.add(0, 1, 4);
    list.add(4, 2, 2);
    list.add(5, 3, 0);
    return list.sequence;
  }

  Encoding& splitAll() {
    for (uint32_t node : {0u, 1u, 3u}) encoding.encoder.split(node);
    return encoding;
  }
};

TEST(SplitEncoder, ChildrenAreNumberedOneAfterTheOther) {
  Tetrahedron tetrahedron;
  Encoding& e = tetrahedron.splitAll();
  // 6 -> 5, 3; 5 -> 4, 2; 4 -> its children in the order that makes its ring a closed one: 1, 0.
  EXPECT_EQ(e.cut.node_hierarchy, (Ids{6, 5, 3, 4, 2, 1, 0}));
  EXPECT_EQ(e.cut.face_triangle.size(), 4u);
  EXPECT_EQ(hiddenFaces(e.cut), Ids{});
}

TEST(SplitEncoder, TetrahedronByHand) {
  Tetrahedron tetrahedron;
  Encoding& e = tetrahedron.splitAll();
  // t8 counts from child B: 8, 6 and 4, as the first two splits call child 0 A, the third child 1. Without a face 4 is
  // expected; the two faces of the third split have (0, 0, 8) and (0, 8, 0) beyond child B and expect 2.
  EXPECT_EQ(e.first(format::kSplits, format::kSplitT8),
            (Values{format::rankOfEighth(8, 4), format::rankOfEighth(6, 4), format::rankOfEighth(4, 2)}));
  // Fans without corners: no corner at B, no face; then two faces (4, 3, 2) and (2, 3, 4) to node 2 (vertex 3), which
  // no corner names: rank 0, id 0 and 2.
  EXPECT_EQ(e.first(format::kGeneral), (Values{0, 0, 0, 2, 0, 0, 0, 2, 1, 0, 0, 2}));
  // The third split has a ring of two edges, cut at both of its vertices: the only pair, said as 1 + 0.
  EXPECT_EQ(e.first(format::kCut3), Values{1});
  EXPECT_EQ(e.encoder.page().max_fan, 2u);
  const PageData page = e.encoder.finish();
  EXPECT_EQ(page.streams[format::kSplits].attributes[format::kSplitLattice].values, Values(6, 0));  // none was moved
}

TEST(SplitEncoder, AFullSplitGivesTheMeshBack) {
  const Mesh mesh = test::tetrahedron();
  CollapseList list(mesh);
  list.add(2, 0, 3);
  list.add(4, 3, 5);
  Encoding e(mesh, list.sequence);
  for (uint32_t node = 0; node < e.cut.node_hierarchy.size(); ++node)
    if (!e.h.isLeaf(e.cut.node_hierarchy[node])) e.encoder.split(node);
  ASSERT_EQ(e.cut.face_wedges.size(), mesh.triangles.size());
  for (uint32_t f = 0; f < e.cut.face_wedges.size(); ++f)
    for (uint32_t k = 0; k < 3; ++k) {
      const uint32_t corner = 3 * f + k;
      EXPECT_EQ(e.cut.node_hierarchy[e.cut.cornerNode(corner)], e.cut.leafVertex(corner)) << f << " " << k;
    }
}

/// A disc: a closed hexagon of vertices 1 .. 6 around 0; or its half, in which 0 lies on the boundary.
Mesh disc(bool closed) {
  const glm::ivec3 around[6] = {{16, 0, 0}, {8, 14, 0}, {-8, 14, 0}, {-16, 0, 0}, {-8, -14, 0}, {8, -14, 0}};
  std::vector<glm::ivec3> positions = {{20, 20, 0}};
  for (const glm::ivec3& p : around) positions.push_back(p + glm::ivec3(20, 20, 0));
  std::vector<std::array<uint32_t, 3>> triangles;
  for (uint32_t i = 0; i < (closed ? 6u : 3u); ++i) triangles.push_back({0, 1 + i, 1 + (i + 1) % 6});
  return test::plainMesh(positions, triangles);
}

TEST(SplitEncoder, AnInnerEdgeIsOneSplitOfAnOpenRingWithTwoFaces) {
  const Mesh mesh = disc(true);
  CollapseList list(mesh);
  list.add(0, 1, 0);  // faces (0, 1, 2) and (0, 6, 1) die; four are left around the parent
  Encoding e(mesh, list.sequence);
  ASSERT_EQ(e.base.streams[format::kBaseFaces].records(), 4u);
  const uint32_t node = e.cut.file_node[7];
  e.encoder.split(node);
  // Ring 2, 3, 4, 5, 6 is open and all at child 0, which is B; cut at its ends 0 and 4: pair 4 * 3 / 2 + 0, behind
  // the list and the five single vertices.
  EXPECT_EQ(e.first(format::kCutOpen), Values{1 + 5 + 6});
  EXPECT_TRUE(e.first(format::kGeneral).empty());
  EXPECT_EQ(e.cut.face_wedges.size(), 6u);
}

TEST(SplitEncoder, ABoundaryEdgeIsACutOfAnOpenRing) {
  const Mesh mesh = disc(false);  // faces (0, 1, 2), (0, 2, 3), (0, 3, 4)
  CollapseList list(mesh);
  list.add(0, 1, 8);  // one face dies, two are left
  Encoding e(mesh, list.sequence);
  e.encoder.split(e.cut.file_node[7]);
  // Ring 2, 3, 4 of two edges, both at child 0, which is B: the cut is at its beginning.
  EXPECT_EQ(e.first(format::kSplits, format::kSplitT8), Values{format::rankOfEighth(8, 4)});  // a flat patch
  EXPECT_EQ(e.first(format::kCutOpen), Values{1});
  EXPECT_TRUE(e.first(format::kGeneral).empty());
  EXPECT_EQ(e.cut.face_wedges.size(), 3u);
}

TEST(SplitEncoder, FlagsGoToTheStreamOfTheNodesAge) {
  const Mesh mesh = test::tetrahedron();
  Encoding e(mesh, {});
  e.encoder.flag(true, true);
  e.encoder.flag(true, false);
  e.encoder.flag(false, true);
  EXPECT_EQ(e.first(format::kFlagsOld), (Values{1, 0}));
  EXPECT_EQ(e.first(format::kFlagsNew), Values{1});
}

TEST(SplitEncoder, TheLatticeIndexSaysHowFarTheParentLiesFromItsEighths) {
  const Mesh mesh = test::tetrahedron();
  CollapseList list(mesh);
  list.add(0, 1, 4);
  list.sequence.collapses[0].position = {12, 16, 0};  // (4, 0, 0) and one step of 8 along x, two along y
  Encoding e(mesh, list.sequence, 0);
  e.encoder.split(e.cut.file_node[4]);
  // D lies along x: two indices across it, and the third as it is.
  EXPECT_EQ(e.first(format::kSplits, format::kSplitLatticeHeight), Values{1});
  const PageData page = e.encoder.finish();
  ASSERT_EQ(page.parameters[format::kPlacement], 0);  // one split is no reason to predict
  EXPECT_EQ(page.streams[format::kSplits].attributes[format::kSplitLattice].values, (Values{2, 0}));
}

TEST(SplitEncoder, AFinishedPageLeavesAnEmptyOne) {
  const Mesh mesh = test::tetrahedron();
  CollapseList list(mesh);
  list.add(0, 1, 4);
  Encoding e(mesh, list.sequence);
  e.encoder.split(e.cut.file_node[4]);
  EXPECT_GT(e.encoder.work(), 0u);
  const PageData page = e.encoder.finish();
  EXPECT_EQ(page.streams[format::kSplits].records(), 1u);
  EXPECT_EQ(page.streams[format::kSplits].attributes[format::kSplitPosition].values.size(), 2u);
  EXPECT_EQ(page.streams[format::kSplits].attributes[format::kSplitPositionHeight].values.size(), 1u);
  EXPECT_EQ(e.encoder.page().valueCount(), 0u);
  EXPECT_EQ(e.encoder.page().max_fan, 0u);
  EXPECT_EQ(e.encoder.work(), 0u);
}

}  // namespace
}  // namespace lithe::bake
