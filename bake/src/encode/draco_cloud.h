// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Integer columns -> a Draco point cloud of the subset that the runtime reads: version 2.3, sequential encoding, every
/// column one GENERIC INT32 attribute, no prediction. The order of the records is kept.
///
/// Every such cloud begins with bytes that its reader knows already; a page leaves them out.
#pragma once

#include <cstdint>
#include <vector>

namespace lithe::bake {

/// One attribute. Signed values lie in [-2^18, 2^18), unsigned ones in [0, 2^19).
struct CloudColumn {
  uint32_t components = 1;      ///< 1..4. Components share one frequency table: columns that differ are better apart
  bool is_unsigned = false;     ///< coded without a place for negative numbers; the reader must be told
  std::vector<int32_t> values;  ///< records * components, record by record
};

struct CloudColumns {
  uint32_t records = 0;              ///< > 0: an empty cloud has no encoding that Draco itself can read
  std::vector<CloudColumn> columns;  ///< 1..127
  bool raw = false;                  ///< store bytes (as many per value as a column's largest needs), no entropy coding
};

/// The smallest cloud that libdraco makes of the columns: its speeds only choose the precision of the frequencies, so
/// all that differ are tried; of equal ones the coarsest precision, which decodes fastest, is kept. Same input, same
/// bytes. Throws Error for an empty cloud, a wrong count, or a value out of range.
std::vector<uint8_t> encodeCloud(const CloudColumns& columns);

/// The beginning of a cloud (docs/format.md, "The cloud of a stream"): what it says of its records and columns.
/// components  of each column: 1..127 of them
std::vector<uint8_t> cloudBeginning(uint32_t records, const std::vector<uint8_t>& components);

/// The rest of a cloud behind its beginning: a stream of a page. Throws Error when the cloud begins otherwise, since
/// another libdraco made it.
std::vector<uint8_t> withoutBeginning(const std::vector<uint8_t>& cloud, const std::vector<uint8_t>& beginning);

}  // namespace lithe::bake
