// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/bake.h"

#include <gtest/gtest.h>

#include <limits>

#include "lithe/runtime.h"
#include "malloc_allocator.h"
#include "shapes.h"

namespace lithe::bake {
namespace {

BakeOptions quick() {
  BakeOptions options;
  options.poses.count = 3;
  options.levels = {0.5, 0.2, 0.05};
  options.threads = 2;
  return options;
}

std::string refusal(const BakeOptions& options) {
  try {
    bake(test::tube(6, 4), options, nullptr);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Bake, OptionsOutOfRangeAreRefusedInOneSentence) {
  struct Bad {
    uint32_t BakeOptions::*member;
    std::vector<uint32_t> values;
    const char* name;
    const char* range;
  };
  const Bad all[] = {{&BakeOptions::max_influences, {0, 9}, "--max-influences", "1 to 8"},
                     {&BakeOptions::position_bits, {7, 17}, "--position-bits", "8 to 16"},
                     {&BakeOptions::normal_bits, {3, 16}, "--normal-bits", "4 to 15"},
                     {&BakeOptions::uv_bits, {3, 17}, "--uv-bits", "4 to 16"},
                     {&BakeOptions::weight_bits, {3, 17}, "--weight-bits", "4 to 16"},
                     {&BakeOptions::precision, {32}, "--precision", "0 to 31"}};
  for (const Bad& bad : all)
    for (uint32_t value : bad.values) {
      BakeOptions options = quick();
      options.*bad.member = value;
      EXPECT_EQ(refusal(options), std::string(bad.name) + " is " + std::to_string(value) + ": it must be " + bad.range);
    }
}

TEST(Bake, SharesOutOfRangeAreRefused) {
  for (double share : {0.0, -0.5, 1.5, std::numeric_limits<double>::quiet_NaN()}) {
    BakeOptions options = quick();
    options.levels = {0.5, share};
    EXPECT_EQ(refusal(options), "--levels: every share must be above 0 and at most 1") << share;
  }
}

TEST(Bake, UnknownMetricsAndClipsAreRefused) {
  BakeOptions metric = quick();
  metric.metric = "pretty";
  EXPECT_NE(refusal(metric).find("pretty"), std::string::npos);
  BakeOptions clip = quick();
  clip.poses.clips = {"dance"};
  EXPECT_NE(refusal(clip).find("dance"), std::string::npos);
}

TEST(Bake, OneThreadAndTwoGiveTheSameBytes) {
  const Model model = test::tube(12, 40);
  BakeOptions options = quick();
  const std::vector<uint8_t> two = bake(model, options, nullptr);
  options.threads = 1;
  EXPECT_EQ(bake(model, options, nullptr), two);
  options.threads = 5;
  EXPECT_EQ(bake(model, options, nullptr), two);
}

TEST(Bake, EdgesOfTheRangesAreTaken) {
  const Model model = test::tube(6, 8);
  for (bool least : {true, false}) {
    BakeOptions options = quick();
    options.max_influences = least ? 1 : 8;
    options.position_bits = least ? 8 : 16;
    options.normal_bits = least ? 4 : 15;
    options.uv_bits = least ? 4 : 16;
    options.weight_bits = least ? 4 : 16;
    options.precision = least ? 0 : 31;
    options.levels = least ? std::vector<double>{} : std::vector<double>{1.0};
    const std::vector<uint8_t> bytes = bake(model, options, nullptr);
    lithe_asset* asset = nullptr;
    ASSERT_EQ(lithe_asset_open(lithe::test::mallocAllocator(), bytes.data(), bytes.size(), nullptr, &asset), LITHE_OK);
    lithe_asset_close(asset);
  }
}

TEST(Bake, TheReportIsThatOfTheFile) {
  const Model model = test::tube(12, 40);
  BakeReport report;
  std::vector<std::string> stages;
  BakeOptions options = quick();
  options.progress = [&](const char* stage, double progress) {
    if (stages.empty() || stages.back() != stage) stages.push_back(stage);
    EXPECT_TRUE(progress >= 0.0 && progress <= 1.0);
  };
  const std::vector<uint8_t> bytes = bake(model, options, &report);
  EXPECT_EQ(stages, (std::vector<std::string>{"poses", "weld", "simplify", "hierarchy", "measure", "encode"}));
  ASSERT_EQ(report.stages.size(), stages.size());
  for (size_t i = 0; i < stages.size(); ++i) EXPECT_EQ(report.stages[i].name, stages[i]);

  EXPECT_EQ(report.poses, 3u);
  EXPECT_EQ(report.source_triangles, 960u);
  EXPECT_EQ(report.source_vertices, model.positions.size());
  EXPECT_EQ(report.file_bytes, bytes.size());
  uint64_t sum = 0;
  for (const auto& kind : report.kinds) sum += kind.bytes;
  EXPECT_EQ(sum, bytes.size());

  lithe_asset* asset = nullptr;
  ASSERT_EQ(lithe_asset_open(lithe::test::mallocAllocator(), bytes.data(), bytes.size(), nullptr, &asset), LITHE_OK);
  lithe_asset_info info;
  lithe_asset_describe(asset, &info);
  ASSERT_EQ(info.level_count, report.levels.size());
  EXPECT_GE(report.levels.size(), 3u);
  for (uint32_t i = 0; i < info.level_count; ++i) {
    lithe_level level;
    ASSERT_EQ(lithe_asset_level(asset, i, &level), LITHE_OK);
    EXPECT_EQ(level.triangle_count, report.levels[i].triangles);
    EXPECT_EQ(level.vertex_count, report.levels[i].vertices);
    EXPECT_EQ(level.bytes_end, report.levels[i].bytes_end);
    EXPECT_EQ(level.error, static_cast<float>(report.levels[i].error));
    EXPECT_EQ(level.error_rms, static_cast<float>(report.levels[i].error_rms));
  }
  EXPECT_EQ(report.levels.back().share, 1.0);
  EXPECT_EQ(report.levels.back().triangles, 960u);
  lithe_asset_close(asset);
}

TEST(Bake, RefitBringsLevelsCloser) {
  Model bumpy = test::tube(64, 96);
  for (glm::vec3& p : bumpy.positions) {
    const float bump = 0.2f * std::sin(9.0f * p.x + 5.0f * p.z) * std::cos(11.0f * p.y - 7.0f * p.z);
    p += bump * glm::vec3(p.x, p.y, 0.0f);
  }
  BakeOptions options = quick();
  options.levels = {0.2, 0.1, 0.05};
  const auto levels = [&](bool refit) {
    options.refit = refit;
    BakeReport report;
    bake(bumpy, options, &report);
    return report.levels;
  };
  const auto collapsed = levels(false), refit = levels(true);
  ASSERT_EQ(collapsed.size(), refit.size());
  for (size_t i = 0; i + 1 < refit.size(); ++i) {
    EXPECT_LT(refit[i].error_rms, 0.98 * collapsed[i].error_rms) << "level " << i;
  }
}

TEST(Bake, AReportUsedAgainIsFilledAnew) {
  const Model model = test::tube(6, 8);
  BakeReport report;
  bake(model, quick(), &report);
  const size_t levels = report.levels.size(), stages = report.stages.size(), warnings = report.warnings.size();
  bake(model, quick(), &report);
  EXPECT_EQ(report.levels.size(), levels);
  EXPECT_EQ(report.stages.size(), stages);
  EXPECT_EQ(report.warnings.size(), warnings);
}

TEST(Bake, TheSmallestShareIsWhereItEnds) {
  const Model model = test::tube(12, 40);
  BakeOptions options = quick();
  options.levels = {0.1};
  BakeReport report;
  bake(model, options, &report);
  ASSERT_EQ(report.levels.size(), 2u);
  EXPECT_LE(report.levels[0].triangles, 96u);
  EXPECT_GE(report.levels[0].triangles, 94u);
}

TEST(Bake, WarningsOfTheModelAreHandedOn) {
  Model model = test::tube(6, 8);
  model.warnings = {"something was repaired"};
  BakeReport report;
  bake(model, quick(), &report);
  ASSERT_FALSE(report.warnings.empty());
  EXPECT_EQ(report.warnings[0], "something was repaired");
}

}  // namespace
}  // namespace lithe::bake
