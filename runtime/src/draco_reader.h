// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// A bounds-checked little-endian reader for Draco streams. Reading past the end gives zeros and clears `ok`, so that a
/// run of reads needs one check.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace lithe::runtime {

struct DracoReader {
  const uint8_t* bytes = nullptr;  ///< borrowed
  size_t size = 0;
  size_t at = 0;   ///< next byte; never beyond size
  bool ok = true;  ///< false once something was read that is not there

  size_t left() const { return size - at; }
  const uint8_t* here() const { return bytes + at; }

  void skip(size_t count) {
    if (count > left()) ok = false;
    at = ok ? at + count : size;
  }

  uint8_t u8() {
    if (at == size) {
      ok = false;
      return 0;
    }
    return bytes[at++];
  }

  /// Seven bits per byte, low bits first. More than 32 bits are an error.
  uint32_t varint() {
    uint32_t value = 0;
    for (uint32_t shift = 0; shift < 35; shift += 7) {
      const uint32_t byte = u8(), low = byte & 0x7f;
      if (shift == 28 && low > 0xf) break;
      value |= low << shift;
      if (byte < 0x80) return value;
    }
    ok = false;
    return 0;
  }
};

}  // namespace lithe::runtime
