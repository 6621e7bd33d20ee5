// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/poses.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "arm.h"

namespace lithe::bake {
namespace {

constexpr double kTight = 1e-6;

void expectNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance = kTight) {
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], tolerance) << "component " << k;
}

Channel rotationChannel(uint32_t node, Channel::Interpolation interpolation, std::vector<float> times,
                        std::vector<glm::vec4> values) {
  return {node, Channel::Path::kRotation, interpolation, std::move(times), std::move(values)};
}

glm::vec4 aboutZ(double degrees) {
  const double half = degrees * std::numbers::pi / 360.0;
  return {0.0f, 0.0f, static_cast<float>(std::sin(half)), static_cast<float>(std::cos(half))};
}

TEST(RestPose, LeavesBindSpaceWhereRestIsBind) {
  const Model arm = makeArm();
  const std::vector<glm::dvec3> posed = skinPositions(arm, restPose(arm));
  for (size_t v = 0; v < posed.size(); ++v) expectNear(posed[v], glm::dvec3(arm.positions[v]));
}

TEST(RestPose, AppliesTranslationRotationAndScaleInThatOrder) {
  Model arm = makeArm();
  arm.nodes[0].rest = {{1, 2, 3}, glm::dquat(std::sqrt(0.5), 0, 0, std::sqrt(0.5)), {2, 1, 1}};
  // (3, 0, 0) scaled to (6, 0, 0), turned by 90 degrees about z to (0, 6, 0), moved.
  expectNear(skinPositions(arm, restPose(arm))[2], {1, 8, 3});
}

TEST(ClipPose, BendsTheElbowByHand) {
  Model arm = makeArm();
  arm.clips.push_back({"bend", 0, 1, {rotationChannel(1, Channel::Interpolation::kStep, {0.0f}, {aboutZ(90)})}});
  const std::vector<glm::dvec3> posed = skinPositions(arm, clipPose(arm, 0, 0.0));
  expectNear(posed[0], {1, 0, 0});        // upper arm only
  expectNear(posed[2], {2, 1, 0});        // forearm only: (3, 0, 0) about the elbow at (2, 0, 0)
  expectNear(posed[1], {2, 0, 0});        // the elbow itself
  expectNear(posed[3], {2.25, 0.25, 0});  // (2.5, 0, 0), half and half: the mean of (2.5, 0, 0) and (2, 0.5, 0)
}

TEST(ClipPose, InterpolatesRotationsAtConstantAngularSpeed) {
  Model arm = makeArm();
  arm.clips.push_back(
      {"bend", 0, 1, {rotationChannel(1, Channel::Interpolation::kLinear, {0.0f, 1.0f}, {aboutZ(0), aboutZ(120)})}});
  // A normalised linear blend would be at 28.3 degrees instead of 30.
  const double angle = 30.0 * std::numbers::pi / 180.0;
  expectNear(skinPositions(arm, clipPose(arm, 0, 0.25))[2], {2 + std::cos(angle), std::sin(angle), 0});
}

TEST(ClipPose, TakesTheShorterArc) {
  Model arm = makeArm();
  arm.clips.push_back(
      {"bend", 0, 1, {rotationChannel(1, Channel::Interpolation::kLinear, {0.0f, 1.0f}, {aboutZ(10), -aboutZ(30)})}});
  const double angle = 20.0 * std::numbers::pi / 180.0;
  expectNear(skinPositions(arm, clipPose(arm, 0, 0.5))[2], {2 + std::cos(angle), std::sin(angle), 0});
}

TEST(ClipPose, StepHoldsTheKeyBefore) {
  Model arm = makeArm();
  arm.clips.push_back(
      {"bend", 0, 2, {rotationChannel(1, Channel::Interpolation::kStep, {0.0f, 1.0f}, {aboutZ(0), aboutZ(90)})}});
  expectNear(skinPositions(arm, clipPose(arm, 0, 0.999))[2], {3, 0, 0});
  expectNear(skinPositions(arm, clipPose(arm, 0, 1.0))[2], {2, 1, 0});
}

TEST(ClipPose, CubicSplinesUseTangentsScaledByTheInterval) {
  Model arm = makeArm();
  Channel slide{0, Channel::Path::kTranslation, Channel::Interpolation::kCubicSpline, {0.0f, 2.0f}, {}};
  slide.values = {glm::vec4(9),          glm::vec4(0),          glm::vec4(1, 0, 0, 0),
                  glm::vec4(0, 1, 0, 0), glm::vec4(4, 0, 0, 0), glm::vec4(9)};
  arm.clips.push_back({"slide", 0, 2, {slide}});
  // Hermite at u = 1/2 over 2 s: (p0 + p1) / 2 + 2 s * (m0 - m1) / 8, with m0 = x and m1 = y.
  expectNear(skinPositions(arm, clipPose(arm, 0, 1.0))[0], glm::dvec3(1, 0, 0) + glm::dvec3(2 + 0.25, -0.25, 0));
}

TEST(ClipPose, HoldsTheEndsAndLeavesOtherNodesAtRest) {
  Model arm = makeArm();
  Channel grow{1, Channel::Path::kScale, Channel::Interpolation::kLinear, {1.0f, 2.0f}, {glm::vec4(1), glm::vec4(3)}};
  arm.clips.push_back({"grow", 1, 2, {grow}});
  expectNear(skinPositions(arm, clipPose(arm, 0, -5.0))[2], {3, 0, 0});
  expectNear(skinPositions(arm, clipPose(arm, 0, 99.0))[2], {5, 0, 0});
  expectNear(skinPositions(arm, clipPose(arm, 0, 99.0))[0], {1, 0, 0});
  EXPECT_EQ(clipPose(arm, 0, 99.0).clip, "grow");
  EXPECT_THROW(clipPose(arm, 1, 0.0), Error);
}

TEST(Palette, NoiseBelowFloatPrecisionVanishes) {
  Model arm = makeArm(), noisy = makeArm();
  arm.nodes[0].rest.rotation = glm::dquat(std::cos(0.3), 0, std::sin(0.3), 0);
  noisy.nodes[0].rest.rotation =
      glm::dquat(std::nextafter(std::cos(0.3), 2), 0, std::nextafter(std::sin(0.3), 2), 1e-17);
  EXPECT_EQ(restPose(arm).palette, restPose(noisy).palette);
}

TEST(LocalPose, NeedsOneTransformPerNode) {
  const Model arm = makeArm();
  EXPECT_THROW(localPose(arm, std::vector<Transform>(1)), Error);
}

TEST(PosedDiagonal, IsTheMeanOverPoses) {
  Model arm = makeArm();
  Channel grow{0, Channel::Path::kScale, Channel::Interpolation::kLinear, {0.0f, 1.0f}, {glm::vec4(1), glm::vec4(3)}};
  arm.clips.push_back({"grow", 0, 1, {grow}});
  EXPECT_NEAR(posedDiagonal(arm, {clipPose(arm, 0, 0)}), 2.0, kTight);
  EXPECT_NEAR(posedDiagonal(arm, {clipPose(arm, 0, 0), clipPose(arm, 0, 1)}), 4.0, kTight);
  EXPECT_EQ(posedDiagonal(arm, {}), 0.0);
}

TEST(SampledPoses, AreBoundedRepeatableAndOfSeveralStrengths) {
  const Model arm = makeArm();
  const std::vector<Pose> poses = sampledPoses(arm, 64), prefix = sampledPoses(arm, 7);
  double strongest = 0.0, mildest = 180.0;
  for (uint32_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ(sampledPoses(arm, 1, i)[0].palette, poses[i].palette);
    if (i < prefix.size()) {
      EXPECT_EQ(poses[i].palette, prefix[i].palette);
    }
    // The angle between forearm and upper arm, from the trace of the elbow's own rotation.
    const glm::dmat3 elbow = glm::transpose(glm::dmat3(poses[i].palette[0])) * glm::dmat3(poses[i].palette[1]);
    const double angle =
        std::acos(std::min(1.0, (elbow[0][0] + elbow[1][1] + elbow[2][2] - 1) / 2)) * 180 / std::numbers::pi;
    EXPECT_LE(angle, kSampledDegrees + 1e-3);
    const glm::dmat3 root(poses[i].palette[0]);
    const double root_angle =
        std::acos(std::min(1.0, (root[0][0] + root[1][1] + root[2][2] - 1) / 2)) * 180 / std::numbers::pi;
    EXPECT_LE(root_angle, kSampledDegrees * kSampledRootShare + 1e-3);
    strongest = std::max(strongest, angle);
    mildest = std::min(mildest, angle);
  }
  EXPECT_GT(strongest, 0.8 * kSampledDegrees);
  EXPECT_LT(mildest, 0.2 * kSampledDegrees);
}

}  // namespace
}  // namespace lithe::bake
