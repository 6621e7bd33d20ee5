// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Whole files: what the report says, how levels share pages, and every page taken apart without the runtime.
#include "lithe/bake/encode.h"

#include <gtest/gtest.h>

#include <set>

#include "lithe/format/bytes.h"
#include "lithe/format/file.h"
#include "page_reader.h"
#include "random_character.h"

namespace lithe::bake {
namespace {

namespace format = lithe::format;
using format::loadU32;

struct Encoded {
  Model model;
  Mesh mesh;
  CollapseSequence sequence;
  Hierarchy hierarchy;
  std::vector<LevelPlan> levels;
  EncodeReport report;
  std::vector<uint8_t> bytes;

  Encoded(const std::vector<uint32_t>& collapses_left, uint32_t page_splits, uint32_t shared_page_splits) {
    test::CharacterShape shape;
    shape.seams = true;
    shape.parts = 2;
    shape.attributes = {true, true, 2, 1};
    mesh = test::randomMesh(shape, 77);
    sequence = test::randomCollapses(mesh, 10, 4, shape.joints, 78);
    hierarchy = buildHierarchy(mesh, sequence, 4);
    model.nodes = {{"root", kNone, {}}};
    for (uint32_t j = 0; j < shape.joints; ++j) model.joints.push_back({0, glm::dmat4(1.0)});
    model.parts.resize(shape.parts);
    model.rest_diagonal = 1.0;
    const uint32_t all = static_cast<uint32_t>(sequence.collapses.size());
    double error = 1.0;
    levels.push_back({all, error, error});
    for (uint32_t left : collapses_left) levels.push_back({left, error /= 2, error / 2});
    bytes = encodeFile({model, mesh, hierarchy, levels, 4, 1.0, page_splits, shared_page_splits}, &report);
  }

  const uint8_t* record(uint32_t id, uint32_t index) const {
    for (uint32_t i = 0;; ++i) {
      const uint8_t* entry = bytes.data() + format::header::kBytes + i * format::directory::kBytes;
      if (loadU32(entry) != id) continue;
      return bytes.data() + loadU32(entry + format::directory::kOffsetAt) +
             size_t{index} * format::loadU16(entry + format::directory::kRecordBytesAt);
    }
  }
  uint32_t pageEnd(uint32_t level) const {
    return loadU32(record(format::level::kId, level) + format::level::kPageEndAt);
  }
  uint32_t pageCount() const { return pageEnd(static_cast<uint32_t>(levels.size()) - 1); }

  std::vector<uint32_t> hiddenCounts(uint32_t page) const {
    std::vector<uint32_t> counts;
    for (uint32_t level = 0; level < levels.size(); ++level)
      if (pageEnd(level) == page + 1)
        counts.push_back(loadU32(record(format::level::kId, level) + format::level::kHiddenCountAt));
    return counts;
  }

  test::ReadPage page(uint32_t index) const {
    uint64_t at = report.head_bytes;
    for (uint32_t i = 0; i < index; ++i) at += loadU32(record(format::page::kId, i));
    const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    return test::readPage({begin, begin + loadU32(record(format::page::kId, index))}, {true, true, 2, 1},
                          hiddenCounts(index));
  }
};

uint64_t sumOf(const std::vector<EncodeReport::Kind>& kinds) {
  uint64_t sum = 0;
  for (const auto& kind : kinds) sum += kind.bytes;
  return sum;
}

TEST(Encode, KindsAddUpToTheFile) {
  for (uint32_t page_splits : {8192u, 20u}) {
    const Encoded e({60, 20, 0}, page_splits, page_splits / 4);
    EXPECT_EQ(e.report.file_bytes, e.bytes.size());
    EXPECT_EQ(sumOf(e.report.kinds), e.bytes.size());
    std::set<std::string> names;
    for (const auto& kind : e.report.kinds) EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
    EXPECT_EQ(e.report.kinds[0].name, "head");
    EXPECT_EQ(e.report.kinds[0].bytes, e.report.head_bytes);
  }
}

TEST(Encode, ReportedLevelsAreThoseOfTheTables) {
  const Encoded e({60, 20, 0}, 15, 4);
  ASSERT_EQ(e.report.levels.size(), 4u);
  for (uint32_t level = 0; level < 4; ++level) {
    const uint8_t* p = e.record(format::level::kId, level);
    EXPECT_EQ(e.report.levels[level].vertices, loadU32(p + format::level::kWedgeCountAt));
    EXPECT_EQ(e.report.levels[level].triangles,
              loadU32(p + format::level::kFaceCountAt) - loadU32(p + format::level::kHiddenCountAt));
    uint64_t end = e.report.head_bytes;
    for (uint32_t page = 0; page < e.pageEnd(level); ++page) end += loadU32(e.record(format::page::kId, page));
    EXPECT_EQ(e.report.levels[level].bytes_end, end);
  }
  EXPECT_EQ(e.report.levels.back().bytes_end, e.bytes.size());
  EXPECT_EQ(e.report.levels.back().triangles, e.mesh.triangleCount());
  EXPECT_EQ(e.report.levels.back().vertices, e.hierarchy.wedge_node.size());
}

TEST(Encode, LevelsHoldTheNodesOfTheirCuts) {
  const Encoded e({60, 20, 0}, 15, 4);
  for (uint32_t level = 0; level < 4; ++level) {
    const uint32_t roots = e.mesh.vertexCount() - static_cast<uint32_t>(e.sequence.collapses.size());
    const uint32_t splits = e.levels[0].collapses - e.levels[level].collapses;
    EXPECT_EQ(loadU32(e.record(format::level::kId, level) + format::level::kNodeCountAt), roots + 2 * splits);
  }
}

TEST(Encode, SmallLevelsShareAPageAndLargeOnesHaveSeveral) {
  // 110 collapses: levels of 5, 5, 10 and 90 splits.
  const Encoded shared({105, 100, 90, 0}, 8192, 2048);
  EXPECT_EQ(shared.pageCount(), 2u);
  for (uint32_t level = 1; level < 5; ++level) EXPECT_EQ(shared.pageEnd(level), 2u);
  const Encoded apart({105, 100, 90, 0}, 8192, 1);
  for (uint32_t level = 0; level < 5; ++level) EXPECT_EQ(apart.pageEnd(level), level + 1);
  const Encoded several({105, 100, 90, 0}, 30, 10);
  EXPECT_EQ(several.pageEnd(1), several.pageEnd(2)) << "five and five splits make one page";
  EXPECT_EQ(several.pageEnd(3), several.pageEnd(2) + 1);
  EXPECT_EQ(several.pageEnd(4), several.pageEnd(3) + 3);
}

TEST(Encode, EveryPageIsWhatTheSpecificationSays) {
  const Encoded e({105, 100, 60, 20, 0}, 25, 8);
  uint32_t splits = 0;
  for (uint32_t i = 0; i < e.pageCount(); ++i) {
    const test::ReadPage page = e.page(i);
    const uint8_t* entry = e.record(format::page::kId, i);
    ASSERT_EQ(page.kind, i == 0 ? 0 : 1);
    uint64_t values = 0;
    for (const auto& stream : page.values)
      for (const auto& attribute : stream) values += attribute.size();
    EXPECT_EQ(loadU32(entry + format::page::kValuesAt), values) << i;
    for (const auto& level : page.hidden)
      for (size_t k = 1; k < level.size(); ++k) EXPECT_LT(level[k - 1], level[k]);
    if (i == 0) {
      EXPECT_EQ(page.records[format::kBaseNodes], loadU32(entry + format::page::kNodeCountAt));
      EXPECT_EQ(page.records[format::kBaseWedges], loadU32(entry + format::page::kWedgeCountAt));
      EXPECT_EQ(page.records[format::kBaseFaces], loadU32(entry + format::page::kFaceCountAt));
      continue;
    }
    splits += page.records[format::kSplits];
    const uint32_t before = loadU32(e.record(format::page::kId, i - 1) + format::page::kNodeCountAt);
    EXPECT_EQ(loadU32(entry + format::page::kNodeCountAt), before + 2 * page.records[format::kSplits]);
    uint32_t set = 0;
    for (uint32_t stream : {format::kFlagsOld, format::kFlagsNew})
      for (const auto& flags : page.values[stream])
        for (int32_t flag : flags) set += static_cast<uint32_t>(flag);
    EXPECT_EQ(set, page.records[format::kSplits]) << "one flag per split";
  }
  EXPECT_EQ(splits, e.sequence.collapses.size());
}

TEST(Encode, SameInputSameBytes) { EXPECT_EQ(Encoded({60, 20, 0}, 15, 4).bytes, Encoded({60, 20, 0}, 15, 4).bytes); }

TEST(Encode, TheReportIsOptional) {
  const Encoded e({60, 0}, 8192, 2048);
  EXPECT_EQ(encodeFile({e.model, e.mesh, e.hierarchy, e.levels, 4, 1.0, 8192, 2048}, nullptr), e.bytes);
}

TEST(Encode, AReportUsedAgainIsFilledAnew) {
  Encoded e({60, 20, 0}, 15, 4);
  EncodeReport report = e.report;
  encodeFile({e.model, e.mesh, e.hierarchy, e.levels, 4, 1.0, 15, 4}, &report);
  EXPECT_EQ(report.levels.size(), e.levels.size());
  EXPECT_EQ(sumOf(report.kinds), report.file_bytes);
}

TEST(Encode, EveryStreamIsCountedAsSomeKind) {
  for (uint32_t stream = 0; stream < format::kBaseStreamCount; ++stream)
    EXPECT_STREQ(streamKind(format::kBasePage, stream), "base");
  const std::set<std::string> known = {"splits", "normals", "tangents", "colours",      "skin",
                                       "wedges", "flags",   "uvs",      "connectivity", "extra wedges"};
  std::set<std::string> seen;
  for (uint32_t stream = 0; stream < format::kSplitStreamCount; ++stream) {
    EXPECT_TRUE(known.count(streamKind(format::kSplitPage, stream))) << stream;
    seen.insert(streamKind(format::kSplitPage, stream));
  }
  EXPECT_EQ(seen, known);
  EXPECT_STREQ(streamKind(format::kSplitPage, format::kUv0 + 7), "uvs");
  EXPECT_STREQ(streamKind(format::kSplitPage, format::kGeneral), "connectivity");
}

}  // namespace
}  // namespace lithe::bake
