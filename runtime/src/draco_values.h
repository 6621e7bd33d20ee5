// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// What becomes of a column's symbols: bit fields of tagged columns, plain bytes, and zigzag.
#pragma once

#include <stdint.h>

#include "draco_cloud.h"
#include "draco_reader.h"

namespace lithe::runtime {

/// Replaces tags by the values they announce. A record's tag is the bit count of each of its values; the fields follow
/// each other low bits first, and zero bits fill the last byte.
/// values  the records' tags in its last `records` entries; receives records * components symbols [the same count]
/// tags must be at most kCloudSymbolBits. Returns kOk, kTruncated, or kStream when the filling bits are not zero.
CloudResult readTaggedValues(DracoReader& reader, uint32_t records, uint32_t components, int32_t* values);

/// Reads symbols that are stored as byte_count bytes each. Returns kOk, kTruncated or kRange.
CloudResult readPlainValues(DracoReader& reader, uint32_t byte_count, uint64_t count, int32_t* values);

/// Symbols to signed values, in place.
void undoZigzag(uint64_t count, int32_t* values);

}  // namespace lithe::runtime
