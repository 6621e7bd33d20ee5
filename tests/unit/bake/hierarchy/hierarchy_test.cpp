// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Tiny meshes whose hierarchy can be worked out by hand.
#include "lithe/bake/hierarchy.h"

#include <gtest/gtest.h>

#include "small_mesh.h"

namespace lithe::bake {
namespace {

using test::addVertex;
using test::addWedge;
using test::CollapseList;
using Ids = std::vector<uint32_t>;

constexpr uint32_t kAnyPoint = 31;  ///< a placement shift with which every grid point is on the lattice

Ids bornAt(const Hierarchy& h, uint32_t node) {
  return {h.born.begin() + h.born_begin[node], h.born.begin() + h.born_begin[node + 1]};
}

Ids wedgesOf(const Hierarchy& h, uint32_t node) {
  Ids wedges;
  for (uint32_t w = h.first_wedge[node]; w < h.first_wedge[node + 1]; ++w) wedges.push_back(w);
  return wedges;
}

std::vector<int32_t> valuesOf(const Hierarchy& h, uint32_t wedge) {
  const int32_t* begin = h.wedge_attributes.data() + size_t{wedge} * h.record.stride;
  return {begin, begin + h.record.stride};
}

TEST(Hierarchy, WithoutCollapsesEveryVertexIsARoot) {
  const Mesh mesh = test::tetrahedron();
  const Hierarchy h = buildHierarchy(mesh, {}, kAnyPoint);
  EXPECT_EQ(h.nodeCount(), 4u);
  EXPECT_EQ(h.vertex_count, 4u);
  EXPECT_EQ(h.parent, Ids(4, kNone));
  EXPECT_EQ(h.birth_node, Ids(4, kNone));
  EXPECT_TRUE(h.born.empty());
  EXPECT_EQ(h.face_wedges, mesh.triangles);
  for (uint32_t n = 0; n < 4; ++n) EXPECT_TRUE(h.isLeaf(n));
}

TEST(Hierarchy, TetrahedronByHand) {
  const Mesh mesh = test::tetrahedron();
  CollapseList list(mesh);
  EXPECT_EQ(list.add(0, 1, 4), 4u);  // faces 0 and 1 have both vertices
  EXPECT_EQ(list.add(4, 2, 2), 5u);  // faces 2 and 3
  EXPECT_EQ(list.add(5, 3, 0), 6u);  // nothing is left to die
  const Hierarchy h = buildHierarchy(mesh, list.sequence, kAnyPoint);
  EXPECT_EQ(h.nodeCount(), 7u);
  EXPECT_EQ(h.parent, (Ids{4, 4, 5, 6, 5, 6, kNone}));
  EXPECT_EQ(h.children[4], (std::array<uint32_t, 2>{0, 1}));
  EXPECT_EQ(h.children[5], (std::array<uint32_t, 2>{4, 2}));
  EXPECT_EQ(h.children[6], (std::array<uint32_t, 2>{5, 3}));
  EXPECT_EQ(h.position[4], glm::ivec3(4, 0, 0));
  EXPECT_EQ(h.position[5], glm::ivec3(3, 2, 0));  // 4 + floor((2 * -4 + 4) / 8), floor((2 * 8 + 4) / 8)
  EXPECT_EQ(h.position[6], h.position[5]);
  EXPECT_EQ(h.birth_node, (Ids{4, 4, 5, 5}));
  EXPECT_EQ(bornAt(h, 4), (Ids{0, 1}));
  EXPECT_EQ(bornAt(h, 5), (Ids{2, 3}));
  EXPECT_TRUE(bornAt(h, 6).empty());
  EXPECT_EQ(h.wedge_parent, (Ids{4, 4, 5, 6, 5, 6, kNone}));
}

TEST(Hierarchy, ContainsIsBelow) {
  const Mesh mesh = test::tetrahedron();
  CollapseList list(mesh);
  list.add(3, 1, 4);  // node 4
  list.add(0, 4, 4);  // node 5
  const Hierarchy h = buildHierarchy(mesh, list.sequence, kAnyPoint);
  const bool expected[6][4] = {{true, false, false, false}, {false, true, false, false}, {false, false, true, false},
                               {false, false, false, true}, {false, true, false, true},  {true, true, false, true}};
  for (uint32_t node = 0; node < 6; ++node)
    for (uint32_t vertex = 0; vertex < 4; ++vertex)
      EXPECT_EQ(h.contains(node, vertex), expected[node][vertex]) << node << " " << vertex;
}

TEST(Hierarchy, WedgesAreRenumberedByTheirVertex) {
  Mesh mesh = test::emptyMesh({false, false, 1, 0});
  for (int32_t v = 0; v < 3; ++v) addVertex(mesh, {8 * v, v * v, 0});
  for (uint32_t vertex : {2u, 0u, 1u, 0u}) addWedge(mesh, vertex, {int32_t(mesh.wedgeCount()) * 10, 1});
  mesh.triangles = {{1, 2, 0}, {3, 0, 2}};
  const Hierarchy h = buildHierarchy(mesh, {}, kAnyPoint);
  EXPECT_EQ(h.first_wedge, (Ids{0, 2, 3, 4}));
  EXPECT_EQ(h.wedge_node, (Ids{0, 0, 1, 2}));
  EXPECT_EQ(valuesOf(h, 0), (std::vector<int32_t>{10, 1}));
  EXPECT_EQ(valuesOf(h, 1), (std::vector<int32_t>{30, 1}));
  EXPECT_EQ(valuesOf(h, 2), (std::vector<int32_t>{20, 1}));
  EXPECT_EQ(valuesOf(h, 3), (std::vector<int32_t>{0, 1}));
  EXPECT_EQ(h.face_wedges[0], (std::array<uint32_t, 3>{0, 2, 3}));
  EXPECT_EQ(h.face_wedges[1], (std::array<uint32_t, 3>{1, 3, 2}));
}

/// An edge 0-1 with a face on either side, 2 to its left and 3 to its right; the wedges at 0 and 1 differ between the
/// sides. Faces beyond, where asked for, keep the wedges of a side in use.
struct SeamMesh {
  Mesh mesh = test::emptyMesh({false, false, 1, 0}, 2);
  uint32_t left0, left1, right0, right1;

  explicit SeamMesh(bool faces_beyond_right, uint32_t right_part = 0) {
    for (glm::ivec3 p : {glm::ivec3(20, 20, 0), {28, 20, 0}, {24, 28, 0}, {24, 12, 0}, {12, 20, 0}, {36, 20, 0}})
      addVertex(mesh, p);
    left0 = addWedge(mesh, 0, {0, 0});
    right0 = addWedge(mesh, 0, {100, 0}, right_part);
    left1 = addWedge(mesh, 1, {16, 8});
    right1 = addWedge(mesh, 1, {60, 0}, right_part);
    const uint32_t top = addWedge(mesh, 2), bottom = addWedge(mesh, 3, {0, 0}, right_part);
    const uint32_t before = addWedge(mesh, 4), after = addWedge(mesh, 5);
    const uint32_t right_before = addWedge(mesh, 4, {7, 7}, right_part),
                   right_after = addWedge(mesh, 5, {9, 9}, right_part);
    mesh.triangles = {{left0, left1, top}, {right1, right0, bottom}, {left0, top, before}, {top, left1, after}};
    if (!faces_beyond_right) return;
    mesh.triangles.push_back({right0, right_before, bottom});
    mesh.triangles.push_back({right1, bottom, right_after});
  }
};

TEST(HierarchyWedges, ADyingFaceUnitesTheWedgesAtItsCorners) {
  const SeamMesh seam(true);
  CollapseList list(seam.mesh);
  const uint32_t node = list.add(0, 1, 2);
  const Hierarchy h = buildHierarchy(seam.mesh, list.sequence, kAnyPoint);
  const Ids parents = wedgesOf(h, node);
  ASSERT_EQ(parents.size(), 2u);
  // Wedges were numbered by vertex from the start, so ids are the mesh's.
  EXPECT_EQ(h.wedge_parent[seam.left0], parents[0]);
  EXPECT_EQ(h.wedge_parent[seam.left1], parents[0]);
  EXPECT_EQ(h.wedge_parent[seam.right0], parents[1]);
  EXPECT_EQ(h.wedge_parent[seam.right1], parents[1]);
  EXPECT_EQ(valuesOf(h, parents[0]), (std::vector<int32_t>{4, 2}));
  EXPECT_EQ(valuesOf(h, parents[1]), (std::vector<int32_t>{90, 0}));  // 100 + floor((2 * -40 + 4) / 8)
  EXPECT_EQ(bornAt(h, node), (Ids{0, 1}));
}

TEST(HierarchyWedges, AWedgeWithoutPartnerKeepsItsValues) {
  SeamMesh seam(true);
  const uint32_t alone = addWedge(seam.mesh, 0, {7, 9});
  const uint32_t far = addVertex(seam.mesh, {4, 4, 4});
  seam.mesh.triangles.push_back({alone, addWedge(seam.mesh, far), seam.mesh.triangles[2][2]});
  CollapseList list(seam.mesh);
  const uint32_t node = list.add(0, 1, 5);
  const Hierarchy h = buildHierarchy(seam.mesh, list.sequence, kAnyPoint);
  ASSERT_EQ(wedgesOf(h, node).size(), 3u);
  const uint32_t renumbered = 2;  // the third wedge of vertex 0
  EXPECT_EQ(valuesOf(h, renumbered), (std::vector<int32_t>{7, 9}));
  EXPECT_EQ(valuesOf(h, h.wedge_parent[renumbered]), (std::vector<int32_t>{7, 9}));
}

TEST(HierarchyWedges, TwoWedgesAtOneChildMayBecomeOne) {
  SeamMesh seam(true);
  // Vertex 1 has one wedge, which both faces use: the seam ends there.
  for (auto& triangle : seam.mesh.triangles)
    for (uint32_t& wedge : triangle)
      if (wedge == seam.right1) wedge = seam.left1;
  CollapseList list(seam.mesh);
  const uint32_t node = list.add(0, 1, 2);
  const Hierarchy h = buildHierarchy(seam.mesh, list.sequence, kAnyPoint);
  const Ids parents = wedgesOf(h, node);
  EXPECT_EQ(h.wedge_parent[seam.left0], parents[0]);
  EXPECT_EQ(h.wedge_parent[seam.right0], parents[0]);
  EXPECT_EQ(h.wedge_parent[seam.left1], parents[0]);
  // Between the first member on either side.
  EXPECT_EQ(valuesOf(h, parents[0]), (std::vector<int32_t>{4, 2}));
}

TEST(HierarchyWedges, AClassThatLostItsLastFaceJoinsOneInUse) {
  const SeamMesh seam(false);
  CollapseList list(seam.mesh);
  const uint32_t node = list.add(0, 1, 2);
  const Hierarchy h = buildHierarchy(seam.mesh, list.sequence, kAnyPoint);
  const Ids parents = wedgesOf(h, node);
  ASSERT_EQ(parents.size(), 1u);
  for (uint32_t wedge : {seam.left0, seam.left1, seam.right0, seam.right1})
    EXPECT_EQ(h.wedge_parent[wedge], parents[0]);
  EXPECT_EQ(valuesOf(h, parents[0]), (std::vector<int32_t>{4, 2}));
}

TEST(HierarchyWedges, OfSeveralInUseItJoinsTheNearest) {
  SeamMesh seam(false);
  // Vertex 1 has one more wedge in use, nearer to the right side's at vertex 0 than the left side's there is.
  const uint32_t near = addWedge(seam.mesh, 1, {90, 0});
  seam.mesh.triangles[3][1] = near;
  CollapseList list(seam.mesh);
  const uint32_t node = list.add(0, 1, 2);
  const Hierarchy h = buildHierarchy(seam.mesh, list.sequence, kAnyPoint);
  const Ids parents = wedgesOf(h, node), at_1 = wedgesOf(h, 1);
  ASSERT_EQ(parents.size(), 2u);
  ASSERT_EQ(at_1.size(), 3u);
  EXPECT_EQ(h.wedge_parent[seam.left0], parents[0]);
  for (uint32_t wedge : {seam.right0, at_1[1], at_1[2]}) EXPECT_EQ(h.wedge_parent[wedge], parents[1]);
}

TEST(HierarchyWedges, ButNeverOneOfAnotherPart) {
  const SeamMesh seam(false, 1);
  CollapseList list(seam.mesh);
  const uint32_t node = list.add(0, 1, 2);
  const Hierarchy h = buildHierarchy(seam.mesh, list.sequence, kAnyPoint);
  const Ids parents = wedgesOf(h, node);
  ASSERT_EQ(parents.size(), 2u);
  EXPECT_EQ(h.wedge_part[parents[0]], 0u);
  EXPECT_EQ(h.wedge_part[parents[1]], 1u);
  EXPECT_EQ(valuesOf(h, parents[1]), (std::vector<int32_t>{90, 0}));
}

TEST(HierarchyWedges, ANodeWithoutFacesStillHasAWedge) {
  const Mesh mesh = test::plainMesh({{0, 0, 0}, {8, 0, 0}, {0, 8, 0}}, {{0, 1, 2}});
  CollapseList list(mesh);
  const uint32_t node = list.add(0, 1, 4);
  const Hierarchy h = buildHierarchy(mesh, list.sequence, kAnyPoint);
  EXPECT_EQ(wedgesOf(h, node).size(), 1u);
  EXPECT_EQ(h.birth_node, Ids{node});
}

// Two nodes that share no face: a collapse across a gap. Nothing is born, nothing united.
TEST(HierarchyWedges, ACollapseWithoutAFaceKeepsBothSidesWedges) {
  const Mesh mesh =
      test::plainMesh({{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {40, 0, 0}, {48, 0, 0}, {40, 8, 0}}, {{0, 1, 2}, {3, 4, 5}});
  CollapseList list(mesh);
  const uint32_t node = list.add(1, 3, 4);
  const Hierarchy h = buildHierarchy(mesh, list.sequence, kAnyPoint);
  EXPECT_EQ(wedgesOf(h, node).size(), 2u);
  EXPECT_TRUE(h.born.empty());
}

// ---- Collapses that cannot be ----

void expectRefused(const Mesh& mesh, const CollapseSequence& sequence, uint32_t shift, const std::string& sentence) {
  try {
    buildHierarchy(mesh, sequence, shift);
    FAIL() << "taken, but should say: " << sentence;
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()), sentence);
  }
}

TEST(HierarchyRefuses, ANodeThatIsGone) {
  const Mesh mesh = test::tetrahedron();
  CollapseList list(mesh);
  list.add(0, 1, 4);
  list.add(1, 2, 4);
  expectRefused(mesh, list.sequence, kAnyPoint, "collapse 1: names a node that is not in the cut");
}

TEST(HierarchyRefuses, ANodeThatDoesNotExistYet) {
  const Mesh mesh = test::tetrahedron();
  CollapseList list(mesh);
  list.add(0, 1, 4);
  list.sequence.collapses[0].child[1] = 4;
  expectRefused(mesh, list.sequence, kAnyPoint, "collapse 0: names a node that is not in the cut");
}

TEST(HierarchyRefuses, ANodeWithItselfAndAWrongEighth) {
  const Mesh mesh = test::tetrahedron();
  const std::string sentence = "collapse 0: merges a node with itself or has no valid t8";
  CollapseList itself(mesh);
  itself.add(2, 2, 4);
  expectRefused(mesh, itself.sequence, kAnyPoint, sentence);
  CollapseList ninth(mesh);
  ninth.add(2, 1, 8);
  ninth.sequence.collapses[0].t8 = 9;
  expectRefused(mesh, ninth.sequence, kAnyPoint, sentence);
}

TEST(HierarchyRefuses, AParentOffItsLattice) {
  const Mesh mesh = test::tetrahedron();  // edges of length 8: step 8 at shift 0, 4 at 1, 2 at 2, 1 from 3 on
  for (uint32_t shift = 0; shift < 5; ++shift) {
    CollapseList list(mesh);
    list.add(0, 1, 4);
    list.sequence.collapses[0].position.y += 8;
    EXPECT_NO_THROW(buildHierarchy(mesh, list.sequence, shift));
    list.sequence.collapses[0].position.y -= 7;
    if (shift < 3)
      expectRefused(mesh, list.sequence, shift, "collapse 0: puts the parent off its lattice");
    else
      EXPECT_NO_THROW(buildHierarchy(mesh, list.sequence, shift));
  }
}

}  // namespace
}  // namespace lithe::bake
