// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// A page taken apart by its own stream table: where its streams and low bits lie. Nothing is decoded.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "lithe/format/page.h"

namespace lithe::tool {

struct PageTable {
  struct Stream {
    uint32_t records = 0;
    std::span<const uint8_t> bytes;  ///< none where there are no records
  };
  format::PageKind kind = format::kBasePage;
  std::span<const uint8_t> parameters;
  std::vector<Stream> streams;  ///< of the page's kind, in the order of the format
  std::array<std::span<const uint8_t>, format::kLowBitsKinds> low_bits;

  /// What the streams and the low bits take; the rest of the page is tables.
  uint64_t payloadBytes() const;
};

/// `place` names the page in sentences. The spans are the page's. @throws bake::Error when the table is damaged
PageTable readPageTable(std::span<const uint8_t> page, const std::string& place);

}  // namespace lithe::tool
