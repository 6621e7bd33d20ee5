// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "xxh64.h"

namespace lithe::runtime {

namespace {

constexpr uint64_t kPrime1 = 0x9E3779B185EBCA87u;
constexpr uint64_t kPrime2 = 0xC2B2AE3D27D4EB4Fu;
constexpr uint64_t kPrime3 = 0x165667B19E3779F9u;
constexpr uint64_t kPrime4 = 0x85EBCA77C2B2AE63u;
constexpr uint64_t kPrime5 = 0x27D4EB2F165667C5u;
constexpr size_t kStripe = 32;

uint64_t rotateLeft(uint64_t x, uint32_t bits) { return x << bits | x >> (64 - bits); }

uint64_t load32(const uint8_t* p) {
  return p[0] | static_cast<uint64_t>(p[1]) << 8 | static_cast<uint64_t>(p[2]) << 16 |
         static_cast<uint64_t>(p[3]) << 24;
}

uint64_t load64(const uint8_t* p) { return load32(p) | load32(p + 4) << 32; }

uint64_t round(uint64_t lane, uint64_t input) { return rotateLeft(lane + input * kPrime2, 31) * kPrime1; }

uint64_t mergeLane(uint64_t hash, uint64_t lane) { return (hash ^ round(0, lane)) * kPrime1 + kPrime4; }

/// Four lanes take eight bytes each of every whole stripe; returns them merged.
uint64_t hashStripes(const uint8_t* p, size_t stripes, uint64_t seed) {
  uint64_t lane[4] = {seed + kPrime1 + kPrime2, seed + kPrime2, seed, seed - kPrime1};
  for (size_t i = 0; i < stripes; ++i, p += kStripe) {
    for (size_t k = 0; k < 4; ++k) lane[k] = round(lane[k], load64(p + 8 * k));
  }
  uint64_t hash = rotateLeft(lane[0], 1) + rotateLeft(lane[1], 7) + rotateLeft(lane[2], 12) + rotateLeft(lane[3], 18);
  for (uint64_t value : lane) hash = mergeLane(hash, value);
  return hash;
}

uint64_t hashTail(uint64_t hash, const uint8_t* p, size_t size) {
  for (; size >= 8; size -= 8, p += 8) hash = rotateLeft(hash ^ round(0, load64(p)), 27) * kPrime1 + kPrime4;
  if (size >= 4) {
    hash = rotateLeft(hash ^ load32(p) * kPrime1, 23) * kPrime2 + kPrime3;
    p += 4;
    size -= 4;
  }
  for (; size > 0; --size, ++p) hash = rotateLeft(hash ^ *p * kPrime5, 11) * kPrime1;
  return hash;
}

uint64_t avalanche(uint64_t hash) {
  hash = (hash ^ hash >> 33) * kPrime2;
  hash = (hash ^ hash >> 29) * kPrime3;
  return hash ^ hash >> 32;
}

}  // namespace

uint64_t xxh64(const void* bytes, size_t size, uint64_t seed) {
  const uint8_t* p = static_cast<const uint8_t*>(bytes);
  const size_t stripes = size / kStripe, striped = stripes * kStripe;
  uint64_t hash = stripes ? hashStripes(p, stripes, seed) : seed + kPrime5;
  hash += size;
  return avalanche(hashTail(hash, p + striped, size - striped));
}

}  // namespace lithe::runtime
