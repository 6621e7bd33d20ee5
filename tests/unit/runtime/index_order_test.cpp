// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "lithe/runtime.hpp"
#include "random.h"

namespace lithe {
namespace {

using Triangles = std::vector<std::array<uint32_t, 3>>;

/// A FIFO that has misses per triangle, written down independently of the order's own clock.
double missesPerTriangle(const std::vector<uint32_t>& indices, size_t cache_size = 16) {
  std::vector<uint32_t> cache;
  size_t misses = 0;
  for (const uint32_t v : indices) {
    if (std::find(cache.begin(), cache.end(), v) != cache.end()) continue;
    ++misses;
    cache.insert(cache.begin(), v);
    if (cache.size() > cache_size) cache.pop_back();
  }
  return 3.0 * static_cast<double>(misses) / static_cast<double>(indices.size());
}

Triangles sortedTriangles(const std::vector<uint32_t>& indices, const lithe_range& range) {
  Triangles triangles;
  for (uint32_t i = range.first_index; i < range.first_index + range.index_count; i += 3)
    triangles.push_back({indices[i], indices[i + 1], indices[i + 2]});
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

Result order(std::vector<uint32_t>& indices, const std::vector<lithe_range>& ranges, uint32_t vertex_count) {
  std::vector<uint8_t> scratch(orderScratch(static_cast<uint32_t>(indices.size()), vertex_count));
  return orderIndices(Span<uint32_t>(indices), ranges, vertex_count, scratch);
}

/// A grid of quads, its triangles shuffled.
std::vector<uint32_t> shuffledGrid(uint32_t cells, test::Random& random) {
  Triangles triangles;
  for (uint32_t y = 0; y < cells; ++y) {
    for (uint32_t x = 0; x < cells; ++x) {
      const uint32_t a = y * (cells + 1) + x, b = a + cells + 1;
      triangles.push_back({a, a + 1, b});
      triangles.push_back({a + 1, b + 1, b});
    }
  }
  for (size_t i = triangles.size(); i > 1; --i)
    std::swap(triangles[i - 1], triangles[random.below(static_cast<uint32_t>(i))]);
  std::vector<uint32_t> indices;
  for (const auto& t : triangles) indices.insert(indices.end(), t.begin(), t.end());
  return indices;
}

TEST(OrderIndices, MakesAShuffledGridFitTheCache) {
  test::Random random(1);
  std::vector<uint32_t> indices = shuffledGrid(60, random);
  const lithe_range all = {0, static_cast<uint32_t>(indices.size())};
  const Triangles before = sortedTriangles(indices, all);
  EXPECT_GT(missesPerTriangle(indices), 2.5);
  ASSERT_EQ(order(indices, {all}, 61 * 61), Result::kOk);
  EXPECT_LT(missesPerTriangle(indices), 0.75) << "half a vertex per triangle is all that there are";
  EXPECT_EQ(sortedTriangles(indices, all), before);
}

// Whatever the triangles are: repeated, with repeated corners, fans of hundreds, vertices in several parts.
TEST(OrderIndices, KeepsEveryTriangleInItsRange) {
  test::Random random(2);
  for (uint32_t round = 0; round < 300; ++round) {
    const uint32_t vertices = 1 + random.below(round % 7 == 0 ? 300 : 40);
    std::vector<uint32_t> indices;
    std::vector<lithe_range> ranges;
    for (uint32_t r = random.below(4); r-- > 0;) {
      const uint32_t count = 3 * random.below(round % 5 == 0 ? 400 : 30), hub = random.below(vertices);
      ranges.push_back({static_cast<uint32_t>(indices.size()), count});
      for (uint32_t i = 0; i < count; ++i)
        indices.push_back(i % 3 == 0 && round % 3 == 0 ? hub : random.below(vertices));
    }
    const std::vector<uint32_t> before = indices;
    ASSERT_EQ(order(indices, ranges, vertices), Result::kOk);
    for (const lithe_range& range : ranges)
      ASSERT_EQ(sortedTriangles(indices, range), sortedTriangles(before, range)) << round;
    std::vector<uint32_t> again = before;
    ASSERT_EQ(order(again, ranges, vertices), Result::kOk);
    ASSERT_EQ(again, indices) << "the same order every time";
  }
}

TEST(OrderIndices, SixteenBitIndicesGetTheSameOrder) {
  test::Random random(3);
  std::vector<uint32_t> wide = shuffledGrid(20, random);
  std::vector<uint16_t> narrow(wide.begin(), wide.end());
  const std::vector<lithe_range> ranges = {{0, 600}, {600, static_cast<uint32_t>(wide.size()) - 600}};
  std::vector<uint8_t> scratch(orderScratch(static_cast<uint32_t>(wide.size()), 441));
  ASSERT_EQ(orderIndices(Span<uint16_t>(narrow), ranges, 441, scratch), Result::kOk);
  ASSERT_EQ(orderIndices(Span<uint32_t>(wide), ranges, 441, scratch), Result::kOk);
  EXPECT_TRUE(std::equal(wide.begin(), wide.end(), narrow.begin()));
}

TEST(OrderIndices, RefusesWhatDoesNotFitAndLeavesItAlone) {
  const std::vector<uint32_t> before = {0, 1, 2, 2, 1, 3};
  std::vector<uint32_t> indices = before;
  const auto with = [&](std::vector<lithe_range> ranges, uint32_t vertex_count) {
    const Result result = order(indices, ranges, vertex_count);
    EXPECT_EQ(indices, before);
    return result;
  };
  EXPECT_EQ(with({{0, 6}}, 3), Result::kInvalidArgument) << "an index beyond the vertices";
  EXPECT_EQ(with({{0, 3}}, 4), Result::kInvalidArgument) << "indices in no range";
  EXPECT_EQ(with({{0, 3}, {0, 6}}, 4), Result::kInvalidArgument) << "ranges that overlap";
  EXPECT_EQ(with({{0, 4}, {4, 2}}, 4), Result::kInvalidArgument) << "part of a triangle";
  EXPECT_EQ(with({{3, 3}, {0, 3}}, 4), Result::kInvalidArgument) << "ranges that do not ascend";
  std::vector<uint8_t> scratch(orderScratch(6, 4) - 1);
  EXPECT_EQ(orderIndices(Span<uint32_t>(indices), {}, 4, scratch), Result::kInvalidArgument) << "no range";
  const std::vector<lithe_range> all = {{0, 6}};
  EXPECT_EQ(orderIndices(Span<uint32_t>(indices), all, 4, scratch), Result::kBufferTooSmall);
  EXPECT_EQ(indices, before);
}

TEST(OrderIndices, NothingIsInOrder) {
  std::vector<uint32_t> none;
  EXPECT_EQ(order(none, {}, 0), Result::kOk);
  EXPECT_EQ(order(none, {{0, 0}, {0, 0}}, 5), Result::kOk);
}

}  // namespace
}  // namespace lithe
