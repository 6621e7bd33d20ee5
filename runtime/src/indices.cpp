// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// A level's triangles: the faces born up to it, their corners moved up to the wedges that the level has.
#include "arguments.h"
#include "asset.h"

namespace lithe::runtime {
namespace {

/// The wedge below wedge_count that a wedge came from.
uint32_t ancestorBelow(const Decoded& d, uint32_t wedge, uint32_t wedge_count) {
  while (wedge >= wedge_count) wedge = d.wedge_parent[wedge];
  return wedge;
}

/// Calls visit(face) for the faces that a level draws, ascending.
template <typename Visit>
void forEachDrawnFace(const lithe_asset& asset, uint32_t level, Visit visit) {
  const Decoded& d = asset.decoded;
  const uint32_t face_count = asset.levels[level].entry.face_count;
  uint32_t hidden = level ? asset.levels[level - 1].hidden_end : 0;
  const uint32_t hidden_end = asset.levels[level].hidden_end;
  for (uint32_t face = 0; face < face_count; ++face) {
    if (hidden < hidden_end && d.hidden_faces[hidden] == face)
      ++hidden;
    else
      visit(face);
  }
}

/// All wedges of a face, and all that they came from, are in one part.
uint32_t partOf(const Decoded& d, uint32_t face) { return d.wedge_part[d.face_wedges[3 * size_t{face}]]; }

void countPerPart(const lithe_asset& asset, uint32_t level, uint32_t* counts) {
  for (uint32_t p = 0; p < asset.head.parts.count; ++p) counts[p] = 0;
  forEachDrawnFace(asset, level, [&](uint32_t face) { counts[partOf(asset.decoded, face)] += 3; });
}

/// Turns counts into the places where each part begins.
void placeParts(uint32_t part_count, uint32_t* counts, lithe_range* ranges) {
  uint32_t begin = 0;
  for (uint32_t p = 0; p < part_count; ++p) {
    const uint32_t count = counts[p];
    if (ranges) ranges[p] = {begin, count};
    counts[p] = begin;
    begin += count;
  }
}

template <typename Index>
void writeFaces(const lithe_asset& asset, uint32_t level, uint32_t* next_of_part, Index* out) {
  const Decoded& d = asset.decoded;
  const uint32_t wedge_count = asset.levels[level].entry.wedge_count;
  forEachDrawnFace(asset, level, [&](uint32_t face) {
    const uint32_t* wedges = d.face_wedges + 3 * size_t{face};
    uint32_t& next = next_of_part[partOf(d, face)];
    for (uint32_t k = 0; k < 3; ++k) out[next++] = static_cast<Index>(ancestorBelow(d, wedges[k], wedge_count));
  });
}

}  // namespace
}  // namespace lithe::runtime

using namespace lithe::runtime;  // NOLINT: the C functions below are the outside of this namespace

lithe_result lithe_asset_write_indices(const lithe_asset* asset, uint32_t level, lithe_index_type type,
                                       void* destination, size_t size, lithe_range* ranges) {
  if (!asset || level >= asset->level_count || (type != LITHE_INDEX_U16 && type != LITHE_INDEX_U32))
    return invalidArgument();
  const LevelEntry& entry = asset->levels[level].entry;
  const uint64_t index_count = 3 * (uint64_t{entry.face_count} - entry.hidden_count);
  if ((!destination && index_count) || (type == LITHE_INDEX_U16 && entry.wedge_count > 65536)) return invalidArgument();
  if (reinterpret_cast<uintptr_t>(destination) % static_cast<uint32_t>(type)) return invalidArgument();
  if (index_count * static_cast<uint32_t>(type) > size) return LITHE_ERROR_BUFFER_TOO_SMALL;
  if (!isResident(*asset, level)) return LITHE_ERROR_NOT_RESIDENT;

  uint32_t next_of_part[lithe::format::limits::kParts];  // 16 KiB of stack
  countPerPart(*asset, level, next_of_part);
  placeParts(asset->head.parts.count, next_of_part, ranges);
  if (type == LITHE_INDEX_U16)
    writeFaces(*asset, level, next_of_part, static_cast<uint16_t*>(destination));
  else
    writeFaces(*asset, level, next_of_part, static_cast<uint32_t*>(destination));
  return LITHE_OK;
}

lithe_result lithe_asset_write_morph_sources(const lithe_asset* asset, uint32_t level, uint32_t* destination,
                                             size_t count) {
  if (!asset || level >= asset->level_count || level == 0 || !destination) return invalidArgument();
  const uint32_t wedge_count = asset->levels[level].entry.wedge_count;
  if (count < wedge_count) return LITHE_ERROR_BUFFER_TOO_SMALL;
  if (!isResident(*asset, level)) return LITHE_ERROR_NOT_RESIDENT;
  const uint32_t coarser_count = asset->levels[level - 1].entry.wedge_count;
  for (uint32_t w = 0; w < wedge_count; ++w) destination[w] = ancestorBelow(asset->decoded, w, coarser_count);
  return LITHE_OK;
}
