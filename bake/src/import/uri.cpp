// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "uri.h"

#include <cstdint>
#include <string_view>

namespace lithe::bake {

namespace {

constexpr std::string_view kHexadecimal = "0123456789ABCDEF";

bool isUnreserved(char c) {
  const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  return letter || (c >= '0' && c <= '9') || std::string_view("-_.~").find(c) != std::string_view::npos;
}

/// 16 for what is no hexadecimal digit.
uint32_t digitOf(char c) {
  const char upper = c >= 'a' && c <= 'f' ? static_cast<char>(c - 'a' + 'A') : c;
  const size_t digit = kHexadecimal.find(upper);
  return digit == std::string_view::npos ? 16 : static_cast<uint32_t>(digit);
}

}  // namespace

std::string percentEncoded(const std::string& name) {
  std::string uri;
  for (const char c : name) {
    const uint8_t byte = static_cast<uint8_t>(c);
    if (isUnreserved(c)) {
      uri += c;
    } else {
      uri += {'%', kHexadecimal[byte >> 4], kHexadecimal[byte & 15]};
    }
  }
  return uri;
}

std::string percentDecoded(const std::string& uri) {
  std::string name;
  for (size_t i = 0; i < uri.size(); ++i) {
    const uint32_t high = uri[i] == '%' && i + 2 < uri.size() ? digitOf(uri[i + 1]) : 16;
    const uint32_t low = high < 16 ? digitOf(uri[i + 2]) : 16;
    name += low < 16 ? static_cast<char>(high * 16 + low) : uri[i];
    if (low < 16) i += 2;
  }
  return name;
}

}  // namespace lithe::bake
