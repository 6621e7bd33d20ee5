// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The tables of a page against docs/format.md, and the arithmetic that the writer and the reader share.
#include "lithe/format/page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <vector>

#include "random.h"
#include "spec_tables.h"

namespace lithe::format {
namespace {

using test::numbersIn;
using test::spec;
using test::SpecRow;

constexpr WedgeAttributes kEverything{true, true, 1, 1};
constexpr WedgeAttributes kAllSets{true, true, 8, 2};
constexpr WedgeAttributes kNothing{false, false, 0, 0};

/// Attributes as a cell writes them: "1 u t8; 3 s k" gives "1u 3s".
std::string attributesOf(const std::string& cell) {
  std::string found;
  for (size_t i = 0; i + 2 < cell.size(); ++i) {
    const bool begins = i == 0 || cell[i - 1] == ' ';
    const bool ends = i + 3 == cell.size() || !std::isalnum(static_cast<unsigned char>(cell[i + 3]));
    if (begins && ends && std::isdigit(static_cast<unsigned char>(cell[i])) && cell[i + 1] == ' ' &&
        (cell[i + 2] == 's' || cell[i + 2] == 'u'))
      found += std::string(found.empty() ? "" : " ") + cell[i] + cell[i + 2];
  }
  return found;
}

std::string attributesOf(const StreamAttribute* attributes, uint32_t count) {
  std::string text;
  for (uint32_t i = 0; i < count; ++i)
    text +=
        std::string(i ? " " : "") + std::to_string(attributes[i].components) + (attributes[i].is_unsigned ? "u" : "s");
  return text;
}

/// First and last stream of a row: "2 splits", "24 .. 31 uv".
std::pair<uint64_t, uint64_t> streamsOf(const std::string& cell) {
  const std::vector<uint64_t> numbers = numbersIn(cell);
  return {numbers.at(0), numbers.size() > 1 ? numbers[1] : numbers[0]};
}

TEST(PageSpecification, BaseStreams) {
  const std::vector<SpecRow> rows = spec().table("Streams", 0);
  ASSERT_EQ(rows.size(), uint32_t{kBaseStreamCount});
  for (uint32_t stream = 0; stream < rows.size(); ++stream) {
    EXPECT_EQ(streamsOf(rows[stream][0]).first, stream);
    StreamAttribute attributes[kMaxStreamAttributes];
    const uint32_t count = baseStreamAttributes(stream, kEverything, attributes);
    EXPECT_EQ(attributesOf(attributes, count), attributesOf(rows[stream][2])) << rows[stream][0];
  }
}

TEST(PageSpecification, SplitStreams) {
  uint64_t next = 0;
  for (const SpecRow& row : spec().table("Streams", 1)) {
    const auto [first, last] = streamsOf(row[0]);
    EXPECT_EQ(first, next) << row[0];
    for (uint64_t stream = first; stream <= last; ++stream) {
      StreamAttribute attributes[kMaxStreamAttributes];
      const uint32_t count = splitStreamAttributes(static_cast<uint32_t>(stream), kAllSets, attributes);
      EXPECT_EQ(attributesOf(attributes, count), attributesOf(row[2])) << row[0];
    }
    next = last + 1;
  }
  EXPECT_EQ(next, uint64_t{kSplitStreamCount});
}

TEST(PageSpecification, ParametersAreCountedAndNamedInOrder) {
  for (const SpecRow& row : spec().table("3. A page")) {
    const size_t named = row[0].find("parameters");
    if (named == std::string::npos) continue;
    EXPECT_EQ(numbersIn(row[0]), std::vector<uint64_t>{kParameterBytes});
    // "name of set 0 .. 7" counts eight times.
    uint64_t count = 0;
    const std::string list = row[0].substr(row[0].find("in order:") + 9) + (row.size() > 1 ? row[1] : "");
    for (size_t begin = 0; begin < list.size();) {
      const size_t end = std::min(list.find(',', begin), list.size());
      const std::vector<uint64_t> numbers = numbersIn(list.substr(begin, end - begin));
      count += numbers.size() == 2 ? numbers[1] - numbers[0] + 1 : 1;
      begin = end + 1;
    }
    EXPECT_EQ(count, uint64_t{kParameterBytes});
    return;
  }
  FAIL() << "no row of parameters";
}

TEST(PageSpecification, WedgeClasses) {
  const std::vector<SpecRow> rows = spec().table("4.4 Wedges and attributes");
  ASSERT_EQ(rows.size(), 1u);
  const SpecRow& pairs = rows[0];
  const std::vector<uint64_t> values = {0, 1, 2, 3, 4, 5, kClassListed - 1};
  for (size_t i = 0; i < values.size(); ++i) {
    const uint32_t code = static_cast<uint32_t>(values[i]);
    auto counts = [&](bool at_a, bool at_b) {
      const ClassCounts found = classCounts(code, at_a, at_b);
      return std::vector<uint64_t>{found.a, found.b};
    };
    // The first cell names the row, "..." has a cell of its own.
    const std::vector<uint64_t> pair = numbersIn(pairs[i < 6 ? i + 1 : 8]);
    EXPECT_EQ(pair, counts(true, true)) << code;
    EXPECT_EQ(pair, counts(false, false)) << code;
    EXPECT_EQ(pair, counts(true, false)) << code;
    EXPECT_EQ((std::vector<uint64_t>{pair[1], pair[0]}), counts(false, true)) << code;
  }
}

TEST(PageArithmetic, WedgeClassesHaveEachTheirCode) {
  std::set<uint32_t> codes;
  for (const auto& [at_a, at_b] : {std::pair(true, true), {true, false}, {false, true}, {false, false}})
    for (uint32_t a = 0; a <= kMostCodedWedges + 1; ++a)
      for (uint32_t b = a == 0 ? 1 : 0; b <= kMostCodedWedges + 1; ++b) {
        const uint32_t code = classCode({a, b}, at_a, at_b);
        ASSERT_EQ(code == kClassListed, a + b > kMostCodedWedges);
        if (code == kClassListed) continue;
        const ClassCounts found = classCounts(code, at_a, at_b);
        ASSERT_EQ(found.a, a);
        ASSERT_EQ(found.b, b);
        codes.insert(code);
      }
  EXPECT_EQ(codes.size(), kClassListed);
  EXPECT_EQ(classCode({1u << 31, 1u << 31}, true, false), kClassListed);
  EXPECT_EQ(classStream(true, true), uint32_t{kClassesBoth});
  EXPECT_EQ(classStream(true, false), uint32_t{kClassesOne});
  EXPECT_EQ(classStream(false, true), uint32_t{kClassesOne});
  EXPECT_EQ(classStream(false, false), uint32_t{kClassesNone});
}

TEST(PageStreams, AnAssetWithoutAnAttributeHasNoStreamForIt) {
  StreamAttribute attributes[kMaxStreamAttributes];
  for (uint32_t stream : {uint32_t{kNormals}, uint32_t{kTangents}, uint32_t{kColors}, uint32_t{kUv0}, kUv0 + 7u})
    EXPECT_EQ(splitStreamAttributes(stream, kNothing, attributes), 0u) << stream;
  EXPECT_EQ(splitStreamAttributes(kUv0 + 1, {false, false, 2, 0}, attributes), 1u);
  EXPECT_EQ(splitStreamAttributes(kUv0 + 2, {false, false, 2, 0}, attributes), 0u);
  EXPECT_EQ(attributesOf(attributes, baseStreamAttributes(kBaseWedges, kNothing, attributes)), "1u");
  EXPECT_EQ(baseStreamAttributes(kBaseWedges, kAllSets, attributes), kMaxStreamAttributes);
}

TEST(PageArithmetic, BitLength) {
  EXPECT_EQ(bitLength(0), 0);
  EXPECT_EQ(bitLength(1), 1);
  EXPECT_EQ(bitLength(2), 2);
  EXPECT_EQ(bitLength(3), 2);
  EXPECT_EQ(bitLength(255), 8);
  EXPECT_EQ(bitLength(256), 9);
  EXPECT_EQ(bitLength(0xffffffffu), 32);
}

TEST(PageArithmetic, LowBitsFollowTheExtentWithinTheirRange) {
  EXPECT_EQ(lowBits(0, 0), 0);
  EXPECT_EQ(lowBits(100, 0), 7);
  EXPECT_EQ(lowBits(100, 5), 2);
  EXPECT_EQ(lowBits(100, 7), 0);
  EXPECT_EQ(lowBits(100, 31), 0);
  EXPECT_EQ(lowBits(0xffffffffu, 0), static_cast<int32_t>(kLowBitsMax));
}

TEST(PageArithmetic, PairsAreNumberedOnceEach) {
  uint32_t index = 0;
  for (uint32_t q = 1; q <= kMaxRing; ++q)
    for (uint32_t p = 0; p < q; ++p, ++index) {
      ASSERT_EQ(pairIndex(p, q), index);
      uint32_t back_p = 0, back_q = 0;
      pairOf(index, &back_p, &back_q);
      ASSERT_EQ(back_p, p);
      ASSERT_EQ(back_q, q);
    }
}

TEST(PageArithmetic, CutStreamsByRingSize) {
  EXPECT_EQ(cutStream(3), uint32_t{kCut3});
  EXPECT_EQ(cutStream(1), uint32_t{kCut3});  // "up to 3"
  EXPECT_EQ(cutStream(2), uint32_t{kCut3});
  for (uint32_t n = 4; n <= 8; ++n) EXPECT_EQ(cutStream(n), kCut3 + n - 3);
  EXPECT_EQ(cutStream(9), uint32_t{kCut9});
  EXPECT_EQ(cutStream(kMaxRing), uint32_t{kCut9});
}

// ---- Rings ----

struct TestFan {
  std::vector<uint32_t> corner, next, previous;

  /// Edges (next, previous) in the fan's order; corner ids are their positions.
  explicit TestFan(const std::vector<std::pair<uint32_t, uint32_t>>& edges) {
    for (const auto& [from, to] : edges) {
      corner.push_back(static_cast<uint32_t>(corner.size()));
      next.push_back(from);
      previous.push_back(to);
    }
  }

  Ring ring() {
    Ring result;
    buildRing({static_cast<uint32_t>(corner.size()), corner.data(), next.data(), previous.data()}, result);
    return result;
  }
};

std::vector<uint32_t> verticesOf(const Ring& ring) {
  const uint32_t count = ring.kind == RingKind::kOpen ? ring.count + 1 : ring.count;
  return {ring.vertex, ring.vertex + count};
}

std::vector<uint32_t> edgesOf(const Ring& ring) { return {ring.edge, ring.edge + ring.count}; }

TEST(PageRing, ClosedRingBeginsWithTheFirstCorner) {
  const Ring ring = TestFan({{5, 7}, {9, 5}, {7, 9}}).ring();
  ASSERT_EQ(ring.kind, RingKind::kClosed);
  EXPECT_EQ(verticesOf(ring), (std::vector<uint32_t>{5, 7, 9}));
  EXPECT_EQ(edgesOf(ring), (std::vector<uint32_t>{0, 2, 1}));
}

TEST(PageRing, OpenRingBeginsAtItsOpenEnd) {
  const Ring ring = TestFan({{7, 9}, {9, 4}, {5, 7}}).ring();
  ASSERT_EQ(ring.kind, RingKind::kOpen);
  EXPECT_EQ(verticesOf(ring), (std::vector<uint32_t>{5, 7, 9, 4}));
  EXPECT_EQ(edgesOf(ring), (std::vector<uint32_t>{2, 0, 1}));
}

TEST(PageRing, OneTriangleIsAnOpenRing) {
  const Ring ring = TestFan({{3, 8}}).ring();
  ASSERT_EQ(ring.kind, RingKind::kOpen);
  EXPECT_EQ(verticesOf(ring), (std::vector<uint32_t>{3, 8}));
}

TEST(PageRing, TwoFacesBackToBackAreAClosedRing) {
  const Ring ring = TestFan({{3, 8}, {8, 3}}).ring();
  ASSERT_EQ(ring.kind, RingKind::kClosed);
  EXPECT_EQ(verticesOf(ring), (std::vector<uint32_t>{3, 8}));
}

TEST(PageRing, WhatIsNoRingIsIrregular) {
  EXPECT_EQ(TestFan({}).ring().kind, RingKind::kIrregular);
  EXPECT_EQ(TestFan({{1, 2}, {3, 4}}).ring().kind, RingKind::kIrregular) << "two open chains";
  EXPECT_EQ(TestFan({{1, 2}, {2, 1}, {3, 4}, {4, 3}}).ring().kind, RingKind::kIrregular) << "two closed chains";
  EXPECT_EQ(TestFan({{1, 2}, {2, 1}, {3, 4}}).ring().kind, RingKind::kIrregular) << "a closed and an open chain";
  EXPECT_EQ(TestFan({{1, 2}, {2, 3}, {2, 4}}).ring().kind, RingKind::kIrregular) << "two edges leave 2";
  EXPECT_EQ(TestFan({{1, 3}, {2, 3}, {3, 4}}).ring().kind, RingKind::kIrregular) << "two edges enter 3";
  EXPECT_EQ(TestFan({{1, 2}, {1, 2}}).ring().kind, RingKind::kIrregular) << "the same face twice";
}

TEST(PageRing, AtMostSixtyFourCorners) {
  for (uint32_t n : {kMaxRing, kMaxRing + 1}) {
    std::vector<std::pair<uint32_t, uint32_t>> edges;
    for (uint32_t i = 0; i < n; ++i) edges.push_back({100 + i, 100 + (i + 1) % n});
    EXPECT_EQ(TestFan(edges).ring().kind, n <= kMaxRing ? RingKind::kClosed : RingKind::kIrregular) << n;
    edges.back().second = 99;
    EXPECT_EQ(TestFan(edges).ring().kind, n <= kMaxRing ? RingKind::kOpen : RingKind::kIrregular) << n;
  }
}

// Against the specification's words, taken literally, on every small multigraph of edges.
TEST(PageRing, IsWhatTheSpecificationSays) {
  test::Random random(5);
  uint32_t kinds[3] = {0, 0, 0};
  for (int round = 0; round < 40000; ++round) {
    const uint32_t n = 1 + random.below(6), vertices = 2 + random.below(6);
    std::vector<std::pair<uint32_t, uint32_t>> edges;
    // Mostly chains in a random order, spoiled now and then.
    for (uint32_t i = 0; i < n; ++i) edges.push_back({i % vertices, (i + 1) % vertices});
    for (uint32_t i = n; i > 1; --i) std::swap(edges[i - 1], edges[random.below(i)]);
    if (random.chance(40)) edges[random.below(n)].second = random.below(vertices + 1);
    if (std::any_of(edges.begin(), edges.end(), [](const auto& e) { return e.first == e.second; })) continue;

    std::set<uint32_t> leaves, enters;
    for (const auto& [from, to] : edges) leaves.insert(from), enters.insert(to);
    uint32_t start = 0, starts = 0;
    for (uint32_t i = 0; i < n; ++i)
      if (!enters.count(edges[i].first)) start = i, ++starts;
    std::vector<uint32_t> order;
    std::set<uint32_t> visited;
    if (leaves.size() == n && enters.size() == n && starts <= 1)
      for (uint32_t at = start; at < n && visited.insert(at).second;) {
        order.push_back(at);
        const uint32_t end = edges[at].second;
        at = 0;
        while (at < n && edges[at].first != end) ++at;
      }
    const RingKind expected = order.size() != n ? RingKind::kIrregular : starts ? RingKind::kOpen : RingKind::kClosed;
    const Ring ring = TestFan(edges).ring();
    ASSERT_EQ(ring.kind, expected) << round;
    if (expected != RingKind::kIrregular) {
      ASSERT_EQ(edgesOf(ring), order);
    }
    ++kinds[static_cast<int>(expected)];
  }
  for (uint32_t count : kinds) EXPECT_GT(count, 1000u);
}

}  // namespace
}  // namespace lithe::format
