// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// What holds for every hierarchy, on random characters, computed again in the plainest way.
#include <gtest/gtest.h>

#include "attributes.h"
#include "lithe/bake/hierarchy.h"
#include "lithe/format/octahedral.h"
#include "random_character.h"

namespace lithe::bake {
namespace {

struct Case {
  const char* name;
  test::CharacterShape shape;
};

std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

test::CharacterShape shapeWith(auto&& change) {
  test::CharacterShape shape;
  change(shape);
  return shape;
}

class HierarchyInvariants : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    const test::CharacterShape& shape = GetParam().shape;
    mesh = test::randomMesh(shape, 41);
    sequence = test::randomCollapses(mesh, 5, 4, shape.joints, 42);
    h = buildHierarchy(mesh, sequence, 4);
  }

  /// The node above a node once `node_end` nodes exist.
  uint32_t above(uint32_t node, uint32_t node_end) const {
    while (h.parent[node] < node_end) node = h.parent[node];
    return node;
  }

  Mesh mesh;
  CollapseSequence sequence;
  Hierarchy h;
};

TEST_P(HierarchyInvariants, NodesAreTheCollapses) {
  ASSERT_EQ(h.nodeCount(), mesh.vertexCount() + sequence.collapses.size());
  for (uint32_t i = 0; i < sequence.collapses.size(); ++i) {
    const uint32_t node = mesh.vertexCount() + i;
    const Collapse& c = sequence.collapses[i];
    for (uint32_t k = 0; k < 2; ++k) {
      EXPECT_EQ(h.children[node][k], c.child[k]);
      EXPECT_EQ(h.parent[c.child[k]], node);
    }
    EXPECT_EQ(h.position[node], c.position);
    EXPECT_EQ(h.skin[node], c.skin);
    EXPECT_EQ(h.t8[node], c.t8);
  }
}

TEST_P(HierarchyInvariants, ContainsIsTheWalkToTheRoot) {
  for (uint32_t vertex = 0; vertex < h.vertex_count; ++vertex) {
    std::vector<char> is_above(h.nodeCount(), 0);
    for (uint32_t node = vertex; node != kNone; node = h.parent[node]) is_above[node] = 1;
    for (uint32_t node = 0; node < h.nodeCount(); ++node) ASSERT_EQ(h.contains(node, vertex), is_above[node] != 0);
  }
}

// A face is born by the split of the lowest node that has two of its corners below it.
TEST_P(HierarchyInvariants, EveryFaceIsBornByExactlyOneSplit) {
  ASSERT_EQ(h.birth_node.size(), mesh.triangles.size());
  for (uint32_t f = 0; f < h.birth_node.size(); ++f) {
    uint32_t expected = kNone;
    for (uint32_t node = h.vertex_count; node < h.nodeCount() && expected == kNone; ++node) {
      uint32_t below = 0;
      for (uint32_t wedge : h.face_wedges[f]) below += h.contains(node, h.wedge_node[wedge]);
      if (below >= 2) expected = node;
    }
    ASSERT_EQ(h.birth_node[f], expected) << f;
  }
  std::vector<char> listed(mesh.triangles.size(), 0);
  for (uint32_t node = 0; node < h.nodeCount(); ++node)
    for (uint32_t i = h.born_begin[node]; i < h.born_begin[node + 1]; ++i) {
      ASSERT_EQ(h.birth_node[h.born[i]], node);
      ASSERT_TRUE(i == h.born_begin[node] || h.born[i - 1] < h.born[i]);
      ASSERT_FALSE(listed[h.born[i]]++);
    }
  for (uint32_t f = 0; f < listed.size(); ++f) ASSERT_EQ(listed[f] != 0, h.birth_node[f] != kNone);
}

TEST_P(HierarchyInvariants, WedgesOfANodeAreConsecutiveAndHangTogether) {
  ASSERT_EQ(h.first_wedge.size(), h.nodeCount() + 1u);
  ASSERT_EQ(h.first_wedge.back(), h.wedge_node.size());
  ASSERT_EQ(h.wedge_attributes.size(), h.wedge_node.size() * h.record.stride);
  std::vector<uint32_t> children(h.wedge_node.size(), 0);
  for (uint32_t node = 0; node < h.nodeCount(); ++node) {
    ASSERT_LT(h.first_wedge[node], h.first_wedge[node + 1]) << "a node without a wedge";
    for (uint32_t w = h.first_wedge[node]; w < h.first_wedge[node + 1]; ++w) {
      ASSERT_EQ(h.wedge_node[w], node);
      if (h.parent[node] == kNone) {
        ASSERT_EQ(h.wedge_parent[w], kNone);
        continue;
      }
      ASSERT_EQ(h.wedge_node[h.wedge_parent[w]], h.parent[node]);
      ASSERT_EQ(h.wedge_part[h.wedge_parent[w]], h.wedge_part[w]);
      ++children[h.wedge_parent[w]];
    }
  }
  for (uint32_t w = h.first_wedge[h.vertex_count]; w < children.size(); ++w) ASSERT_GT(children[w], 0u);
}

TEST_P(HierarchyInvariants, AParentsRecordFollowsFromItsFirstChildren) {
  const int32_t center = format::octahedralCenter(mesh.normal_bits);
  for (uint32_t node = h.vertex_count; node < h.nodeCount(); ++node)
    for (uint32_t w = h.first_wedge[node]; w < h.first_wedge[node + 1]; ++w) {
      uint32_t first[2] = {kNone, kNone};
      for (uint32_t k = 0; k < 2; ++k) {
        const uint32_t child = h.children[node][k];
        for (uint32_t c = h.first_wedge[child + 1]; c-- > h.first_wedge[child];)
          if (h.wedge_parent[c] == w) first[k] = c;
      }
      const uint32_t from = first[0] != kNone ? first[0] : first[1], to = first[1] != kNone ? first[1] : first[0];
      const auto values = [&](uint32_t wedge) { return h.wedge_attributes.data() + size_t{wedge} * h.record.stride; };
      std::vector<int32_t> expected(h.record.stride);
      const DirectionRule rule{center, h.t8[node], h.born_begin[node] < h.born_begin[node + 1]};
      attributesBetween(h.record, values(from), values(to), rule, expected.data());
      for (uint32_t i = 0; i < h.record.stride; ++i) {
        if (from == to) {
          ASSERT_EQ(values(w)[i], values(from)[i]);
        }
        ASSERT_EQ(values(w)[i], expected[i]) << "wedge " << w << " entry " << i;
      }
    }
}

// At every cut the corners of a face that stand meet one wedge each, and a dying face's two wedges have become one.
TEST_P(HierarchyInvariants, AFaceDiesInOneWedge) {
  for (uint32_t f = 0; f < h.face_wedges.size(); ++f) {
    if (h.birth_node[f] == kNone) continue;
    std::vector<uint32_t> at_birth;
    for (uint32_t wedge : h.face_wedges[f]) {
      if (!h.contains(h.birth_node[f], h.wedge_node[wedge])) continue;
      while (h.wedge_node[wedge] != h.birth_node[f]) wedge = h.wedge_parent[wedge];
      at_birth.push_back(wedge);
    }
    ASSERT_GE(at_birth.size(), 2u);
    ASSERT_EQ(at_birth[0], at_birth[1]) << f;
  }
}

TEST_P(HierarchyInvariants, SameInputSameForest) {
  const Hierarchy again = buildHierarchy(mesh, sequence, 4);
  EXPECT_EQ(again.parent, h.parent);
  EXPECT_EQ(again.wedge_parent, h.wedge_parent);
  EXPECT_EQ(again.wedge_attributes, h.wedge_attributes);
  EXPECT_EQ(again.born, h.born);
}

INSTANTIATE_TEST_SUITE_P(Shapes, HierarchyInvariants,
                         testing::Values(Case{"torus", {}}, Case{"patch", shapeWith([](auto& s) { s.closed = false; })},
                                         Case{"seams_and_parts", shapeWith([](auto& s) {
                                                s.seams = true;
                                                s.parts = 3;
                                                s.attributes = {true, true, 2, 1};
                                              })},
                                         Case{"non_manifold", shapeWith([](auto& s) {
                                                s.loose_triangles = 120;
                                                s.parts = 2;
                                                s.seams = true;
                                              })}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace lithe::bake
