// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Whether bytes are UTF-8 (RFC 3629): no overlong forms, no surrogates, nothing beyond U+10FFFF.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace lithe::runtime {

inline bool isUtf8(const uint8_t* bytes, size_t size) {
  for (size_t i = 0; i < size;) {
    const uint8_t lead = bytes[i++];
    if (lead < 0x80) continue;
    if (lead < 0xc2 || lead > 0xf4) return false;
    const size_t trail = lead < 0xe0 ? 1 : lead < 0xf0 ? 2 : 3;
    if (size - i < trail) return false;
    // The first trailing byte's range is narrower after four of the leads.
    const uint8_t least = lead == 0xe0 ? 0xa0 : lead == 0xf0 ? 0x90 : 0x80;
    const uint8_t greatest = lead == 0xed ? 0x9f : lead == 0xf4 ? 0x8f : 0xbf;
    if (bytes[i] < least || bytes[i] > greatest) return false;
    for (size_t t = 1; t < trail; ++t)
      if ((bytes[i + t] & 0xc0) != 0x80) return false;
    i += trail;
  }
  return true;
}

}  // namespace lithe::runtime
