// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "draco_cloud.h"

#include <gtest/gtest.h>

#include "cloud_writer.h"
#include "random.h"
#include "rans.h"

namespace lithe::runtime {
namespace {

using test::Bytes;
using test::Random;

/// Decodes into memory of exactly the stated size, so that a sanitizer sees one step too far.
struct Decoded {
  std::vector<std::vector<int32_t>> values;
  std::vector<uint64_t> scratch;

  CloudResult decode(const Bytes& bytes, uint32_t records, const std::vector<ColumnSpec>& columns,
                     const Bytes& lead = {}) {
    Bytes exact;
    exact.reserve(lead.size() + bytes.size());
    test::append(exact, lead);
    test::append(exact, bytes);
    std::vector<int32_t*> outs;
    values.resize(columns.size());
    for (size_t i = 0; i < columns.size(); ++i) {
      values[i].assign(size_t{records} * columns[i].components, -5);
      outs.push_back(values[i].data());
    }
    scratch.resize((decodeScratchSize(records, bytes.size()) + 7) / 8);
    const CloudJob job = {exact.data() + lead.size(),
                          bytes.size(),
                          lead.size(),
                          records,
                          columns.data(),
                          static_cast<uint32_t>(columns.size()),
                          outs.data()};
    return decodeClouds(&job, 1, {scratch.data(), scratch.size() * 8}, nullptr);
  }
};

constexpr ColumnSpec kOneSigned = {1, ColumnKind::kSigned};
constexpr ColumnSpec kOneUnsigned = {1, ColumnKind::kUnsigned};

Bytes joined(std::initializer_list<Bytes> parts) {
  Bytes bytes;
  for (const Bytes& part : parts) test::append(bytes, part);
  return bytes;
}

std::vector<int32_t> asInts(const std::vector<uint32_t>& symbols) { return {symbols.begin(), symbols.end()}; }

std::vector<uint32_t> someSymbols(Random& random, uint32_t count, uint32_t alphabet) {
  std::vector<uint32_t> symbols(count);
  for (uint32_t& symbol : symbols) symbol = random.octave(alphabet) - 1;
  return symbols;
}

// ---- What is read
// ----------------------------------------------------------------------------------------------------

TEST(DracoCloud, ReadsEverySchemeInOneCloud) {
  Random random(1);
  const std::vector<uint32_t> raw = someSymbols(random, 2 * 60, 40), tagged = someSymbols(random, 3 * 60, 1 << 19),
                              wide = someSymbols(random, 60, 1 << 18);
  Bytes plain = {0xfe, 0, 1};
  for (uint32_t i = 0; i < 60; ++i) plain.push_back(static_cast<uint8_t>(i));
  const Bytes bytes =
      joined({test::rawColumn(raw, 6), test::taggedColumn(tagged, 3), test::rawColumn(wide, 14), plain});
  Decoded decoded;
  ASSERT_EQ(
      CloudResult::kOk,
      decoded.decode(bytes, 60, {{2, ColumnKind::kUnsigned}, {3, ColumnKind::kUnsigned}, kOneUnsigned, kOneSigned}));
  EXPECT_EQ(asInts(raw), decoded.values[0]);
  EXPECT_EQ(asInts(tagged), decoded.values[1]);
  EXPECT_EQ(asInts(wide), decoded.values[2]);
  for (int32_t i = 0; i < 60; ++i) EXPECT_EQ(i % 2 ? -(i + 1) / 2 : i / 2, decoded.values[3][static_cast<size_t>(i)]);
}

/// More columns than lanes, of different lengths, so that lanes are freed and taken again.
TEST(DracoCloud, ColumnsOutnumberLanes) {
  Random random(2);
  const std::vector<uint8_t> components = {4, 1, 2, 1, 3, 1, 4, 4, 1};
  Bytes bytes;
  std::vector<ColumnSpec> columns;
  std::vector<std::vector<uint32_t>> symbols;
  for (uint8_t count : components) {
    symbols.push_back(someSymbols(random, 500u * count, random.octave(250)));
    columns.push_back({count, ColumnKind::kUnsigned});
    test::append(bytes, test::rawColumn(symbols.back(), static_cast<uint8_t>(1 + random.below(10))));
  }
  Decoded decoded;
  ASSERT_EQ(CloudResult::kOk, decoded.decode(bytes, 500, columns));
  for (size_t c = 0; c < columns.size(); ++c) EXPECT_EQ(asInts(symbols[c]), decoded.values[c]) << c;
}

TEST(DracoCloud, SeveralCloudsAtOnceAndWhichOneIsWrong) {
  Random random(3);
  const uint32_t records[3] = {100, 7, 300};
  std::vector<uint32_t> symbols[3];
  Bytes bytes[3];
  std::vector<int32_t> values[3];
  int32_t* outs[3];
  CloudJob jobs[3];
  for (int i = 0; i < 3; ++i) {
    symbols[i] = someSymbols(random, records[i], 90);
    bytes[i] = test::rawColumn(symbols[i], 7);
    values[i].resize(records[i]);
    outs[i] = values[i].data();
    jobs[i] = {bytes[i].data(), bytes[i].size(), 0, records[i], &kOneUnsigned, 1, &outs[i]};
  }
  std::vector<uint64_t> memory(decodeScratchSize(300, SIZE_MAX) / 8 + 1);
  const DecodeScratch scratch = {memory.data(), memory.size() * 8};
  ASSERT_EQ(CloudResult::kOk, decodeClouds(jobs, 3, scratch, nullptr));
  for (int i = 0; i < 3; ++i) EXPECT_EQ(asInts(symbols[i]), values[i]);
  for (uint32_t wrong = 0; wrong < 3; ++wrong) {
    bytes[wrong].back() ^= 0x15;  // the initial state
    uint32_t failed = 99;
    EXPECT_EQ(CloudResult::kStream, decodeClouds(jobs, 3, scratch, &failed));
    EXPECT_EQ(wrong, failed);
    bytes[wrong].back() ^= 0x15;
  }
}

// ---- What is refused
// --------------------------------------------------------------------------------------------------

struct SmallCloud {
  Bytes bytes;
  std::vector<ColumnSpec> columns = {kOneUnsigned, {2, ColumnKind::kSigned}};
  static constexpr uint32_t kRecords = 20;

  SmallCloud() {
    Random random(4);
    bytes =
        joined({test::rawColumn(someSymbols(random, 20, 30), 5), test::taggedColumn(someSymbols(random, 40, 5000), 2)});
  }

  CloudResult decode() const { return Decoded().decode(bytes, kRecords, columns); }
  CloudResult decodeWith(size_t at, uint8_t value) const {
    SmallCloud changed = *this;
    changed.bytes[at] = value;
    return changed.decode();
  }
};

TEST(DracoCloud, AnotherLayoutIsRefused) {
  const SmallCloud cloud;
  ASSERT_EQ(CloudResult::kOk, cloud.decode());
  EXPECT_EQ(CloudResult::kStream, Decoded().decode(cloud.bytes, 21, cloud.columns));
  EXPECT_EQ(CloudResult::kTrailing, Decoded().decode(cloud.bytes, 20, {kOneUnsigned}));
  EXPECT_EQ(CloudResult::kTruncated, Decoded().decode(cloud.bytes, 20, {kOneUnsigned, cloud.columns[1], kOneSigned}));
}

TEST(DracoCloud, UnknownPredictionsTransformsAndSchemesAreRefused) {
  const SmallCloud cloud;
  for (uint32_t value = 0; value < 256; ++value) {
    const uint8_t byte = static_cast<uint8_t>(value);
    EXPECT_EQ(byte == 0xfe, cloud.decodeWith(0, byte) == CloudResult::kOk) << value;
    EXPECT_EQ(byte == 1, cloud.decodeWith(1, byte) == CloudResult::kOk) << value;
    EXPECT_EQ(byte > 1, cloud.decodeWith(2, byte) == CloudResult::kForeign) << value;
    const bool no_precision = byte == 0 || byte > 18;
    EXPECT_TRUE(!no_precision || cloud.decodeWith(3, byte) == CloudResult::kFrequencies) << value;
  }
}

TEST(DracoCloud, EveryPrefixIsRefused) {
  const SmallCloud cloud;
  for (size_t size = 0; size < cloud.bytes.size(); ++size) {
    SmallCloud shorter;
    shorter.bytes.resize(size);
    EXPECT_NE(CloudResult::kOk, shorter.decode()) << size;
  }
}

TEST(DracoCloud, TrailingBytesAreRefused) {
  SmallCloud cloud;
  cloud.bytes.push_back(0);
  EXPECT_EQ(CloudResult::kTrailing, cloud.decode());
}

TEST(DracoCloud, FillingBitsMustBeZero) {
  const Bytes bytes = test::taggedColumn({5}, 1);
  ASSERT_EQ(CloudResult::kOk, Decoded().decode(bytes, 1, {kOneSigned}));
  Bytes changed = bytes;
  changed.back() |= 0x80;
  EXPECT_EQ(CloudResult::kStream, Decoded().decode(changed, 1, {kOneSigned}));
}

TEST(DracoCloud, TagsOfMoreThan19BitsAreRefused) {
  const Bytes bytes = test::taggedColumn({5, 1 << 19}, 1);
  EXPECT_EQ(CloudResult::kFrequencies, Decoded().decode(bytes, 2, {kOneUnsigned}));
}

TEST(DracoCloud, PlainValuesOfMoreThan19BitsAreRefused) {
  const Bytes head = {0xfe, 0, 3};
  EXPECT_EQ(CloudResult::kOk, Decoded().decode(joined({head, {0xff, 0xff, 0x07}}), 1, {kOneSigned}));
  EXPECT_EQ(CloudResult::kRange, Decoded().decode(joined({head, {0xff, 0xff, 0x08}}), 1, {kOneSigned}));
  EXPECT_EQ(CloudResult::kRange, Decoded().decode({0xfe, 0, 4, 0, 0, 0, 0}, 1, {kOneSigned}));
}

TEST(DracoCloud, CallersMistakesAreRefused) {
  const SmallCloud cloud;
  Decoded decoded;
  int32_t value = 0;
  int32_t* outs[] = {&value, &value};
  std::vector<uint64_t> memory(decodeScratchSize(20, cloud.bytes.size()) / 8 + 1);
  const auto decode = [&](uint32_t records, const std::vector<ColumnSpec>& columns, size_t scratch_size, size_t shift) {
    return decodeCloud(cloud.bytes.data(), cloud.bytes.size(), records, columns.data(),
                       static_cast<uint32_t>(columns.size()), outs,
                       {reinterpret_cast<uint8_t*>(memory.data()) + shift, scratch_size});
  };
  const size_t enough = decodeScratchSize(20, cloud.bytes.size());
  EXPECT_EQ(CloudResult::kArgument, decode(0, cloud.columns, enough, 0));
  EXPECT_EQ(CloudResult::kArgument, decode(20, {}, enough, 0));
  EXPECT_EQ(CloudResult::kArgument, decode(20, {{0, ColumnKind::kSigned}}, enough, 0));
  EXPECT_EQ(CloudResult::kArgument, decode(20, {{5, ColumnKind::kSigned}}, enough, 0));
  EXPECT_EQ(CloudResult::kArgument, decode(20, cloud.columns, enough - 1, 0));
  EXPECT_EQ(CloudResult::kArgument, decode(20, cloud.columns, enough, 4));
  EXPECT_EQ(CloudResult::kArgument, decode(kMaxCloudRecords + 1, cloud.columns, SIZE_MAX, 0));
}

TEST(DracoCloud, ScratchGrowsWithTheRecordsOrTheBytesUpToALimit) {
  EXPECT_LT(decodeScratchSize(1, SIZE_MAX), 265u * 1024);
  EXPECT_EQ(decodeScratchSize(1, SIZE_MAX) + 32 * 999, decodeScratchSize(1000, SIZE_MAX));
  EXPECT_EQ(decodeScratchSize(1000, 500) + 8 * 500, decodeScratchSize(1000, 1000));
  EXPECT_LT(decodeScratchSize(kMaxCloudRecords, SIZE_MAX), 2355u * 1024);
}

// ---- Hostile bytes
// ----------------------------------------------------------------------------------------------------

/// Whatever the bytes, decoding ends, stays inside its memory (the sanitizer build sees to that) and says the same
/// twice.
TEST(DracoCloud, RandomDamageIsHarmless) {
  Random random(5);
  const SmallCloud cloud;
  uint32_t refused = 0;
  Decoded once, twice;
  for (int round = 0; round < 20000; ++round) {
    SmallCloud damaged = cloud;
    for (uint32_t k = 1 + random.below(3); k > 0; --k) {
      damaged.bytes[random.below(static_cast<uint32_t>(damaged.bytes.size()))] =
          static_cast<uint8_t>(random.below(256));
    }
    if (random.chance(10)) damaged.bytes.resize(random.below(static_cast<uint32_t>(damaged.bytes.size())));
    const CloudResult result = once.decode(damaged.bytes, SmallCloud::kRecords, cloud.columns);
    ASSERT_EQ(result, twice.decode(damaged.bytes, SmallCloud::kRecords, cloud.columns));
    ASSERT_TRUE(result != CloudResult::kOk || once.values == twice.values);
    refused += result != CloudResult::kOk;
  }
  EXPECT_GT(refused, 10000u);
}

/// Values that are accepted lie in the promised ranges, so that what is made of them cannot overflow.
TEST(DracoCloud, AcceptedValuesAreInRange) {
  Random random(6);
  for (int round = 0; round < 3000; ++round) {
    const Bytes columns[3] = {test::taggedColumn(someSymbols(random, 4, 1 << 19), 1),
                              test::rawColumn(someSymbols(random, 4, 1 << 18), 18),
                              {0xfe, 0, 3, 1, 2, 3, 4, 5, 6, 7, 0, 1, 1, 1, 7}};
    Bytes bytes = columns[random.below(3)];
    for (int k = 0; k < 2; ++k) {
      bytes[3 + random.below(static_cast<uint32_t>(bytes.size() - 3))] ^= 1u << random.below(8);
    }
    for (ColumnKind kind : {ColumnKind::kSigned, ColumnKind::kUnsigned}) {
      Decoded decoded;
      if (decoded.decode(bytes, 4, {{1, kind}}) != CloudResult::kOk) continue;
      const int32_t least = kind == ColumnKind::kSigned ? -(1 << 18) : 0;
      for (int32_t value : decoded.values[0]) {
        EXPECT_GE(value, least);
        EXPECT_LT(value, least + (1 << 19));
      }
    }
  }
}

/// Whether a cloud is taken, and its values, do not depend on what lies before it.
TEST(DracoCloud, WhatLiesBeforeItIsLookedAtButDoesNotCount) {
  Random random(7);
  const SmallCloud cloud;
  Decoded alone, behind;
  for (int round = 0; round < 2000; ++round) {
    SmallCloud damaged = cloud;
    if (random.chance(80))
      damaged.bytes[random.below(static_cast<uint32_t>(cloud.bytes.size()))] ^= 1 << random.below(8);
    Bytes lead(random.below(40));
    for (uint8_t& byte : lead) byte = static_cast<uint8_t>(random.below(256));
    const CloudResult result = alone.decode(damaged.bytes, SmallCloud::kRecords, cloud.columns);
    const CloudResult again = behind.decode(damaged.bytes, SmallCloud::kRecords, cloud.columns, lead);
    ASSERT_EQ(result == CloudResult::kOk, again == CloudResult::kOk);
    ASSERT_TRUE(result != CloudResult::kOk || alone.values == behind.values);
  }
}

/// Before a stream a lane needs kRansLead bytes that it may look at: the shortest column has them.
TEST(DracoCloud, ShortestColumnsNeedNothingBeforeThem) {
  for (const uint32_t records : {1u, 2u, 5000u}) {
    const std::vector<uint32_t> same(records, 1);
    for (const Bytes& bytes : {test::rawColumn(same, 1), test::taggedColumn(same, 1)}) {
      Decoded decoded;
      ASSERT_EQ(CloudResult::kOk, decoded.decode(bytes, records, {kOneUnsigned}));
      EXPECT_EQ(asInts(same), decoded.values[0]);
    }
  }
}

/// 2^20 slots in a cloud of one record.
TEST(DracoCloud, LargestPrecisionForOneRecord) {
  const Bytes bytes = test::rawColumn({200000}, 18);
  Decoded decoded;
  ASSERT_EQ(CloudResult::kOk, decoded.decode(bytes, 1, {kOneUnsigned}));
  EXPECT_EQ(200000, decoded.values[0][0]);
}

}  // namespace
}  // namespace lithe::runtime
