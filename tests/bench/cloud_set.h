// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Draco clouds that are ready to be decoded again and again, by the runtime's reader and by libdraco.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "draco_cloud.h"

namespace lithe::bench {

/// Clouds that the runtime decodes in one call, as it does with those of a page. Not copied: jobs point into it.
class CloudSet {
 public:
  CloudSet() = default;
  CloudSet(const CloudSet&) = delete;
  CloudSet& operator=(const CloudSet&) = delete;

  /// Copies the bytes of a stream: a cloud without its beginning. `columns`: what its attributes are.
  void add(const uint8_t* bytes, size_t size, uint32_t records, const std::vector<runtime::ColumnSpec>& columns);

  /// Decode every cloud; false when one is refused.
  bool decodeWithLithe();
  bool decodeWithDraco();

  size_t cloudCount() const { return clouds_.size(); }
  uint64_t recordCount() const { return records_; }
  uint64_t valueCount() const { return values_; }
  uint64_t byteCount() const { return bytes_; }  ///< of the streams
  /// Decodes with both and compares every value.
  bool bothAgree();

 private:
  struct Cloud {
    std::vector<uint8_t> bytes;  ///< with its beginning, for libdraco
    std::vector<runtime::ColumnSpec> columns;
    std::vector<std::vector<int32_t>> values;  ///< per column
    std::vector<int32_t*> outs;
  };
  std::deque<Cloud> clouds_;  // addresses stay
  std::vector<runtime::CloudJob> jobs_;
  std::vector<uint64_t> scratch_;
  uint64_t records_ = 0, values_ = 0, bytes_ = 0;
};

}  // namespace lithe::bench
