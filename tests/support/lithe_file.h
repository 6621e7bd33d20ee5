// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// A .lithe file in pieces that a test or a fuzzer may break one by one; put together again, everything that states
/// another piece's size or hash is made true, so that only what was broken is wrong.
#pragma once

#include <cstdint>
#include <vector>

#include "head_builder.h"

namespace lithe::test {

using FileBytes = std::vector<uint8_t>;

/// One chunk with its records.
struct FileChunk {
  uint32_t id = 0, flags = 0, record_bytes = 0;
  FileBytes bytes;
};

class LitheFile {
 public:
  /// The file must be sound.
  explicit LitheFile(const FileBytes& bytes) {
    using namespace format;
    const uint32_t head_bytes = loadU32(bytes.data() + header::kHeadBytesAt);
    head.assign(bytes.begin(), bytes.begin() + head_bytes);
    size_t at = head_bytes;
    for (uint32_t i = 0; i < chunk(page::kId).record_count; ++i) {
      const uint32_t size = loadU32(record(page::kId, i) + page::kSizeAt);
      pages.emplace_back(bytes.begin() + static_cast<int64_t>(at), bytes.begin() + static_cast<int64_t>(at + size));
      at += size;
    }
  }

  ChunkPlace chunk(uint32_t id) const { return findChunk(head, id); }

  /// A record of a chunk, in `head`.
  uint8_t* record(uint32_t id, uint32_t index = 0) {
    const ChunkPlace place = chunk(id);
    return head.data() + place.offset + size_t{index} * place.record_bytes;
  }

  /// All chunks in order, and a head made of chunks.
  std::vector<FileChunk> chunks() const {
    using namespace format;
    std::vector<FileChunk> list;
    for (uint32_t i = 0; i < loadU32(head.data() + header::kChunkCountAt); ++i) {
      const uint8_t* entry = head.data() + header::kBytes + size_t{i} * directory::kBytes;
      const uint32_t record_bytes = loadU16(entry + directory::kRecordBytesAt);
      const auto begin = head.begin() + loadU32(entry + directory::kOffsetAt);
      const size_t size = size_t{record_bytes} * loadU32(entry + directory::kRecordCountAt);
      list.push_back({loadU32(entry + directory::kIdAt), loadU16(entry + directory::kFlagsAt), record_bytes,
                      FileBytes(begin, begin + static_cast<int64_t>(size))});
    }
    return list;
  }
  void setChunks(const std::vector<FileChunk>& list) {
    using namespace format;
    uint64_t page_bytes = 0;
    for (const FileBytes& page : pages) page_bytes += page.size();
    head.resize(header::kBytes);
    head.resize(header::kBytes + list.size() * directory::kBytes);
    for (size_t i = 0; i < list.size(); ++i) {
      head.resize((head.size() + 7) / 8 * 8);
      uint8_t* entry = head.data() + header::kBytes + i * directory::kBytes;
      storeU32(entry + directory::kIdAt, list[i].id);
      storeU16(entry + directory::kFlagsAt, static_cast<uint16_t>(list[i].flags));
      storeU32(entry + directory::kOffsetAt, static_cast<uint32_t>(head.size()));
      storeU16(entry + directory::kRecordBytesAt, static_cast<uint16_t>(list[i].record_bytes));
      storeU32(entry + directory::kRecordCountAt, static_cast<uint32_t>(list[i].bytes.size() / list[i].record_bytes));
      head.insert(head.end(), list[i].bytes.begin(), list[i].bytes.end());
    }
    head.resize((head.size() + 7) / 8 * 8);
    storeU32(head.data() + header::kHeadBytesAt, static_cast<uint32_t>(head.size()));
    storeU32(head.data() + header::kChunkCountAt, static_cast<uint32_t>(list.size()));
    storeU64(head.data() + header::kFileBytesAt, head.size() + page_bytes);
  }

  /// Makes PAGE and file_bytes say what the pages are.
  void sealPages() {
    using namespace format;
    uint64_t end = head.size();
    for (uint32_t i = 0; i < pages.size(); ++i) {
      uint8_t* entry = record(page::kId, i);
      storeU32(entry + page::kSizeAt, static_cast<uint32_t>(pages[i].size()));
      storeU64(entry + page::kChecksumAt, runtime::xxh64(pages[i].data(), pages[i].size()));
      end += pages[i].size();
    }
    storeU64(head.data() + header::kFileBytesAt, end);
  }

  /// The head as it is, under its true checksum.
  FileBytes sealedHead() const {
    FileBytes sealed = head;
    refreshHeadChecksum(sealed);
    return sealed;
  }

  /// The whole file; call sealPages() first where pages have changed.
  FileBytes bytes() const {
    FileBytes file = sealedHead();
    for (const FileBytes& page : pages) file.insert(file.end(), page.begin(), page.end());
    return file;
  }

  FileBytes head;
  std::vector<FileBytes> pages;
};

}  // namespace lithe::test
