// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "draco_cloud.h"

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

/// A used symbol occurs, and its frequency takes a byte at least.
uint64_t rowCapacity(uint32_t records, size_t bytes) {
  uint64_t rows = static_cast<uint64_t>(records) * kMaxCloudComponents;
  if (rows > bytes) rows = bytes;
  return (rows < kMaxRansSymbols ? rows : kMaxRansSymbols) + 1;
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

/// A cloud whose columns are being read, and the column at whose stream it waits.
struct OpenCloud {
  const CloudJob* job = nullptr;  ///< null: free for the next one
  DracoReader reader;
  uint32_t column = 0;                       ///< being read, or the next one
  bool waits = false;                        ///< for a stream: nothing behind it can be read before
  bool tagged = false, differences = false;  ///< what becomes of the column's symbols
};

constexpr uint32_t kNobody = ~0u;

/// Who a lane's values are for.
struct LaneOwner {
  const CloudJob* job;
  uint32_t waiter;  ///< the open cloud that waits for them, or kNobody
};

/// Decodes clouds side by side. Streams lie in lanes and are decoded in turns. What follows a stream of tags is only
/// found once they are decoded, so a cloud waits there; that several clouds are open keeps the lanes busy meanwhile.
class Decoder {
 public:
  explicit Decoder(const DecodeScratch& scratch)
      : work_(static_cast<Workspace*>(scratch.memory)), rows_(reinterpret_cast<RansRow*>(work_ + 1)) {}

  CloudResult run(const CloudJob* jobs, uint32_t job_count) {
    const CloudJob* next = jobs;
    const CloudJob* const end = jobs + job_count;
    for (;;) {
      CloudResult result = fillLanes(&next, end);
      if (result != CloudResult::kOk || busy_ == 0) return result;
      result = stepLanes();
      if (result != CloudResult::kOk) return result;
    }
  }

  /// The cloud that the last failure was found in.
  const CloudJob* failed() const { return failed_; }

 private:
  static constexpr uint32_t kAllLanes = (1u << kRansLanes) - 1;

  Workspace* work_;
  RansRow* rows_;
  RansLane lanes_[kRansLanes];
  LaneOwner owners_[kRansLanes];
  uint32_t busy_ = 0;  ///< bit k: lane k holds a stream
  OpenCloud open_[kRansLanes];
  const CloudJob* failed_ = nullptr;

  uint32_t freeLane() const {
    uint32_t k = 0;
    while (busy_ >> k & 1) ++k;
    return k;
  }

  /// Reads on, in open clouds and then in new ones, until every lane has a stream or every cloud waits.
  CloudResult fillLanes(const CloudJob** next, const CloudJob* end) {
    for (uint32_t k = 0; k < kRansLanes; ++k) {
      OpenCloud& cloud = open_[k];
      while (busy_ != kAllLanes && !cloud.waits) {
        if (!cloud.job && *next == end) break;
        if (!cloud.job)
          cloud.job = failed_ = (*next)++;
        else
          failed_ = cloud.job;
        const CloudResult result = readOn(cloud, k);
        if (result != CloudResult::kOk) return result;
      }
    }
    return CloudResult::kOk;
  }

  CloudResult stepLanes() {
    RansLane* active[kRansLanes];
    uint32_t count = 0;
    for (uint32_t k = 0; k < kRansLanes; ++k) {
      if (busy_ >> k & 1) active[count++] = &lanes_[k];
    }
    stepRansLanes(active, count);
    for (uint32_t k = 0; k < kRansLanes; ++k) {
      if (!(busy_ >> k & 1)) continue;
      failed_ = owners_[k].job;
      if (!ransIsSound(lanes_[k])) return CloudResult::kStream;
      if (lanes_[k].left != 0) continue;
      busy_ &= ~(1u << k);
      if (owners_[k].waiter == kNobody) continue;
      const CloudResult result = finishColumn(open_[owners_[k].waiter]);
      if (result != CloudResult::kOk) return result;
    }
    return CloudResult::kOk;
  }

  /// One step of an open cloud: its beginning, its next column, or its end.
  CloudResult readOn(OpenCloud& cloud, uint32_t place) {
    const CloudJob& job = *cloud.job;
    if (!cloud.reader.bytes) return begin(cloud);
    if (cloud.column < job.column_count) return readColumn(cloud, place);
    const bool finished = cloud.reader.left() == 0;
    cloud = OpenCloud{};
    return finished ? CloudResult::kOk : CloudResult::kTrailing;
  }

  static CloudResult begin(OpenCloud& cloud) {
    const CloudJob& job = *cloud.job;
    cloud.reader = DracoReader{job.bytes, job.size};
    const CloudResult result = readHeader(cloud.reader);
    if (result != CloudResult::kOk) return result;
    return readLayout(cloud.reader, job.expected_records, job.columns, job.column_count);
  }

  CloudResult readColumn(OpenCloud& cloud, uint32_t place) {
    DracoReader& reader = cloud.reader;
    const uint8_t prediction = reader.u8();
    cloud.differences = prediction != kNoPrediction;
    if (cloud.differences && (prediction != kDifference || reader.u8() != kWrap))
      return refused(reader, CloudResult::kForeign);
    const uint8_t compressed = reader.u8();
    const uint8_t how = reader.u8();  // the scheme, or bytes per value
    if (!reader.ok) return CloudResult::kTruncated;
    if (compressed == 0) return readPlain(cloud, how);
    if (compressed != 1 || how > kRaw) return CloudResult::kForeign;
    return how == kTagged ? openTags(cloud, place) : openSymbols(cloud, place);
  }

  CloudResult readPlain(OpenCloud& cloud, uint8_t byte_count) {
    const CloudResult result = readPlainValues(cloud.reader, byte_count, valueCount(cloud), outOf(cloud));
    if (result != CloudResult::kOk) return result;
    if (becomesSigned(cloud)) undoZigzag(valueCount(cloud), outOf(cloud));
    return finishValues(cloud);
  }

  CloudResult openTags(OpenCloud& cloud, uint32_t place) {
    const uint32_t records = cloud.job->expected_records;
    int32_t* tags = outOf(cloud) + static_cast<size_t>(records) * (cloud.job->columns[cloud.column].components - 1);
    cloud.tagged = cloud.waits = true;
    return openStream(cloud, place, {kMinRansPrecision, kTagSymbols, records}, RansValue::kSymbol, records, tags);
  }

  CloudResult openSymbols(OpenCloud& cloud, uint32_t place) {
    const uint32_t bit_length = cloud.reader.u8(), count = valueCount(cloud);
    if (bit_length == 0 || bit_length > kMaxRansBitLength) return refused(cloud.reader, CloudResult::kFrequencies);
    const RansValue value = becomesSigned(cloud) ? RansValue::kSigned : RansValue::kSymbol;
    cloud.tagged = false;
    cloud.waits = cloud.differences;
    return openStream(cloud, place, {ransPrecision(bit_length), kMaxRansSymbols, count}, value, count, outOf(cloud));
  }

  /// Reads a frequency table and puts its stream into a free lane; a stream that is too wide for lanes is decoded here.
  CloudResult openStream(OpenCloud& cloud, uint32_t place, const RansLimits& limits, RansValue value, uint32_t count,
                         int32_t* out) {
    DracoReader& reader = cloud.reader;
    const uint32_t row_count = readRansRows(reader, limits, rows_);
    if (row_count == 0) return refused(reader, CloudResult::kFrequencies);
    RansStream stream;
    if (!openRansStream(reader, limits.precision, &stream)) return refused(reader, CloudResult::kStream);
    if (!fitsNarrow(row_count, limits.precision)) {
      buildWideTable(rows_, row_count, limits.precision, &work_->wide);
      if (!decodeWide(work_->wide, stream, value, count, out)) return CloudResult::kStream;
      return finishColumn(cloud);
    }
    // The stream lies behind the cloud's header, which is longer than the kRansLead bytes that a lane may look back.
    const uint32_t k = freeLane();
    buildNarrowTable(rows_, row_count, value, &work_->narrow[k]);
    lanes_[k] = {&work_->narrow[k], limits.precision, reader.bytes, stream, out, count};
    owners_[k] = {cloud.job, cloud.waits ? place : kNobody};
    busy_ |= 1u << k;
    if (!cloud.waits) ++cloud.column;
    return CloudResult::kOk;
  }

  /// What is to be done once a column's stream is decoded.
  static CloudResult finishColumn(OpenCloud& cloud) {
    cloud.waits = false;
    if (cloud.tagged) {
      const CloudJob& job = *cloud.job;
      const uint32_t components = job.columns[cloud.column].components;
      const CloudResult result = readTaggedValues(cloud.reader, job.expected_records, components, outOf(cloud));
      if (result != CloudResult::kOk) return result;
      if (becomesSigned(cloud)) undoZigzag(valueCount(cloud), outOf(cloud));
    }
    return finishValues(cloud);
  }

  static CloudResult finishValues(OpenCloud& cloud) {
    if (cloud.differences) {
      const CloudResult result = addDifferences(cloud);
      if (result != CloudResult::kOk) return result;
    }
    ++cloud.column;
    return CloudResult::kOk;
  }

  static CloudResult addDifferences(OpenCloud& cloud) {
    DracoReader& reader = cloud.reader;
    const int32_t minimum = static_cast<int32_t>(reader.u32()), maximum = static_cast<int32_t>(reader.u32());
    if (!reader.ok) return CloudResult::kTruncated;
    const ColumnSpec& column = cloud.job->columns[cloud.column];
    int32_t* values = outOf(cloud);
    const CloudResult result = sumDifferences(cloud.job->expected_records, column.components, minimum, maximum, values);
    if (result == CloudResult::kOk && column.kind == ColumnKind::kUnsigned) applyZigzag(valueCount(cloud), values);
    return result;
  }

  static CloudResult refused(const DracoReader& reader, CloudResult otherwise) {
    return reader.ok ? otherwise : CloudResult::kTruncated;
  }
  static int32_t* outOf(const OpenCloud& cloud) { return cloud.job->out[cloud.column]; }
  static uint32_t valueCount(const OpenCloud& cloud) {
    return cloud.job->expected_records * cloud.job->columns[cloud.column].components;
  }
  /// Differences are signed whatever their sums are.
  static bool becomesSigned(const OpenCloud& cloud) {
    return cloud.differences || cloud.job->columns[cloud.column].kind == ColumnKind::kSigned;
  }
};

bool isSane(const CloudJob& cloud, const DecodeScratch& scratch) {
  if (reinterpret_cast<uintptr_t>(scratch.memory) % 8 != 0) return false;
  if (cloud.expected_records == 0 || cloud.expected_records > kMaxCloudRecords) return false;
  if (scratch.size < decodeScratchSize(cloud.expected_records, cloud.size)) return false;
  if (cloud.column_count == 0 || cloud.column_count > kMaxCloudColumns) return false;
  for (uint32_t i = 0; i < cloud.column_count; ++i) {
    const uint32_t components = cloud.columns[i].components;
    if (components == 0 || components > kMaxCloudComponents) return false;
  }
  return true;
}

}  // namespace

size_t decodeScratchSize(uint32_t max_records, size_t max_bytes) {
  return sizeof(Workspace) + static_cast<size_t>(rowCapacity(max_records, max_bytes)) * sizeof(RansRow);
}

CloudResult decodeClouds(const CloudJob* jobs, uint32_t job_count, const DecodeScratch& scratch, uint32_t* failed) {
  for (uint32_t i = 0; i < job_count; ++i) {
    if (isSane(jobs[i], scratch)) continue;
    if (failed) *failed = i;
    return CloudResult::kArgument;
  }
  Decoder decoder(scratch);
  const CloudResult result = decoder.run(jobs, job_count);
  if (failed && result != CloudResult::kOk) *failed = static_cast<uint32_t>(decoder.failed() - jobs);
  return result;
}

CloudResult decodeCloud(const uint8_t* bytes, size_t size, uint32_t expected_records, const ColumnSpec* columns,
                        uint32_t column_count, int32_t* const* out, const DecodeScratch& scratch) {
  const CloudJob job = {bytes, size, expected_records, columns, column_count, out};
  return decodeClouds(&job, 1, scratch, nullptr);
}

}  // namespace lithe::runtime
