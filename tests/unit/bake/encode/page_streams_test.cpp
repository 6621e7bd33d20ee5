// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The bytes of a page, taken apart again as docs/format.md says.
#include "page_streams.h"

#include <gtest/gtest.h>

#include <numeric>

#include "page_reader.h"
#include "random.h"

namespace lithe::bake {
namespace {

constexpr format::WedgeAttributes kHas{true, true, 2, 1};

/// A page with `records` records in some of its streams, of numbers that tell where they stand.
PageData numberedPage(format::PageKind kind, uint64_t seed) {
  test::Random random(seed);
  PageData page = makePage(kind, kHas);
  for (auto& parameter : page.parameters) parameter = static_cast<uint8_t>(random.below(16));
  for (StreamData& stream : page.streams) {
    const uint32_t records = random.chance(30) ? 0 : 1 + random.below(300);
    for (StreamData::Attribute& attribute : stream.attributes)
      for (uint32_t i = 0; i < records * attribute.spec.components; ++i)
        attribute.values.push_back(attribute.spec.is_unsigned ? random.between(0, 900) : random.between(-500, 500));
  }
  for (uint32_t k = 1; k < format::kLowBitsKinds; ++k)
    for (uint32_t i = 0; i < 150 * k; ++i) page.low_bits[k].push_back(static_cast<uint8_t>(random.below(256)));
  page.hidden = {{0, 5, 133, 134, 20000}, {}, {70000}};
  return page;
}

std::vector<uint32_t> hiddenCounts(const PageData& page) {
  std::vector<uint32_t> counts;
  for (const auto& level : page.hidden) counts.push_back(static_cast<uint32_t>(level.size()));
  return counts;
}

class PageStreams : public testing::TestWithParam<format::PageKind> {};

TEST_P(PageStreams, ComeBackFromTheirBytes) {
  for (uint64_t seed = 1; seed <= 8; ++seed) {
    const PageData page = numberedPage(GetParam(), seed);
    PageBytes unused;
    const test::ReadPage read = test::readPage(writePage(page, &unused), kHas, hiddenCounts(page));
    EXPECT_EQ(read.kind, page.kind);
    EXPECT_TRUE(
        std::equal(read.parameters.begin(), read.parameters.end(), page.parameters.begin(), page.parameters.end()));
    ASSERT_EQ(read.records.size(), page.streams.size());
    for (size_t s = 0; s < page.streams.size(); ++s) {
      ASSERT_EQ(read.records[s], page.streams[s].records()) << s;
      for (size_t a = 0; a < read.values[s].size(); ++a)
        ASSERT_EQ(read.values[s][a], page.streams[s].attributes[a].values) << s << " " << a;
    }
    EXPECT_EQ(read.low_bits, page.low_bits);
    EXPECT_EQ(read.hidden, page.hidden);
  }
}

TEST_P(PageStreams, ReportedBytesAddUpToThePage) {
  const PageData page = numberedPage(GetParam(), 9);
  PageBytes bytes;
  const size_t size = writePage(page, &bytes).size();
  ASSERT_EQ(bytes.streams.size(), page.streams.size());
  EXPECT_EQ(std::accumulate(bytes.streams.begin(), bytes.streams.end(), size_t{0}) + bytes.low_bits + bytes.overhead,
            size);
  EXPECT_EQ(bytes.low_bits, 150u * (1 + 2 + 3 + 4 + 5));
  for (size_t s = 0; s < page.streams.size(); ++s) EXPECT_EQ(bytes.streams[s] > 0, page.streams[s].records() > 0) << s;
}

INSTANTIATE_TEST_SUITE_P(Kinds, PageStreams, testing::Values(format::kBasePage, format::kSplitPage),
                         [](const auto& test) { return test.param == format::kBasePage ? "base" : "split"; });

TEST(PageStreamsEmpty, OnlyTheFixedPartIsLeft) {
  PageBytes bytes;
  const std::vector<uint8_t> written = writePage(makePage(format::kBasePage, kHas), &bytes);
  // kind, parameters, a zero per stream, no low bits
  EXPECT_EQ(written,
            std::vector<uint8_t>(1 + format::kParameterBytes + format::kBaseStreamCount + format::kLowBitsKinds, 0));
  EXPECT_EQ(bytes.overhead, written.size());
}

TEST(PageStreamsEmpty, ValuesAreCountedOverAllStreams) {
  PageData page = makePage(format::kBasePage, kHas);
  EXPECT_EQ(page.valueCount(), 0u);
  page.streams[format::kBaseFaces].attributes[0].values = {1, 2, 3, 4, 5, 6};
  page.streams[format::kBaseInfluences].attributes[0].values = {1, 2};
  page.streams[format::kBaseInfluences].attributes[1].values = {3, 4};
  EXPECT_EQ(page.streams[format::kBaseFaces].records(), 2u);
  EXPECT_EQ(page.valueCount(), 10u);
}

TEST(PageStreamsEmpty, AttributesThatTheAssetLacksHaveNoStream) {
  const PageData page = makePage(format::kSplitPage, {false, false, 0, 0});
  for (uint32_t stream :
       {uint32_t{format::kNormals}, uint32_t{format::kTangents}, uint32_t{format::kColors}, uint32_t{format::kUv0}})
    EXPECT_TRUE(page.streams[stream].attributes.empty()) << stream;
}

TEST(BitWriter, FirstFieldInTheLowestBits) {
  BitWriter writer;
  writer.write(1, 1);
  writer.write(0, 0);
  writer.write(0b0110, 4);
  writer.write(0b101, 3);
  writer.write(0b11, 2);
  EXPECT_EQ(writer.bytes(), (std::vector<uint8_t>{0b10101101, 0b11}));
}

TEST(BitWriter, TakesTheLowestBitsOfANegativeNumber) {
  BitWriter writer;
  writer.write(static_cast<uint32_t>(-3), 4);
  EXPECT_EQ(writer.bytes(), (std::vector<uint8_t>{0b1101}));
}

TEST(BitWriter, FieldsComeBack) {
  test::Random random(3);
  BitWriter writer;
  std::vector<std::pair<uint32_t, int32_t>> fields;
  for (int i = 0; i < 500; ++i) {
    const int32_t bits = random.between(0, 15);
    fields.push_back({static_cast<uint32_t>(random.next()) & ((1u << bits) - 1), bits});
    writer.write(fields.back().first, bits);
  }
  test::BitReader reader(writer.bytes());
  for (const auto& [value, bits] : fields) ASSERT_EQ(reader.read(bits), value);
  EXPECT_TRUE(reader.atEnd());
}

}  // namespace
}  // namespace lithe::bake
