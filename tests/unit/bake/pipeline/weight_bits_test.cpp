// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "weight_bits.h"

#include <gtest/gtest.h>

#include "lithe/bake/poses.h"

namespace lithe::bake {
namespace {

/// Vertices 0 .. 1 along x on two joints, half each; joint 1 is moved by `apart` along x in the only pose.
uint32_t bitsFor(double apart, uint32_t position_bits, uint32_t influences = 2) {
  Model model;
  model.joints.resize(2);
  for (float x : {0.0f, 0.25f, 0.5f, 1.0f}) {
    model.positions.push_back({x, 0, 0});
    Skin skin;
    skin.count = static_cast<uint8_t>(influences);
    skin.joint = {0, 1};
    skin.weight = {influences == 2 ? 0.5f : 1.0f, influences == 2 ? 0.5f : 0.0f};
    model.skins.push_back(skin);
  }
  Pose pose;
  pose.palette.assign(2, glm::dmat4(1.0));
  pose.palette[1][3].x = apart;
  return chooseWeightBits(model, {pose}, position_bits);
}

// All vertices move alike, so the posed diagonal is 1: the fewest bits with apart / 2^bits <= 1 / 2^position_bits.
TEST(WeightBits, AsManyAsTheJointsLieApart) {
  EXPECT_EQ(bitsFor(2.0, 10), 10u);
  EXPECT_EQ(bitsFor(1.0, 10), 9u);
  EXPECT_EQ(bitsFor(1.02, 10), 10u);
  EXPECT_EQ(bitsFor(4.0, 9), 10u);
}

TEST(WeightBits, AtLeastEightAndAtMostTwelve) {
  EXPECT_EQ(bitsFor(0.0, 14), kLeastWeightBits);
  EXPECT_EQ(bitsFor(1e-6, 14), kLeastWeightBits);
  EXPECT_EQ(bitsFor(100.0, 14), kMostWeightBits);
}

TEST(WeightBits, WhatHasOneJointNeedsNone) { EXPECT_EQ(bitsFor(100.0, 14, 1), kLeastWeightBits); }

TEST(WeightBits, NoPosesAndNoVerticesAreFine) {
  EXPECT_EQ(chooseWeightBits(Model(), {}, 14), kLeastWeightBits);
  EXPECT_EQ(chooseWeightBits(Model(), {Pose()}, 14), kLeastWeightBits);
}

}  // namespace
}  // namespace lithe::bake
