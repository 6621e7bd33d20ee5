// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The host's memory: blocks, and the growing and shrinking of the decoded arrays.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "decoded.h"
#include "lithe/runtime.h"

namespace lithe::runtime {

inline constexpr size_t kBlockAlignment = 16;

/// NULL when the host has none, or when the size is beyond what the machine can address.
inline void* allocateBlock(const lithe_allocator& allocator, uint64_t size) {
  if (size > SIZE_MAX / 2) return nullptr;
  return allocator.alloc(allocator.user, static_cast<size_t>(size), kBlockAlignment);
}

inline void freeBlock(const lithe_allocator& allocator, void* block, uint64_t size) {
  if (block) allocator.free(allocator.user, block, static_cast<size_t>(size));
}

/// How much the decoded arrays hold.
struct Counts {
  uint32_t nodes, wedges, faces, hidden;
};

/// The arrays lie in four blocks, one per word: nodes, wedges, faces, hidden faces.
uint64_t decodedBytes(const Counts& counts, const RecordWidths& widths);
uint64_t largestBlock(const Counts& counts, const RecordWidths& widths);

/// Makes room for the counts. Blocks that are large enough stay; a new block exists beside the one it replaces, one at
/// a time. Returns false when the host has no memory: what has grown stays grown, and no entry is lost.
bool reserveDecoded(const lithe_allocator& allocator, const Counts& counts, const RecordWidths& widths,
                    Decoded* decoded);

/// Gives back what the counts (which must hold the valid entries) do not need, as far as the host has memory for
/// copies.
void shrinkDecoded(const lithe_allocator& allocator, const Counts& counts, const RecordWidths& widths,
                   Decoded* decoded);

void freeDecoded(const lithe_allocator& allocator, const RecordWidths& widths, Decoded* decoded);

}  // namespace lithe::runtime
