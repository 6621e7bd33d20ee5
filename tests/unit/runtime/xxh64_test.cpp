// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "xxh64.h"

#include <gtest/gtest.h>

#include <cstring>

namespace lithe::runtime {
namespace {

uint64_t hashOf(const char* text) { return xxh64(text, std::strlen(text)); }

/// Digests that xxHash's own tool prints.
TEST(Xxh64, KnownDigests) {
  EXPECT_EQ(0xef46db3751d8e999u, xxh64(nullptr, 0));
  EXPECT_EQ(0xd24ec4f1a98c6e5bu, hashOf("a"));
  EXPECT_EQ(0x44bc2cf5ad770999u, hashOf("abc"));
  EXPECT_EQ(0xcfe1f278fa89835cu, hashOf("abcdefghijklmnopqrstuvwxyz"));
  EXPECT_EQ(0xaaa46907d3047814u, hashOf("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789"));
}

TEST(Xxh64, EveryBitCounts) {
  uint8_t bytes[77] = {};
  const uint64_t before = xxh64(bytes, sizeof bytes);
  for (size_t bit = 0; bit < 8 * sizeof bytes; ++bit) {
    bytes[bit / 8] ^= static_cast<uint8_t>(1 << bit % 8);
    EXPECT_NE(before, xxh64(bytes, sizeof bytes)) << bit;
    bytes[bit / 8] ^= static_cast<uint8_t>(1 << bit % 8);
  }
  EXPECT_NE(before, xxh64(bytes, sizeof bytes - 1));
  EXPECT_NE(before, xxh64(bytes, sizeof bytes, 1));
}

}  // namespace
}  // namespace lithe::runtime
