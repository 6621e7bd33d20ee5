// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "hand_made_asset.h"

namespace lithe::test {
namespace {

/// A level's drawn faces by part, in their order: what the hand that made the asset remembers.
std::vector<std::vector<uint32_t>> expectedParts(const HandMade& hand, uint32_t level) {
  std::vector<std::vector<uint32_t>> parts(hand.shape().parts);
  const HandLevel& l = hand.levels[level];
  for (uint32_t f = 0; f < l.faces.size(); ++f) {
    if (std::binary_search(l.hidden.begin(), l.hidden.end(), f)) continue;
    auto& part = parts[hand.wedges[l.faces[f][0]].part];
    part.insert(part.end(), l.faces[f].begin(), l.faces[f].end());
  }
  return parts;
}

template <typename Index>
void expectLevel(const HandMade& hand, const lithe_asset* asset, uint32_t level, lithe_index_type type) {
  lithe_level info;
  ASSERT_EQ(lithe_asset_level(asset, level, &info), LITHE_OK);
  std::vector<Index> indices(info.index_count + 1, Index(0x7777));
  std::vector<lithe_range> ranges(hand.shape().parts);
  ASSERT_EQ(
      lithe_asset_write_indices(asset, level, type, indices.data(), info.index_count * sizeof(Index), ranges.data()),
      LITHE_OK);
  EXPECT_EQ(indices.back(), Index(0x7777));
  const auto parts = expectedParts(hand, level);
  uint32_t next = 0;
  for (uint32_t p = 0; p < parts.size(); ++p) {
    ASSERT_EQ(ranges[p].first_index, next);
    ASSERT_EQ(ranges[p].index_count, parts[p].size());
    for (const uint32_t wedge : parts[p]) ASSERT_EQ(indices[next++], wedge) << "level " << level;
  }
  EXPECT_EQ(next, info.index_count);
}

TEST(Indices, EveryLevelIsTheCutItWasWhenItWasMade) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    const HandMade hand({}, seed);
    const auto asset = hand.open();
    ASSERT_TRUE(asset);
    for (uint32_t level = 0; level < hand.levels.size(); ++level) {
      expectLevel<uint16_t>(hand, asset.get(), level, LITHE_INDEX_U16);
      expectLevel<uint32_t>(hand, asset.get(), level, LITHE_INDEX_U32);
    }
  }
}

TEST(Indices, CoarserLevelsStayAsTheyWereWhenFinerOnesAreDropped) {
  const HandMade hand({}, 5);
  const auto asset = hand.open();
  for (uint32_t left = static_cast<uint32_t>(hand.levels.size()); left-- > 0;) {
    ASSERT_EQ(lithe_asset_evict(asset.get(), left), LITHE_OK);
    for (uint32_t level = 0; level <= left; ++level) expectLevel<uint32_t>(hand, asset.get(), level, LITHE_INDEX_U32);
    if (left + 1 < hand.levels.size()) {
      std::vector<uint32_t> indices(10000);
      EXPECT_EQ(lithe_asset_write_indices(asset.get(), left + 1, LITHE_INDEX_U32, indices.data(), 40000, nullptr),
                LITHE_ERROR_NOT_RESIDENT);
    }
  }
}

TEST(Indices, BadArguments) {
  const HandMade hand({}, 3);
  const auto asset = hand.open();
  lithe_level level;
  ASSERT_EQ(lithe_asset_level(asset.get(), 1, &level), LITHE_OK);
  std::vector<uint32_t> out(level.index_count + 1);
  const size_t size = 4 * level.index_count;
  auto call = [&](const lithe_asset* a, uint32_t l, int type, void* to, size_t bytes) {
    return lithe_asset_write_indices(a, l, static_cast<lithe_index_type>(type), to, bytes, nullptr);
  };
  EXPECT_EQ(call(asset.get(), 1, 4, out.data(), size), LITHE_OK);
  EXPECT_EQ(call(nullptr, 1, 4, out.data(), size), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call(asset.get(), 4, 4, out.data(), size), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call(asset.get(), 1, 3, out.data(), size), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call(asset.get(), 1, 4, nullptr, size), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call(asset.get(), 1, 4, reinterpret_cast<uint8_t*>(out.data()) + 2, size), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call(asset.get(), 1, 4, out.data(), size - 1), LITHE_ERROR_BUFFER_TOO_SMALL);
}

TEST(Indices, SixteenBitsOnlyWhereTheyReach) {
  AssetShape shape;
  shape.splits = {};
  shape.base_nodes = 22000;  // times three parts
  const HandMade hand(shape);
  const auto asset = hand.open();
  ASSERT_TRUE(asset);
  std::vector<uint32_t> out(300000);
  EXPECT_EQ(lithe_asset_write_indices(asset.get(), 0, LITHE_INDEX_U16, out.data(), 1200000, nullptr),
            LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_asset_write_indices(asset.get(), 0, LITHE_INDEX_U32, out.data(), 1200000, nullptr), LITHE_OK);
}

TEST(MorphSources, LeadToTheWedgeOfTheLevelAbove) {
  const HandMade hand({}, 9);
  const auto asset = hand.open();
  for (uint32_t level = 1; level < hand.levels.size(); ++level) {
    const uint32_t count = hand.levels[level].wedge_count, coarser = hand.levels[level - 1].wedge_count;
    std::vector<uint32_t> sources(count);
    ASSERT_EQ(lithe_asset_write_morph_sources(asset.get(), level, sources.data(), count), LITHE_OK);
    for (uint32_t w = 0; w < count; ++w) {
      uint32_t expected = w;
      while (expected >= coarser) expected = hand.wedges[expected].parent;
      ASSERT_EQ(sources[w], expected);
      if (w < coarser) {
        ASSERT_EQ(sources[w], w);
      }
    }
  }
}

TEST(MorphSources, BadArguments) {
  const HandMade hand({}, 9);
  const auto asset = hand.open();
  std::vector<uint32_t> out(hand.levels[3].wedge_count);
  EXPECT_EQ(lithe_asset_write_morph_sources(asset.get(), 0, out.data(), out.size()), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_asset_write_morph_sources(asset.get(), 4, out.data(), out.size()), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_asset_write_morph_sources(nullptr, 1, out.data(), out.size()), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_asset_write_morph_sources(asset.get(), 1, nullptr, out.size()), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_asset_write_morph_sources(asset.get(), 3, out.data(), out.size() - 1), LITHE_ERROR_BUFFER_TOO_SMALL);
  ASSERT_EQ(lithe_asset_evict(asset.get(), 1), LITHE_OK);
  EXPECT_EQ(lithe_asset_write_morph_sources(asset.get(), 2, out.data(), out.size()), LITHE_ERROR_NOT_RESIDENT);
}

}  // namespace
}  // namespace lithe::test
