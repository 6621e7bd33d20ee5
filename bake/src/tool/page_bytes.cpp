// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "page_bytes.h"

#include "lithe/bake/encode.h"
#include "page_table.h"

namespace lithe::tool {
namespace {

void countPage(std::span<const uint8_t> page, const std::string& place, std::map<std::string, uint64_t>& kinds) {
  const PageTable table = readPageTable(page, place);
  for (uint32_t s = 0; s < table.streams.size(); ++s)
    if (table.streams[s].records > 0) kinds[bake::streamKind(table.kind, s)] += table.streams[s].bytes.size();
  for (const auto& bits : table.low_bits) kinds["low bits"] += bits.size();
  kinds["page tables"] += page.size() - table.payloadBytes();
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
