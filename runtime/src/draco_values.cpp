// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "draco_values.h"

#include "lithe/format/bytes.h"
#include "rans.h"

namespace lithe::runtime {

namespace {

/// Up to eight bytes as one number; what lies beyond the end reads as zero.
uint64_t loadBits(const uint8_t* bytes, size_t size, size_t at) {
  if (size - at >= 8) return format::loadU64(bytes + at);
  uint64_t bits = 0;
  for (uint32_t k = 0; at + k < size; ++k) bits |= static_cast<uint64_t>(bytes[at + k]) << (8 * k);
  return bits;
}

uint64_t sumOf(const int32_t* tags, uint32_t count) {
  uint64_t sum = 0;
  for (uint32_t i = 0; i < count; ++i) sum += static_cast<uint32_t>(tags[i]);
  return sum;
}

bool fillIsZero(const uint8_t* bytes, uint64_t bit_count) {
  return bit_count % 8 == 0 || bytes[bit_count / 8] >> (bit_count % 8) == 0;
}

/// A record of up to three values is at most 57 bits: one load covers it wherever it begins in its first byte.
template <uint32_t kComponents>
void unpackRecords(const uint8_t* bytes, size_t size, uint32_t records, const int32_t* tags, int32_t* values) {
  static_assert(3 * kCloudSymbolBits + 7 <= 64, "a load must cover three values");
  uint64_t bit = 0;
  for (uint32_t i = 0; i < records; ++i) {
    const uint32_t tag = static_cast<uint32_t>(tags[i]), mask = (1u << tag) - 1;
    for (uint32_t c = 0; c < kComponents; c += 3) {
      uint64_t window = loadBits(bytes, size, static_cast<size_t>(bit / 8)) >> (bit % 8);
      const uint32_t in_window = kComponents - c < 3 ? kComponents - c : 3;
      for (uint32_t k = 0; k < in_window; ++k, window >>= tag) *values++ = static_cast<int32_t>(window & mask);
      bit += static_cast<uint64_t>(tag) * in_window;
    }
  }
}

}  // namespace

CloudResult readTaggedValues(DracoReader& reader, uint32_t records, uint32_t components, int32_t* values) {
  // Values are written from the front while tags are read from the back: value (i, c) never overtakes tag i.
  const int32_t* tags = values + static_cast<size_t>(records) * (components - 1);
  const uint64_t bit_count = sumOf(tags, records) * components;
  const uint8_t* bytes = reader.here();
  const size_t reach = reader.left();
  if ((bit_count + 7) / 8 > reach) return CloudResult::kTruncated;
  reader.skip(static_cast<size_t>((bit_count + 7) / 8));
  if (!fillIsZero(bytes, bit_count)) return CloudResult::kStream;
  switch (components) {
    case 1:
      unpackRecords<1>(bytes, reach, records, tags, values);
      break;
    case 2:
      unpackRecords<2>(bytes, reach, records, tags, values);
      break;
    case 3:
      unpackRecords<3>(bytes, reach, records, tags, values);
      break;
    default:
      unpackRecords<4>(bytes, reach, records, tags, values);
      break;
  }
  return CloudResult::kOk;
}

CloudResult readPlainValues(DracoReader& reader, uint32_t byte_count, uint64_t count, int32_t* values) {
  if (byte_count == 0 || byte_count > 3) return CloudResult::kRange;
  if (count > reader.left() / byte_count) return CloudResult::kTruncated;
  const uint8_t* bytes = reader.here();
  uint32_t seen = 0;
  for (uint64_t i = 0; i < count; ++i, bytes += byte_count) {
    uint32_t symbol = bytes[0];
    for (uint32_t k = 1; k < byte_count; ++k) symbol |= static_cast<uint32_t>(bytes[k]) << (8 * k);
    seen |= symbol;
    values[i] = static_cast<int32_t>(symbol);
  }
  reader.skip(static_cast<size_t>(count * byte_count));
  return seen >> kCloudSymbolBits ? CloudResult::kRange : CloudResult::kOk;
}

void undoZigzag(uint64_t count, int32_t* values) {
  for (uint64_t i = 0; i < count; ++i) values[i] = fromZigzag(static_cast<uint32_t>(values[i]));
}

}  // namespace lithe::runtime
