// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// A page taken apart with libdraco and docs/format.md, section 3: nothing of the runtime's reader or the bake's
/// writer.
#pragma once

#include <draco/compression/decode.h>
#include <draco/point_cloud/point_cloud.h>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "cloud_writer.h"
#include "lithe/format/page.h"

namespace lithe::test {

/// Columns of a Draco cloud, record by record, as Draco gives them (unsigned columns are zigzagged).
inline std::vector<std::vector<int32_t>> columnsOfCloud(const std::vector<uint8_t>& bytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::Decoder decoder;
  auto result = decoder.DecodePointCloudFromBuffer(&buffer);
  if (!result.ok()) throw std::runtime_error("libdraco: " + result.status().error_msg_string());
  if (buffer.remaining_size() != 0) throw std::runtime_error("bytes after the cloud");
  const std::unique_ptr<draco::PointCloud> cloud = std::move(result).value();
  std::vector<std::vector<int32_t>> columns(static_cast<size_t>(cloud->num_attributes()));
  for (int id = 0; id < cloud->num_attributes(); ++id) {
    const draco::PointAttribute* attribute = cloud->attribute(id);
    if (attribute->attribute_type() != draco::GeometryAttribute::GENERIC || attribute->data_type() != draco::DT_INT32 ||
        attribute->normalized())
      throw std::runtime_error("an attribute is not a plain GENERIC INT32");
    for (uint32_t point = 0; point < cloud->num_points(); ++point) {
      int32_t record[4];
      attribute->GetMappedValue(draco::PointIndex(point), record);
      columns[static_cast<size_t>(id)].insert(columns[static_cast<size_t>(id)].end(), record,
                                              record + attribute->num_components());
    }
  }
  return columns;
}

/// The number that an unsigned attribute's stored value stands for.
inline int32_t unsignedOf(int32_t stored) {
  return static_cast<int32_t>((static_cast<uint32_t>(stored) << 1) ^ static_cast<uint32_t>(stored >> 31));
}

struct ReadPage {
  uint8_t kind = 0;
  std::vector<uint8_t> parameters;
  std::vector<uint32_t> records;                          ///< per stream
  std::vector<std::vector<std::vector<int32_t>>> values;  ///< per stream and attribute; none for an empty stream
  std::array<std::vector<uint8_t>, format::kLowBitsKinds> low_bits;
  std::vector<std::vector<uint32_t>> hidden;  ///< per level that ends with the page
};

/// @param hidden_counts  of the levels that end with the page, from the level table
/// @throws std::runtime_error where the bytes are not as the specification says, or bytes are left
inline ReadPage readPage(const std::vector<uint8_t>& bytes, format::WedgeAttributes has,
                         const std::vector<uint32_t>& hidden_counts) {
  size_t at = 0;
  const auto byte = [&] {
    if (at >= bytes.size()) throw std::runtime_error("the page is cut short");
    return bytes[at++];
  };
  const auto varint = [&] {
    uint32_t value = 0;
    for (uint32_t shift = 0;; shift += 7) {
      const uint8_t next = byte();
      value |= uint32_t{next & 0x7fu} << shift;
      if (next & 0x80) continue;
      if (next == 0 && shift > 0) throw std::runtime_error("a varint longer than it need be");
      return value;
    }
  };
  ReadPage page;
  page.kind = byte();
  for (uint32_t i = 0; i < format::kParameterBytes; ++i) page.parameters.push_back(byte());
  const uint32_t streams =
      page.kind == format::kBasePage ? uint32_t{format::kBaseStreamCount} : uint32_t{format::kSplitStreamCount};
  std::vector<uint32_t> sizes(streams, 0);
  for (uint32_t s = 0; s < streams; ++s) {
    page.records.push_back(varint());
    if (page.records[s]) sizes[s] = varint();
  }
  std::array<uint32_t, format::kLowBitsKinds> low_sizes;
  for (uint32_t& size : low_sizes) size = varint();
  page.values.resize(streams);
  for (uint32_t s = 0; s < streams; ++s) {
    if (page.records[s] == 0) continue;
    if (sizes[s] > bytes.size() - at) throw std::runtime_error("a stream is cut short");
    format::StreamAttribute specs[format::kMaxStreamAttributes];
    const uint32_t count = page.kind == format::kBasePage ? format::baseStreamAttributes(s, has, specs)
                                                          : format::splitStreamAttributes(s, has, specs);
    std::vector<uint8_t> components;
    for (uint32_t a = 0; a < count; ++a) components.push_back(specs[a].components);
    Bytes cloud = cloudBeginning(page.records[s], components);
    append(cloud, {bytes.data() + at, bytes.data() + at + sizes[s]});
    page.values[s] = columnsOfCloud(cloud);
    at += sizes[s];
    for (uint32_t a = 0; a < count; ++a) {
      if (!specs[a].is_unsigned) continue;
      for (int32_t& value : page.values[s][a]) value = unsignedOf(value);
    }
  }
  for (size_t k = 0; k < low_sizes.size(); ++k)
    for (uint32_t i = 0; i < low_sizes[k]; ++i) page.low_bits[k].push_back(byte());
  for (uint32_t count : hidden_counts) {
    page.hidden.emplace_back();
    for (uint32_t i = 0, face = 0; i < count; ++i) page.hidden.back().push_back(face += varint());
  }
  if (at != bytes.size()) throw std::runtime_error("bytes after the page");
  return page;
}

/// Fields of low bits, first field in the lowest bits of the first byte.
class BitReader {
 public:
  explicit BitReader(const std::vector<uint8_t>& bytes) : bytes_(bytes) {}

  uint32_t read(int32_t bits) {
    uint32_t value = 0;
    for (int32_t i = 0; i < bits; ++i, ++count_) value |= uint32_t{bytes_.at(count_ / 8) >> (count_ % 8) & 1u} << i;
    return value;
  }
  /// Whether all bytes are used and what is left of the last one is zero.
  bool atEnd() {
    if ((count_ + 7) / 8 != bytes_.size()) return false;
    return count_ % 8 == 0 || read(static_cast<int32_t>(8 - count_ % 8)) == 0;
  }

 private:
  const std::vector<uint8_t>& bytes_;
  size_t count_ = 0;
};

}  // namespace lithe::test
