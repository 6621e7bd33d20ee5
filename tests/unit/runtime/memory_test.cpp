// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "memory.h"

#include <gtest/gtest.h>

#include "malloc_allocator.h"
#include "random.h"

namespace lithe::runtime {
namespace {

constexpr uint32_t kStride = 7, kSkin = 2 * 3;
constexpr RecordWidths kWidths{kStride, kSkin / 2};

void fill(Decoded* d, const Counts& counts, uint32_t seed) {
  d->node_count = counts.nodes, d->wedge_count = counts.wedges, d->face_count = counts.faces;
  d->hidden_count = counts.hidden;
  for (uint32_t i = 0; i < counts.nodes; ++i) {
    d->node_position[3 * i + 2] = static_cast<uint16_t>(i + seed);
    d->node_parent[i] = i + seed + 1, d->node_first_child[i] = i + seed + 2, d->node_first_wedge[i] = i + seed + 3;
    d->node_first_corner[i] = i + seed + 4, d->node_skin[kSkin * i + kSkin - 1] = static_cast<uint16_t>(i + seed);
  }
  if (counts.nodes) d->node_first_wedge[counts.nodes] = seed;
  for (uint32_t i = 0; i < counts.wedges; ++i) {
    d->wedge_node[i] = i + seed, d->wedge_parent[i] = i + seed + 1, d->wedge_part[i] = static_cast<uint16_t>(i + seed);
    d->wedge_attributes[kStride * i + kStride - 1] = static_cast<uint16_t>(i + seed);
  }
  for (uint32_t i = 0; i < 3 * counts.faces; ++i) d->face_wedges[i] = i + seed, d->corner_next[i] = i + seed + 1;
  for (uint32_t i = 0; i < counts.hidden; ++i) d->hidden_faces[i] = i + seed;
}

void expectFilled(const Decoded& d, const Counts& counts, uint32_t seed) {
  for (uint32_t i = 0; i < counts.nodes; ++i) {
    ASSERT_EQ(d.node_position[3 * i + 2], static_cast<uint16_t>(i + seed));
    ASSERT_EQ(d.node_parent[i], i + seed + 1);
    ASSERT_EQ(d.node_first_child[i], i + seed + 2);
    ASSERT_EQ(d.node_first_wedge[i], i + seed + 3);
    ASSERT_EQ(d.node_first_corner[i], i + seed + 4);
    ASSERT_EQ(d.node_skin[kSkin * i + kSkin - 1], static_cast<uint16_t>(i + seed));
  }
  if (counts.nodes) {
    ASSERT_EQ(d.node_first_wedge[counts.nodes], seed);
  }
  for (uint32_t i = 0; i < counts.wedges; ++i) {
    ASSERT_EQ(d.wedge_node[i], i + seed);
    ASSERT_EQ(d.wedge_parent[i], i + seed + 1);
    ASSERT_EQ(d.wedge_part[i], static_cast<uint16_t>(i + seed));
    ASSERT_EQ(d.wedge_attributes[kStride * i + kStride - 1], static_cast<uint16_t>(i + seed));
  }
  for (uint32_t i = 0; i < 3 * counts.faces; ++i) {
    ASSERT_EQ(d.face_wedges[i], i + seed);
    ASSERT_EQ(d.corner_next[i], i + seed + 1);
  }
  for (uint32_t i = 0; i < counts.hidden; ++i) ASSERT_EQ(d.hidden_faces[i], i + seed);
}

// Whatever grows, shrinks or fails, what was there is there, and the account is right to the byte.
TEST(Arrays, KeepTheirEntriesThroughGrowingShrinkingAndFailing) {
  test::Random random(4);
  for (uint32_t trial = 0; trial < 200; ++trial) {
    test::FailingAllocator memory;
    const lithe_allocator allocator = memory.get();
    Decoded d = {};
    Counts held = {};
    for (uint32_t step = 0; step < 12; ++step) {
      const Counts next = {held.nodes + random.below(20), held.wedges + random.below(30), held.faces + random.below(9),
                           held.hidden + random.below(3)};
      memory.fail_at = random.below(2) ? memory.calls + random.below(5) : SIZE_MAX;
      const bool grown = reserveDecoded(allocator, next, kWidths, &d);
      ASSERT_EQ(grown, memory.fail_at >= memory.calls);
      expectFilled(d, held, trial + step);
      memory.fail_at = SIZE_MAX;
      if (random.below(3) == 0) {
        const Counts exact = held;
        shrinkDecoded(allocator, exact, kWidths, &d);
        expectFilled(d, held, trial + step);
        ASSERT_EQ(memory.bytes, decodedBytes(exact, kWidths));
      }
      ASSERT_TRUE(reserveDecoded(allocator, next, kWidths, &d));
      fill(&d, next, trial + step + 1);
      held = next;
    }
    ASSERT_EQ(memory.bytes,
              decodedBytes({d.node_capacity, d.wedge_capacity, d.face_capacity, d.hidden_capacity}, kWidths));
    freeDecoded(allocator, kWidths, &d);
    ASSERT_EQ(memory.bytes, 0u);
    ASSERT_EQ(d.node_capacity, 0u);
  }
}

TEST(Arrays, GrowOneBlockAtATime) {
  test::FailingAllocator memory;
  const lithe_allocator allocator = memory.get();
  Decoded d = {};
  const Counts small = {100, 150, 190, 10}, large = {1000, 1500, 1900, 100};
  ASSERT_TRUE(reserveDecoded(allocator, small, kWidths, &d));
  fill(&d, small, 0);
  ASSERT_TRUE(reserveDecoded(allocator, large, kWidths, &d));
  EXPECT_LE(memory.peak, decodedBytes(large, kWidths) + largestBlock(small, kWidths));
  freeDecoded(allocator, kWidths, &d);
}

TEST(Blocks, BeyondTheAddressSpaceAreRefusedUnasked) {
  test::FailingAllocator memory;
  EXPECT_EQ(allocateBlock(memory.get(), UINT64_MAX / 4 * 3), nullptr);
  EXPECT_EQ(memory.calls, 0u);
}

}  // namespace
}  // namespace lithe::runtime
