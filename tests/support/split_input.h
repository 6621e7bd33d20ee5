// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The bytes that fuzz_splits takes for the integers of a page's streams, and what they mean.
///
///     kind and prefix | splits - 1 | new wedges | new faces | max_fan | level ends | parameters | streams | low bits
///
/// One byte each; a stream is its records (one byte) and their values: one byte, or 0xf0 and more for three that
/// follow. The low bits are what is left.
#pragma once

#include <cstdint>
#include <vector>

#include "lithe/format/page.h"

namespace lithe::test {

inline constexpr uint8_t kLongValue = 0xf0;
inline constexpr uint32_t kValueMask = (1u << 19) - 1;

/// Reads; past the end everything is zero.
struct SplitInput {
  const uint8_t* at;
  const uint8_t* end;

  uint8_t byte() { return at == end ? uint8_t{0} : *at++; }

  int32_t value(bool is_unsigned) {
    uint32_t code = byte();
    if (code >= kLongValue) {
      code = byte();
      code |= static_cast<uint32_t>(byte()) << 8;
      code |= static_cast<uint32_t>(byte()) << 16;
      code &= kValueMask;
    }
    return is_unsigned ? static_cast<int32_t>(code) : static_cast<int32_t>((code >> 1) ^ (0u - (code & 1)));
  }
};

/// Writes what SplitInput reads: the seeds are pages of real files.
struct SplitOutput {
  std::vector<uint8_t> bytes;

  void byte(uint32_t value) { bytes.push_back(static_cast<uint8_t>(value)); }

  void value(int32_t value, bool is_unsigned) {
    const uint32_t code = is_unsigned ? static_cast<uint32_t>(value)
                                      : (static_cast<uint32_t>(value) << 1 ^ static_cast<uint32_t>(value >> 31));
    if (code < kLongValue) return byte(code);
    byte(kLongValue), byte(code), byte(code >> 8), byte(code >> 16);
  }
};

}  // namespace lithe::test
