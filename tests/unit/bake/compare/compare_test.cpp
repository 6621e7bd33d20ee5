// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/compare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "lithe/bake/poses.h"
#include "shapes.h"

namespace lithe::bake {
namespace {

using test::tube;

CompareOptions quick(uint32_t frames = 4) {
  CompareOptions options;
  options.frames = frames;
  options.samples = 3000;
  return options;
}

std::vector<std::pair<std::string, double>> framesOf(const CompareReport& report) {
  std::vector<std::pair<std::string, double>> frames;
  for (const FrameReport& frame : report.frames) frames.emplace_back(frame.clip, frame.time);
  return frames;
}

/// The model with every joint listed in another order and renamed to nothing else: only names can match it.
Model withReversedJoints(Model model) {
  std::reverse(model.joints.begin(), model.joints.end());
  const uint16_t last = static_cast<uint16_t>(model.joints.size() - 1);
  for (Skin& skin : model.skins) {
    for (uint32_t k = 0; k < skin.count; ++k) skin.joint[k] = static_cast<uint16_t>(last - skin.joint[k]);
  }
  return model;
}

TEST(Compare, AModelWithItselfIsWithoutError) {
  const Model model = tube(24, 16);
  const CompareReport report = compare(model, model, quick());
  EXPECT_LT(report.worst.rms, 1e-12);
  EXPECT_LT(report.worst.max, 1e-12);
  EXPECT_LT(report.worst.normal_degrees, 1e-5);
  EXPECT_EQ(report.worst.flipped, 0.0);
  EXPECT_LT(report.worst.uv_rms, 1e-6);
  EXPECT_LT(report.seam.gap, 1e-12);
  EXPECT_LT(report.weight_sum_error, 1e-6);
  EXPECT_EQ(report.original_triangles, 768u);
  EXPECT_EQ(report.simplified_vertices, 25u * 17u);
  EXPECT_TRUE(report.has_uv);
}

TEST(Compare, AShiftedModelIsOffByTheShiftInUnitsOfTheRestDiagonal) {
  const Model original = tube(64, 16);
  Model shifted = original;
  for (size_t i = 0; i < shifted.positions.size(); ++i) shifted.positions[i] += 0.05f * shifted.normals[i];
  CompareOptions options = quick();
  options.animation = "none";
  const CompareReport report = compare(original, shifted, options);
  ASSERT_EQ(report.frames.size(), 1u);
  EXPECT_NEAR(report.mean.rms * report.rest_diagonal, 0.05, 2e-4);
  EXPECT_NEAR(report.mean.max * report.rest_diagonal, 0.05, 2e-4);
  EXPECT_NEAR(report.rest_diagonal, std::sqrt(18.0), 1e-12);
}

TEST(Compare, MeasuresThePosedSurfaceNotTheRestSurface) {
  // The same rest shape, but every vertex hangs on its heavier joint alone: exact at rest, far off when the elbow
  // bends.
  const Model original = tube(24, 16);
  Model rigid = original;
  for (Skin& skin : rigid.skins) {
    skin.count = 1;
    skin.weight[0] = 1.0f;
  }
  CompareOptions options = quick();
  options.animation = "none";
  EXPECT_LT(compare(original, rigid, options).mean.rms, 1e-12);
  options.animation = "bend";
  const CompareReport bent = compare(original, rigid, options);
  EXPECT_GT(bent.worst.rms, 0.005);
  EXPECT_LT(bent.frames.front().symmetric.rms, bent.frames.back().symmetric.rms);
}

TEST(Compare, MatchesJointsByName) {
  const Model original = tube(24, 16);
  EXPECT_LT(compare(original, withReversedJoints(original), quick()).worst.max, 1e-9);
}

TEST(Compare, MatchesJointsByIndexWhereNamesSayNothing) {
  const Model original = tube(24, 16);
  Model nameless = original;
  for (Node& node : nameless.nodes) node.name.clear();
  EXPECT_LT(compare(original, nameless, quick()).worst.max, 1e-12);
  Model nameless_original = nameless;
  EXPECT_LT(compare(nameless_original, original, quick()).worst.max, 1e-12);
}

TEST(Compare, EachModelUsesItsOwnInverseBinds) {
  // The simplified model is bound in other units and elsewhere: its inverse binds undo that.
  const Model original = tube(24, 16);
  Model rebound = original;
  for (glm::vec3& position : rebound.positions) position = position * 4.0f + glm::vec3(1, 2, 3);
  glm::dmat4 back(0.25);
  back[3] = {-0.25, -0.5, -0.75, 1.0};
  for (Joint& joint : rebound.joints) joint.inverse_bind = joint.inverse_bind * back;
  EXPECT_LT(compare(original, rebound, quick()).worst.max, 1e-6);
}

TEST(Compare, CountsTheFlippedShareOfTheArea) {
  Model original = tube(24, 16);
  Model flipped = original;
  for (size_t i = 0; i < flipped.triangles.size() / 4; ++i) std::swap(flipped.triangles[i][1], flipped.triangles[i][2]);
  CompareOptions options = quick();
  options.animation = "none";
  const CompareReport report = compare(original, flipped, options);
  EXPECT_NEAR(report.mean.flipped, 0.25, 0.01);
  EXPECT_LT(report.mean.rms, 1e-12);
  EXPECT_LT(report.mean.normal_degrees, 1e-5);  // the vertex normals are as they were
}

TEST(Compare, NormalDeviationIsTheRmsAngle) {
  const Model original = tube(48, 8);
  Model tilted = original;
  const float cosine = std::cos(0.2f), sine = std::sin(0.2f);
  for (glm::vec3& normal : tilted.normals) normal = cosine * normal + sine * glm::vec3(0, 0, 1);
  CompareOptions options = quick();
  options.animation = "none";
  EXPECT_NEAR(compare(original, tilted, options).mean.normal_degrees, glm::degrees(0.2), 0.05);
}

TEST(Compare, UvDeviationIsMeasuredInUvUnits) {
  const Model original = tube(24, 16);
  Model shifted = original;
  for (glm::vec2& uv : shifted.uvs[0]) uv += glm::vec2(0.03f, 0.04f);
  const CompareReport report = compare(original, shifted, quick());
  EXPECT_NEAR(report.mean.uv_rms, 0.05, 2e-3);
  EXPECT_NEAR(report.mean.uv_median, 0.05, 1e-5);
  shifted.uvs[0].clear();
  shifted.attributes.uv_sets = 0;
  EXPECT_FALSE(compare(original, shifted, quick()).has_uv);
}

TEST(Compare, ASeamWhoseSidesAreSkinnedApartIsAnOpenedGap) {
  const Model original = tube(24, 16);
  Model torn = original;
  for (size_t vertex = 24; vertex < torn.skins.size();
       vertex += 25) {  // the last vertex of every ring: one side of the seam
    torn.skins[vertex].count = 1;
    torn.skins[vertex].weight[0] = 1.0f;
  }
  CompareOptions options = quick();
  options.animation = "bend";
  const CompareReport report = compare(original, torn, options);
  EXPECT_GT(report.seam.gap, 0.01);
  EXPECT_NEAR(report.seam.opened, report.seam.gap, 1e-12);
  const CompareReport reverse = compare(torn, original, options);
  EXPECT_LT(reverse.seam.gap, 1e-12);
  const CompareReport both =
      compare(torn, torn, options);  // the original is torn itself: a gap, but nothing was opened
  EXPECT_NEAR(both.seam.gap, report.seam.gap, 1e-9);
  EXPECT_LT(both.seam.opened, 1e-12);
}

TEST(Compare, MeasuresSkinnedPartsUnlessRigidOnesAreAskedFor) {
  const Model original = tube(24, 16);
  Model with_rigid = original;
  with_rigid.parts.push_back({"hat", kNone, 1, 1, 0});
  const uint32_t first = static_cast<uint32_t>(with_rigid.positions.size());
  for (const glm::vec3 corner : {glm::vec3(0, 0, 9), glm::vec3(1, 0, 9), glm::vec3(0, 1, 9)}) {
    with_rigid.positions.push_back(corner);
    with_rigid.normals.emplace_back(0, 0, 1);
    with_rigid.uvs[0].emplace_back(0, 0);
    Skin skin;
    skin.count = 1;
    skin.joint[0] = 1;
    skin.weight[0] = 1.0f;
    with_rigid.skins.push_back(skin);
  }
  with_rigid.triangles.push_back({first, first + 1, first + 2});
  with_rigid.triangle_part.push_back(1);
  CompareOptions options = quick();
  EXPECT_LT(compare(original, with_rigid, options).worst.max, 1e-12);
  options.include_rigid = true;
  EXPECT_GT(compare(original, with_rigid, options).worst.max, 1.0);
}

TEST(Compare, CountsTheSamplesBeyondADistance) {
  // One half of the tube, by area, is pushed out by 0.05.
  const Model original = tube(64, 16);
  Model pushed = original;
  for (size_t i = 0; i < pushed.positions.size(); ++i)
    if (pushed.positions[i].z > 2.01f) pushed.positions[i] += 0.05f * pushed.normals[i];
  CompareOptions options = quick();
  options.animation = "none";
  EXPECT_EQ(compare(original, pushed, options).mean.beyond, 0.0);
  EXPECT_FALSE(compare(original, pushed, options).beyond.has_value());
  const auto beyond = [&](double distance) {
    options.beyond = distance;
    return compare(original, pushed, options).mean.beyond;
  };
  EXPECT_NEAR(beyond(0.045), 0.5, 0.05);
  EXPECT_EQ(beyond(0.0501), 0.0);
  EXPECT_GT(beyond(0.0), 0.5);
}

TEST(Compare, TheReportDoesNotDependOnTheNumberOfThreads) {
  const Model original = tube(40, 20), simplified = tube(10, 8);
  CompareOptions options = quick(7);
  options.threads = 1;
  const std::string one = compareJson(compare(original, simplified, options));
  for (const uint32_t threads : {2u, 5u, 16u}) {
    options.threads = threads;
    EXPECT_EQ(compareJson(compare(original, simplified, options)), one) << threads;
  }
}

TEST(CompareFrames, AreSpreadByDuration) {
  const Model model = tube(4, 2);  // bend lasts 1 s, still 2 s
  using Frames = std::vector<std::pair<std::string, double>>;
  EXPECT_EQ(framesOf(compare(model, model, quick(3))), (Frames{{"bend", 0.5}, {"still", 0.5}, {"still", 1.5}}));
  EXPECT_EQ(framesOf(compare(model, model, quick(1))), (Frames{{"bend", 0.5}}));
  CompareOptions ends = quick(3);
  ends.phase = FramePhase::kEnds;
  EXPECT_EQ(framesOf(compare(model, model, ends)), (Frames{{"bend", 0.5}, {"still", 0.0}, {"still", 2.0}}));
  ends.animation = "1";
  EXPECT_EQ(framesOf(compare(model, model, ends)), (Frames{{"still", 0.0}, {"still", 1.0}, {"still", 2.0}}));
}

TEST(CompareFrames, BetweenIsHalfwayBetweenWhatABakeMaySee) {
  const Model model = tube(4, 2);
  CompareOptions options = quick(7);
  options.phase = FramePhase::kBetween;
  for (const auto& [clip, time] : framesOf(compare(model, model, options))) {
    const double steps = time * kCandidateRate;
    EXPECT_NEAR(steps - std::floor(steps), 0.5, 1e-9) << clip << " " << time;
  }
}

TEST(CompareFrames, SampledPosesBeginWhereAsked) {
  Model model = tube(12, 8), rigid = model;
  for (Skin& skin : rigid.skins) skin.count = 1;
  CompareOptions options = quick(6);
  options.animation = "sampled";
  const CompareReport all = compare(model, rigid, options);
  options.first_pose = 4;
  options.frames = 2;
  options.samples = 20000;
  const CompareReport last = compare(model, rigid, options);
  ASSERT_EQ(last.frames.size(), 2u);
  for (size_t i = 0; i < 2; ++i)
    EXPECT_NEAR(last.frames[i].symmetric.rms, all.frames[4 + i].symmetric.rms, 0.1 * last.frames[i].symmetric.rms);
  EXPECT_GT(std::abs(last.frames[0].symmetric.rms - all.frames[0].symmetric.rms), 0.2 * last.frames[0].symmetric.rms);
}

TEST(CompareFrames, ZeroMeansEveryThirtiethOfASecond) {
  const Model model = tube(4, 2);
  CompareOptions options = quick(0);
  options.samples = 10;
  options.animation = "bend";
  const CompareReport report = compare(model, model, options);
  ASSERT_EQ(report.frames.size(), 31u);
  EXPECT_EQ(report.frames.front().time, 0.0);
  EXPECT_NEAR(report.frames[1].time, 1.0 / 30.0, 1e-12);
  EXPECT_EQ(report.frames.back().time, 1.0);
}

TEST(CompareFrames, AModelWithoutClipsIsComparedInSampledPoses) {
  Model model = tube(12, 8);
  model.clips.clear();
  Model rigid = model;
  for (Skin& skin : rigid.skins) skin.count = 1;
  const CompareReport report = compare(model, rigid, quick(6));
  ASSERT_EQ(report.frames.size(), 6u);
  EXPECT_GT(report.worst.rms, 1e-3);
  EXPECT_LT(compare(model, model, quick(6)).worst.rms, 1e-12);
}

std::string messageOf(const Model& original, const Model& simplified, const CompareOptions& options) {
  try {
    compare(original, simplified, options);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

TEST(CompareErrors, SayWhatIsWrong) {
  const Model model = tube(4, 2);
  CompareOptions options = quick();
  options.animation = "dance";
  EXPECT_NE(messageOf(model, model, options).find("'dance': choose one of bend, still"), std::string::npos);
  options = quick();
  options.samples = 0;
  EXPECT_NE(messageOf(model, model, options).find("1 to 10,000,000"), std::string::npos);
  Model empty = model;
  empty.triangles.clear();
  empty.triangle_part.clear();
  EXPECT_NE(messageOf(model, empty, quick()).find("simplified model has no skinned triangle"), std::string::npos);
  Model stranger = model;
  stranger.nodes.push_back({"tail", 1, {}});
  stranger.joints.push_back({2, glm::dmat4(1.0)});
  EXPECT_NE(messageOf(model, stranger, quick()).find("'tail'"), std::string::npos);
}

TEST(CompareReports, TextAndJsonSayTheSame) {
  const CompareReport report = compare(tube(24, 16), tube(12, 8), quick(2));
  const nlohmann::json json = nlohmann::json::parse(compareJson(report));
  EXPECT_EQ(json["original"]["triangles"], 768);
  EXPECT_EQ(json["simplified"]["triangles"], 192);
  EXPECT_DOUBLE_EQ(json["rms_mean"].get<double>(), report.mean.rms);
  EXPECT_DOUBLE_EQ(json["rms_mean_absolute"].get<double>(), report.mean.rms * report.rest_diagonal);
  EXPECT_EQ(json["frames"].size(), 2u);
  EXPECT_DOUBLE_EQ(json["frames"][0]["original_to_simplified"]["max"].get<double>(),
                   report.frames[0].original_to_simplified.max);
  EXPECT_DOUBLE_EQ(json["mean_of_frames"]["silhouette"].get<double>(), report.mean_silhouette);
  EXPECT_DOUBLE_EQ(json["worst_frame"]["silhouette"].get<double>(), report.worst_silhouette);
  EXPECT_DOUBLE_EQ(json["frames"][1]["silhouette"].get<double>(), report.frames[1].silhouette);
  const std::string text = compareText(report);
  char headline[64];
  std::snprintf(headline, sizeof headline, "rms_mean %.4e", report.mean.rms);
  EXPECT_NE(text.find(headline), std::string::npos) << text;
  EXPECT_NE(text.find("bend 0.500 s"), std::string::npos) << text;
}

}  // namespace
}  // namespace lithe::bake
