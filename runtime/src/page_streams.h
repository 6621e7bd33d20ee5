// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// A page's streams, entropy decoded: one array of integers per stream attribute, read in order.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "draco_cloud.h"
#include "lithe/format/bytes.h"
#include "page.h"

namespace lithe::runtime {

/// Reader checks of docs/format.md that concern pages.
enum PageCheck : uint32_t {
  kCheckKind = 62,
  kCheckParameters = 63,
  kCheckTable = 64,
  kCheckCloud = 65,
  kCheckLeftover = 66,
  kCheckNode = 67,
  kCheckSkin = 68,
  kCheckWedge = 69,
  kCheckBaseFace = 70,
  kCheckFlags = 71,
  kCheckSplit = 72,
  kCheckPosition = 73,
  kCheckCut = 74,
  kCheckGeneral = 75,
  kCheckClasses = 76,
  kCheckPick = 77,
  kCheckFace = 78,
  kCheckChildSkin = 79,
  kCheckStream = 80,
  kCheckWork = 81,
  kCheckCounts = 82,
  kCheckHidden = 83,
};

/// 0 when all is well, else the check that failed.
constexpr uint32_t failUnless(bool ok, PageCheck check) { return ok ? 0u : static_cast<uint32_t>(check); }

/// Integers read front to back. Reading past the end gives 0 and is remembered.
struct IntReader {
  const int32_t* at = nullptr;
  const int32_t* end = nullptr;
  bool overrun = false;

  int32_t next() {
    if (at == end) {
      overrun = true;
      return 0;
    }
    return *at++;
  }
  uint32_t left() const { return static_cast<uint32_t>(end - at); }
};

/// Bits read front to back, least significant first. Reading past the end gives 0 and is remembered.
struct BitReader {
  const uint8_t* bytes = nullptr;
  uint64_t bit = 0, bit_end = 0;
  bool overrun = false;

  /// count 0..32
  uint32_t next(int32_t count) {
    const uint64_t after = bit + static_cast<uint64_t>(count);
    if (after > bit_end) {
      overrun = true;
      return 0;
    }
    const uint64_t value = window() >> (bit & 7) & ((uint64_t{1} << count) - 1);
    bit = after;
    return static_cast<uint32_t>(value);
  }

  /// The eight bytes from the current one on; near the end what is left of them, and no byte beyond it.
  uint64_t window() const {
    const uint8_t* at = bytes + (bit >> 3);
    const uint64_t left = ((bit_end + 7) >> 3) - (bit >> 3);
    if (left >= 8) return format::loadU64(at);
    uint64_t value = 0;
    for (uint64_t i = 0; i < left; ++i) value |= uint64_t{at[i]} << (8 * i);
    return value;
  }

  /// Read to the last byte, whose padding is zero, and no further.
  bool exhausted() const {
    if (overrun || bit_end - bit >= 8) return false;
    return bit == bit_end || (bytes[bit >> 3] >> (bit & 7)) == 0;
  }
};

inline constexpr uint32_t kMaxStreams = static_cast<uint32_t>(format::kSplitStreamCount) >
                                                static_cast<uint32_t>(format::kBaseStreamCount)
                                            ? static_cast<uint32_t>(format::kSplitStreamCount)
                                            : static_cast<uint32_t>(format::kBaseStreamCount);
inline constexpr uint32_t kMaxAttributesPerStream = format::kMaxStreamAttributes;

struct PageStreams {
  const uint8_t* parameters;
  uint32_t records[kMaxStreams];
  IntReader values[kMaxStreams][kMaxAttributesPerStream];
  BitReader low_bits[format::kLowBitsKinds];
  const uint8_t* hidden;  ///< what follows the low bits
  const uint8_t* hidden_end;
};

/// A value whose `low` lowest bits are in the low bits, the others in a stream.
inline int32_t splitValue(BitReader* low_bits, IntReader* high, int32_t low) {
  const uint32_t bits = low_bits->next(low);
  return static_cast<int32_t>((static_cast<uint32_t>(high->next()) << low) | bits);
}

/// Reads a page's header and tables, checks every stream's length against what the plan allows, and decodes the clouds.
/// values   room for plan.values integers, used as the streams' memory
/// returns  the check that failed, 0 when all is well; *offset is where in the page
uint32_t readStreams(const PageFormat& format, const PagePlan& plan, const Decoded& before, const uint8_t* bytes,
                     size_t size, int32_t* values, const DecodeScratch& scratch, PageStreams* streams, size_t* offset);

/// Every stream must have been read to its end, and no further.
bool streamsExhausted(const PageStreams& streams);

/// LEB128, at most 5 bytes; returns false at the end of the bytes or beyond 32 bits.
bool readVarint(const uint8_t** at, const uint8_t* end, uint32_t* value);

}  // namespace lithe::runtime
