// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Real characters: every one reaches any target, and the error stays where it was when this was written (with some
// room).
#include <gtest/gtest.h>

#include <filesystem>

#include "lithe/bake/compare.h"
#include "lithe/bake/cut.h"
#include "lithe/bake/generate.h"
#include "lithe/bake/import.h"
#include "lithe/bake/poses.h"
#include "meshes.h"

namespace lithe::bake {
namespace {

using namespace test;

std::filesystem::path modelPath(const std::string& name) {
  return std::filesystem::path(LITHE_SHARED_DIR) / "models" / name;
}

struct Baked {
  Model model;
  Mesh mesh;
  CollapseSequence sequence;
};

Baked bakeModel(Model model, const PoseOptions& pose_options, const SimplifyOptions& options,
                const WeldOptions& weld_options = {}) {
  Baked baked{std::move(model), {}, {}};
  const std::vector<Pose> poses = choosePoses(baked.model, pose_options);
  std::vector<std::string> warnings;
  baked.mesh = weld(baked.model, poses, weld_options, warnings);
  baked.sequence = simplify(baked.mesh, baked.model.joints, poses, options);
  return baked;
}

/// Posed RMS distance over the rest diagonal, of the cut at `triangles`.
double errorAt(const Baked& baked, uint32_t triangles, const std::string& animation) {
  const Model cut = cutToModel(baked.model, baked.mesh, baked.sequence, triangles);
  EXPECT_LE(cut.triangles.size(), triangles);
  EXPECT_GE(cut.triangles.size(), triangles - 3u);
  CompareOptions options;
  options.animation = animation;
  options.frames = 10;
  options.samples = 4000;
  options.include_rigid = true;
  const CompareReport report = compare(baked.model, cut, options);
  EXPECT_LE(report.seam.opened, 1e-7);
  return report.mean.rms;
}

class SlowCharacters : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Models, SlowCharacters,
                         testing::Values("sintel.glb", "valid_asian_f3.glb", "mannequiny.glb", "shark.glb",
                                         "knight.glb", "robot.glb", "spider.glb", "fox.glb", "dragon.glb", "bunny.gltf",
                                         "eight_influences.glb", "alien/Alien_Scolitex.gltf", "pumpkin/scene.gltf"),
                         [](const auto& named) {
                           std::string name = named.param.substr(0, named.param.find_first_of("./"));
                           return name;
                         });

TEST_P(SlowCharacters, ReachesOnePercentAndKeepsEveryPromise) {
  if (!std::filesystem::exists(modelPath(GetParam()))) GTEST_SKIP() << "no " << modelPath(GetParam());
  SimplifyOptions options;
  const Baked baked = bakeModel(importGltf(modelPath(GetParam())), {}, options);
  ASSERT_FALSE(baked.sequence.collapses.empty());
  EXPECT_LE(baked.sequence.collapses.back().triangles, baked.mesh.triangleCount() / 100);
  for (size_t i = 1; i < baked.sequence.collapses.size(); ++i) {
    ASSERT_LE(baked.sequence.collapses[i].triangles, baked.sequence.collapses[i - 1].triangles);
  }
  if (baked.mesh.triangleCount() < 10000) expectValid(baked.mesh, baked.sequence, options);
}

TEST(SlowQuality, SintelStaysWithinItsBounds) {
  if (!std::filesystem::exists(modelPath("sintel.glb"))) GTEST_SKIP() << "no " << modelPath("sintel.glb");
  const Baked baked = bakeModel(importGltf(modelPath("sintel.glb")), {}, {});
  EXPECT_LT(errorAt(baked, 8261, "all"), 2.6e-4);
  EXPECT_LT(errorAt(baked, 4130, "all"), 5.5e-4);
  EXPECT_LT(errorAt(baked, 2065, "all"), 10e-4);
  EXPECT_LT(errorAt(baked, 826, "all"), 22e-4);
}

TEST(SlowQuality, FourInfluencesLoseAtMostThreePercentAgainstEight) {
  const auto path = modelPath("eight_influences.glb");
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  const auto error = [&](uint32_t max_influences) {
    WeldOptions weld_options;
    weld_options.max_influences = max_influences;
    return errorAt(bakeModel(importGltf(path), {}, {}, weld_options), 422, "all");  // 20 %
  };
  EXPECT_LE(error(4), 1.03 * error(8));
}

TEST(SlowQuality, ColumnBeatsTheOtherMetrics) {
  PoseOptions examples;
  examples.clips = {"examples"};
  const auto error = [&](const std::string& metric) {
    SimplifyOptions options;
    options.metric = metric;
    options.min_triangles = 3000;
    return errorAt(bakeModel(generate("column"), examples, options), 3000, "test");
  };
  const double articulated = error("articulated");
  EXPECT_LT(articulated, 0.4e-4);
  EXPECT_LT(articulated, 0.95 * error("dsd"));
  EXPECT_LT(articulated, 0.95 * error("dod"));
  EXPECT_LT(articulated, 0.6 * error("pose-independent"));
  EXPECT_LT(articulated, 0.3 * error("rest"));
}

}  // namespace
}  // namespace lithe::bake
