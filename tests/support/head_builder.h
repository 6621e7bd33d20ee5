// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Builds heads of .lithe files record by record, for tests that must not depend on the bake.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lithe/format/bytes.h"
#include "lithe/format/file.h"
#include "xxh64.h"

namespace lithe::test {

/// States the head's true checksum, after a test has changed its bytes.
inline void refreshHeadChecksum(std::vector<uint8_t>& file) {
  const uint32_t head_bytes = format::loadU32(file.data() + format::header::kHeadBytesAt);
  format::storeU64(file.data() + format::header::kChecksumAt, 0);
  format::storeU64(file.data() + format::header::kChecksumAt, runtime::xxh64(file.data(), head_bytes));
}

/// Where a chunk lies in a head; kNoIndex when it has no such chunk.
struct ChunkPlace {
  uint32_t entry = format::kNoIndex;  ///< offset of the directory entry
  uint32_t offset = 0, record_bytes = 0, record_count = 0;
};

inline ChunkPlace findChunk(const std::vector<uint8_t>& head, uint32_t id) {
  const uint32_t count = format::loadU32(head.data() + format::header::kChunkCountAt);
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t at = format::header::kBytes + i * format::directory::kBytes;
    if (format::loadU32(head.data() + at + format::directory::kIdAt) != id) continue;
    return {at, format::loadU32(head.data() + at + format::directory::kOffsetAt),
            format::loadU16(head.data() + at + format::directory::kRecordBytesAt),
            format::loadU32(head.data() + at + format::directory::kRecordCountAt)};
  }
  return {};
}

/// Chunks in the order of their first use; build() puts them after the header and the directory.
class HeadBuilder {
 public:
  /// A new zeroed record of a chunk. Valid until the next call.
  uint8_t* add(uint32_t id, uint32_t record_bytes) {
    Chunk& chunk = chunkOf(id, record_bytes);
    chunk.bytes.resize(chunk.bytes.size() + record_bytes);
    return chunk.bytes.data() + chunk.bytes.size() - record_bytes;
  }

  /// A chunk that may stay without records.
  void declare(uint32_t id, uint32_t record_bytes, uint32_t flags = 0) { chunkOf(id, record_bytes).flags = flags; }

  /// The name's offset in NAME.
  uint32_t name(const std::string& text) {
    Chunk& chunk = chunkOf(format::names::kId, 1);
    const uint32_t offset = static_cast<uint32_t>(chunk.bytes.size());
    chunk.bytes.insert(chunk.bytes.end(), text.c_str(), text.c_str() + text.size() + 1);
    return offset;
  }

  std::vector<uint8_t> build(uint64_t page_bytes) const {
    using namespace format;
    std::vector<uint8_t> head(header::kBytes + chunks_.size() * directory::kBytes);
    for (size_t i = 0; i < chunks_.size(); ++i) {
      head.resize((head.size() + 7) / 8 * 8);
      uint8_t* entry = head.data() + header::kBytes + i * directory::kBytes;
      storeU32(entry + directory::kIdAt, chunks_[i].id);
      storeU16(entry + directory::kFlagsAt, static_cast<uint16_t>(chunks_[i].flags));
      storeU32(entry + directory::kOffsetAt, static_cast<uint32_t>(head.size()));
      storeU16(entry + directory::kRecordBytesAt, static_cast<uint16_t>(chunks_[i].record_bytes));
      storeU32(entry + directory::kRecordCountAt,
               static_cast<uint32_t>(chunks_[i].bytes.size() / chunks_[i].record_bytes));
      head.insert(head.end(), chunks_[i].bytes.begin(), chunks_[i].bytes.end());
    }
    head.resize((head.size() + 7) / 8 * 8);
    std::copy(std::begin(kMagic), std::end(kMagic), head.begin());
    storeU16(head.data() + header::kVersionMajorAt, kVersionMajor);
    storeU16(head.data() + header::kVersionMinorAt, kVersionMinor);
    storeU32(head.data() + header::kHeadBytesAt, static_cast<uint32_t>(head.size()));
    storeU64(head.data() + header::kFileBytesAt, head.size() + page_bytes);
    storeU32(head.data() + header::kChunkCountAt, static_cast<uint32_t>(chunks_.size()));
    refreshHeadChecksum(head);
    return head;
  }

 private:
  struct Chunk {
    uint32_t id, record_bytes, flags;
    std::vector<uint8_t> bytes;
  };

  Chunk& chunkOf(uint32_t id, uint32_t record_bytes) {
    for (Chunk& chunk : chunks_)
      if (chunk.id == id) return chunk;
    chunks_.push_back({id, record_bytes, 0, {}});
    return chunks_.back();
  }

  std::vector<Chunk> chunks_;
};

}  // namespace lithe::test
