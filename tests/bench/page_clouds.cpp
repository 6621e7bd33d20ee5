// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "page_clouds.h"

#include "lithe/bake/model.h"
#include "lithe/format/page.h"
#include "tool/page_table.h"

namespace lithe::bench {
namespace {

std::vector<runtime::ColumnSpec> columnsOf(bool base, uint32_t stream, format::WedgeAttributes has) {
  format::StreamAttribute attributes[format::kMaxStreamAttributes];
  const uint32_t count = base ? format::baseStreamAttributes(stream, has, attributes)
                              : format::splitStreamAttributes(stream, has, attributes);
  std::vector<runtime::ColumnSpec> columns;
  for (uint32_t a = 0; a < count; ++a)
    columns.push_back({attributes[a].components,
                       attributes[a].is_unsigned ? runtime::ColumnKind::kUnsigned : runtime::ColumnKind::kSigned});
  return columns;
}

std::unique_ptr<CloudSet> cloudsOf(std::span<const uint8_t> page, format::WedgeAttributes has) {
  const tool::PageTable table = tool::readPageTable(page, "a page");
  auto clouds = std::make_unique<CloudSet>();
  for (uint32_t s = 0; s < table.streams.size(); ++s) {
    const tool::PageTable::Stream& stream = table.streams[s];
    if (stream.records == 0) continue;
    clouds->add(stream.bytes.data(), stream.bytes.size(), stream.records,
                columnsOf(table.kind == format::kBasePage, s, has));
  }
  return clouds;
}

}  // namespace

std::vector<std::unique_ptr<CloudSet>> pageClouds(const lithe_asset& asset, const std::vector<uint8_t>& bytes) {
  lithe_asset_info info;
  lithe_asset_describe(&asset, &info);
  const format::WedgeAttributes has = {info.has_normals != 0, info.has_tangents != 0, info.uv_sets, info.color_sets};
  std::vector<std::unique_ptr<CloudSet>> pages;
  for (uint32_t i = 0; i < info.page_count; ++i) {
    lithe_page page;
    if (lithe_asset_page(&asset, i, &page) != LITHE_OK) throw bake::Error("a page is missing from its table");
    pages.push_back(cloudsOf(std::span(bytes).subspan(page.offset, page.size), has));
    if (!pages.back()->bothAgree()) throw bake::Error("libdraco reads other values from a page than the runtime");
  }
  return pages;
}

}  // namespace lithe::bench
