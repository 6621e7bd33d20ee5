// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/skin_weights.h"

#include <gtest/gtest.h>

#include <random>

namespace lithe::bake {
namespace {

uint32_t sumOf(const QuantizedSkin& skin) {
  uint32_t sum = 0;
  for (uint32_t i = 0; i < skin.count; ++i) sum += skin.weight[i];
  return sum;
}

void expectValid(const QuantizedSkin& skin, uint32_t one, uint32_t cap) {
  EXPECT_EQ(sumOf(skin), one);
  EXPECT_GE(skin.count, 1);
  EXPECT_LE(skin.count, cap);
  for (uint32_t i = 0; i < 8; ++i) EXPECT_EQ(skin.weight[i] > 0, i < skin.count);
  for (uint32_t i = 1; i < skin.count; ++i) {
    EXPECT_TRUE(skin.weight[i - 1] > skin.weight[i] ||
                (skin.weight[i - 1] == skin.weight[i] && skin.joint[i - 1] < skin.joint[i]));
  }
}

QuantizedSkin randomSkin(std::mt19937& random, uint32_t count) {
  std::vector<uint16_t> joints;
  std::vector<double> weights;
  while (joints.size() < count) {
    const auto joint = static_cast<uint16_t>(random() % 12);
    if (std::find(joints.begin(), joints.end(), joint) != joints.end()) continue;
    joints.push_back(joint);
    weights.push_back(1.0 + random() % 1000);
  }
  return quantizeSkin(joints, weights, 255);
}

TEST(QuantizeSkin, GivesTheRemainderToTheLargestFractions) {
  const uint16_t joints[] = {7, 3, 5};
  const double weights[] = {1.0, 1.0, 1.0};
  const QuantizedSkin skin = quantizeSkin(joints, weights, 256);
  EXPECT_EQ(skin.weight[0], 86);
  EXPECT_EQ(skin.joint[0], 7);  // the tie goes to the first given
  EXPECT_EQ(skin.weight[1], 85);
  EXPECT_EQ(skin.joint[1], 3);
}

TEST(QuantizeSkin, DropsWhatRoundsToZero) {
  const uint16_t joints[] = {1, 2};
  const double weights[] = {0.999, 0.001};
  const QuantizedSkin skin = quantizeSkin(joints, weights, 255);
  expectValid(skin, 255, 1);
  EXPECT_EQ(skin.joint[0], 1);
}

TEST(InterpolateSkin, EndsAreTheChildren) {
  std::mt19937 random(5);
  for (int i = 0; i < 200; ++i) {
    const QuantizedSkin v = randomSkin(random, 1 + random() % 4), u = randomSkin(random, 1 + random() % 4);
    EXPECT_EQ(interpolateSkin(v, u, 0, 255, 4), v);
    EXPECT_EQ(interpolateSkin(v, u, 8, 255, 4), u);
  }
}

TEST(InterpolateSkin, IsValidAndSymmetricForEveryParameter) {
  std::mt19937 random(11);
  for (int i = 0; i < 500; ++i) {
    const QuantizedSkin v = randomSkin(random, 1 + random() % 4), u = randomSkin(random, 1 + random() % 4);
    for (int t8 = 0; t8 <= 8; ++t8) {
      const QuantizedSkin skin = interpolateSkin(v, u, t8, 255, 4);
      expectValid(skin, 255, 4);
      EXPECT_EQ(skin, interpolateSkin(u, v, 8 - t8, 255, 4));
    }
  }
}

TEST(InterpolateSkin, ScalesUpWhatTheCapKeeps) {
  const uint16_t left[] = {0, 1}, right[] = {2, 3};
  const double halves[] = {3.0, 1.0};
  const QuantizedSkin v = quantizeSkin(left, halves, 200), u = quantizeSkin(right, halves, 200);
  // Halfway: 75, 25, 75, 25; the cap of three keeps 75, 75, 25 of 175 -> 85, 85, 28 of 200, two missing.
  const QuantizedSkin skin = interpolateSkin(v, u, 4, 200, 3);
  ASSERT_EQ(skin.count, 3);
  EXPECT_EQ(skin.joint[0], 0);
  EXPECT_EQ(skin.weight[0], 87);
  EXPECT_EQ(skin.weight[1], 85);
  EXPECT_EQ(skin.joint[2], 1);
  EXPECT_EQ(skin.weight[2], 28);
}

}  // namespace
}  // namespace lithe::bake
