// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Little-endian loads and stores of unaligned bytes, on any host.
#pragma once

#include <stdint.h>
#include <string.h>

namespace lithe::format {

inline uint16_t loadU16(const uint8_t* p) { return static_cast<uint16_t>(p[0] | (p[1] << 8)); }
inline uint32_t loadU32(const uint8_t* p) { return loadU16(p) | (static_cast<uint32_t>(loadU16(p + 2)) << 16); }
inline uint64_t loadU64(const uint8_t* p) { return loadU32(p) | (static_cast<uint64_t>(loadU32(p + 4)) << 32); }
inline float loadF32(const uint8_t* p) {
  const uint32_t bits = loadU32(p);
  float value;
  memcpy(&value, &bits, 4);
  return value;
}

inline void storeU16(uint8_t* p, uint16_t v) {
  p[0] = static_cast<uint8_t>(v);
  p[1] = static_cast<uint8_t>(v >> 8);
}
inline void storeU32(uint8_t* p, uint32_t v) {
  storeU16(p, static_cast<uint16_t>(v));
  storeU16(p + 2, static_cast<uint16_t>(v >> 16));
}
inline void storeU64(uint8_t* p, uint64_t v) {
  storeU32(p, static_cast<uint32_t>(v));
  storeU32(p + 4, static_cast<uint32_t>(v >> 32));
}
inline void storeF32(uint8_t* p, float v) {
  uint32_t bits;
  memcpy(&bits, &v, 4);
  storeU32(p, bits);
}

}  // namespace lithe::format
