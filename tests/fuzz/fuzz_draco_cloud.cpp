// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Any bytes as a Draco cloud behind its beginning. Input: records - 1 (one byte) | columns - 1 (one byte, low three
/// bits) | one byte per column (components - 1 in two bits, unsigned in the next) | the cloud.
#include <cstdlib>
#include <memory>
#include <vector>

#include "draco_cloud.h"

namespace {

using namespace lithe::runtime;

void requireRange(const std::vector<int32_t>& values, ColumnKind kind) {
  const int32_t least = kind == ColumnKind::kSigned ? -(1 << (kCloudSymbolBits - 1)) : 0;
  for (int32_t value : values) {
    if (value < least || value - least >= 1 << kCloudSymbolBits) std::abort();
  }
}

/// `cloud` lies in memory of exactly its size, so that a sanitizer sees a look before it, too.
void decode(const std::vector<uint8_t>& cloud, uint32_t records, const std::vector<ColumnSpec>& columns) {
  std::vector<std::vector<int32_t>> values;
  std::vector<int32_t*> outs;
  for (const ColumnSpec& column : columns) values.emplace_back(records * column.components);
  for (std::vector<int32_t>& column : values) outs.push_back(column.data());
  const size_t scratch_words = (decodeScratchSize(records, cloud.size()) + 7) / 8;
  const std::unique_ptr<uint64_t[]> scratch(
      new uint64_t[scratch_words]);  // not cleared: that would take most of the time
  const CloudResult result =
      decodeCloud(cloud.data(), cloud.size(), records, columns.data(), static_cast<uint32_t>(columns.size()),
                  outs.data(), {scratch.get(), scratch_words * 8});
  if (result == CloudResult::kArgument) std::abort();
  if (result != CloudResult::kOk) return;
  for (size_t i = 0; i < columns.size(); ++i) requireRange(values[i], columns[i].kind);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size < 2) return 0;
  const uint32_t records = data[0] + 1u, column_count = (data[1] & 7) + 1u;
  if (size < 2 + column_count) return 0;
  std::vector<ColumnSpec> columns;
  for (uint32_t i = 0; i < column_count; ++i) {
    const uint8_t byte = data[2 + i];
    columns.push_back({static_cast<uint8_t>((byte & 3) + 1), byte & 4 ? ColumnKind::kUnsigned : ColumnKind::kSigned});
  }
  decode({data + 2 + column_count, data + size}, records, columns);
  return 0;
}
