// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <map>
#include <tuple>
#include <vector>

#include "lithe/runtime.h"
#include "random.h"

namespace lithe::test {
namespace {

struct Crowd {
  std::vector<std::vector<lithe_range>> ranges;
  std::vector<lithe_placement> placements;
  std::vector<lithe_instance> instances;

  lithe_crowd get() {
    return {nullptr, instances.data(), 0, static_cast<uint32_t>(placements.size()),
            static_cast<uint32_t>(instances.size())};
  }
};

Crowd randomCrowd(Random& random) {
  Crowd crowd;
  const uint32_t assets = random.below(6);
  for (uint32_t a = 0; a < assets; ++a) {
    const uint32_t parts = random.below(4), levels = random.below(5);
    std::vector<lithe_range> ranges(parts * levels);
    for (lithe_range& range : ranges) range = {random.below(10000), 3 * random.below(4)};
    crowd.ranges.push_back(ranges);
    crowd.placements.push_back({static_cast<int32_t>(random.below(1000)) - 100, parts, levels, nullptr});
  }
  for (uint32_t a = 0; a < assets; ++a) crowd.placements[a].ranges = crowd.ranges[a].data();
  for (uint32_t i = 0, count = assets ? random.below(200) : 0; i < count; ++i) {
    lithe_instance instance = {};
    instance.asset = random.below(assets);
    instance.level = static_cast<uint8_t>(random.below(7) == 0 ? LITHE_UNDRAWN : random.below(6));
    instance.views = static_cast<uint8_t>(random.below(4));
    crowd.instances.push_back(instance);
  }
  return crowd;
}

/// The instances of every asset and drawn level that a view of the mask sees, in their order.
std::map<std::tuple<uint32_t, uint32_t>, std::vector<uint32_t>> naiveGroups(const Crowd& crowd, uint32_t view_mask) {
  std::map<std::tuple<uint32_t, uint32_t>, std::vector<uint32_t>> groups;
  for (uint32_t i = 0; i < crowd.instances.size(); ++i) {
    const lithe_instance& instance = crowd.instances[i];
    const uint32_t levels = crowd.placements[instance.asset].level_count;
    if (instance.level == LITHE_UNDRAWN || levels == 0 || (instance.views & view_mask) == 0) continue;
    groups[{instance.asset, std::min<uint32_t>(instance.level, levels - 1)}].push_back(i);
  }
  return groups;
}

TEST(Draws, EqualANaiveModelOverRandomCrowds) {
  Random random(11);
  for (uint32_t trial = 0; trial < 2000; ++trial) {
    Crowd crowd = randomCrowd(random);
    const lithe_crowd given = crowd.get();
    const uint32_t view_mask = random.below(2) ? ~0u : random.below(4);
    const uint32_t assets = static_cast<uint32_t>(crowd.placements.size()),
                   count = static_cast<uint32_t>(crowd.instances.size());
    const uint32_t bound = lithe_draws_bound(crowd.placements.data(), assets);
    std::vector<uint32_t> order(count), counters(bound);
    std::vector<lithe_draw> draws(bound);
    std::vector<lithe_draw_key> keys(bound);
    uint32_t draw_count = 12345;
    ASSERT_EQ(lithe_build_draws(&given, crowd.placements.data(), view_mask, order.data(), draws.data(), keys.data(),
                                &draw_count, counters.data()),
              LITHE_OK);
    ASSERT_LE(draw_count, bound);
    uint32_t next = 0;
    for (const auto& [key, members] : naiveGroups(crowd, view_mask)) {
      const auto [asset, level] = key;
      const lithe_placement& placement = crowd.placements[asset];
      for (uint32_t part = 0; part < placement.part_count; ++part) {
        const lithe_range& range = crowd.ranges[asset][level * placement.part_count + part];
        if (range.index_count == 0) continue;
        ASSERT_LT(next, draw_count);
        const lithe_draw& draw = draws[next];
        ASSERT_EQ(std::tie(keys[next].asset, keys[next].level, keys[next].part), std::tie(asset, level, part));
        ASSERT_EQ(draw.index_count, range.index_count);
        ASSERT_EQ(draw.first_index, range.first_index);
        ASSERT_EQ(draw.vertex_offset, placement.vertex_offset);
        ASSERT_EQ(draw.instance_count, members.size());
        for (uint32_t i = 0; i < members.size(); ++i) ASSERT_EQ(order[draw.first_instance + i], members[i]);
        ++next;
      }
    }
    ASSERT_EQ(next, draw_count);
  }
}

TEST(Draws, KeysMayBeLeftOut) {
  const lithe_range range = {0, 3};
  const lithe_placement placement = {0, 1, 1, &range};
  lithe_instance instance = {};
  uint32_t order, counters[4], draw_count;
  lithe_draw draws[4];
  ASSERT_LE(lithe_draws_bound(&placement, 1), 4u);
  instance.views = 1;
  const lithe_crowd crowd = {nullptr, &instance, 0, 1, 1};
  EXPECT_EQ(lithe_build_draws(&crowd, &placement, 1, &order, draws, nullptr, &draw_count, counters), LITHE_OK);
  EXPECT_EQ(draw_count, 1u);
}

TEST(Draws, BadArguments) {
  const lithe_range range = {0, 3};
  const lithe_placement placement = {0, 1, 1, &range}, lost = {0, 1, 1, nullptr};
  lithe_instance instance = {}, stranger = {};
  stranger.asset = 1;
  instance.views = stranger.views = 1;
  uint32_t order, counters[4], count;
  lithe_draw draws[4];
  auto call = [&](const lithe_placement* p, lithe_instance* i, uint32_t* o, lithe_draw* d, uint32_t* n, uint32_t* c) {
    const lithe_crowd crowd = {nullptr, i, 0, 1, 1};
    return lithe_build_draws(&crowd, p, 1, o, d, nullptr, n, c);
  };
  EXPECT_EQ(call(&placement, &instance, &order, draws, &count, counters), LITHE_OK);
  EXPECT_EQ(call(nullptr, &instance, &order, draws, &count, counters), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call(&lost, &instance, &order, draws, &count, counters), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call(&placement, nullptr, &order, draws, &count, counters), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call(&placement, &stranger, &order, draws, &count, counters), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call(&placement, &instance, nullptr, draws, &count, counters), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call(&placement, &instance, &order, nullptr, &count, counters), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call(&placement, &instance, &order, draws, nullptr, counters), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call(&placement, &instance, &order, draws, &count, nullptr), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_draws_bound(nullptr, 1), 0u);
  const lithe_placement vast[2] = {{0, 1u << 20, 1u << 20, &range}, {0, 1, 1, &range}};
  EXPECT_EQ(lithe_draws_bound(vast, 2), UINT32_MAX);
  const lithe_crowd nobody = {nullptr, nullptr, 0, 2, 0};
  EXPECT_EQ(lithe_build_draws(&nobody, vast, 1, nullptr, draws, nullptr, &count, counters),
            LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_build_draws(nullptr, &placement, 1, &order, draws, nullptr, &count, counters),
            LITHE_ERROR_INVALID_ARGUMENT);
  const lithe_crowd crooked = {nullptr, &instance, sizeof instance + 1, 1, 1};
  EXPECT_EQ(lithe_build_draws(&crooked, &placement, 1, &order, draws, nullptr, &count, counters),
            LITHE_ERROR_INVALID_ARGUMENT);
}

}  // namespace
}  // namespace lithe::test
