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

TEST(FileCosts, LowBitsCountForTheirKind) {
  const Bytes file = test::encodeSmallFile(test::richShape());
  test::AssetReader reader(file);
  reader.supplyThrough(reader.info().level_count - 1);
  const format::WedgeAttributes has{reader.info().has_normals != 0, reader.info().has_tangents != 0,
                                    reader.info().uv_sets, reader.info().color_sets};
  uint64_t normals = 0, differences = 0;
  for (uint32_t i = 1; i < reader.info().page_count; ++i) {
    lithe_page page;
    ASSERT_EQ(lithe_asset_page(reader.get(), i, &page), LITHE_OK);
    const PageTable table = readPageTable(std::span(file).subspan(page.offset, page.size), "a page");
    normals += table.streams[format::kNormals].bytes.size() + table.low_bits[format::kLowNormals].size();
    format::StreamAttribute attributes[format::kMaxStreamAttributes];
    const uint32_t count = format::splitStreamAttributes(format::kSplits, has, attributes);
    const CloudBytes cloud = measureCloud(table.streams[format::kSplits], {attributes, count}, "splits");
    differences += cloud.attributes[format::kSplitPosition] + cloud.attributes[format::kSplitPositionHeight] +
                   table.low_bits[format::kLowPositions].size();
  }
  const FileCosts costs = fileCosts(*reader.get(), file, "a test's file");
  EXPECT_EQ(bytesOf(costs, "normals"), normals);
  EXPECT_EQ(bytesOf(costs, "differences"), differences);
}

TEST(FileCosts, DamagedPagesAreRefused) {
  Bytes page = test::encodeSmallFile(test::tinyShape());
  EXPECT_THROW(readPageTable(page, "no page"), bake::Error);
  EXPECT_THROW(readPageTable({}, "nothing"), bake::Error);
  const format::StreamAttribute one[] = {{1, true}};
  EXPECT_THROW(measureCloud({1, page}, one, "no cloud"), bake::Error);
  const Bytes plain = {0xfe, 0, 1, 7}, more = {0xfe, 0, 1, 7, 7};
  EXPECT_EQ(measureCloud({1, plain}, one, "a cloud").attributes[0], plain.size());
  EXPECT_THROW(measureCloud({1, more}, one, "a cloud and a byte"), bake::Error);
}

}  // namespace
}  // namespace lithe::tool
