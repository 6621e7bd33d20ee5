// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "page_bytes.h"

#include <span>

#include "lithe/bake/encode.h"
#include "lithe/format/page.h"

namespace lithe::tool {
namespace {

using Bytes = std::span<const uint8_t>;

/// A page's bytes from front to back; everything that reaches beyond them is damage.
class Cursor {
 public:
  Cursor(Bytes bytes, std::string place) : bytes_(bytes), place_(std::move(place)) {}

  uint8_t byte() {
    if (at_ == bytes_.size()) fail();
    return bytes_[at_++];
  }

  uint32_t varint() {
    uint32_t value = 0;
    for (uint32_t shift = 0; shift < 32; shift += 7) {
      const uint32_t next = byte();
      value |= (next & 127) << shift;
      if (next < 128) return value;
    }
    fail();
  }

  void skip(size_t count) {
    if (count > bytes_.size() - at_) fail();
    at_ += count;
  }

  [[noreturn]] void fail() const {
    throw bake::Error(place_ + ": is damaged (stream table); copy it again or bake it again");
  }

 private:
  Bytes bytes_;
  size_t at_ = 0;
  std::string place_;
};

void countPage(Bytes page, const std::string& place, std::map<std::string, uint64_t>& kinds) {
  Cursor cursor(page, place);
  const auto kind = static_cast<format::PageKind>(cursor.byte());
  if (kind != format::kBasePage && kind != format::kSplitPage) cursor.fail();
  cursor.skip(format::kParameterBytes);
  const uint32_t streams = kind == format::kBasePage ? +format::kBaseStreamCount : +format::kSplitStreamCount;
  uint64_t payload = 0;
  for (uint32_t stream = 0; stream < streams; ++stream) {
    if (cursor.varint() == 0) continue;
    const uint32_t bytes = cursor.varint();
    kinds[bake::streamKind(kind, stream)] += bytes;
    payload += bytes;
  }
  const uint32_t low_bits = cursor.varint();
  kinds["low bits"] += low_bits;
  payload += low_bits;
  cursor.skip(payload);
  kinds["page tables"] += page.size() - payload;
}

}  // namespace

std::map<std::string, uint64_t> bytesByKind(const Asset& asset) {
  std::map<std::string, uint64_t> kinds{{"head", asset.headBytes()}};
  for (uint32_t i = 0; i < asset.info().page_count; ++i) {
    const lithe_page page = asset.page(i);
    const std::string place = asset.name() + ": page " + std::to_string(i);
    if (page.offset + page.size > asset.bytes().size()) throw bake::Error(place + ": is missing; copy it again");
    countPage(asset.bytes().subspan(page.offset, page.size), place, kinds);
  }
  return kinds;
}

}  // namespace lithe::tool
