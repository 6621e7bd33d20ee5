// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// What a file's bytes are said to be for adds up, and is what the pages really hold.
#include "file_costs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "asset_reader.h"
#include "cloud_bytes.h"
#include "encoded_character.h"
#include "page_table.h"

namespace lithe::tool {
namespace {

using Bytes = std::vector<uint8_t>;

FileCosts costsOf(const Bytes& file) {
  test::AssetReader reader(file);
  reader.supplyThrough(reader.info().level_count - 1);
  return fileCosts(*reader.get(), file, "a test's file");
}

uint64_t bytesOf(const FileCosts& costs, const std::string& name) {
  for (const FileCosts::Kind& kind : costs.kinds)
    if (kind.name == name) return kind.bytes;
  ADD_FAILURE() << "no kind " << name;
  return 0;
}

TEST(FileCosts, KindsAddUpToTheFile) {
  for (const test::FileShape& shape : {test::richShape(), test::tinyShape(), test::patchShape()}) {
    const Bytes file = test::encodeSmallFile(shape);
    const FileCosts costs = costsOf(file);
    uint64_t sum = 0, sum_of_groups = 0;
    std::set<std::string> groups;
    for (const FileCosts::Kind& kind : costs.kinds) {
      sum += kind.bytes;
      if (groups.insert(kind.group).second) sum_of_groups += costs.bytesOf(kind.group);
    }
    EXPECT_EQ(sum, file.size());
    EXPECT_EQ(sum_of_groups, file.size());
  }
}

TEST(FileCosts, AKindIsZeroWithoutItsAttribute) {
  const FileCosts rich = costsOf(test::encodeSmallFile(test::richShape()));
  test::FileShape shape = test::richShape();
  shape.character.attributes = {false, false, 0, 0};
  const FileCosts bare = costsOf(test::encodeSmallFile(shape));
  for (const char* group : {"normals", "tangents", "uvs", "colours"}) {
    EXPECT_GT(rich.bytesOf(group), 0u) << group;
    EXPECT_EQ(bare.bytesOf(group), 0u) << group;
  }
  for (const FileCosts* costs : {&rich, &bare}) {
    EXPECT_GT(bytesOf(*costs, "differences"), 0u);
    EXPECT_GT(bytesOf(*costs, "weights"), 0u);
    EXPECT_GT(bytesOf(*costs, "skeleton and names"), 0u);
  }
}

TEST(FileCosts, VerticesAreThoseOfTheMesh) {
  const test::FileShape shape = test::richShape();
  const bake::Mesh mesh = test::randomMesh(shape.character, shape.seed);
  const FileCosts costs = costsOf(test::encodeSmallFile(shape));
  EXPECT_EQ(costs.vertices, mesh.vertexCount());
  EXPECT_EQ(costs.wedges, mesh.wedgeCount());
}

// ---- Low bits: a file with one split a page, so that each split's ring can be had from the asset before its page

struct NextPage {
  Bytes bytes;
  PageTable table;
};

NextPage nextPage(const test::AssetReader& reader, const Bytes& file) {
  lithe_request request;
  EXPECT_EQ(lithe_asset_next_request(reader.get(), reader.info().level_count - 1, &request), LITHE_OK);
  NextPage next;
  const auto begin = file.begin() + static_cast<std::ptrdiff_t>(request.offset);
  next.bytes.assign(begin, begin + request.size);
  next.table = readPageTable(next.bytes, "a page");
  return next;
}

/// The largest side of the box of a node and its neighbours.
uint32_t ringExtent(const lithe_hierarchy& cut, uint32_t node) {
  std::vector<uint32_t> nodes{node};
  for (uint32_t corner = 0; corner < 3 * cut.face_count; ++corner) {
    if (cut.wedge_node[cut.face_wedges[corner]] != node) continue;
    const uint32_t face = corner / 3 * 3;
    for (uint32_t k = 0; k < 3; ++k) nodes.push_back(cut.wedge_node[cut.face_wedges[face + k]]);
  }
  int32_t extent = 0;
  for (uint32_t c = 0; c < 3; ++c) {
    std::vector<int32_t> values;
    for (uint32_t n : nodes) values.push_back(cut.node_position[3 * n + c]);
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    extent = std::max(extent, *greatest - *least);
  }
  return static_cast<uint32_t>(extent);
}

uint64_t positionLowBits(const PageTable& table, uint32_t extent) {
  return 2 * static_cast<uint64_t>(format::lowBits(extent, table.parameters[format::kPositionBias])) +
         static_cast<uint64_t>(format::lowBits(extent, table.parameters[format::kHeightBias]));
}

uint64_t positionStreamBytes(const PageTable& table) {
  format::StreamAttribute attributes[format::kMaxStreamAttributes];
  const uint32_t count = format::splitStreamAttributes(format::kSplits, {}, attributes);
  const CloudBytes cloud = measureCloud(table.streams[format::kSplits], {attributes, count}, "splits");
  return cloud.attributes[format::kSplitPosition].bytes + cloud.attributes[format::kSplitPositionHeight].bytes;
}

TEST(FileCosts, WhatIsLeftOfTheLowBitsIsPositionsAndPadding) {
  test::FileShape shape = test::richShape();
  shape.page_splits = 1;
  shape.shared_page_splits = 1;
  const Bytes file = test::encodeSmallFile(shape);
  test::AssetReader reader(file);
  ASSERT_TRUE(reader.supplyNext());
  uint64_t bits = 0, most_padding = 0, others = 0;
  for (uint32_t page = 1; page < reader.info().page_count; ++page) {
    const NextPage next = nextPage(reader, file);
    ASSERT_EQ(next.table.streams[format::kSplits].records, 1u);
    lithe_hierarchy before, after;
    lithe_asset_hierarchy(reader.get(), &before);
    const uint32_t first_child = before.node_count;
    const std::vector<uint32_t> wedges(before.face_wedges, before.face_wedges + 3 * before.face_count);
    const std::vector<uint32_t> wedge_node(before.wedge_node, before.wedge_node + before.wedge_count);
    ASSERT_TRUE(reader.supplyNext());
    lithe_asset_hierarchy(reader.get(), &after);
    ASSERT_EQ(after.node_count, first_child + 2);
    lithe_hierarchy cut = after;
    cut.face_wedges = wedges.data();
    cut.wedge_node = wedge_node.data();
    cut.face_count = static_cast<uint32_t>(wedges.size() / 3);
    const uint64_t low = positionLowBits(next.table, ringExtent(cut, after.node_parent[first_child]));
    bits += 8 * positionStreamBytes(next.table) + low;
    others += 8 * next.table.low_bits.size() - low;
    most_padding += 7;
  }
  const uint64_t said = 8 * bytesOf(fileCosts(*reader.get(), file, "a test's file"), "differences");
  EXPECT_GE(said + 8, bits);
  EXPECT_LE(said, bits + most_padding + 8);
  EXPECT_GT(others, 2 * most_padding);  // else the padding could hide what is another attribute's
}

TEST(FileCosts, DamagedPagesAreRefused) {
  Bytes page = test::encodeSmallFile(test::tinyShape());
  EXPECT_THROW(readPageTable(page, "no page"), bake::Error);
  EXPECT_THROW(readPageTable({}, "nothing"), bake::Error);
  const format::StreamAttribute one[] = {{1, true}};
  EXPECT_THROW(measureCloud({1, page}, one, "no cloud"), bake::Error);
  const Bytes plain = {0xfe, 0, 1, 7}, more = {0xfe, 0, 1, 7, 7};
  EXPECT_EQ(measureCloud({1, plain}, one, "a cloud").attributes[0].bytes, plain.size());
  EXPECT_THROW(measureCloud({1, more}, one, "a cloud and a byte"), bake::Error);
}

}  // namespace
}  // namespace lithe::tool
