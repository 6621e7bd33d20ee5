// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// A page as the integers of its streams, to be changed and written again with the bake's own page writer.
#pragma once

#include <stdexcept>

#include "draco_cloud.h"
#include "encode/page_streams.h"
#include "lithe/format/page.h"
#include "lithe_file.h"

namespace lithe::test {

inline format::WedgeAttributes attributesOf(LitheFile& file) {
  using namespace format;
  const uint8_t* p = file.record(info::kId);
  const uint8_t bits = p[info::kAttributesAt];
  return {(bits & info::kHasNormals) != 0, (bits & info::kHasTangents) != 0, p[info::kUvSetsAt], p[info::kColorSetsAt]};
}

/// Reads varints of a sound page.
struct VarintReader {
  const uint8_t* at;

  uint32_t next() {
    uint32_t value = 0;
    for (uint32_t shift = 0;; shift += 7) {
      const uint8_t byte = *at++;
      value |= static_cast<uint32_t>(byte & 0x7f) << shift;
      if (byte < 0x80) return value;
    }
  }
};

class PageEditor {
 public:
  /// Takes page `index` of a sound file apart.
  PageEditor(LitheFile& file, uint32_t index) : file_(file), index_(index) {
    const FileBytes& bytes = file.pages[index];
    data = bake::makePage(static_cast<format::PageKind>(bytes[0]), attributesOf(file));
    std::copy_n(bytes.begin() + 1, data.parameters.size(), data.parameters.begin());
    VarintReader table{bytes.data() + 1 + data.parameters.size()};
    std::vector<uint32_t> records, sizes;
    for (size_t s = 0; s < data.streams.size(); ++s) {
      records.push_back(table.next());
      sizes.push_back(records.back() ? table.next() : 0);
    }
    std::array<uint32_t, format::kLowBitsKinds> low_sizes;
    for (uint32_t& size : low_sizes) size = table.next();
    const uint8_t* at = table.at;
    for (size_t s = 0; s < data.streams.size(); ++s) {
      if (records[s]) readStream(at, sizes[s], records[s], data.streams[s]);
      at += sizes[s];
    }
    for (size_t k = 0; k < low_sizes.size(); ++k) {
      data.low_bits[k].assign(at, at + low_sizes[k]);
      at += low_sizes[k];
    }
    readHidden(VarintReader{at});
  }

  /// The values of one attribute of a stream.
  std::vector<int32_t>& values(uint32_t stream, uint32_t attribute = 0) {
    return data.streams[stream].attributes[attribute].values;
  }

  /// Writes the page and makes the tables state its size, hash and integers.
  void apply() {
    bake::PageBytes report;
    file_.pages[index_] = bake::writePage(data, &report);
    format::storeU32(file_.record(format::page::kId, index_) + format::page::kValuesAt,
                     static_cast<uint32_t>(data.valueCount()));
    file_.sealPages();
  }

  bake::PageData data;

 private:
  static void readStream(const uint8_t* bytes, uint32_t size, uint32_t records, bake::StreamData& stream) {
    std::vector<runtime::ColumnSpec> columns;
    std::vector<int32_t*> outs;
    for (auto& attribute : stream.attributes) {
      attribute.values.resize(size_t{records} * attribute.spec.components);
      columns.push_back({attribute.spec.components,
                         attribute.spec.is_unsigned ? runtime::ColumnKind::kUnsigned : runtime::ColumnKind::kSigned});
      outs.push_back(attribute.values.data());
    }
    std::vector<uint64_t> scratch((runtime::decodeScratchSize(records, size) + 7) / 8);
    if (runtime::decodeCloud(bytes, size, records, columns.data(), static_cast<uint32_t>(columns.size()), outs.data(),
                             {scratch.data(), scratch.size() * 8}) != runtime::CloudResult::kOk)
      throw std::runtime_error("a page editor needs a sound page");
  }

  void readHidden(VarintReader hidden) {
    using namespace format;
    for (uint32_t l = 0; l < file_.chunk(level::kId).record_count; ++l) {
      const uint8_t* level = file_.record(level::kId, l);
      if (loadU32(level + level::kPageEndAt) != index_ + 1) continue;
      std::vector<uint32_t> faces(loadU32(level + level::kHiddenCountAt));
      uint32_t face = 0;
      for (uint32_t& f : faces) f = face += hidden.next();
      data.hidden.push_back(faces);
    }
  }

  LitheFile& file_;
  uint32_t index_;
};

}  // namespace lithe::test
