// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "draco_cloud.h"

#include <draco/compression/config/compression_shared.h>
#include <draco/compression/expert_encode.h>
#include <draco/point_cloud/point_cloud.h>

#include <algorithm>
#include <string>

#include "lithe/bake/model.h"

namespace lithe::bake {

namespace {

constexpr int32_t kValueLimit = 1 << 18;
constexpr uint32_t kMaxComponents = 4;
constexpr size_t kMaxColumns = 127;

/// One speed for each precision that libdraco can choose, coarsest first.
constexpr int kSpeeds[] = {10, 6, 4, 2, 0};

[[noreturn]] void refuse(size_t column, const std::string& what) {
  throw Error("Draco cloud, column " + std::to_string(column) + ": " + what);
}

void checkColumn(const CloudColumn& column, uint32_t records, size_t index) {
  if (column.components == 0 || column.components > kMaxComponents) {
    refuse(index, std::to_string(column.components) + " components; use 1 to 4");
  }
  if (column.values.size() != size_t{records} * column.components) {
    refuse(index, std::to_string(column.values.size()) + " values for " + std::to_string(records) + " records of " +
                      std::to_string(column.components) + "; give one value per record and component");
  }
  const int32_t least = column.is_unsigned ? 0 : -kValueLimit;
  const int32_t most = column.is_unsigned ? 2 * kValueLimit - 1 : kValueLimit - 1;
  for (int32_t value : column.values) {
    if (value >= least && value <= most) continue;
    refuse(index, "the value " + std::to_string(value) + " is outside " + std::to_string(least) + ".." +
                      std::to_string(most) + "; split it into two columns");
  }
}

void checkColumns(const CloudColumns& columns) {
  if (columns.records == 0) throw Error("Draco cloud: no records; leave an empty cloud out");
  if (columns.columns.empty() || columns.columns.size() > kMaxColumns) {
    throw Error("Draco cloud: " + std::to_string(columns.columns.size()) + " columns; use 1 to 127");
  }
  for (size_t i = 0; i < columns.columns.size(); ++i) checkColumn(columns.columns[i], columns.records, i);
}

/// The attribute's values. Draco codes the zigzag code of a value: for an unsigned column hand it the number whose
/// zigzag code is the value, so that no symbol is skipped.
std::vector<int32_t> attributeValues(const CloudColumn& column) {
  std::vector<int32_t> values = column.values;
  if (!column.is_unsigned) return values;
  for (int32_t& value : values) value = (value >> 1) ^ -(value & 1);
  return values;
}

void addAttribute(draco::PointCloud& cloud, const CloudColumn& column, uint32_t records) {
  draco::GeometryAttribute layout;
  const int64_t stride = static_cast<int64_t>(sizeof(int32_t) * column.components);
  layout.Init(draco::GeometryAttribute::GENERIC, nullptr, static_cast<int8_t>(column.components), draco::DT_INT32,
              false, stride, 0);
  const int id = cloud.AddAttribute(layout, true, records);
  const std::vector<int32_t> values = attributeValues(column);
  cloud.attribute(id)->buffer()->Write(0, values.data(), values.size() * sizeof(int32_t));
}

std::vector<uint8_t> encodeAt(const draco::PointCloud& cloud, int speed, bool raw) {
  draco::ExpertEncoder encoder(cloud);
  encoder.SetEncodingMethod(draco::POINT_CLOUD_SEQUENTIAL_ENCODING);
  encoder.SetSpeedOptions(speed, speed);
  encoder.SetUseBuiltInAttributeCompression(!raw);
  for (int id = 0; id < cloud.num_attributes(); ++id) {
    const draco::Status set = encoder.SetAttributePredictionScheme(id, draco::PREDICTION_NONE);
    if (!set.ok()) throw Error("Draco cloud: libdraco refuses to leave prediction out: " + set.error_msg_string());
  }
  draco::EncoderBuffer buffer;
  const draco::Status status = encoder.EncodeToBuffer(&buffer);
  if (!status.ok()) throw Error("Draco cloud: libdraco failed: " + status.error_msg_string());
  return {buffer.data(), buffer.data() + buffer.size()};
}

/// Bitstream 2.3, without flags.
constexpr uint8_t kSequentialCloud[] = {
    'D', 'R', 'A', 'C', 'O', 2, 3, draco::POINT_CLOUD, draco::POINT_CLOUD_SEQUENTIAL_ENCODING, 0, 0};
constexpr uint8_t kOneDecoder = 1, kNotNormalised = 0;

}  // namespace

std::vector<uint8_t> encodeCloud(const CloudColumns& columns) {
  checkColumns(columns);
  draco::PointCloud cloud;
  cloud.set_num_points(columns.records);
  for (const CloudColumn& column : columns.columns) addAttribute(cloud, column, columns.records);
  if (columns.raw) return encodeAt(cloud, kSpeeds[0], true);
  std::vector<uint8_t> smallest;
  for (int speed : kSpeeds) {
    std::vector<uint8_t> bytes = encodeAt(cloud, speed, false);
    if (smallest.empty() || bytes.size() < smallest.size()) smallest = std::move(bytes);
  }
  return smallest;
}

std::vector<uint8_t> cloudBeginning(uint32_t records, const std::vector<uint8_t>& components) {
  std::vector<uint8_t> bytes(std::begin(kSequentialCloud), std::end(kSequentialCloud));
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<uint8_t>(records >> shift));
  const uint8_t count = static_cast<uint8_t>(components.size());
  bytes.push_back(kOneDecoder);
  bytes.push_back(count);
  for (uint8_t id = 0; id < count; ++id)
    for (const uint8_t byte :
         {uint8_t{draco::GeometryAttribute::GENERIC}, uint8_t{draco::DT_INT32}, components[id], kNotNormalised, id})
      bytes.push_back(byte);
  for (uint8_t id = 0; id < count; ++id) bytes.push_back(draco::SEQUENTIAL_ATTRIBUTE_ENCODER_INTEGER);
  return bytes;
}

std::vector<uint8_t> withoutBeginning(const std::vector<uint8_t>& cloud, const std::vector<uint8_t>& beginning) {
  const auto [rest, differs] = std::mismatch(cloud.begin(), cloud.end(), beginning.begin(), beginning.end());
  if (differs != beginning.end())
    throw Error("Draco cloud: this libdraco begins it otherwise than the format; build with libdraco 1.5");
  return {rest, cloud.end()};
}

}  // namespace lithe::bake
