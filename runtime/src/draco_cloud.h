// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Reads the subset of Draco that a page is made of: point clouds of integer attributes without prediction; both symbol
/// schemes, all precisions, and values stored as plain bytes. Everything else is refused.
///
/// A cloud comes without its beginning (docs/format.md, "The cloud of a stream"): what it would say the caller knows.
/// No input makes it touch memory outside its arguments; time is linear in the bytes plus the values, whatever the
/// bytes.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace lithe::runtime {

enum class CloudResult : uint8_t {
  kOk = 0,
  kTruncated,    ///< the bytes end before the cloud does
  kForeign,      ///< not of the subset: a column is predicted, or coded in an unknown way
  kFrequencies,  ///< a frequency table is malformed
  kStream,       ///< a stream of symbols does not end where its writer began
  kRange,        ///< a value beyond the limits below
  kTrailing,     ///< bytes are left over
  kArgument,     ///< a caller's mistake: counts beyond the limits below, scratch memory too small or not aligned
};

/// Signed values lie in [-2^18, 2^18), unsigned ones in [0, 2^19): the range that libdraco encodes at a sane cost.
inline constexpr uint32_t kCloudSymbolBits = 19;
inline constexpr uint32_t kMaxCloudComponents = 4;
inline constexpr uint32_t kMaxCloudColumns = 127;
inline constexpr uint32_t kMaxCloudRecords = 1u << 24;

enum class ColumnKind : uint8_t {
  kSigned,    ///< values are the attribute's
  kUnsigned,  ///< values are the zigzag codes of the attribute's: small alphabets without holes
};

/// What one attribute is.
struct ColumnSpec {
  uint8_t components;  ///< 1..4
  ColumnKind kind;
};

/// One cloud, what it is, and where its values go. Everything is borrowed.
struct CloudJob {
  const uint8_t* bytes;  ///< the cloud without its beginning, and nothing after it
  size_t size;
  size_t lead;       ///< bytes before `bytes` that may be looked at too, whatever they are: with more it is faster
  uint32_t records;  ///< 1..kMaxCloudRecords
  const ColumnSpec* columns;  ///< the attributes, in order [column_count]
  uint32_t column_count;      ///< 1..kMaxCloudColumns
  int32_t* const* out;        ///< per column, receives records * components values, record by record
};

/// Memory that a decode may use and leaves in any state.
struct DecodeScratch {
  void* memory = nullptr;  ///< aligned to 8; decodes that follow each other may share it, threads may not
  size_t size = 0;         ///< at least decodeScratchSize()
};

/// The scratch that a decode needs when no cloud has more than max_records records or max_bytes bytes: 264 KiB, and 32
/// bytes per record or 8 per byte, whichever is less, at most 2 MiB.
size_t decodeScratchSize(uint32_t max_records, size_t max_bytes);

/// Decodes several clouds at once: faster than one after the other, since the streams of a cloud's last columns are
/// decoded in turns with the next cloud's first.
/// failed    receives the index of the cloud that was refused; may be null
/// returns kOk, or what is wrong with a cloud; the contents of every out are unspecified then.
/// Never allocates. Any number of threads, each with its own scratch and outs.
CloudResult decodeClouds(const CloudJob* jobs, uint32_t job_count, const DecodeScratch& scratch, uint32_t* failed);

/// Decodes one cloud, looking at nothing before it.
CloudResult decodeCloud(const uint8_t* bytes, size_t size, uint32_t records, const ColumnSpec* columns,
                        uint32_t column_count, int32_t* const* out, const DecodeScratch& scratch);

}  // namespace lithe::runtime
