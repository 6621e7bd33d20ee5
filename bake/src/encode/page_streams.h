// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The symbols of a page before entropy coding: one list of integers per stream attribute.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lithe/format/page.h"

namespace lithe::bake {

/// Packs integers of a few bits each, least significant bit first.
class BitWriter {
 public:
  void write(uint32_t value, int32_t bits) {
    for (int32_t i = 0; i < bits; ++i, ++count_) {
      if (count_ % 8 == 0) bytes_.push_back(0);
      bytes_.back() |= static_cast<uint8_t>(((value >> i) & 1) << (count_ % 8));
    }
  }
  const std::vector<uint8_t>& bytes() const { return bytes_; }

 private:
  std::vector<uint8_t> bytes_;
  uint64_t count_ = 0;
};

struct PageData;

/// The low bits of a page, each kind's apart.
class LowBitsWriter {
 public:
  BitWriter& operator[](format::LowBits kind) { return kinds_[kind]; }
  void finish(PageData& page) const;

 private:
  std::array<BitWriter, format::kLowBitsKinds> kinds_;
};

/// One stream: `attributes[i].values` holds records * components integers.
struct StreamData {
  struct Attribute {
    format::StreamAttribute spec{};
    std::vector<int32_t> values;

    /// A split value: its `low` lowest bits go to the low bits, the others to the stream.
    void putSplit(int32_t value, int32_t low, BitWriter& low_bits) {
      values.push_back(value >> low);
      low_bits.write(static_cast<uint32_t>(value), low);
    }
  };
  std::vector<Attribute> attributes;

  uint32_t records() const {
    return attributes.empty() ? 0 : static_cast<uint32_t>(attributes[0].values.size() / attributes[0].spec.components);
  }
  void put(int32_t value) { attributes[0].values.push_back(value); }
};

/// A page ready to be entropy coded.
struct PageData {
  format::PageKind kind = format::kBasePage;
  std::array<uint8_t, format::kParameterBytes> parameters{};
  std::vector<StreamData> streams;
  std::array<std::vector<uint8_t>, format::kLowBitsKinds> low_bits;
  std::vector<std::vector<uint32_t>> hidden;  ///< ascending face ids, of each level that ends in this page
  uint32_t max_fan = 0;                       ///< most corners or wedges at a node that is split

  uint64_t valueCount() const;  ///< integers in all streams
};

PageData makePage(format::PageKind kind, format::WedgeAttributes has);

/// Bytes per stream of a written page, for the report; the last two entries are the low bits and everything else.
struct PageBytes {
  std::vector<uint32_t> streams;
  uint32_t low_bits = 0;
  uint32_t overhead = 0;
};

/// Entropy codes a page with Draco. Throws Error when a symbol is beyond what a stream can hold, or when libdraco
/// writes other clouds than the format has.
std::vector<uint8_t> writePage(const PageData& page, PageBytes* bytes);

}  // namespace lithe::bake
