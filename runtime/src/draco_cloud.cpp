// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "draco_cloud.h"

#include "draco_reader.h"
#include "draco_values.h"
#include "rans.h"

namespace lithe::runtime {

namespace {

constexpr uint8_t kNoPrediction = 0xfe;
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

/// A cloud whose columns are being read, and the column at whose stream it waits.
struct OpenCloud {
  const CloudJob* job = nullptr;  ///< null: free for the next one
  DracoReader reader;
  uint32_t column = 0;  ///< being read, or the next one
  bool waits = false;   ///< for the column's tags: nothing behind them can be read before
};

constexpr uint32_t kNobody = ~0u;

/// Who a lane's values are for.
struct LaneOwner {
  const CloudJob* job;
  uint32_t waiter;  ///< the open cloud whose tags they are, or kNobody
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
        if (!cloud.job) begin(cloud, (*next)++);
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
      const CloudResult result = finishTags(open_[owners_[k].waiter]);
      if (result != CloudResult::kOk) return result;
    }
    return CloudResult::kOk;
  }

  static void begin(OpenCloud& cloud, const CloudJob* job) {
    cloud.job = job;
    cloud.reader = DracoReader{job->bytes, job->size};
  }

  /// One step of an open cloud: its next column, or its end.
  CloudResult readOn(OpenCloud& cloud, uint32_t place) {
    if (cloud.column < cloud.job->column_count) return readColumn(cloud, place);
    const bool finished = cloud.reader.left() == 0;
    cloud = OpenCloud{};
    return finished ? CloudResult::kOk : CloudResult::kTrailing;
  }

  CloudResult readColumn(OpenCloud& cloud, uint32_t place) {
    DracoReader& reader = cloud.reader;
    const uint8_t prediction = reader.u8(), compressed = reader.u8();
    const uint8_t how = reader.u8();  // the scheme, or bytes per value
    if (!reader.ok) return CloudResult::kTruncated;
    if (prediction != kNoPrediction || compressed > 1) return CloudResult::kForeign;
    if (compressed == 0) return readPlain(cloud, how);
    if (how > kRaw) return CloudResult::kForeign;
    return how == kTagged ? openTags(cloud, place) : openSymbols(cloud);
  }

  static CloudResult readPlain(OpenCloud& cloud, uint8_t byte_count) {
    return finishColumn(cloud, readPlainValues(cloud.reader, byte_count, valueCount(cloud), outOf(cloud)));
  }

  CloudResult openTags(OpenCloud& cloud, uint32_t place) {
    const uint32_t records = cloud.job->records;
    int32_t* tags = outOf(cloud) + static_cast<size_t>(records) * (componentsOf(cloud) - 1);
    cloud.waits = true;
    return openStream(cloud, place, {kMinRansPrecision, kTagSymbols, records}, RansValue::kSymbol, records, tags);
  }

  CloudResult openSymbols(OpenCloud& cloud) {
    const uint32_t bit_length = cloud.reader.u8(), count = valueCount(cloud);
    if (bit_length == 0 || bit_length > kMaxRansBitLength) return refused(cloud.reader, CloudResult::kFrequencies);
    const RansValue value = isSigned(cloud) ? RansValue::kSigned : RansValue::kSymbol;
    int32_t* out = outOf(cloud);
    ++cloud.column;
    return openStream(cloud, kNobody, {ransPrecision(bit_length), kMaxRansSymbols, count}, value, count, out);
  }

  /// Reads a frequency table and puts its stream into a free lane; a stream that is too wide for lanes is decoded here.
  CloudResult openStream(OpenCloud& cloud, uint32_t waiter, const RansLimits& limits, RansValue value, uint32_t count,
                         int32_t* out) {
    DracoReader& reader = cloud.reader;
    const uint32_t row_count = readRansRows(reader, limits, rows_);
    if (row_count == 0) return refused(reader, CloudResult::kFrequencies);
    RansStream stream;
    if (!openRansStream(reader, limits.precision, &stream)) return refused(reader, CloudResult::kStream);
    if (!fitsNarrow(row_count, limits.precision)) {  // never tags: nobody waits
      buildWideTable(rows_, row_count, limits.precision, &work_->wide);
      return decodeWide(work_->wide, stream, value, count, out) ? CloudResult::kOk : CloudResult::kStream;
    }
    // The floor is low enough without a lead: the first bytes of the column, its table and its size lie before a
    // stream.
    static_assert(kRansLead <= 3, "a column's prediction, coding and scheme");
    const uint32_t k = freeLane();
    buildNarrowTable(rows_, row_count, value, &work_->narrow[k]);
    lanes_[k] = {&work_->narrow[k], limits.precision, reader.bytes - cloud.job->lead, stream, out, count};
    owners_[k] = {cloud.job, waiter};
    busy_ |= 1u << k;
    return CloudResult::kOk;
  }

  static CloudResult finishTags(OpenCloud& cloud) {
    cloud.waits = false;
    return finishColumn(cloud, readTaggedValues(cloud.reader, cloud.job->records, componentsOf(cloud), outOf(cloud)));
  }

  /// For values that do not come out of a lane, which are still symbols.
  static CloudResult finishColumn(OpenCloud& cloud, CloudResult result) {
    if (result == CloudResult::kOk && isSigned(cloud)) undoZigzag(valueCount(cloud), outOf(cloud));
    ++cloud.column;
    return result;
  }

  static CloudResult refused(const DracoReader& reader, CloudResult otherwise) {
    return reader.ok ? otherwise : CloudResult::kTruncated;
  }
  static int32_t* outOf(const OpenCloud& cloud) { return cloud.job->out[cloud.column]; }
  static uint32_t componentsOf(const OpenCloud& cloud) { return cloud.job->columns[cloud.column].components; }
  static uint32_t valueCount(const OpenCloud& cloud) { return cloud.job->records * componentsOf(cloud); }
  static bool isSigned(const OpenCloud& cloud) { return cloud.job->columns[cloud.column].kind == ColumnKind::kSigned; }
};

bool isSane(const CloudJob& cloud, const DecodeScratch& scratch) {
  if (reinterpret_cast<uintptr_t>(scratch.memory) % 8 != 0) return false;
  if (cloud.records == 0 || cloud.records > kMaxCloudRecords) return false;
  if (scratch.size < decodeScratchSize(cloud.records, cloud.size)) return false;
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

CloudResult decodeCloud(const uint8_t* bytes, size_t size, uint32_t records, const ColumnSpec* columns,
                        uint32_t column_count, int32_t* const* out, const DecodeScratch& scratch) {
  const CloudJob job = {bytes, size, 0, records, columns, column_count, out};
  return decodeClouds(&job, 1, scratch, nullptr);
}

}  // namespace lithe::runtime
