// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "draco_cloud.h"

#include <string.h>

#include "draco_reader.h"
#include "draco_values.h"
#include "rans.h"

namespace lithe::runtime {

namespace {

constexpr uint8_t kMagic[5] = {'D', 'R', 'A', 'C', 'O'};
constexpr uint8_t kVersionMajor = 2, kVersionMinor = 3;
constexpr uint8_t kPointCloud = 0, kSequential = 0;
constexpr uint8_t kGeneric = 4, kInt32 = 5, kIntegerCoder = 1;
constexpr uint8_t kNoPrediction = 0xfe, kDifference = 0, kWrap = 1;
constexpr uint8_t kTagged = 0, kRaw = 1;

/// Tags say 0..19 bits.
constexpr uint32_t kTagSymbols = kCloudSymbolBits + 1;

/// The scratch, laid out. rows comes last: its length depends on the records.
struct Workspace {
  NarrowTable narrow[kRansLanes];
  WideTable wide;
};

uint64_t rowCapacity(uint32_t records) {
  const uint64_t values = static_cast<uint64_t>(records) * kMaxCloudComponents;
  return (values < kMaxRansSymbols ? values : kMaxRansSymbols) + 1;
}

CloudResult readHeader(DracoReader& reader) {
  bool known = true;
  for (uint8_t letter : kMagic) known = known & (reader.u8() == letter);
  known = known & (reader.u8() == kVersionMajor);
  known = known & (reader.u8() == kVersionMinor);
  known = known & (reader.u8() == kPointCloud);
  known = known & (reader.u8() == kSequential);
  known = known & (reader.u8() == 0);  // no flags: no metadata
  known = known & (reader.u8() == 0);
  if (!reader.ok) return CloudResult::kTruncated;
  return known ? CloudResult::kOk : CloudResult::kForeign;
}

CloudResult readAttribute(DracoReader& reader, uint32_t components, uint32_t id) {
  bool known = reader.u8() == kGeneric;
  known = known & (reader.u8() == kInt32);
  const bool same = reader.u8() == components;
  known = known & (reader.u8() == 0);  // not normalised
  const bool in_order = reader.varint() == id;
  if (!reader.ok) return CloudResult::kTruncated;
  if (!known) return CloudResult::kForeign;
  return same && in_order ? CloudResult::kOk : CloudResult::kLayout;
}

CloudResult readLayout(DracoReader& reader, uint32_t records, const ColumnSpec* columns, uint32_t column_count) {
  const bool same_records = reader.u32() == records;
  const bool one_encoder = reader.u8() == 1;
  const bool same_columns = reader.varint() == column_count;
  if (!reader.ok) return CloudResult::kTruncated;
  if (!one_encoder) return CloudResult::kForeign;
  if (!same_records || !same_columns) return CloudResult::kLayout;
  for (uint32_t i = 0; i < column_count; ++i) {
    const CloudResult result = readAttribute(reader, columns[i].components, i);
    if (result != CloudResult::kOk) return result;
  }
  for (uint32_t i = 0; i < column_count; ++i) {
    const bool integer_coder = reader.u8() == kIntegerCoder;
    if (!reader.ok) return CloudResult::kTruncated;
    if (!integer_coder) return CloudResult::kForeign;
  }
  return CloudResult::kOk;
}

/// Clouds being decoded. Streams whose place is known wait in lanes, so that up to four are decoded in turns; a tagged
/// column must be finished at once, because its length is only known from its tags, and takes the others along.
struct Decoder {
  Workspace* work;
  RansRow* rows;
  RansLane lanes[kRansLanes];
  uint32_t lane_job[kRansLanes];  ///< whose stream a lane holds
  uint32_t busy = 0;              ///< bit k: lane k holds a stream

  uint32_t job = 0;  ///< the cloud being read
  DracoReader reader;
  uint32_t records = 0;
  uint32_t failed_job = 0;  ///< whose stream was unsound, when a step says so

  uint32_t freeLane() const {
    uint32_t k = 0;
    while (busy >> k & 1) ++k;
    return k;
  }

  /// Decodes from all busy lanes until one is done, and closes those that are.
  bool stepOnce() {
    RansLane* active[kRansLanes];
    uint32_t count = 0;
    for (uint32_t k = 0; k < kRansLanes; ++k) {
      if (busy >> k & 1) active[count++] = &lanes[k];
    }
    stepRansLanes(active, count);
    for (uint32_t k = 0; k < kRansLanes; ++k) {
      if (!(busy >> k & 1)) continue;
      if (!ransIsSound(lanes[k])) {
        failed_job = lane_job[k];
        return false;
      }
      if (lanes[k].left == 0) busy &= ~(1u << k);
    }
    return true;
  }

  bool finish(uint32_t lane_mask) {
    while (busy & lane_mask) {
      if (!stepOnce()) return false;
    }
    return true;
  }

  bool makeRoom() {
    while (busy == (1u << kRansLanes) - 1) {
      if (!stepOnce()) return false;
    }
    return true;
  }

  CloudResult refused(CloudResult otherwise) const { return reader.ok ? otherwise : CloudResult::kTruncated; }

  /// Reads a frequency table and takes up its stream. lane: receives the mask of the lane that the stream waits in, or
  /// zero when it has been decoded already.
  CloudResult openStream(const RansLimits& limits, RansValue value, uint32_t count, int32_t* out, uint32_t* lane) {
    const uint32_t row_count = readRansRows(reader, limits, rows);
    if (row_count == 0) return refused(CloudResult::kFrequencies);
    RansStream stream;
    if (!openRansStream(reader, limits.precision, &stream)) return refused(CloudResult::kStream);
    *lane = 0;
    if (!fitsNarrow(row_count, limits.precision)) {
      buildWideTable(rows, row_count, limits.precision, &work->wide);
      return decodeWide(work->wide, stream, value, count, out) ? CloudResult::kOk : CloudResult::kStream;
    }
    if (!makeRoom()) return CloudResult::kStream;
    const uint32_t k = freeLane();
    buildNarrowTable(rows, row_count, value, &work->narrow[k]);
    lanes[k] = {&work->narrow[k], limits.precision, reader.bytes, stream, out, count};
    lane_job[k] = job;
    *lane = 1u << k;
    busy |= *lane;
    return CloudResult::kOk;
  }

  CloudResult readTagged(uint32_t components, int32_t* out) {
    uint32_t lane = 0;
    int32_t* tags = out + static_cast<size_t>(records) * (components - 1);
    const RansLimits limits = {kMinRansPrecision, kTagSymbols, records};
    const CloudResult result = openStream(limits, RansValue::kSymbol, records, tags, &lane);
    if (result != CloudResult::kOk) return result;
    if (!finish(lane)) return CloudResult::kStream;
    return readTaggedValues(reader, records, components, out);
  }

  CloudResult readRaw(RansValue value, uint32_t count, int32_t* out, uint32_t* lane) {
    const uint32_t bit_length = reader.u8();
    if (bit_length == 0 || bit_length > kMaxRansBitLength) return refused(CloudResult::kFrequencies);
    const RansLimits limits = {ransPrecision(bit_length), kMaxRansSymbols, count};
    return openStream(limits, value, count, out, lane);
  }

  /// One column's symbols, or signed values where `value` asks for them.
  CloudResult readSymbols(const ColumnSpec& column, RansValue value, int32_t* out, uint32_t* lane) {
    const uint32_t count = records * column.components;
    const uint8_t compressed = reader.u8();
    const uint8_t how = reader.u8();  // the scheme, or bytes per value
    if (!reader.ok) return CloudResult::kTruncated;
    if (compressed == 1 && how == kRaw) return readRaw(value, count, out, lane);
    CloudResult result = CloudResult::kForeign;
    if (compressed == 0)
      result = readPlainValues(reader, how, count, out);
    else if (compressed == 1 && how == kTagged)
      result = readTagged(column.components, out);
    if (result == CloudResult::kOk && value == RansValue::kSigned) undoZigzag(count, out);
    return result;
  }

  CloudResult readColumn(const ColumnSpec& column, int32_t* out) {
    uint32_t lane = 0;
    const uint8_t prediction = reader.u8();
    if (prediction == kNoPrediction) {
      const RansValue value = column.kind == ColumnKind::kSigned ? RansValue::kSigned : RansValue::kSymbol;
      return readSymbols(column, value, out, &lane);
    }
    const uint8_t transform = reader.u8();
    if (prediction != kDifference || transform != kWrap) return refused(CloudResult::kForeign);
    const CloudResult result = readSymbols(column, RansValue::kSigned, out, &lane);
    if (result != CloudResult::kOk) return result;
    if (!finish(lane)) return CloudResult::kStream;
    return addDifferences(column, out);
  }

  CloudResult addDifferences(const ColumnSpec& column, int32_t* out) {
    const int32_t minimum = static_cast<int32_t>(reader.u32()), maximum = static_cast<int32_t>(reader.u32());
    if (!reader.ok) return CloudResult::kTruncated;
    const CloudResult result = sumDifferences(records, column.components, minimum, maximum, out);
    if (result == CloudResult::kOk && column.kind == ColumnKind::kUnsigned) {
      applyZigzag(static_cast<uint64_t>(records) * column.components, out);
    }
    return result;
  }

  CloudResult readCloud(const CloudJob& cloud, uint32_t index) {
    job = index;
    records = cloud.expected_records;
    reader = DracoReader{cloud.bytes, cloud.size};
    CloudResult result = readHeader(reader);
    if (result == CloudResult::kOk) result = readLayout(reader, records, cloud.columns, cloud.column_count);
    for (uint32_t i = 0; i < cloud.column_count && result == CloudResult::kOk; ++i) {
      result = readColumn(cloud.columns[i], cloud.out[i]);
    }
    if (result != CloudResult::kOk) return result;
    return reader.left() == 0 ? CloudResult::kOk : CloudResult::kTrailing;
  }
};

bool isSane(const CloudJob& cloud, const DecodeScratch& scratch) {
  if (reinterpret_cast<uintptr_t>(scratch.memory) % 8 != 0) return false;
  if (cloud.expected_records == 0 || cloud.expected_records > kMaxCloudRecords) return false;
  if (scratch.size < decodeScratchSize(cloud.expected_records)) return false;
  if (cloud.column_count == 0 || cloud.column_count > kMaxCloudColumns) return false;
  for (uint32_t i = 0; i < cloud.column_count; ++i) {
    const uint32_t components = cloud.columns[i].components;
    if (components == 0 || components > kMaxCloudComponents) return false;
  }
  return true;
}

}  // namespace

size_t decodeScratchSize(uint32_t max_records) {
  return sizeof(Workspace) + static_cast<size_t>(rowCapacity(max_records)) * sizeof(RansRow);
}

CloudResult decodeClouds(const CloudJob* jobs, uint32_t job_count, const DecodeScratch& scratch, uint32_t* failed) {
  Decoder decoder;
  decoder.work = static_cast<Workspace*>(scratch.memory);
  decoder.rows = reinterpret_cast<RansRow*>(decoder.work + 1);
  CloudResult result = CloudResult::kOk;
  for (uint32_t i = 0; i < job_count && result == CloudResult::kOk; ++i) {
    decoder.failed_job = i;
    result = isSane(jobs[i], scratch) ? decoder.readCloud(jobs[i], i) : CloudResult::kArgument;
  }
  if (result == CloudResult::kOk && !decoder.finish(~0u)) result = CloudResult::kStream;
  if (failed && result != CloudResult::kOk) *failed = decoder.failed_job;
  return result;
}

CloudResult decodeCloud(const uint8_t* bytes, size_t size, uint32_t expected_records, const ColumnSpec* columns,
                        uint32_t column_count, int32_t* const* out, const DecodeScratch& scratch) {
  const CloudJob job = {bytes, size, expected_records, columns, column_count, out};
  return decodeClouds(&job, 1, scratch, nullptr);
}

}  // namespace lithe::runtime
