// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// An opened asset: the checked head, what was read of it for speed, and what has been decoded so far.
#pragma once

#include "decoded.h"
#include "head.h"
#include "lithe/runtime.h"
#include "memory.h"
#include "page.h"

namespace lithe::runtime {

/// uv = offset + scale * integer, for one part and uv set.
struct UvGrid {
  float offset[2];
  float scale;
};

struct Level {
  LevelEntry entry;
  uint64_t bytes_end;
  uint32_t hidden_end;  ///< hidden faces of the levels up to and with this one
};

/// What selection wants of a level. The error of one stands with the next.
struct LevelChoice {
  float coarser_error;  ///< of the level before; infinity before the coarsest
  uint32_t triangles;   ///< that are drawn
};

}  // namespace lithe::runtime

/// Two blocks: this struct with the tables behind it, and the head's bytes.
struct lithe_asset {
  lithe_allocator allocator;
  uint64_t block_bytes;
  uint8_t* head_bytes;

  lithe::runtime::Head head;
  lithe::runtime::PageFormat format;
  lithe::runtime::Level levels[lithe::format::limits::kLevels];
  uint64_t* page_offset;             ///< page_count + 1: where each page begins, and the file's end
  lithe::runtime::UvGrid* uv_grids;  ///< [part * uv_sets + set]
  uint32_t page_count;
  uint32_t pages_resident;  ///< pages [0, pages_resident) have been decoded
  uint32_t visit_cursor;    ///< where the splits of the level being decoded go on

  // What selection reads lies side by side: a crowd's instances come to any asset in any order.
  uint32_t level_count;
  uint32_t resident_level;  ///< LITHE_NO_LEVEL before the first page
  lithe::runtime::LevelChoice choices[lithe::format::limits::kLevels + 1];

  lithe::runtime::Decoded decoded;
};

namespace lithe::runtime {

inline PageEntry pageEntry(const lithe_asset& asset, uint32_t page) {
  return readPageEntry(asset.head.pages.record(page));
}

inline const char* nameAt(const lithe_asset& asset, uint32_t offset) {
  return reinterpret_cast<const char*>(asset.head.names.bytes + offset);
}

inline uint32_t strideOf(const lithe_asset& asset) { return asset.format.layout.stride; }
inline RecordWidths widthsOf(const lithe_asset& asset) { return {strideOf(asset), asset.format.max_influences}; }

/// What the arrays hold when a level is resident.
inline Counts countsOf(const lithe_asset& asset, uint32_t level) {
  const Level& l = asset.levels[level];
  return {l.entry.node_count, l.entry.wedge_count, l.entry.face_count, l.hidden_end};
}

inline bool isResident(const lithe_asset& asset, uint32_t level) {
  return asset.resident_level != LITHE_NO_LEVEL && level <= asset.resident_level;
}

/// Bind-space coordinate of a grid coordinate.
inline float bindCoordinate(const Info& info, uint32_t axis, float grid) {
  return info.grid_origin[axis] + info.grid_step * grid;
}

/// In bind space, of the grid's cells that the joint's box covers. False for a joint without one: least > greatest
/// then.
inline bool jointBox(const Head& head, uint32_t joint, float* least, float* greatest) {
  const uint8_t* p = head.joints.record(joint);
  const uint32_t cell_bits = format::joint::boxCellBits(head.info.position_bits);
  bool any = true;
  for (uint32_t c = 0; c < 3; ++c) {
    const uint32_t first = p[format::joint::kBoxMinAt + c], last = p[format::joint::kBoxMaxAt + c];
    any = any & (first <= last);
    least[c] = bindCoordinate(head.info, c, static_cast<float>(first << cell_bits));
    greatest[c] = bindCoordinate(head.info, c, static_cast<float>(((last + 1) << cell_bits) - 1));
  }
  return any;
}

}  // namespace lithe::runtime
