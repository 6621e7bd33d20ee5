// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "rans.h"

#include <string.h>

namespace lithe::runtime {

namespace {

constexpr uint32_t lowerBound(uint32_t precision) { return 4u << precision; }

/// A token whose low bits say how many bytes follow the first; zero is no frequency.
uint32_t readFrequency(DracoReader& reader, uint32_t first) {
  uint32_t frequency = first >> 2;
  const uint32_t more = first & 3;
  for (uint32_t k = 0; k < more; ++k) frequency |= static_cast<uint32_t>(reader.u8()) << (8 * k + 6);
  return frequency;
}

/// The two bytes that a stream gives next, the nearer one on top.
uint32_t twoBefore(const uint8_t* cursor) {
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
  uint16_t two;  // one load; compilers do not see it in the form below once its bytes are used apart
  memcpy(&two, cursor - 2, 2);
  return two;
#else
  return cursor[-2] | static_cast<uint32_t>(cursor[-1]) << 8;
#endif
}

/// One lane's running state, kept in registers by the kernels.
struct Stepper {
  const NarrowTable* table;
  const uint8_t* cursor;
  int32_t* out;
  uint32_t state;
  uint32_t precision;

  /// After one symbol x >= 4, so for precisions up to 15 two bytes always lift it to L again.
  template <uint32_t kPrecision>
  void step(uint32_t i) {
    const uint32_t bits = kPrecision ? kPrecision : precision;
    const uint32_t slot = state & ((1u << bits) - 1);
    const NarrowRow row = table->rows[table->lookup[slot]];
    out[i] = row.value;
    const uint32_t x = (row.slots & 0xffff) * (state >> bits) + slot - (row.slots >> 16);
    const uint32_t two = twoBefore(cursor);
    const bool one_more = x<lowerBound(bits), two_more = x<lowerBound(bits)>> 8;
    uint32_t next = one_more ? x << 8 | two >> 8 : x;
    next = two_more ? x << 16 | two : next;
    state = next;
    cursor -= one_more;
    cursor -= two_more;
  }
};

template <uint32_t kPrecision, uint32_t kLanes>
void runLanes(RansLane* const* lanes, uint32_t steps) {
  Stepper stepper[kLanes];
  for (uint32_t k = 0; k < kLanes; ++k) {
    const RansLane& lane = *lanes[k];
    stepper[k] = {lane.table, lane.stream.cursor, lane.out, lane.stream.state, lane.precision};
  }
  for (uint32_t i = 0; i < steps; ++i) {
    for (uint32_t k = 0; k < kLanes; ++k) stepper[k].template step<kPrecision>(i);
  }
  for (uint32_t k = 0; k < kLanes; ++k) {
    RansLane& lane = *lanes[k];
    lane.stream.cursor = stepper[k].cursor;
    lane.stream.state = stepper[k].state;
    lane.out += steps;
    lane.left -= steps;
  }
}

template <uint32_t kPrecision>
void runLanes(RansLane* const* lanes, uint32_t lane_count, uint32_t steps) {
  switch (lane_count) {
    case 1:
      return runLanes<kPrecision, 1>(lanes, steps);
    case 2:
      return runLanes<kPrecision, 2>(lanes, steps);
    case 3:
      return runLanes<kPrecision, 3>(lanes, steps);
    default:
      return runLanes<kPrecision, 4>(lanes, steps);
  }
}

}  // namespace

uint32_t readRansRows(DracoReader& reader, const RansLimits& limits, RansRow* rows) {
  const uint32_t symbol_count = reader.varint(), total = 1u << limits.precision;
  if (symbol_count == 0 || symbol_count > limits.max_symbols) return 0;
  uint32_t row_count = 0, start = 0;
  bool last_used = false;
  for (uint32_t symbol = 0; symbol < symbol_count; ++symbol) {
    const uint32_t token = reader.u8();
    if (!reader.ok) return 0;
    last_used = (token & 3) != 3;
    if (!last_used) {
      symbol += token >> 2;
      if (symbol >= symbol_count) return 0;
      continue;
    }
    const uint32_t frequency = readFrequency(reader, token);
    if (frequency == 0 || frequency > total - start || row_count == limits.max_rows) return 0;
    rows[row_count++] = {symbol, start};
    start += frequency;
  }
  if (!reader.ok || !last_used || start != total) return 0;
  rows[row_count] = {symbol_count, total};
  return row_count;
}

bool openRansStream(DracoReader& reader, uint32_t precision, RansStream* stream) {
  const uint32_t size = reader.varint();
  const uint8_t* begin = reader.here();
  reader.skip(size);
  if (!reader.ok || size == 0) return false;
  // The last byte's two top bits say in how many bytes the state was written.
  const uint32_t state_bytes = (begin[size - 1] >> 6) + 1u;
  if (state_bytes > size) return false;
  uint32_t state = begin[size - 1] & 0x3f;
  for (uint32_t k = 2; k <= state_bytes; ++k) state = state << 8 | begin[size - k];
  state += lowerBound(precision);
  *stream = {begin, begin + size - state_bytes, state};
  return state < static_cast<uint64_t>(lowerBound(precision)) << 8;
}

void buildWideTable(const RansRow* rows, uint32_t row_count, uint32_t precision, WideTable* table) {
  const uint32_t shift = precision > kWideLookupBits ? precision - kWideLookupBits : 0;
  table->rows = rows;
  table->precision = precision;
  uint32_t bucket = 0;
  for (uint32_t row = 0; row < row_count; ++row) {
    const uint32_t end = rows[row + 1].start;
    for (; bucket << shift < end; ++bucket) table->lookup[bucket] = row;
  }
}

bool decodeWide(const WideTable& table, RansStream stream, RansValue value, uint32_t count, int32_t* out) {
  const uint32_t precision = table.precision, lower = lowerBound(precision), mask = (1u << precision) - 1;
  const uint32_t shift = precision > kWideLookupBits ? precision - kWideLookupBits : 0;
  uint32_t state = stream.state;
  const uint8_t* cursor = stream.cursor;
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t slot = state & mask;
    const RansRow* row = table.rows + table.lookup[slot >> shift];
    while (row[1].start <= slot) ++row;
    out[i] = value == RansValue::kSigned ? fromZigzag(row->symbol) : static_cast<int32_t>(row->symbol);
    state = (row[1].start - row[0].start) * (state >> precision) + slot - row->start;
    while (state < lower && cursor != stream.begin) state = state << 8 | *--cursor;
  }
  // A stream that ran dry stays below L: without bytes the state never grows.
  return state == lower && cursor == stream.begin;
}

void buildNarrowTable(const RansRow* rows, uint32_t row_count, RansValue value, NarrowTable* table) {
  for (uint32_t row = 0; row < row_count; ++row) {
    const uint32_t start = rows[row].start, frequency = rows[row + 1].start - start;
    const uint32_t symbol = rows[row].symbol;
    const int32_t written = value == RansValue::kSigned ? fromZigzag(symbol) : static_cast<int32_t>(symbol);
    table->rows[row] = {frequency | start << 16, written};
    memset(table->lookup + start, static_cast<int>(row), frequency);
  }
}

void stepRansLanes(RansLane* const* lanes, uint32_t lane_count) {
  uint32_t steps = lanes[0]->left;
  bool common = true;
  for (uint32_t k = 0; k < lane_count; ++k) {
    // A step moves the cursor by two bytes at most: nothing before the floor is looked at.
    const size_t room = static_cast<size_t>(lanes[k]->stream.cursor - lanes[k]->floor) / 2;
    if (lanes[k]->left < steps) steps = lanes[k]->left;
    if (room < steps) steps = static_cast<uint32_t>(room);
    common = common && lanes[k]->precision == kMinRansPrecision;
  }
  if (common)
    runLanes<kMinRansPrecision>(lanes, lane_count, steps);
  else
    runLanes<0>(lanes, lane_count, steps);
}

bool ransIsSound(const RansLane& lane) {
  if (lane.left != 0) return lane.stream.cursor >= lane.stream.begin;
  return lane.stream.cursor == lane.stream.begin && lane.stream.state == lowerBound(lane.precision);
}

}  // namespace lithe::runtime
