// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "page_streams.h"

#include "draco_cloud.h"

namespace lithe::bake {
namespace {

void putVarint(std::vector<uint8_t>& out, uint64_t value) {
  for (; value >= 0x80; value >>= 7) out.push_back(static_cast<uint8_t>(value | 0x80));
  out.push_back(static_cast<uint8_t>(value));
}

std::vector<uint8_t> encodeStream(const StreamData& stream) {
  CloudColumns cloud;
  std::vector<uint8_t> components;
  cloud.records = stream.records();
  for (const StreamData::Attribute& attribute : stream.attributes) {
    cloud.columns.push_back({attribute.spec.components, attribute.spec.is_unsigned, attribute.values});
    components.push_back(attribute.spec.components);
  }
  return withoutBeginning(encodeCloud(cloud), cloudBeginning(cloud.records, components));
}

}  // namespace

void LowBitsWriter::finish(PageData& page) const {
  for (std::size_t k = 0; k < kinds_.size(); ++k) page.low_bits[k] = kinds_[k].bytes();
}

uint64_t PageData::valueCount() const {
  uint64_t count = 0;
  for (const StreamData& stream : streams)
    for (const StreamData::Attribute& attribute : stream.attributes) count += attribute.values.size();
  return count;
}

PageData makePage(format::PageKind kind, format::WedgeAttributes has) {
  PageData page;
  page.kind = kind;
  const bool base = kind == format::kBasePage;
  page.streams.resize(base ? uint32_t{format::kBaseStreamCount} : uint32_t{format::kSplitStreamCount});
  for (uint32_t s = 0; s < page.streams.size(); ++s) {
    format::StreamAttribute specs[format::kMaxStreamAttributes];
    const uint32_t count =
        base ? format::baseStreamAttributes(s, has, specs) : format::splitStreamAttributes(s, has, specs);
    for (uint32_t i = 0; i < count; ++i) page.streams[s].attributes.push_back({specs[i], {}});
  }
  return page;
}

std::vector<uint8_t> writePage(const PageData& page, PageBytes* bytes) {
  std::vector<uint8_t> table, payload;
  bytes->streams.assign(page.streams.size(), 0);
  for (std::size_t s = 0; s < page.streams.size(); ++s) {
    const uint32_t records = page.streams[s].records();
    putVarint(table, records);
    if (records == 0) continue;
    const std::vector<uint8_t> stream = encodeStream(page.streams[s]);
    putVarint(table, stream.size());
    payload.insert(payload.end(), stream.begin(), stream.end());
    bytes->streams[s] = static_cast<uint32_t>(stream.size());
  }
  bytes->low_bits = 0;
  for (const std::vector<uint8_t>& bits : page.low_bits) {
    putVarint(table, bits.size());
    payload.insert(payload.end(), bits.begin(), bits.end());
    bytes->low_bits += static_cast<uint32_t>(bits.size());
  }

  std::vector<uint8_t> out;
  out.reserve(1 + page.parameters.size() + table.size() + payload.size());
  out.push_back(page.kind);
  out.insert(out.end(), page.parameters.begin(), page.parameters.end());
  out.insert(out.end(), table.begin(), table.end());
  out.insert(out.end(), payload.begin(), payload.end());
  for (const std::vector<uint32_t>& level : page.hidden) {
    uint32_t previous = 0;
    for (uint32_t face : level) {
      putVarint(out, face - previous);
      previous = face;
    }
  }
  bytes->overhead = static_cast<uint32_t>(out.size() - payload.size());
  return out;
}

}  // namespace lithe::bake
