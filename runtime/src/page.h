// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Decodes one page onto the arrays of an asset.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "decoded.h"
#include "lithe/format/file.h"
#include "lithe/format/page.h"
#include "lithe/runtime.h"

namespace lithe::runtime {

/// What the head of the file says that pages depend on. All of it checked when the asset was opened.
struct PageFormat {
  uint32_t position_bits;
  uint32_t weight_one;     ///< 2^weight_bits - 1
  uint32_t normal_center;  ///< octahedralCenter(normal_bits)
  uint32_t uv_bits;
  uint32_t placement_shift;
  uint32_t max_influences;
  uint32_t joint_count;
  uint32_t part_count;
  format::WedgeAttributes has;
  WedgeLayout layout;
};

/// Where a level of a page ends: the counts after it.
struct LevelEnd {
  uint32_t node_count, wedge_count, face_count;
  uint32_t hidden_count;  ///< faces of the level that are not drawn
};

/// What the tables state of one page.
struct PagePlan {
  uint32_t node_count, wedge_count, face_count;  ///< after this page; the arrays have room for them
  uint32_t level;                                ///< the coarsest level that needs it
  uint32_t level_first_node;                     ///< nodes of the levels before that one
  uint32_t values;                               ///< integers in all streams
  uint32_t bytes;                                ///< of the page
  uint32_t max_fan;
  uint32_t ended_levels;  ///< levels that end in this page: several, or one at its end, or none
  LevelEnd ends[format::limits::kLevels];
};

/// Bytes of scratch that decodePage needs for a page: aligned to 8.
size_t pageScratchBytes(const PagePlan& plan);

/// Decodes a page whose checksum has been verified.
/// decoded   arrays with room for the plan's counts; on an error its counts are as before (entries beyond them and the
///           fields of nodes below them that this page changed are restored by undoPage)
/// cursor    the next node to be visited in this level; 0 at a level's first page
/// scratch   pageScratchBytes(plan) bytes, aligned to 8
/// returns LITHE_OK, LITHE_ERROR_CORRUPT or LITHE_ERROR_LIMIT; diagnosis->check tells which check of docs/format.md
///           failed, diagnosis->offset is relative to the page
lithe_result decodePage(const PageFormat& format, const PagePlan& plan, const uint8_t* bytes, size_t size,
                        Decoded* decoded, uint32_t* cursor, void* scratch, lithe_diagnosis* diagnosis);

/// Takes the arrays back to the first node_count nodes, wedge_count wedges and face_count faces: corners move up to the
/// wedges they came from, and nodes whose children are gone are leaves again.
void truncateDecoded(Decoded* decoded, uint32_t node_count, uint32_t wedge_count, uint32_t face_count);

}  // namespace lithe::runtime
