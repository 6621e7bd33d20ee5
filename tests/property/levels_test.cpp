// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// What every level of every file keeps: whole surfaces, whole skins, no cracks, honest errors.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

#include "decoded_character.h"
#include "lithe/bake/poses.h"

namespace lithe::test {
namespace {

class Levels : public DecodedCharacter {};

TEST_P(Levels, IndicesDrawWholeTrianglesOfTheirPart) {
  const lithe_hierarchy h = asset.hierarchy();
  for (uint32_t level = 0; level < levelCount(); ++level) {
    std::vector<lithe_range> ranges;
    const std::vector<uint32_t> indices = asset.indices(level, &ranges);
    EXPECT_EQ(indices.size(), 3u * asset.level(level).triangle_count);
    uint32_t end = 0;
    for (uint32_t part = 0; part < ranges.size(); ++part) {
      ASSERT_EQ(ranges[part].first_index, end);
      ASSERT_EQ(ranges[part].index_count % 3, 0u);
      end += ranges[part].index_count;
      for (uint32_t i = ranges[part].first_index; i < end; ++i) {
        ASSERT_LT(indices[i], asset.level(level).vertex_count);
        ASSERT_EQ(h.wedge_part[indices[i]], part);
      }
    }
    ASSERT_EQ(end, indices.size());
  }
}

TEST_P(Levels, NoTriangleIsDegenerateOrDrawnTwice) {
  const lithe_hierarchy h = asset.hierarchy();
  for (uint32_t level = 0; level < levelCount(); ++level) {
    const std::vector<uint32_t> indices = asset.indices(level);
    std::set<std::array<uint32_t, 3>> seen;
    for (size_t i = 0; i < indices.size(); i += 3) {
      std::array<uint32_t, 3> nodes;
      for (size_t k = 0; k < 3; ++k) nodes[k] = h.wedge_node[indices[i + k]];
      ASSERT_TRUE(nodes[0] != nodes[1] && nodes[1] != nodes[2] && nodes[2] != nodes[0]) << "level " << level;
      std::rotate(nodes.begin(), std::min_element(nodes.begin(), nodes.end()), nodes.end());
      ASSERT_TRUE(seen.insert(nodes).second) << "level " << level;
    }
  }
}

// A collapse maps edges to edges: where every edge had a face on either side it still has.
TEST_P(Levels, AClosedCharacterStaysClosed) {
  if (!character.closed) GTEST_SKIP() << "the input is open";
  const lithe_hierarchy h = asset.hierarchy();
  for (uint32_t level = 0; level < levelCount(); ++level) {
    const std::vector<uint32_t> indices = asset.indices(level);
    std::set<std::pair<uint32_t, uint32_t>> edges;
    for (size_t i = 0; i < indices.size(); ++i)
      edges.insert({h.wedge_node[indices[i]], h.wedge_node[indices[i % 3 == 2 ? i - 2 : i + 1]]});
    for (const auto& [from, to] : edges) ASSERT_TRUE(edges.count({to, from})) << "level " << level;
  }
}

TEST_P(Levels, VerticesOfALevelAreOfItsCut) {
  const lithe_hierarchy h = asset.hierarchy();
  for (uint32_t level = 0; level < levelCount(); ++level) {
    lithe_level_extent extent;
    ASSERT_EQ(lithe_asset_level_extent(asset.get(), level, &extent), LITHE_OK);
    for (uint32_t index : asset.indices(level)) {
      const uint32_t node = h.wedge_node[index], child = h.node_first_child[node];
      ASSERT_LT(node, extent.node_count);
      ASSERT_TRUE(child == LITHE_NO_INDEX || child >= extent.node_count) << "a node that the level has split";
    }
  }
}

// Nodes are numbered breadth first: children come in pairs, in the order in which their parents were visited.
TEST_P(Levels, NodesAreNumberedLevelByLevelBreadthFirst) {
  const lithe_hierarchy h = asset.hierarchy();
  std::vector<char> is_child(h.node_count, 0);
  for (uint32_t node = 0; node < h.node_count; ++node) {
    const uint32_t child = h.node_first_child[node];
    if (child == LITHE_NO_INDEX) continue;
    ASSERT_GT(child, node);
    for (uint32_t k = 0; k < 2; ++k) {
      ASSERT_EQ(h.node_parent[child + k], node);
      is_child[child + k] = 1;
    }
  }
  lithe_level_extent before{};
  for (uint32_t level = 0; level < levelCount(); ++level) {
    lithe_level_extent extent;
    ASSERT_EQ(lithe_asset_level_extent(asset.get(), level, &extent), LITHE_OK);
    for (uint32_t node = before.node_count; node < extent.node_count; ++node) {
      ASSERT_EQ(is_child[node] != 0, level > 0);
      if (level > 0 && node + 2 < extent.node_count && (node - before.node_count) % 2 == 0) {
        ASSERT_LT(h.node_parent[node], h.node_parent[node + 2]);
      }
    }
    before = extent;
  }
}

TEST_P(Levels, WeightsSumToOneInEveryFormat) {
  const uint32_t count = asset.info().vertex_count;
  for (const SkinnedVertex& v : asset.vertices(count)) {
    double sum = 0.0;
    for (float weight : v.weights) sum += weight;
    ASSERT_NEAR(sum, 1.0, 1e-6);
  }
  for (const auto& [format, size, one] :
       {std::array<uint32_t, 3>{LITHE_FORMAT_UNORM8, 1, 255}, {LITHE_FORMAT_UNORM16, 2, 65535}}) {
    lithe_vertex_layout layout{};
    layout.struct_size = sizeof(layout);
    layout.stride = 16;
    layout.influences = 8;
    layout.weights = {static_cast<uint16_t>(format), 0};
    std::vector<uint8_t> bytes(size_t{count} * 16, 0);
    ASSERT_EQ(lithe_asset_write_vertices(asset.get(), &layout, 0, count, bytes.data(), bytes.size()), LITHE_OK);
    for (uint32_t v = 0; v < count; ++v) {
      uint32_t sum = 0;
      for (uint32_t i = 0; i < 8; ++i) {
        const uint8_t* p = bytes.data() + 16 * v + size * i;
        sum += size == 1 ? uint32_t{p[0]} : uint32_t{p[0]} + 256u * p[1];
      }
      ASSERT_EQ(sum, one) << "vertex " << v;
    }
  }
}

TEST_P(Levels, TheInfluenceCapHoldsAtEveryLevel) {
  const uint32_t cap = asset.info().max_influences;
  uint32_t most = 0;
  for (const SkinnedVertex& v : asset.vertices(asset.info().vertex_count)) {
    std::set<uint16_t> joints;
    uint32_t used = 0;
    for (uint32_t i = 0; i < 8; ++i) {
      if (v.weights[i] == 0.0f) continue;
      ++used;
      ASSERT_LT(v.joints[i], asset.info().joint_count);
      ASSERT_TRUE(joints.insert(v.joints[i]).second) << "a joint twice";
      ASSERT_TRUE(i == 0 || v.weights[i] <= v.weights[i - 1]) << "heaviest first";
    }
    ASSERT_GE(used, 1u);
    ASSERT_LE(used, cap);
    most = std::max(most, used);
  }
  EXPECT_GT(most, 1u);
}

TEST_P(Levels, TheStatedErrorDoesNotGrowWhenRefining) {
  for (uint32_t level = 1; level < levelCount(); ++level) {
    const lithe_level coarse = asset.level(level - 1), fine = asset.level(level);
    EXPECT_LE(fine.error, coarse.error);
    EXPECT_GT(fine.vertex_count, coarse.vertex_count);
    EXPECT_GE(fine.bytes_end, coarse.bytes_end);
  }
}

// Both sides of a seam are wedges of one node: to the bit the same place and skin, so no pose can part them.
TEST_P(Levels, WedgesOfANodeHaveOnePlaceAndOneSkin) {
  const lithe_hierarchy h = asset.hierarchy();
  const std::vector<SkinnedVertex> vertices = asset.vertices(asset.info().vertex_count);
  std::map<uint32_t, const SkinnedVertex*> of_node;
  for (uint32_t v = 0; v < vertices.size(); ++v) {
    const SkinnedVertex*& first = of_node.try_emplace(h.wedge_node[v], &vertices[v]).first->second;
    ASSERT_EQ(std::memcmp(first, &vertices[v], sizeof(SkinnedVertex)), 0) << "vertex " << v;
  }
}

INSTANTIATE_TEST_SUITE_P(Characters, Levels, testing::ValuesIn(propertyCharacterNames()),
                         [](const auto& test) { return test.param; });

// ---- The posed surface ----

/// A vertex as a shader would pose it.
std::array<float, 3> posed(const SkinnedVertex& v, const bake::Pose& pose) {
  std::array<float, 3> result = {0, 0, 0};
  for (uint32_t i = 0; i < 8; ++i) {
    const glm::mat4 matrix(pose.palette[v.joints[i]]);
    const glm::vec4 moved = matrix * glm::vec4(v.position[0], v.position[1], v.position[2], 1.0f);
    for (int axis = 0; axis < 3; ++axis) result[static_cast<size_t>(axis)] += v.weights[i] * moved[axis];
  }
  return result;
}

TEST(PosedLevels, CoincidentInputVerticesHaveNoGapAtAnyLevel) {
  const bake::Model model = closedTube(16, 40);
  const PropertyCharacter& character = propertyCharacter("baked_tube");
  AssetReader asset(character.bytes);
  asset.supplyThrough(asset.info().level_count - 1);

  // The seam's vertices are there twice in the input and once in the finest cut.
  const lithe_hierarchy h = asset.hierarchy();
  std::set<uint32_t> nodes;
  const uint32_t finest = asset.info().level_count - 1;
  for (uint32_t index : asset.indices(finest)) nodes.insert(h.wedge_node[index]);
  EXPECT_EQ(model.positions.size(), 17u * 41 + 2);
  EXPECT_EQ(nodes.size(), 16u * 41 + 2);

  for (double time : {0.0, 0.4, 1.0}) {
    const bake::Pose pose = bake::clipPose(model, 0, time);
    const std::vector<SkinnedVertex> vertices = asset.vertices(asset.info().vertex_count);
    for (uint32_t level = 0; level <= finest; ++level) {
      const std::vector<uint32_t> indices = asset.indices(level);
      std::set<std::pair<std::array<float, 3>, std::array<float, 3>>> edges;
      for (size_t i = 0; i < indices.size(); ++i)
        edges.insert({posed(vertices[indices[i]], pose), posed(vertices[indices[i % 3 == 2 ? i - 2 : i + 1]], pose)});
      // A gap, however small, would leave an edge of either side without its opposite.
      for (const auto& [from, to] : edges) ASSERT_TRUE(edges.count({to, from})) << "level " << level << " at " << time;
    }
  }
}

}  // namespace
}  // namespace lithe::test
