// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "asset.h"

#include <math.h>
#include <string.h>

#include "arguments.h"
#include "lithe/format/octahedral.h"
#include "xxh64.h"

namespace lithe::runtime {
namespace {

lithe_result refuse(const Refusal& refusal, lithe_diagnosis* diagnosis) {
  if (diagnosis) *diagnosis = {refusal.check, refusal.offset};
  return refusal.result;
}

/// The head's checksum is taken with its own bytes zero: the copy keeps them so.
bool checksumHolds(uint8_t* head, uint32_t size) {
  const uint64_t stated = format::loadU64(head + format::header::kChecksumAt);
  format::storeU64(head + format::header::kChecksumAt, 0);
  return xxh64(head, size) == stated;
}

Refusal readHead(uint8_t* copy, uint32_t size, Head* head) {
  if (!checksumHolds(copy, size)) return {LITHE_ERROR_CORRUPT, kCheckHeadChecksum, format::header::kChecksumAt};
  if (const Refusal refusal = readDirectory(copy, head)) return refusal;
  return readTables(head);
}

WedgeLayout wedgeLayout(const Info& info) {
  WedgeLayout layout = {};
  uint32_t at = 0;
  auto place = [&](bool present, uint32_t values) {
    const uint32_t begin = present ? at : kNoAttribute;
    at += present ? values : 0;
    return begin;
  };
  layout.normal = place(info.has_normals, 2);
  layout.tangent = place(info.has_tangents, 3);
  for (uint32_t s = 0; s < format::limits::kUvSets; ++s) layout.uv[s] = place(s < info.uv_sets, 2);
  for (uint32_t s = 0; s < format::limits::kColorSets; ++s) layout.color[s] = place(s < info.color_sets, 4);
  layout.stride = at;
  return layout;
}

PageFormat pageFormat(const Head& head) {
  const Info& info = head.info;
  PageFormat format = {};
  format.position_bits = info.position_bits;
  format.weight_one = (1u << info.weight_bits) - 1;
  format.normal_center = static_cast<uint32_t>(format::octahedralCenter(info.normal_bits));
  format.uv_bits = info.uv_bits;
  format.placement_shift = info.placement_shift;
  format.max_influences = info.max_influences;
  format.joint_count = head.joints.count;
  format.part_count = head.parts.count;
  format.has = {info.has_normals, info.has_tangents, info.uv_sets, info.color_sets};
  format.layout = wedgeLayout(info);
  return format;
}

void fillPageOffsets(lithe_asset* asset) {
  uint64_t offset = asset->head.size;
  for (uint32_t i = 0; i < asset->page_count; ++i) {
    asset->page_offset[i] = offset;
    offset += pageEntry(*asset, i).size;
  }
  asset->page_offset[asset->page_count] = offset;
}

void fillLevels(lithe_asset* asset) {
  uint32_t hidden = 0;
  asset->choices[0].coarser_error = INFINITY;
  for (uint32_t i = 0; i < asset->level_count; ++i) {
    Level& level = asset->levels[i];
    level.entry = readLevelEntry(asset->head.levels.record(i));
    hidden += level.entry.hidden_count;
    level.hidden_end = hidden;
    level.bytes_end = asset->page_offset[level.entry.page_end];
    asset->choices[i + 1].coarser_error = level.entry.error;
    asset->choices[i].triangles = level.entry.face_count - level.entry.hidden_count;
  }
}

void fillUvGrids(lithe_asset* asset) {
  for (uint32_t i = 0; i < asset->head.uv_grids.count; ++i) {
    const uint8_t* p = asset->head.uv_grids.record(i) + format::uv_grid::kOffsetAt;
    asset->uv_grids[i] = {{format::loadF32(p), format::loadF32(p + 4)}, format::loadF32(p + format::uv_grid::kScaleAt)};
  }
}

/// The asset and its tables in one block. Takes over the head's copy when there is memory; NULL otherwise.
lithe_asset* makeAsset(const lithe_allocator& allocator, const Head& head, uint8_t* head_copy) {
  const uint64_t offset_bytes = (uint64_t{head.pages.count} + 1) * sizeof(uint64_t);
  const uint64_t block_bytes = sizeof(lithe_asset) + offset_bytes + uint64_t{head.uv_grids.count} * sizeof(UvGrid);
  void* block = allocateBlock(allocator, block_bytes);
  if (!block) return nullptr;
  memset(block, 0, sizeof(lithe_asset));
  lithe_asset* asset = static_cast<lithe_asset*>(block);
  asset->allocator = allocator;
  asset->block_bytes = block_bytes;
  asset->head_bytes = head_copy;
  asset->head = head;
  asset->format = pageFormat(head);
  asset->level_count = head.levels.count;
  asset->page_count = head.pages.count;
  asset->page_offset = reinterpret_cast<uint64_t*>(asset + 1);
  asset->uv_grids = reinterpret_cast<UvGrid*>(asset->page_offset + asset->page_count + 1);
  asset->resident_level = LITHE_NO_LEVEL;
  fillPageOffsets(asset);
  fillLevels(asset);
  fillUvGrids(asset);
  return asset;
}

}  // namespace
}  // namespace lithe::runtime

using namespace lithe::runtime;  // NOLINT: the C functions below are the outside of this namespace

lithe_result lithe_peek(const void* bytes, size_t size, uint64_t* head_bytes) {
  if (!head_bytes || (!bytes && size)) return invalidArgument();
  *head_bytes = LITHE_PEEK_BYTES;
  if (size < LITHE_PEEK_BYTES) return LITHE_PENDING;
  const uint8_t* p = static_cast<const uint8_t*>(bytes);
  const Refusal refusal = checkHeader(p);
  if (!refusal) *head_bytes = lithe::format::loadU32(p + lithe::format::header::kHeadBytesAt);
  return refusal.result;
}

lithe_result lithe_asset_open(const lithe_allocator* allocator, const void* bytes, size_t size,
                              lithe_diagnosis* diagnosis, lithe_asset** asset) {
  if (!allocator || !allocator->alloc || !allocator->free || (!bytes && size) || !asset) return invalidArgument();
  if (diagnosis) *diagnosis = {0, 0};
  *asset = nullptr;
  if (size < lithe::format::header::kBytes) return refuse({LITHE_ERROR_TRUNCATED, kCheckComplete, size}, diagnosis);
  const uint8_t* p = static_cast<const uint8_t*>(bytes);
  if (const Refusal refusal = checkHeader(p)) return refuse(refusal, diagnosis);
  const uint32_t head_bytes = lithe::format::loadU32(p + lithe::format::header::kHeadBytesAt);
  if (size < head_bytes) return refuse({LITHE_ERROR_TRUNCATED, kCheckComplete, size}, diagnosis);

  uint8_t* copy = static_cast<uint8_t*>(allocateBlock(*allocator, head_bytes));
  if (!copy) return LITHE_ERROR_OUT_OF_MEMORY;
  memcpy(copy, p, head_bytes);
  Head head;
  const Refusal refusal = readHead(copy, head_bytes, &head);
  if (!refusal) *asset = makeAsset(*allocator, head, copy);
  if (*asset) return LITHE_OK;
  freeBlock(*allocator, copy, head_bytes);
  return refusal ? refuse(refusal, diagnosis) : LITHE_ERROR_OUT_OF_MEMORY;
}

void lithe_asset_close(lithe_asset* asset) {
  if (!asset) return;
  const lithe_allocator allocator = asset->allocator;
  freeDecoded(allocator, widthsOf(*asset), &asset->decoded);
  freeBlock(allocator, asset->head_bytes, asset->head.size);
  freeBlock(allocator, asset, asset->block_bytes);
}
