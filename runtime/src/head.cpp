// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "head.h"

#include <string.h>

namespace lithe::runtime {
namespace {

using namespace format;  // NOLINT: the records' field names

constexpr uint64_t kUnlimited = limits::kHeadBytes;  // the head's own size bounds these

/// What a reader wants of a chunk.
struct Expected {
  uint32_t id;
  uint32_t record_bytes;
  uint64_t least, most;
  Table Head::*table;
};

constexpr Expected kExpected[] = {
    {info::kId, info::kBytes, 1, 1, &Head::info_record},
    {node::kId, node::kBytes, 0, limits::kSceneNodes, &Head::nodes},
    {joint::kId, joint::kBytes, 0, limits::kJoints, &Head::joints},
    {scale::kId, scale::kBytes, 0, limits::kScales, &Head::scales},
    {material::kId, material::kBytes, 0, limits::kMaterials, &Head::materials},
    {part::kId, part::kBytes, 1, limits::kParts, &Head::parts},
    {uv_grid::kId, uv_grid::kBytes, 0, limits::kParts* limits::kUvSets, &Head::uv_grids},
    {level::kId, level::kBytes, 1, limits::kLevels, &Head::levels},
    {page::kId, page::kBytes, 1, limits::kPages, &Head::pages},
    {names::kId, 1, 0, kUnlimited, &Head::names},
};

const Expected* expectedOf(uint32_t id) {
  for (const Expected& expected : kExpected)
    if (expected.id == id) return &expected;
  return nullptr;
}

bool allZero(const uint8_t* begin, const uint8_t* end) {
  for (; begin != end; ++begin)
    if (*begin != 0) return false;
  return true;
}

Refusal corrupt(uint32_t check, uint64_t offset) { return {LITHE_ERROR_CORRUPT, check, offset}; }

struct Entry {
  uint32_t id, flags, record_bytes, offset, record_count;

  uint64_t end() const { return offset + static_cast<uint64_t>(record_bytes) * record_count; }
};

Entry readEntry(const uint8_t* bytes, uint32_t index) {
  const uint8_t* p = bytes + header::kBytes + index * directory::kBytes;
  return {loadU32(p + directory::kIdAt), loadU16(p + directory::kFlagsAt), loadU16(p + directory::kRecordBytesAt),
          loadU32(p + directory::kOffsetAt), loadU32(p + directory::kRecordCountAt)};
}

uint64_t entryOffset(uint32_t index) { return header::kBytes + index * directory::kBytes; }

/// Chunks follow each other; what lies between them is zero.
Refusal checkPlace(const Head& head, const Entry& entry, uint64_t entry_offset, uint64_t* end) {
  if (entry.offset < *end || entry.end() > head.size) return corrupt(kCheckChunkPlace, entry_offset);
  if (!allZero(head.bytes + *end, head.bytes + entry.offset)) return corrupt(kCheckChunkPlace, *end);
  *end = entry.end();
  return {};
}

bool occursBefore(const uint8_t* bytes, uint32_t index, uint32_t id) {
  for (uint32_t i = 0; i < index; ++i)
    if (readEntry(bytes, i).id == id) return true;
  return false;
}

Refusal checkEntry(const Head& head, uint32_t index, uint64_t* end) {
  const Entry entry = readEntry(head.bytes, index);
  const uint64_t at = entryOffset(index);
  if ((entry.flags & ~directory::kOptional) || entry.record_bytes == 0 || entry.offset % 8)
    return corrupt(kCheckEntry, at);
  if (const Refusal refusal = checkPlace(head, entry, at, end)) return refusal;
  const bool known = expectedOf(entry.id) != nullptr;
  if (occursBefore(head.bytes, index, entry.id) || (!known && !(entry.flags & directory::kOptional)))
    return corrupt(kCheckChunkId, at);
  return {};
}

Refusal takeChunk(const Expected& expected, uint32_t chunk_count, Head* head) {
  for (uint32_t i = 0; i < chunk_count; ++i) {
    const Entry entry = readEntry(head->bytes, i);
    if (entry.id != expected.id) continue;
    const bool is_names = entry.id == names::kId;
    if (entry.record_bytes < expected.record_bytes || (is_names && entry.record_bytes != 1) ||
        entry.record_count < expected.least)
      return corrupt(kCheckChunkRecords, entryOffset(i));
    if (entry.record_count > expected.most) return {LITHE_ERROR_LIMIT, kCheckChunkRecords, entryOffset(i)};
    head->*expected.table = {head->bytes + entry.offset, entry.record_bytes, entry.record_count};
    return {};
  }
  return corrupt(kCheckChunkRecords, header::kBytes);
}

bool startsWithMagic(const uint8_t* bytes) {
  bool same = true;
  for (uint32_t i = 0; i < sizeof kMagic; ++i) same = same & (bytes[i] == kMagic[i]);
  return same;
}

}  // namespace

Refusal checkHeader(const uint8_t* bytes) {
  if (!startsWithMagic(bytes)) return {LITHE_ERROR_NOT_THIS_FORMAT, kCheckMagic, header::kMagicAt};
  const uint16_t major = loadU16(bytes + header::kVersionMajorAt);
  if (major != kVersionMajor)
    return {major > kVersionMajor ? LITHE_ERROR_VERSION_TOO_NEW : LITHE_ERROR_NOT_THIS_FORMAT, kCheckVersion,
            header::kVersionMajorAt};
  const uint32_t head_bytes = loadU32(bytes + header::kHeadBytesAt);
  if (head_bytes < header::kBytes || head_bytes > limits::kHeadBytes || head_bytes % 8)
    return corrupt(kCheckSizes, header::kHeadBytesAt);
  return {};
}

Refusal readDirectory(const uint8_t* bytes, Head* head) {
  head->bytes = bytes;
  head->size = loadU32(bytes + header::kHeadBytesAt);
  head->file_bytes = loadU64(bytes + header::kFileBytesAt);
  if (!allZero(bytes + header::kReservedAt, bytes + header::kBytes))
    return corrupt(kCheckHeaderReserved, header::kReservedAt);
  const uint32_t chunk_count = loadU32(bytes + header::kChunkCountAt);
  if (chunk_count > limits::kChunks || entryOffset(chunk_count) > head->size)
    return corrupt(kCheckDirectory, header::kChunkCountAt);
  uint64_t end = entryOffset(chunk_count);
  for (uint32_t i = 0; i < chunk_count; ++i)
    if (const Refusal refusal = checkEntry(*head, i, &end)) return refusal;
  if (!allZero(bytes + end, bytes + head->size)) return corrupt(kCheckChunkPlace, end);
  for (const Expected& expected : kExpected)
    if (const Refusal refusal = takeChunk(expected, chunk_count, head)) return refusal;
  return {};
}

}  // namespace lithe::runtime
