// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Instances to indirect draws by counting sort over (asset, level).
///
/// The counters hold, first, where each asset's own counters begin, then one counter per asset and level.
#include "arguments.h"
#include "crowd.h"

namespace lithe::runtime {
namespace {

uint64_t counterCount(const lithe_placement* placements, uint32_t asset_count) {
  uint64_t count = asset_count;
  for (uint32_t a = 0; a < asset_count; ++a) count += placements[a].level_count;
  return count;
}

uint64_t drawCount(const lithe_placement* placements, uint32_t asset_count) {
  uint64_t count = 0;
  for (uint32_t a = 0; a < asset_count; ++a)
    count += static_cast<uint64_t>(placements[a].level_count) * placements[a].part_count;
  return count;
}

bool areSound(const lithe_placement* placements, uint32_t asset_count) {
  for (uint32_t a = 0; a < asset_count; ++a)
    if (!placements[a].ranges && placements[a].level_count && placements[a].part_count) return false;
  return counterCount(placements, asset_count) <= UINT32_MAX && drawCount(placements, asset_count) <= UINT32_MAX;
}

bool isDrawn(const lithe_instance& instance, uint32_t view_mask) {
  return instance.level != LITHE_UNDRAWN && (instance.views & view_mask) != 0;
}

bool allNameAnAsset(const lithe_crowd& crowd, uint32_t view_mask) {
  InstanceCursor instances(crowd);
  for (uint32_t i = 0; i < crowd.instance_count; ++i) {
    const lithe_instance& instance = *instances.next();
    if (isDrawn(instance, view_mask) && instance.asset >= crowd.asset_count) return false;
  }
  return true;
}

void clearCounters(const lithe_placement* placements, uint32_t asset_count, uint32_t* counters) {
  uint32_t next = asset_count;
  for (uint32_t a = 0; a < asset_count; ++a) {
    counters[a] = next;
    for (uint32_t l = 0; l < placements[a].level_count; ++l) counters[next++] = 0;
  }
}

/// The counter of an instance; NULL for one that is not drawn.
uint32_t* counterOf(const lithe_placement* placements, const lithe_instance& instance, uint32_t view_mask,
                    uint32_t* counters) {
  if (!isDrawn(instance, view_mask)) return nullptr;
  const uint32_t level_count = placements[instance.asset].level_count;
  if (level_count == 0) return nullptr;
  const uint32_t level = instance.level < level_count ? instance.level : level_count - 1;
  return counters + counters[instance.asset] + level;
}

/// Where the draws go, and how many there are.
struct DrawList {
  lithe_draw* draws;
  lithe_draw_key* keys;
  uint32_t count;

  void add(const lithe_draw& draw, const lithe_draw_key& key) {
    draws[count] = draw;
    if (keys) keys[count] = key;
    ++count;
  }
};

/// Draws every part of a level for its instances, and turns the counter from their number to their first place.
void drawLevel(const lithe_placement& placement, uint32_t asset, uint32_t level, uint32_t* counter, uint32_t* first,
               DrawList* list) {
  const uint32_t instance_count = *counter, first_instance = *first;
  *counter = first_instance;
  *first += instance_count;
  if (instance_count == 0) return;
  const lithe_range* ranges = placement.ranges + static_cast<size_t>(level) * placement.part_count;
  for (uint32_t p = 0; p < placement.part_count; ++p) {
    if (ranges[p].index_count == 0) continue;
    list->add({ranges[p].index_count, instance_count, ranges[p].first_index, placement.vertex_offset, first_instance},
              {asset, level, p});
  }
}

}  // namespace
}  // namespace lithe::runtime

using namespace lithe::runtime;  // NOLINT: the C functions below are the outside of this namespace

uint32_t lithe_draws_bound(const lithe_placement* placements, uint32_t asset_count) {
  if (!placements && asset_count) return invalidArgument(), 0;
  const uint64_t draws = drawCount(placements, asset_count), counters = counterCount(placements, asset_count);
  const uint64_t bound = draws > counters ? draws : counters;
  return bound > UINT32_MAX ? UINT32_MAX : static_cast<uint32_t>(bound);
}

lithe_result lithe_build_draws(const lithe_crowd* crowd, const lithe_placement* placements, uint32_t view_mask,
                               uint32_t* instance_order, lithe_draw* draws, lithe_draw_key* keys, uint32_t* draw_count,
                               uint32_t* counters) {
  if (!crowd || !draw_count || !instancesAreSound(*crowd) ||
      (crowd->asset_count && (!placements || !counters || !draws)) || (crowd->instance_count && !instance_order) ||
      !areSound(placements, crowd->asset_count) || !allNameAnAsset(*crowd, view_mask))
    return invalidArgument();
  clearCounters(placements, crowd->asset_count, counters);
  InstanceCursor counted(*crowd), ordered(*crowd);
  for (uint32_t i = 0; i < crowd->instance_count; ++i)
    if (uint32_t* counter = counterOf(placements, *counted.next(), view_mask, counters)) ++*counter;
  DrawList list = {draws, keys, 0};
  uint32_t first = 0;
  for (uint32_t a = 0; a < crowd->asset_count; ++a)
    for (uint32_t l = 0; l < placements[a].level_count; ++l)
      drawLevel(placements[a], a, l, counters + counters[a] + l, &first, &list);
  for (uint32_t i = 0; i < crowd->instance_count; ++i)
    if (uint32_t* counter = counterOf(placements, *ordered.next(), view_mask, counters))
      instance_order[(*counter)++] = i;
  *draw_count = list.count;
  return LITHE_OK;
}
