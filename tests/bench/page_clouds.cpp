// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "page_clouds.h"

#include "lithe/bake/model.h"
#include "lithe/format/page.h"
#include "page_streams.h"

namespace lithe::bench {
namespace {

struct Stream {
  uint32_t records, bytes;
  std::vector<runtime::ColumnSpec> columns;
};

/// The bytes come from a bake that was read back: what is odd here is a fault of this file.
uint32_t varintOf(const uint8_t** at, const uint8_t* end) {
  uint32_t value = 0;
  if (!runtime::readVarint(at, end, &value)) throw bake::Error("a page's stream table ends early");
  return value;
}

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

std::unique_ptr<CloudSet> cloudsOf(const uint8_t* page, size_t size, format::WedgeAttributes has) {
  const uint8_t *at = page + 1 + format::kParameterBytes, *const end = page + size;
  const bool base = page[0] == format::kBasePage;
  const uint32_t count = base ? +format::kBaseStreamCount : +format::kSplitStreamCount;
  std::vector<Stream> streams;
  for (uint32_t s = 0; s < count; ++s) {
    const uint32_t records = varintOf(&at, end);
    if (records > 0) streams.push_back({records, varintOf(&at, end), columnsOf(base, s, has)});
  }
  // The low bits follow the streams.
  for (uint32_t kind = 0; kind < format::kLowBitsKinds; ++kind) varintOf(&at, end);
  auto clouds = std::make_unique<CloudSet>();
  for (const Stream& stream : streams) {
    if (stream.bytes > static_cast<size_t>(end - at)) throw bake::Error("a page ends before its streams do");
    clouds->add(at, stream.bytes, stream.records, stream.columns);
    at += stream.bytes;
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
    pages.push_back(cloudsOf(bytes.data() + page.offset, page.size, has));
    if (!pages.back()->bothAgree()) throw bake::Error("libdraco reads other values from a page than the runtime");
  }
  return pages;
}

}  // namespace lithe::bench
