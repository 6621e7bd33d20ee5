// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "cloud_set.h"

#include <benchmark/benchmark.h>
#include <draco/compression/decode.h>
#include <draco/point_cloud/point_cloud.h>

#include <algorithm>
#include <memory>

#include "encode/draco_cloud.h"

namespace lithe::bench {
namespace {

std::unique_ptr<draco::PointCloud> decodeCloudWithDraco(const std::vector<uint8_t>& bytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodePointCloudFromBuffer(&buffer);
  return decoded.ok() ? std::move(decoded).value() : nullptr;
}

std::vector<uint8_t> componentsOf(const std::vector<runtime::ColumnSpec>& columns) {
  std::vector<uint8_t> components;
  for (const runtime::ColumnSpec& column : columns) components.push_back(column.components);
  return components;
}

int32_t zigzag(int32_t value) { return static_cast<int32_t>((static_cast<uint32_t>(value) << 1) ^ (value >> 31)); }

}  // namespace

void CloudSet::add(const uint8_t* bytes, size_t size, uint32_t records,
                   const std::vector<runtime::ColumnSpec>& columns) {
  Cloud& cloud = clouds_.emplace_back();
  cloud.bytes = bake::cloudBeginning(records, componentsOf(columns));
  const size_t beginning = cloud.bytes.size();
  cloud.bytes.insert(cloud.bytes.end(), bytes, bytes + size);
  cloud.columns = columns;
  for (const runtime::ColumnSpec& column : columns) {
    cloud.values.emplace_back(size_t{records} * column.components);
    values_ += cloud.values.back().size();
  }
  for (std::vector<int32_t>& values : cloud.values) cloud.outs.push_back(values.data());
  jobs_.push_back({cloud.bytes.data() + beginning, size, beginning, records, cloud.columns.data(),
                   static_cast<uint32_t>(columns.size()), cloud.outs.data()});
  records_ += records;
  bytes_ += size;
  scratch_.resize(std::max(scratch_.size(), runtime::decodeScratchSize(records, size) / 8 + 1));
}

bool CloudSet::decodeWithLithe() {
  const runtime::DecodeScratch scratch = {scratch_.data(), scratch_.size() * 8};
  return jobs_.empty() || runtime::decodeClouds(jobs_.data(), static_cast<uint32_t>(jobs_.size()), scratch, nullptr) ==
                              runtime::CloudResult::kOk;
}

bool CloudSet::decodeWithDraco() {
  for (const Cloud& cloud : clouds_) {
    const std::unique_ptr<draco::PointCloud> decoded = decodeCloudWithDraco(cloud.bytes);
    if (!decoded) return false;
    benchmark::DoNotOptimize(decoded->attribute(0)->buffer()->data());
  }
  return true;
}

bool CloudSet::bothAgree() {
  if (!decodeWithLithe()) return false;
  for (const Cloud& cloud : clouds_) {
    const std::unique_ptr<draco::PointCloud> decoded = decodeCloudWithDraco(cloud.bytes);
    if (!decoded || static_cast<size_t>(decoded->num_attributes()) != cloud.columns.size()) return false;
    for (size_t c = 0; c < cloud.columns.size(); ++c) {
      const uint32_t components = cloud.columns[c].components;
      for (uint32_t i = 0; i < decoded->num_points(); ++i) {
        int32_t values[runtime::kMaxCloudComponents];
        decoded->attribute(static_cast<int>(c))->GetMappedValue(draco::PointIndex(i), values);
        for (uint32_t k = 0; k < components; ++k) {
          const bool coded = cloud.columns[c].kind == runtime::ColumnKind::kUnsigned;
          if ((coded ? zigzag(values[k]) : values[k]) != cloud.values[c][size_t{i} * components + k]) return false;
        }
      }
    }
  }
  return true;
}

}  // namespace lithe::bench
