// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "page_table.h"

#include "lithe/bake/model.h"

namespace lithe::tool {
namespace {

using Bytes = std::span<const uint8_t>;

/// A page's bytes from front to back; everything that reaches beyond them is damage.
class Cursor {
 public:
  Cursor(Bytes bytes, std::string place) : bytes_(bytes), place_(std::move(place)) {}

  uint8_t byte() { return take(1)[0]; }

  uint32_t varint() {
    uint32_t value = 0;
    for (uint32_t shift = 0; shift < 32; shift += 7) {
      const uint32_t next = byte();
      value |= (next & 127) << shift;
      if (next < 128) return value;
    }
    fail();
  }

  Bytes take(size_t count) {
    if (count > bytes_.size() - at_) fail();
    at_ += count;
    return bytes_.subspan(at_ - count, count);
  }

  [[noreturn]] void fail() const {
    throw bake::Error(place_ + ": is damaged (stream table); copy it again or bake it again");
  }

 private:
  Bytes bytes_;
  size_t at_ = 0;
  std::string place_;
};

}  // namespace

uint64_t PageTable::payloadBytes() const {
  uint64_t count = 0;
  for (const Bytes& bits : low_bits) count += bits.size();
  for (const Stream& stream : streams) count += stream.bytes.size();
  return count;
}

PageTable readPageTable(Bytes page, const std::string& place) {
  Cursor cursor(page, place);
  PageTable table;
  table.kind = static_cast<format::PageKind>(cursor.byte());
  if (table.kind != format::kBasePage && table.kind != format::kSplitPage) cursor.fail();
  table.parameters = cursor.take(format::kParameterBytes);
  const bool base = table.kind == format::kBasePage;
  table.streams.resize(base ? +format::kBaseStreamCount : +format::kSplitStreamCount);
  std::vector<uint32_t> sizes;
  for (PageTable::Stream& stream : table.streams) {
    stream.records = cursor.varint();
    sizes.push_back(stream.records > 0 ? cursor.varint() : 0);
  }
  std::array<uint32_t, format::kLowBitsKinds> low_sizes;
  for (uint32_t& size : low_sizes) size = cursor.varint();
  for (size_t s = 0; s < sizes.size(); ++s) table.streams[s].bytes = cursor.take(sizes[s]);
  for (size_t k = 0; k < low_sizes.size(); ++k) table.low_bits[k] = cursor.take(low_sizes[k]);
  return table;
}

}  // namespace lithe::tool
