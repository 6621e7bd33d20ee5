// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The entropy coder of Draco's integer attributes: range ANS (Duda 2013, "Asymmetric numeral systems") with one state,
/// renormalised by bytes, read from the end of the stream to its beginning.
///
/// With precision P, a state x in [L, 256 L), L = 4 * 2^P, and frequencies f(s) that sum to 2^P, one symbol is
///
///     slot = x mod 2^P;  s: start(s) <= slot < start(s) + f(s);  x = f(s) * (x div 2^P) + slot - start(s);
///     while x < L: x = 256 x + next byte
///
/// A writer begins with x = L, so a sound stream ends with x = L and no byte left: every decoder here checks that.
///
/// There are two decoders. WideTable takes every alphabet and every precision, one stream at a time, and is the
/// specification. NarrowTable takes up to 256 used symbols and 15 bits, which nearly every column has; up to four
/// streams are then decoded in turns, because a stream alone spends its time waiting for its own last step.
///
/// Nothing here allocates. Bytes are hostile: no stream makes these functions touch memory outside what they are given.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "draco_reader.h"

namespace lithe::runtime {

inline constexpr uint32_t kMinRansPrecision = 12;
inline constexpr uint32_t kMaxRansPrecision = 20;
inline constexpr uint32_t kMaxRansBitLength = 18;
inline constexpr uint32_t kMaxRansSymbols = 1u << kMaxRansBitLength;

/// The precision that goes with a stream's stated bit length (1..18): 1.5 bits per bit, within 12..20.
constexpr uint32_t ransPrecision(uint32_t bit_length) {
  const uint32_t precision = 3 * bit_length / 2;
  return precision < kMinRansPrecision   ? kMinRansPrecision
         : precision > kMaxRansPrecision ? kMaxRansPrecision
                                         : precision;
}

constexpr int32_t fromZigzag(uint32_t symbol) {
  return static_cast<int32_t>(symbol >> 1) ^ -static_cast<int32_t>(symbol & 1);
}

/// What a decoder writes for a symbol: the symbol itself, or the signed number that it is the zigzag code of.
enum class RansValue : uint8_t { kSymbol, kSigned };

/// One used symbol and the first of its slots. A list of n rows is followed by one with start = 2^P.
struct RansRow {
  uint32_t symbol;
  uint32_t start;
};

/// Bounds of a frequency table, known before it is read.
struct RansLimits {
  uint32_t precision;    ///< 12..20
  uint32_t max_symbols;  ///< symbols are below this
  uint32_t max_rows;     ///< used symbols at most: a writer only lists symbols that occur
};

/// Reads a frequency table: varint symbol count, then one token per used symbol or per run of up to 64 unused ones.
/// rows       receives the used symbols in ascending order and the closing row [max_rows + 1]
/// returns the number of used symbols; 0 when the table is malformed or truncated, goes beyond the limits, ends with an
///         unused symbol, or does not sum to 2^precision. Time is linear in the bytes read.
uint32_t readRansRows(DracoReader& reader, const RansLimits& limits, RansRow* rows);

/// The bytes of one stream and where its decoder stands.
struct RansStream {
  const uint8_t* begin = nullptr;
  const uint8_t* cursor = nullptr;  ///< one past the next byte; falls to begin
  uint32_t state = 0;
};

/// Reads a stream's size (varint) and bytes, and its initial state from their end. False when that is not sound.
bool openRansStream(DracoReader& reader, uint32_t precision, RansStream* stream);

// ---- Any alphabet, one stream --------------------------------------------------------------------------------------

inline constexpr uint32_t kWideLookupBits = 15;

/// rows with an index on the leading 15 bits of the slot: exact up to precision 15, at most 32 rows to step over
/// beyond.
struct WideTable {
  const RansRow* rows;  ///< borrowed
  uint32_t precision;
  uint32_t lookup[1u << kWideLookupBits];
};

void buildWideTable(const RansRow* rows, uint32_t row_count, uint32_t precision, WideTable* table);

/// Decodes the whole stream. out [count]. False when the stream does not end where a writer begins.
bool decodeWide(const WideTable& table, RansStream stream, RansValue value, uint32_t count, int32_t* out);

// ---- Small alphabets, up to four streams in turns
// --------------------------------------------------------------------

inline constexpr uint32_t kMaxNarrowRows = 256;
inline constexpr uint32_t kMaxNarrowPrecision = 15;
inline constexpr uint32_t kRansLanes = 4;
/// Readable bytes that must lie before every stream: the decoder looks at what is before its cursor.
inline constexpr uint32_t kRansLead = 2;

struct NarrowRow {
  uint32_t slots;  ///< frequency, and the first slot shifted by 16: one load for both
  int32_t value;
};

struct NarrowTable {
  NarrowRow rows[kMaxNarrowRows];
  uint8_t lookup[1u << kMaxNarrowPrecision];  ///< slot -> row; the first 2^precision are used
};

constexpr bool fitsNarrow(uint32_t row_count, uint32_t precision) {
  return row_count <= kMaxNarrowRows && precision <= kMaxNarrowPrecision;
}

void buildNarrowTable(const RansRow* rows, uint32_t row_count, RansValue value, NarrowTable* table);

/// One stream being decoded.
struct RansLane {
  const NarrowTable* table = nullptr;  ///< borrowed
  uint32_t precision = 0;
  const uint8_t* floor = nullptr;  ///< first readable byte, at least kRansLead before stream.begin
  RansStream stream;
  int32_t* out = nullptr;  ///< where the next value goes
  uint32_t left = 0;       ///< values still to decode
};

/// Decodes the same number of values from every lane: as many as the lane with the fewest has left, less where a floor
/// is near, but at least one.
/// lane_count 1..4; each lane has values left
void stepRansLanes(RansLane* const* lanes, uint32_t lane_count);

/// To be asked after every step: false when the lane's stream turned out too short (its values are garbage then), or
/// has given all its values and did not end where a writer begins.
bool ransIsSound(const RansLane& lane);

}  // namespace lithe::runtime
