// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "hand_made_asset.h"

namespace lithe::test {
namespace {

std::vector<float> randomPalette(Random& random, uint32_t joints) {
  std::vector<float> palette(12 * joints);
  const double size = std::exp2(20 * random.unit() - 10);
  for (float& x : palette) x = static_cast<float>(size * (2 * random.unit() - 1));
  return palette;
}

/// A vertex skinned in float, as a shader would.
std::array<float, 3> posed(const HandNode& node, const std::vector<float>& palette, uint32_t weight_bits) {
  const float bind[4] = {-1.5f + 0x1p-9f * static_cast<float>(node.position[0]),
                         2.0f + 0x1p-9f * static_cast<float>(node.position[1]),
                         0.125f + 0x1p-9f * static_cast<float>(node.position[2]), 1.0f};
  const float one = static_cast<float>((1u << weight_bits) - 1);
  std::array<float, 3> point = {};
  for (uint32_t i = 0; i < node.skin.count; ++i)
    for (uint32_t row = 0; row < 3; ++row) {
      const float* m = &palette[12 * node.skin.joint[i] + 4 * row];
      float x = 0;
      for (uint32_t c = 0; c < 4; ++c) x += m[c] * bind[c];
      point[row] += static_cast<float>(node.skin.weight[i]) / one * x;
    }
  return point;
}

TEST(PosedBox, HoldsEveryPosedNodeOfEveryLevel) {
  Random random(5);
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    const HandMade hand({}, seed);
    const auto asset = hand.open();
    for (uint32_t trial = 0; trial < 200; ++trial) {
      const std::vector<float> palette = randomPalette(random, 7);
      float box[6];
      lithe_asset_posed_box(asset.get(), palette.data(), box);
      for (const HandNode& node : hand.nodes) {
        const auto point = posed(node, palette, 8);
        for (uint32_t c = 0; c < 3; ++c) {
          ASSERT_GE(point[c], box[c]);
          ASSERT_LE(point[c], box[3 + c]);
        }
      }
    }
  }
}

// With one identity matrix for all, the box is the vertices' own, but for rounding.
TEST(PosedBox, IsTight) {
  const HandMade hand({}, 2);
  const auto asset = hand.open();
  std::vector<float> palette(12 * 7);
  for (uint32_t j = 0; j < 7; ++j)
    for (uint32_t c = 0; c < 3; ++c) palette[12 * j + 5 * c] = 1;
  float box[6];
  lithe_asset_posed_box(asset.get(), palette.data(), box);
  const float origin[3] = {-1.5f, 2.0f, 0.125f};
  for (uint32_t c = 0; c < 3; ++c) {
    int32_t least = 1 << 20, greatest = 0;
    for (const HandNode& node : hand.nodes) {
      least = std::min(least, node.position[c]);
      greatest = std::max(greatest, node.position[c]);
    }
    // Joints' boxes end where one of the 256 cells does that the grid has along each axis.
    const int32_t cell = 1 << (AssetShape{}.position_bits - 8);
    EXPECT_NEAR(box[c], origin[c] + 0x1p-9 * (least / cell * cell), 2e-4);
    EXPECT_NEAR(box[3 + c], origin[c] + 0x1p-9 * ((greatest / cell + 1) * cell - 1), 2e-4);
  }
}

// Joints that influence nothing do not count, wherever their matrices put things.
TEST(PosedBox, LeavesOutUnusedJoints) {
  AssetShape shape;
  shape.joints = 40;
  shape.splits = {};
  shape.base_nodes = 3;
  const HandMade hand(shape, 3);
  const auto asset = hand.open();
  std::vector<bool> used(40, false);
  for (const HandNode& node : hand.nodes)
    for (uint32_t i = 0; i < node.skin.count; ++i) used[node.skin.joint[i]] = true;
  std::vector<float> palette(12 * 40);
  for (uint32_t j = 0; j < 40; ++j)
    if (!used[j]) palette[12 * j + 3] = 1e6f;
  float box[6];
  lithe_asset_posed_box(asset.get(), palette.data(), box);
  EXPECT_EQ(box[3], 0.0f);
}

TEST(PosedBox, BadArgumentsLeaveTheBoxAlone) {
  const HandMade hand({}, 2);
  const auto asset = hand.open();
  float box[6] = {7, 7, 7, 7, 7, 7};
  lithe_asset_posed_box(nullptr, box, box);
  lithe_asset_posed_box(asset.get(), nullptr, box);
  lithe_asset_posed_box(asset.get(), box, nullptr);
  for (const float x : box) EXPECT_EQ(x, 7.0f);
}

}  // namespace
}  // namespace lithe::test
