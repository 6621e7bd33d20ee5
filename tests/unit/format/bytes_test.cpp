// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/format/bytes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "random.h"

namespace lithe::format {
namespace {

TEST(Bytes, LoadsTheLowestByteFirst) {
  const uint8_t bytes[] = {0x01, 0x82, 0x03, 0x84, 0x05, 0x86, 0x07, 0x88};
  EXPECT_EQ(loadU16(bytes), 0x8201u);
  EXPECT_EQ(loadU32(bytes), 0x84038201u);
  EXPECT_EQ(loadU64(bytes), 0x8807860584038201u);
}

TEST(Bytes, LoadsAtAnyAddress) {
  const uint8_t bytes[] = {0xaa, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0x7f, 0xaa};
  EXPECT_EQ(loadU16(bytes + 7), 0x7fffu);
  EXPECT_EQ(loadU32(bytes + 5), 0x7fffffffu);
  EXPECT_EQ(loadU64(bytes + 1), 0x7fffffffffffffffu);
}

TEST(Bytes, FloatsAreIeeeBits) {
  const uint8_t minus_two_and_a_half[] = {0x00, 0x00, 0x20, 0xc0};
  EXPECT_EQ(loadF32(minus_two_and_a_half), -2.5f);
  uint8_t stored[4];
  storeF32(stored, 1.0f);
  EXPECT_EQ(loadU32(stored), 0x3f800000u);
  storeF32(stored, -0.0f);
  EXPECT_EQ(loadU32(stored), 0x80000000u);
}

TEST(Bytes, StoresTouchOnlyTheirOwn) {
  for (uint32_t at = 0; at < 8; ++at) {
    std::vector<uint8_t> bytes(24, 0xcc);
    storeU16(bytes.data() + at, 0x0102);
    storeU32(bytes.data() + at + 2, 0x03040506);
    storeU64(bytes.data() + at + 6, 0x0708090a0b0c0d0eu);
    std::vector<uint8_t> expected(24, 0xcc);
    const uint8_t written[] = {0x02, 0x01, 0x06, 0x05, 0x04, 0x03, 0x0e, 0x0d, 0x0c, 0x0b, 0x0a, 0x09, 0x08, 0x07};
    std::copy(std::begin(written), std::end(written), expected.begin() + at);
    EXPECT_EQ(bytes, expected) << at;
  }
}

TEST(Bytes, WhatIsStoredIsLoaded) {
  test::Random random(1);
  uint8_t bytes[8];
  for (int i = 0; i < 1000; ++i) {
    const uint64_t value = random.next();
    storeU64(bytes, value);
    ASSERT_EQ(loadU64(bytes), value);
    storeU32(bytes, static_cast<uint32_t>(value));
    ASSERT_EQ(loadU32(bytes), static_cast<uint32_t>(value));
    storeU16(bytes, static_cast<uint16_t>(value));
    ASSERT_EQ(loadU16(bytes), static_cast<uint16_t>(value));
  }
  for (float value : {0.1f, std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::max(),
                      -std::numeric_limits<float>::infinity()}) {
    storeF32(bytes, value);
    EXPECT_EQ(loadF32(bytes), value);
  }
  storeF32(bytes, std::numeric_limits<float>::quiet_NaN());
  EXPECT_TRUE(std::isnan(loadF32(bytes)));
}

}  // namespace
}  // namespace lithe::format
