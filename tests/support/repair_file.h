// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Makes the hashes and the size of any bytes true where there is a place for them, so that a fuzzer gets past them.
#pragma once

#include <algorithm>

#include "lithe_file.h"

namespace lithe::test {

/// The PAGE records in a head whose directory can be followed and that lie behind it; none elsewhere.
struct PageRecords {
  size_t offset = 0, record_bytes = 0, count = 0;
};

inline PageRecords findPageRecords(const FileBytes& file, size_t head_bytes) {
  using namespace format;
  const uint64_t chunks = loadU32(file.data() + header::kChunkCountAt);
  const uint64_t directory_end = header::kBytes + chunks * directory::kBytes;
  if (directory_end > head_bytes) return {};
  const ChunkPlace place = findChunk(file, page::kId);
  const uint64_t end = place.offset + uint64_t{place.record_bytes} * place.record_count;
  // Records over the header would have the hashes written into the head's own size.
  if (place.entry == kNoIndex || place.record_bytes < page::kBytes || place.offset < directory_end || end > head_bytes)
    return {};
  return {place.offset, place.record_bytes, place.record_count};
}

inline void repairHashes(FileBytes& file) {
  using namespace format;
  if (file.size() < header::kBytes) return;
  const size_t head_bytes = loadU32(file.data() + header::kHeadBytesAt);
  if (head_bytes < header::kBytes || head_bytes > file.size()) return;
  const PageRecords pages = findPageRecords(file, head_bytes);
  uint64_t at = head_bytes;
  for (size_t i = 0; i < pages.count; ++i) {
    uint8_t* entry = file.data() + pages.offset + i * pages.record_bytes;
    const uint32_t size = loadU32(entry + page::kSizeAt);
    if (at + size <= file.size()) storeU64(entry + page::kChecksumAt, runtime::xxh64(file.data() + at, size));
    at += size;
  }
  if (pages.count > 0) storeU64(file.data() + header::kFileBytesAt, at);
  refreshHeadChecksum(file);
}

}  // namespace lithe::test
