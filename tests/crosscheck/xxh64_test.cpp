// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The runtime's own XXH64 against libxxhash's.
#define XXH_INLINE_ALL
#include "xxh64.h"

#include <gtest/gtest.h>
#include <xxhash.h>

#include <vector>

#include "random.h"

namespace lithe {
namespace {

std::vector<uint8_t> noise(size_t size, uint64_t seed) {
  test::Random random(seed);
  std::vector<uint8_t> bytes(size);
  for (uint8_t& byte : bytes) byte = static_cast<uint8_t>(random.below(256));
  return bytes;
}

/// Every remainder of the 32-byte stripes and of the 8- and 4-byte words after them, at every alignment.
TEST(Xxh64Crosscheck, EveryLengthAndAlignment) {
  const std::vector<uint8_t> bytes = noise(400, 1);
  for (size_t start = 0; start < 9; ++start) {
    for (size_t size = 0; start + size <= 300; ++size) {
      ASSERT_EQ(XXH64(bytes.data() + start, size, 0), runtime::xxh64(bytes.data() + start, size))
          << start << ' ' << size;
    }
  }
}

TEST(Xxh64Crosscheck, SeedsAndLongInputs) {
  test::Random random(2);
  const std::vector<uint8_t> bytes = noise(1 << 20, 3);
  for (int round = 0; round < 300; ++round) {
    const size_t size = random.octave(1 << 20);
    const uint64_t seed = random.next();
    ASSERT_EQ(XXH64(bytes.data(), size, seed), runtime::xxh64(bytes.data(), size, seed));
  }
}

}  // namespace
}  // namespace lithe
