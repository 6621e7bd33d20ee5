// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "utf8.h"

#include <gtest/gtest.h>

#include <string>

namespace lithe::runtime {
namespace {

bool valid(const std::string& text) { return isUtf8(reinterpret_cast<const uint8_t*>(text.data()), text.size()); }

std::string encoded(uint32_t code) {
  auto byte = [](uint32_t value) { return static_cast<char>(value); };
  if (code < 0x80) return {byte(code)};
  if (code < 0x800) return {byte(0xc0 | code >> 6), byte(0x80 | (code & 63))};
  if (code < 0x10000) return {byte(0xe0 | code >> 12), byte(0x80 | (code >> 6 & 63)), byte(0x80 | (code & 63))};
  return {byte(0xf0 | code >> 18), byte(0x80 | (code >> 12 & 63)), byte(0x80 | (code >> 6 & 63)),
          byte(0x80 | (code & 63))};
}

TEST(Utf8, TakesEveryCodePointButSurrogates) {
  for (uint32_t code = 0; code < 0x110000; ++code) {
    const bool surrogate = code >= 0xd800 && code < 0xe000;
    ASSERT_EQ(valid("a" + encoded(code) + "z"), !surrogate) << code;
  }
  EXPECT_FALSE(valid(encoded(0x110000)));
}

TEST(Utf8, RefusesCutShortStrayAndOverlong) {
  for (const uint32_t code : {0x80u, 0x800u, 0x10000u}) {
    const std::string text = encoded(code);
    for (size_t size = 1; size < text.size(); ++size) {
      EXPECT_FALSE(valid(text.substr(0, size)));
      EXPECT_FALSE(valid(text.substr(0, size) + "a"));
    }
  }
  EXPECT_FALSE(valid("\x80"));
  EXPECT_FALSE(valid("\xc0\xaf"));
  EXPECT_FALSE(valid("\xc1\xbf"));
  EXPECT_FALSE(valid("\xe0\x9f\xbf"));
  EXPECT_FALSE(valid("\xf0\x8f\xbf\xbf"));
  EXPECT_FALSE(valid("\xff"));
}

}  // namespace
}  // namespace lithe::runtime
