// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "arm.h"
#include "lithe/bake/poses.h"

namespace lithe::bake {
namespace {

/// Turns the elbow about z through the given angles, one key per second.
Clip bendClip(const std::string& name, const std::vector<double>& degrees) {
  Channel channel{1, Channel::Path::kRotation, Channel::Interpolation::kLinear, {}, {}};
  for (size_t i = 0; i < degrees.size(); ++i) {
    const double half = degrees[i] * M_PI / 360.0;
    channel.times.push_back(static_cast<float>(i));
    channel.values.emplace_back(0.0f, 0.0f, std::sin(half), std::cos(half));
  }
  return {name, 0.0, static_cast<double>(degrees.size() - 1), {channel}};
}

std::string message(const Model& model, const PoseOptions& options) {
  try {
    choosePoses(model, options);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

TEST(ChoosePoses, PicksTheExtremesOfAClip) {
  Model arm = makeArm();
  arm.clips.push_back(bendClip("swing", {0, 90, 0, -60}));
  const std::vector<Pose> poses = choosePoses(arm, {2, {}, {}});
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_DOUBLE_EQ(poses[0].time, 1.0);  // the farthest from rest
  EXPECT_DOUBLE_EQ(poses[1].time, 3.0);  // the farthest from that
}

TEST(ChoosePoses, FindsTheThirdBetweenTwoExtremes) {
  Model arm = makeArm();
  arm.clips.push_back(bendClip("swing", {-80, 80}));
  const std::vector<Pose> poses = choosePoses(arm, {3, {}, {}});
  ASSERT_EQ(poses.size(), 3u);
  EXPECT_NEAR(poses[2].time, 0.5, 0.02);
}

TEST(ChoosePoses, IgnoresWhereTheCharacterStands) {
  Model arm = makeArm();
  arm.clips.push_back(bendClip("walk", {0, 30}));
  arm.clips[0].channels.push_back({0,
                                   Channel::Path::kTranslation,
                                   Channel::Interpolation::kLinear,
                                   {0.0f, 0.5f, 1.0f},
                                   {glm::vec4(500, 0, 0, 0), glm::vec4(0), glm::vec4(0)}});
  EXPECT_DOUBLE_EQ(choosePoses(arm, {1, {}, {}})[0].time, 1.0);
}

TEST(ChoosePoses, GivesOnlyDistinctPoses) {
  Model arm = makeArm();
  arm.clips.push_back(bendClip("still", {45, 45, 45}));
  EXPECT_EQ(choosePoses(arm, {16, {}, {}}).size(), 1u);
}

TEST(ChoosePoses, TakesOnlyNamedClips) {
  Model arm = makeArm();
  arm.clips.push_back(bendClip("large", {0, 90}));
  arm.clips.push_back(bendClip("small", {0, 10}));
  for (const Pose& pose : choosePoses(arm, {4, {"small"}, {}})) EXPECT_EQ(pose.clip, "small");
  EXPECT_EQ(message(arm, {4, {"huge"}, {}}), "there is no clip 'huge'; the file has 'large', 'small'");
  EXPECT_EQ(message(makeArm(), {4, {"huge"}, {}}), "there is no clip 'huge'; the file has none");
}

TEST(ChoosePoses, EveryClipIsRepresentedHoweverMany) {
  Model arm = makeArm();
  for (int i = 0; i < 600; ++i) arm.clips.push_back(bendClip(std::to_string(i), {0.0, 0.2 * i, 0.0}));
  // 600 clips of 2 s; the distinct poses are those of the middle of each clip.
  std::set<std::string> clips;
  for (const Pose& pose : choosePoses(arm, {600, {}, {}})) clips.insert(pose.clip);
  EXPECT_EQ(clips.size(), 600u);
}

TEST(ChoosePoses, KeepsTheKeysOfSparseClips) {
  Model arm = makeArm();
  arm.clips.push_back(bendClip("key", {0, 90, 0}));
  arm.clips[0].channels[0].times = {0.0f, 0.517f, 2.0f};
  EXPECT_FLOAT_EQ(static_cast<float>(choosePoses(arm, {1, {}, {}})[0].time), 0.517f);
}

TEST(ChoosePoses, SamplesWithoutClipsAndIncludesRest) {
  const Model arm = makeArm();
  const std::vector<Pose> poses = choosePoses(arm, {5, {}, {}});
  ASSERT_EQ(poses.size(), 5u);
  EXPECT_EQ(poses[0].palette, restPose(arm).palette);
  EXPECT_NE(poses[1].palette, poses[0].palette);
  EXPECT_THROW(choosePoses(arm, {0, {}, {}}), Error);
}

TEST(ChoosePoses, IsRepeatable) {
  Model arm = makeArm();
  arm.clips.push_back(bendClip("swing", {0, 90, 13, -60, 7}));
  const std::vector<Pose> a = choosePoses(arm, {8, {}, {}}), b = choosePoses(arm, {8, {}, {}});
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].time, b[i].time);
    EXPECT_EQ(a[i].palette, b[i].palette);
  }
}

}  // namespace
}  // namespace lithe::bake
