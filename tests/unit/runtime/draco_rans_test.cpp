// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <memory>

#include "cloud_writer.h"
#include "random.h"
#include "rans.h"

namespace lithe::runtime {
namespace {

using test::Bytes;

constexpr RansLimits kLimits = {12, 1000, 100};

/// The rows of a table, empty when it is refused.
std::vector<RansRow> rowsOf(const Bytes& table, const RansLimits& limits = kLimits) {
  std::vector<RansRow> rows(limits.max_rows + 1);
  DracoReader reader{table.data(), table.size()};
  const uint32_t count = readRansRows(reader, limits, rows.data());
  rows.resize(count ? count + 1 : 0);
  return rows;
}

TEST(RansTable, ListsUsedSymbolsAndTheirSlots) {
  const std::vector<RansRow> rows = rowsOf(test::ransTable({4000, 0, 0, 95, 1}));
  ASSERT_EQ(4u, rows.size());
  EXPECT_EQ(0u, rows[0].symbol);
  EXPECT_EQ(3u, rows[1].symbol);
  EXPECT_EQ(4000u, rows[1].start);
  EXPECT_EQ(4u, rows[2].symbol);
  EXPECT_EQ(4095u, rows[2].start);
  EXPECT_EQ(4096u, rows[3].start);
}

TEST(RansTable, RunsOfUnusedSymbolsMayBeLong) {
  std::vector<uint32_t> frequencies(700);
  frequencies[699] = 4096;
  const std::vector<RansRow> rows = rowsOf(test::ransTable(frequencies));
  ASSERT_EQ(2u, rows.size());
  EXPECT_EQ(699u, rows[0].symbol);
}

TEST(RansTable, RefusesSumsThatAreNotThePrecision) {
  EXPECT_TRUE(rowsOf(test::ransTable({4000, 95})).empty());
  EXPECT_TRUE(rowsOf(test::ransTable({4000, 97})).empty());
  EXPECT_TRUE(rowsOf(test::ransTable({4096, 1})).empty());
  EXPECT_TRUE(rowsOf(test::ransTable({4096}), {13, 1000, 100}).empty());
  EXPECT_TRUE(rowsOf(test::ransTable({1u << 20, 1u << 20, 4096}), {20, 1000, 100}).empty());
}

TEST(RansTable, RefusesWhatIsBeyondTheLimits) {
  const Bytes table = test::ransTable({4000, 0, 96});
  EXPECT_FALSE(rowsOf(table, {12, 3, 2}).empty());
  EXPECT_TRUE(rowsOf(table, {12, 2, 2}).empty());  // symbols
  EXPECT_TRUE(rowsOf(table, {12, 3, 1}).empty());  // rows
}

TEST(RansTable, RefusesEmptyAlphabetsAndUnusedEnds) {
  EXPECT_TRUE(rowsOf({0}).empty());
  EXPECT_TRUE(rowsOf(test::ransTable({0, 0})).empty());
  EXPECT_TRUE(rowsOf(test::ransTable({4096, 0})).empty());
}

TEST(RansTable, RefusesARunThatLeavesTheAlphabet) {
  Bytes table = {3};
  test::append(table, {2 << 2 | 3});  // symbols 0..2, all
  EXPECT_TRUE(rowsOf(table).empty());
  table = {3};
  test::append(table, {3 << 2 | 3});  // symbols 0..3
  EXPECT_TRUE(rowsOf(table).empty());
}

TEST(RansTable, RefusesAFrequencyOfZero) {
  Bytes table = {2, 0};  // a token without further bytes: frequency 0
  test::append(table, {1, 64});
  EXPECT_TRUE(rowsOf(table).empty());
}

TEST(RansTable, RefusesEveryPrefix) {
  const Bytes table = test::ransTable({4000, 0, 0, 95, 1});
  for (size_t size = 0; size < table.size(); ++size) {
    EXPECT_TRUE(rowsOf(Bytes(table.begin(), table.begin() + static_cast<ptrdiff_t>(size))).empty()) << size;
  }
}

TEST(RansTable, RefusesSymbolCountsOfMoreThan32Bits) {
  Bytes table = {0x81, 0x80, 0x80, 0x80, 0x10};  // 2^32 + 1
  test::append(table, test::ransTable({4096}));
  EXPECT_TRUE(rowsOf(table).empty());
}

// ---- Streams
// ----------------------------------------------------------------------------------------------------------

/// A sized stream behind bytes that do not belong to it.
struct Streamed {
  std::vector<uint32_t> symbols, frequencies;
  uint32_t precision;
  std::vector<RansRow> rows;
  Bytes bytes;

  Streamed(std::vector<uint32_t> what, uint32_t bits) : symbols(std::move(what)), precision(bits) {
    frequencies = test::scaledFrequencies(symbols, precision);
    const uint32_t max_rows = static_cast<uint32_t>(frequencies.size());
    rows = rowsOf(test::ransTable(frequencies), {precision, max_rows, max_rows});
    bytes.assign(kRansLead, 0xee);
    test::append(bytes, test::sized(test::ransStream(symbols, frequencies, precision)));
  }

  uint32_t rowCount() const { return static_cast<uint32_t>(rows.size()) - 1; }
  uint32_t count() const { return static_cast<uint32_t>(symbols.size()); }
};

bool open(const Streamed& streamed, RansStream* stream) {
  DracoReader reader{streamed.bytes.data(), streamed.bytes.size(), kRansLead};
  return openRansStream(reader, streamed.precision, stream);
}

bool decodeWide(const Streamed& streamed, std::vector<int32_t>* out, RansValue value = RansValue::kSymbol) {
  const auto table = std::make_unique<WideTable>();
  buildWideTable(streamed.rows.data(), streamed.rowCount(), streamed.precision, table.get());
  RansStream stream;
  out->assign(streamed.symbols.size(), -7);
  return open(streamed, &stream) && decodeWide(*table, stream, value, streamed.count(), out->data());
}

bool decodeNarrow(const Streamed& streamed, std::vector<int32_t>* out, RansValue value = RansValue::kSymbol) {
  const auto table = std::make_unique<NarrowTable>();
  buildNarrowTable(streamed.rows.data(), streamed.rowCount(), value, table.get());
  out->assign(streamed.symbols.size(), -7);
  RansLane lane;
  lane.table = table.get();
  lane.precision = streamed.precision;
  lane.floor = streamed.bytes.data();
  lane.out = out->data();
  lane.left = streamed.count();
  if (!open(streamed, &lane.stream)) return false;
  RansLane* lanes[] = {&lane};
  while (lane.left) {
    stepRansLanes(lanes, 1);
    if (!ransIsSound(lane)) return false;
  }
  return true;
}

std::vector<uint32_t> skewedSymbols(test::Random& random, uint32_t count, uint32_t alphabet) {
  std::vector<uint32_t> symbols(count);
  for (uint32_t& symbol : symbols) symbol = random.octave(alphabet) - 1;
  return symbols;
}

std::vector<int32_t> asSigned(const std::vector<uint32_t>& symbols) {
  std::vector<int32_t> values;
  for (uint32_t symbol : symbols) values.push_back(fromZigzag(symbol));
  return values;
}

TEST(RansStream, WideReadsEveryPrecision) {
  test::Random random(3);
  for (uint32_t precision = kMinRansPrecision; precision <= kMaxRansPrecision; ++precision) {
    const Streamed streamed(skewedSymbols(random, 3000, 2000), precision);
    std::vector<int32_t> out;
    ASSERT_TRUE(decodeWide(streamed, &out)) << precision;
    EXPECT_EQ(std::vector<int32_t>(streamed.symbols.begin(), streamed.symbols.end()), out);
    ASSERT_TRUE(decodeWide(streamed, &out, RansValue::kSigned));
    EXPECT_EQ(asSigned(streamed.symbols), out);
  }
}

/// The fast decoder does what the specification does.
TEST(RansStream, NarrowAgreesWithWide) {
  test::Random random(4);
  for (uint32_t round = 0; round < 200; ++round) {
    const uint32_t precision = 12 + random.below(4);
    const Streamed streamed(skewedSymbols(random, random.octave(2000), random.octave(256)), precision);
    std::vector<int32_t> wide, narrow;
    ASSERT_TRUE(decodeWide(streamed, &wide, RansValue::kSigned));
    ASSERT_TRUE(decodeNarrow(streamed, &narrow, RansValue::kSigned));
    EXPECT_EQ(wide, narrow);
  }
}

TEST(RansStream, OneSymbolTakesNoBytes) {
  for (uint32_t precision : {12u, 15u}) {
    const Streamed streamed(std::vector<uint32_t>(5000, 3), precision);
    EXPECT_EQ(kRansLead + 2, streamed.bytes.size());
    std::vector<int32_t> out;
    EXPECT_TRUE(decodeNarrow(streamed, &out));
    EXPECT_EQ(std::vector<int32_t>(5000, 3), out);
    EXPECT_TRUE(decodeWide(streamed, &out));
    EXPECT_EQ(std::vector<int32_t>(5000, 3), out);
  }
}

/// Either decoder notices a stream that has other symbols than it was written with.
TEST(RansStream, EveryOtherCountIsRefused) {
  test::Random random(5);
  Streamed streamed(skewedSymbols(random, 300, 100), 12);
  const std::vector<uint32_t> symbols = streamed.symbols;
  std::vector<int32_t> out;
  for (size_t count : {1u, 150u, 299u, 301u, 5000u}) {
    streamed.symbols = symbols;
    streamed.symbols.resize(count);
    EXPECT_FALSE(decodeNarrow(streamed, &out)) << count;
    EXPECT_FALSE(decodeWide(streamed, &out)) << count;
  }
}

/// A byte that is missing or left over at the stream's beginning, which is read last.
TEST(RansStream, EveryOtherLengthIsRefused) {
  test::Random random(6);
  Streamed streamed(skewedSymbols(random, 100, 100), 12);
  const Bytes stream = test::ransStream(streamed.symbols, streamed.frequencies, 12);
  std::vector<int32_t> out;
  for (bool longer : {false, true}) {
    Bytes changed = stream;
    if (longer)
      changed.insert(changed.begin(), 0x55);
    else
      changed.erase(changed.begin());
    streamed.bytes.resize(kRansLead);
    test::append(streamed.bytes, test::sized(changed));
    EXPECT_FALSE(decodeNarrow(streamed, &out));
    EXPECT_FALSE(decodeWide(streamed, &out));
  }
}

/// The last bytes of a stream whose every symbol takes nearly two: a lane that read on would find more of it.
TEST(RansStream, NothingBeforeTheFloorIsLookedAt) {
  const std::vector<uint32_t> symbols(100, 1), frequencies = {32767, 1};
  const Bytes bytes = test::sized(test::ransStream(symbols, frequencies, 15));
  const std::vector<RansRow> rows = rowsOf(test::ransTable(frequencies), {15, 2, 2});
  const auto table = std::make_unique<NarrowTable>();
  buildNarrowTable(rows.data(), 2, RansValue::kSymbol, table.get());
  DracoReader reader{bytes.data(), bytes.size()};
  RansStream whole;
  ASSERT_TRUE(openRansStream(reader, 15, &whole));
  for (ptrdiff_t size = kRansLead; size < whole.cursor - whole.begin; ++size) {
    const Bytes rest(whole.cursor - size, whole.cursor);
    std::vector<int32_t> out(symbols.size());
    RansLane lane{table.get(), 15, rest.data(), whole, out.data(), static_cast<uint32_t>(symbols.size())};
    lane.stream.begin = rest.data() + kRansLead;
    lane.stream.cursor = rest.data() + size;
    RansLane* lanes[] = {&lane};
    while (ransIsSound(lane)) stepRansLanes(lanes, 1);
    EXPECT_GE(lane.stream.cursor, lane.floor) << size;
    EXPECT_GT(lane.left, 0u) << size;
  }
}

TEST(RansStream, InitialStatesAreChecked) {
  const auto opens = [](const Bytes& stream, uint32_t precision) {
    const Bytes bytes = test::sized(stream);
    DracoReader reader{bytes.data(), bytes.size()};
    RansStream opened;
    return openRansStream(reader, precision, &opened);
  };
  EXPECT_FALSE(opens({}, 12));
  EXPECT_TRUE(opens({0x3f}, 12));
  EXPECT_FALSE(opens({0x7f}, 12));              // says two bytes
  EXPECT_FALSE(opens({0xff, 0xff, 0xff}, 20));  // says four
  EXPECT_TRUE(opens({0xff, 0xbf, 0xbf}, 12));   // with L just below 256 L = 2^22
  EXPECT_FALSE(opens({0x00, 0xc0, 0xbf}, 12));  // 256 L
  EXPECT_FALSE(opens({0x00, 0x00, 0x40, 0xc0}, 12));
  EXPECT_TRUE(opens({0x00, 0x00, 0x40, 0xc0}, 20));
  EXPECT_FALSE(opens({0xff, 0xff, 0xff, 0xff}, 20));
  const Bytes cut = {3, 0x00, 0x00};
  DracoReader reader{cut.data(), cut.size()};
  RansStream opened;
  EXPECT_FALSE(openRansStream(reader, 12, &opened));
}

TEST(RansValues, ZigzagAlternatesBetweenTheSigns) {
  const uint32_t symbols[] = {0, 1, 2, 3, (1u << 19) - 2, (1u << 19) - 1};
  const int32_t values[] = {0, -1, 1, -2, (1 << 18) - 1, -(1 << 18)};
  for (size_t i = 0; i < std::size(symbols); ++i) EXPECT_EQ(values[i], fromZigzag(symbols[i]));
}

}  // namespace
}  // namespace lithe::runtime
