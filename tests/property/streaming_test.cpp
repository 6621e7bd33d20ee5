// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// However pages come and go, what is drawn is the same: every prefix draws, nothing that was there changes, what comes
// back is what was dropped, and nobody else's decoding matters.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <thread>

#include "asset_reader.h"
#include "property_characters.h"

namespace lithe::test {
namespace {

class Streaming : public testing::TestWithParam<std::string> {
 protected:
  const PropertyCharacter& character = propertyCharacter(GetParam());

  std::vector<DrawnLevel> whole() const {
    AssetReader asset(character.bytes);
    asset.supplyThrough(asset.info().level_count - 1);
    return drawnLevels(asset);
  }
};

TEST_P(Streaming, EveryPrefixOfPagesDrawsItsLevels) {
  const std::vector<DrawnLevel> expected = whole();
  AssetReader asset(character.bytes);
  EXPECT_EQ(lithe_asset_resident_level(asset.get()), LITHE_NO_LEVEL);
  uint32_t pages = 0;
  while (asset.supplyNext()) {
    ++pages;
    const uint32_t resident = lithe_asset_resident_level(asset.get());
    ASSERT_NE(resident, LITHE_NO_LEVEL);
    ASSERT_LE(asset.level(resident).page_end, pages);
    if (resident + 1 < asset.info().level_count) {
      ASSERT_GT(asset.level(resident + 1).page_end, pages);
    }
    for (uint32_t level = 0; level <= resident; ++level)
      ASSERT_EQ(drawnLevel(asset, level), expected[level]) << "level " << level << " after " << pages << " pages";
  }
  EXPECT_EQ(pages, asset.info().page_count);
}

TEST_P(Streaming, ALevelBeyondThePrefixIsRefusedNotDrawn) {
  AssetReader asset(character.bytes);
  asset.supplyThrough(0);
  const uint32_t finest = asset.info().level_count - 1;
  const uint32_t resident = lithe_asset_resident_level(asset.get());
  if (resident == finest) GTEST_SKIP() << "one page holds everything";
  std::vector<uint32_t> indices(asset.level(finest).index_count);
  EXPECT_EQ(
      lithe_asset_write_indices(asset.get(), finest, LITHE_INDEX_U32, indices.data(), 4 * indices.size(), nullptr),
      LITHE_ERROR_NOT_RESIDENT);
  const lithe_vertex_layout layout = lithe_vertex_layout_default(asset.get());
  std::vector<uint8_t> bytes(size_t{asset.level(finest).vertex_count} * layout.stride);
  EXPECT_EQ(
      lithe_asset_write_vertices(asset.get(), &layout, 0, asset.level(finest).vertex_count, bytes.data(), bytes.size()),
      LITHE_ERROR_NOT_RESIDENT);
}

// The buffers of a coarser level are the beginning of a finer one's: a frame in flight may go on reading them.
TEST_P(Streaming, FinerLevelsOnlyAppendVertices) {
  const std::vector<DrawnLevel> levels = whole();
  for (size_t level = 1; level < levels.size(); ++level) {
    const auto &coarse = levels[level - 1].vertices, &fine = levels[level].vertices;
    ASSERT_LT(coarse.size(), fine.size());
    ASSERT_TRUE(std::equal(coarse.begin(), coarse.end(), fine.begin())) << "level " << level;
  }
}

TEST_P(Streaming, MorphSourcesLieInTheLevelAbove) {
  AssetReader asset(character.bytes);
  asset.supplyThrough(asset.info().level_count - 1);
  const std::vector<DrawnLevel> levels = drawnLevels(asset);
  const lithe_hierarchy h = asset.hierarchy();
  for (uint32_t level = 1; level < levels.size(); ++level) {
    const uint32_t above = asset.level(level - 1).vertex_count;
    for (uint32_t v = 0; v < levels[level].morph_sources.size(); ++v) {
      uint32_t expected = v;
      while (expected >= above) expected = h.wedge_parent[expected];
      ASSERT_EQ(levels[level].morph_sources[v], expected) << "level " << level;
    }
  }
}

TEST_P(Streaming, EvictedPagesComeBackTheSame) {
  const std::vector<DrawnLevel> expected = whole();
  AssetReader asset(character.bytes);
  const uint32_t finest = asset.info().level_count - 1;
  for (uint32_t kept = 0; kept <= finest; ++kept) {
    asset.supplyThrough(finest);
    ASSERT_EQ(lithe_asset_evict(asset.get(), kept), LITHE_OK);
    ASSERT_GE(lithe_asset_resident_level(asset.get()), kept);
    for (uint32_t level = 0; level <= kept; ++level)
      ASSERT_EQ(drawnLevel(asset, level), expected[level]) << "kept " << kept;
  }
  asset.supplyThrough(finest);
  ASSERT_EQ(drawnLevels(asset), expected);
}

TEST_P(Streaming, TwoAssetsOnTwoThreadsDecodeTheSame) {
  const std::vector<DrawnLevel> expected = whole();
  std::vector<DrawnLevel> drawn[2];
  std::thread threads[2];
  for (int i = 0; i < 2; ++i)
    threads[i] = std::thread([this, &result = drawn[i]] {
      for (int round = 0; round < 3; ++round) {
        AssetReader asset(character.bytes);
        asset.supplyThrough(asset.info().level_count - 1);
        result = drawnLevels(asset);
      }
    });
  for (std::thread& thread : threads) thread.join();
  for (const auto& levels : drawn) EXPECT_EQ(levels, expected);
}

// Whatever order of splits the file has, each gives back the children that its collapse merged.
TEST_P(Streaming, EverySplitUndoesItsCollapse) {
  const bake::Hierarchy& meant = character.hierarchy;
  if (meant.nodeCount() == 0) GTEST_SKIP() << "the bake keeps its hierarchy to itself";
  AssetReader asset(character.bytes);
  asset.supplyThrough(asset.info().level_count - 1);
  const lithe_hierarchy h = asset.hierarchy();
  ASSERT_EQ(h.node_count, meant.nodeCount());
  using Point = std::array<int32_t, 3>;
  using Split = std::array<Point, 3>;  // the parent, the lower child, the higher child
  const auto inOrder = [](Split s) {
    if (s[2] < s[1]) std::swap(s[1], s[2]);
    return s;
  };
  const auto read = [&](uint32_t node) {
    return Point{h.node_position[3 * node], h.node_position[3 * node + 1], h.node_position[3 * node + 2]};
  };
  const auto wanted = [&](uint32_t node) {
    return Point{meant.position[node].x, meant.position[node].y, meant.position[node].z};
  };
  std::map<Split, int> balance;
  for (uint32_t node = 0; node < h.node_count; ++node) {
    const uint32_t child = h.node_first_child[node];
    if (child != LITHE_NO_INDEX) ++balance[inOrder({read(node), read(child), read(child + 1)})];
  }
  EXPECT_FALSE(balance.empty());
  for (uint32_t node = meant.vertex_count; node < meant.nodeCount(); ++node)
    --balance[inOrder({wanted(node), wanted(meant.children[node][0]), wanted(meant.children[node][1])})];
  for (const auto& [split, count] : balance) ASSERT_EQ(count, 0);
}

INSTANTIATE_TEST_SUITE_P(Characters, Streaming, testing::ValuesIn(propertyCharacterNames()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace lithe::test
