// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Pages in and out: what is wanted next, what it costs, taking it, and dropping it again.
#include "arguments.h"
#include "asset.h"
#include "xxh64.h"

namespace lithe::runtime {
namespace {

enum SupplyCheck : uint32_t { kCheckPageSize = 60, kCheckPageChecksum = 61 };

lithe_result refuse(lithe_result result, uint32_t check, uint64_t offset, lithe_diagnosis* diagnosis) {
  if (diagnosis) *diagnosis = {check, offset};
  return result;
}

PagePlan planOf(const lithe_asset& asset, uint32_t page) {
  const PageEntry entry = pageEntry(asset, page);
  PagePlan plan = {};
  plan.node_count = entry.node_count;
  plan.wedge_count = entry.wedge_count;
  plan.face_count = entry.face_count;
  plan.level = entry.level;
  plan.level_first_node = entry.level ? asset.levels[entry.level - 1].entry.node_count : 0;
  plan.values = entry.values;
  plan.bytes = entry.size;
  plan.max_fan = entry.max_fan;
  for (uint32_t l = entry.level; l < asset.level_count && asset.levels[l].entry.page_end == page + 1; ++l) {
    const LevelEntry& level = asset.levels[l].entry;
    plan.ends[plan.ended_levels++] = {level.node_count, level.wedge_count, level.face_count, level.hidden_count};
  }
  return plan;
}

/// The finest of the levels that end in the page that `level` ends in.
uint32_t lastOfPage(const lithe_asset& asset, uint32_t level) {
  while (level + 1 < asset.level_count && asset.levels[level + 1].entry.page_end == asset.levels[level].entry.page_end)
    ++level;
  return level;
}

bool beginsLevel(const lithe_asset& asset, uint32_t page) {
  return page == 0 || pageEntry(asset, page - 1).level != pageEntry(asset, page).level;
}

/// Beyond what the machine can address when the page's integers alone would fill it.
uint64_t scratchBytes(const PagePlan& plan) {
  if (4 * sizeof(int32_t) * uint64_t{plan.values} > SIZE_MAX) return UINT64_MAX / 4;
  return pageScratchBytes(plan);
}

// LITHE_NO_LEVEL + 1 is level 0.
void setResident(lithe_asset* asset, uint32_t pages) {
  asset->pages_resident = pages;
  while (asset->resident_level + 1 < asset->level_count &&
         asset->levels[asset->resident_level + 1].entry.page_end <= pages)
    ++asset->resident_level;
}

lithe_result decodeInto(lithe_asset* asset, uint32_t page, const void* bytes, size_t size, lithe_diagnosis* diagnosis) {
  const PagePlan plan = planOf(*asset, page);
  const uint32_t level = plan.ended_levels ? plan.level + plan.ended_levels - 1 : plan.level;
  const Counts counts = countsOf(*asset, level);
  if (!reserveDecoded(asset->allocator, counts, widthsOf(*asset), &asset->decoded)) return LITHE_ERROR_OUT_OF_MEMORY;
  const uint64_t scratch_bytes = scratchBytes(plan);
  void* scratch = allocateBlock(asset->allocator, scratch_bytes);
  if (!scratch) return LITHE_ERROR_OUT_OF_MEMORY;
  uint32_t cursor = beginsLevel(*asset, page) ? 0 : asset->visit_cursor;
  lithe_diagnosis in_page = {0, 0};
  const lithe_result result = decodePage(asset->format, plan, static_cast<const uint8_t*>(bytes), size, &asset->decoded,
                                         &cursor, scratch, &in_page);
  freeBlock(asset->allocator, scratch, scratch_bytes);
  if (result != LITHE_OK) return refuse(result, in_page.check, asset->page_offset[page] + in_page.offset, diagnosis);
  asset->visit_cursor = cursor;
  setResident(asset, page + 1);
  return LITHE_OK;
}

}  // namespace
}  // namespace lithe::runtime

using namespace lithe::runtime;  // NOLINT: the C functions below are the outside of this namespace

lithe_result lithe_asset_next_request(const lithe_asset* asset, uint32_t level, lithe_request* request) {
  if (!asset || !request || level >= asset->level_count) return invalidArgument();
  const uint32_t page = asset->pages_resident;
  if (page >= asset->levels[level].entry.page_end) return LITHE_COMPLETE;
  *request = {page, pageEntry(*asset, page).size, asset->page_offset[page]};
  return LITHE_OK;
}

// The most at any moment on the way: a level's arrays, with its pages' scratch or the block that is being replaced.
uint64_t lithe_asset_memory(const lithe_asset* asset, uint32_t level) {
  if (!asset || level >= asset->level_count) return invalidArgument(), 0;
  uint64_t most = 0;
  uint32_t page = 0, coarser = LITHE_NO_LEVEL;
  for (uint32_t l = 0; coarser == LITHE_NO_LEVEL || coarser < level; l = coarser + 1) {
    l = lastOfPage(*asset, l);
    uint64_t beside = coarser != LITHE_NO_LEVEL ? largestBlock(countsOf(*asset, coarser), widthsOf(*asset)) : 0;
    for (; page < asset->levels[l].entry.page_end; ++page) {
      const uint64_t scratch = scratchBytes(planOf(*asset, page));
      if (scratch > beside) beside = scratch;
    }
    const uint64_t bytes = decodedBytes(countsOf(*asset, l), widthsOf(*asset)) + beside;
    if (bytes > most) most = bytes;
    coarser = l;
  }
  return most;
}

lithe_result lithe_asset_reserve(lithe_asset* asset, uint32_t level) {
  if (!asset || level >= asset->level_count) return invalidArgument();
  const Counts counts = countsOf(*asset, lastOfPage(*asset, level));
  const bool done = reserveDecoded(asset->allocator, counts, widthsOf(*asset), &asset->decoded);
  return done ? LITHE_OK : LITHE_ERROR_OUT_OF_MEMORY;
}

lithe_result lithe_asset_supply(lithe_asset* asset, uint32_t page, const void* bytes, size_t size,
                                lithe_diagnosis* diagnosis) {
  if (!asset || page >= asset->page_count || (!bytes && size)) return invalidArgument();
  if (diagnosis) *diagnosis = {0, 0};
  if (page < asset->pages_resident) return LITHE_OK;
  if (page > asset->pages_resident) return LITHE_PENDING;
  const PageEntry entry = pageEntry(*asset, page);
  const uint64_t offset = asset->page_offset[page];
  if (size != entry.size) return refuse(LITHE_ERROR_TRUNCATED, kCheckPageSize, offset, diagnosis);
  if (xxh64(bytes, size) != entry.checksum) return refuse(LITHE_ERROR_CORRUPT, kCheckPageChecksum, offset, diagnosis);
  return decodeInto(asset, page, bytes, size, diagnosis);
}

uint32_t lithe_asset_resident_level(const lithe_asset* asset) {
  if (!asset) return invalidArgument(), LITHE_NO_LEVEL;
  return asset->resident_level;
}

lithe_result lithe_asset_evict(lithe_asset* asset, uint32_t level) {
  if (!asset || level >= asset->level_count) return invalidArgument();
  // Pages are dropped whole, so levels that share the last one stay.
  level = lastOfPage(*asset, level);
  const uint32_t page_end = asset->levels[level].entry.page_end;
  const Counts counts = countsOf(*asset, level);
  if (asset->pages_resident <= page_end) {
    shrinkDecoded(asset->allocator, counts, widthsOf(*asset), &asset->decoded);  // what a reserve has made room for
    return LITHE_OK;
  }
  asset->decoded.hidden_count = counts.hidden;
  truncateDecoded(&asset->decoded, counts.nodes, counts.wedges, counts.faces);
  shrinkDecoded(asset->allocator, counts, widthsOf(*asset), &asset->decoded);
  asset->pages_resident = page_end;
  asset->resident_level = level;
  return LITHE_OK;
}
