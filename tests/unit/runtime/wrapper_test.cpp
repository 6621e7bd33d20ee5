// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// lithe/runtime.hpp: what it adds is ownership and ranges.
#include <gtest/gtest.h>

#include <cstdint>
#include <type_traits>
#include <vector>

#include "hand_made_asset.h"
#include "lithe/runtime.hpp"

namespace lithe::test {
namespace {

TEST(Wrapper, OwnsOneAsset) {
  const HandMade hand({});
  FailingAllocator memory;
  Asset asset;
  EXPECT_FALSE(asset);
  lithe_diagnosis diagnosis;
  ASSERT_EQ(Asset::open(hand.head, &asset, &diagnosis, memory.get()), Result::kOk);
  const size_t one = memory.bytes;
  ASSERT_EQ(Asset::open(hand.head, &asset, nullptr, memory.get()), Result::kOk);
  EXPECT_EQ(memory.bytes, one);
  Asset other = std::move(asset);
  EXPECT_TRUE(other);
  EXPECT_EQ(memory.bytes, one);
  other = Asset();
  EXPECT_EQ(memory.bytes, 0u);
  static_assert(!std::is_copy_constructible_v<Asset> && std::is_nothrow_move_constructible_v<Asset>);
}

TEST(Wrapper, AFailedOpenLeavesTheAssetAsItWas) {
  const HandMade hand({});
  Asset asset;
  ASSERT_EQ(Asset::open(hand.head, &asset), Result::kOk);
  lithe_asset* const before = asset.get();
  std::vector<uint8_t> broken = hand.head;
  broken[0] = 0;
  EXPECT_EQ(Asset::open(broken, &asset), Result::kNotThisFormat);
  EXPECT_EQ(asset.get(), before);
  EXPECT_TRUE(isError(Result::kNotThisFormat));
  EXPECT_FALSE(isError(Result::kComplete));
  EXPECT_STREQ(nameOf(Result::kComplete), "LITHE_COMPLETE");
}

TEST(Wrapper, PassesEveryCallOn) {
  const HandMade hand({});
  Asset asset(hand.open().release());
  const lithe_asset_info info = asset.info();
  EXPECT_EQ(info.level_count, 4u);
  EXPECT_EQ(asset.residentLevel(), 3u);
  EXPECT_STREQ(asset.node(1).name, "joint 1");
  EXPECT_STREQ(asset.part(0).material, "cloth");
  EXPECT_EQ(asset.joint(4).node, 4u);
  EXPECT_EQ(asset.page(2).level, 2u);
  EXPECT_EQ(asset.levelExtent(3).node_count, asset.hierarchy().node_count);
  EXPECT_GT(asset.memory(3), 0u);

  const lithe_vertex_layout layout = asset.defaultLayout();
  std::vector<uint8_t> vertices(layout.stride * info.vertex_count);
  EXPECT_EQ(asset.writeVertices(layout, 0, info.vertex_count, vertices), Result::kOk);
  std::vector<uint16_t> shorts(asset.level(3).index_count);
  std::vector<uint32_t> longs(asset.level(3).index_count), sources(asset.level(3).vertex_count);
  std::vector<lithe_range> ranges(info.part_count);
  EXPECT_EQ(asset.writeIndices(3, shorts, ranges), Result::kOk);
  EXPECT_EQ(asset.writeIndices(3, longs), Result::kOk);
  EXPECT_TRUE(std::equal(shorts.begin(), shorts.end(), longs.begin()));
  ranges.pop_back();
  EXPECT_EQ(asset.writeIndices(3, longs, ranges), Result::kBufferTooSmall);
  EXPECT_EQ(asset.writeMorphSources(3, sources), Result::kOk);
  lithe_request request;
  EXPECT_EQ(asset.nextRequest(3, &request), Result::kComplete);
  EXPECT_EQ(asset.evict(0), Result::kOk);
  EXPECT_EQ(asset.nextRequest(3, &request), Result::kOk);
  EXPECT_EQ(asset.supply(request.page, Span<const uint8_t>()), Result::kTruncated);
}

TEST(Wrapper, SelectsAndDraws) {
  const HandMade hand({});
  Asset asset(hand.open().release());
  lithe_view view = {};
  view.pixels_per_radian = 500;
  view.near_distance = 0.1f;
  view.threshold_px = 1;
  std::vector<lithe_instance> instances(5);
  for (lithe_instance& instance : instances) instance.scale = instance.bias = 1;
  const lithe_asset* assets[] = {asset.get()};
  const lithe_view views[] = {view};
  const lithe_crowd crowd = crowdOf(assets, instances);
  std::vector<uint32_t> wanted(1);
  ASSERT_EQ(select(crowd, views, wanted), Result::kOk);
  EXPECT_EQ(wanted[0], 3u);
  EXPECT_EQ(select(crowd, views, Span<uint32_t>(wanted.data(), 0)), Result::kBufferTooSmall);

  std::vector<uint64_t> scratch(budgetScratch(5) / 8 + 1);
  const Span<uint8_t> bytes(reinterpret_cast<uint8_t*>(scratch.data()), scratch.size() * 8);
  float factor = 0;
  ASSERT_EQ(selectWithin(crowd, views, 1000, bytes, wanted, nullptr, &factor), Result::kOk);
  EXPECT_EQ(factor, 1.0f);
  EXPECT_EQ(selectWithin(crowd, views, 1000, Span<uint8_t>(bytes.data, 8)), Result::kBufferTooSmall);

  std::vector<lithe_range> ranges(12, lithe_range{0, 3});
  const lithe_placement placements[] = {{0, 3, 4, ranges.data()}};
  const uint32_t bound = lithe_draws_bound(placements, 1);
  std::vector<uint32_t> order(5), counters(bound);
  std::vector<lithe_draw> draws(bound);
  uint32_t count = 0;
  ASSERT_EQ(buildDraws(crowd, placements, ~0u, {order, draws, {}, counters}, &count), Result::kOk);
  EXPECT_EQ(count, 3u);
  draws.pop_back();
  EXPECT_EQ(buildDraws(crowd, placements, ~0u, {order, draws, {}, counters}, &count), Result::kBufferTooSmall);
}

TEST(MallocAllocator, AlignsAndFreesEverything) {
  const lithe_allocator own = lithe::mallocAllocator();
  for (size_t alignment = 1; alignment <= 64; alignment *= 2)
    for (const size_t size : {1, 7, 100, 5000}) {
      void* memory = own.alloc(own.user, size, alignment);
      ASSERT_NE(memory, nullptr);
      EXPECT_EQ(reinterpret_cast<uintptr_t>(memory) % alignment, 0u);
      std::memset(memory, 0xff, size);
      own.free(own.user, memory, size);
    }
  EXPECT_EQ(own.alloc(own.user, SIZE_MAX - 10, 64), nullptr);
}

}  // namespace
}  // namespace lithe::test
