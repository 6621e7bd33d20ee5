// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Influences, and what is done about bad ones.
#include "gltf_draft.h"

namespace lithe::bake {
namespace {

void expectSkin(const Skin& skin, const std::vector<std::pair<uint16_t, float>>& wanted) {
  ASSERT_EQ(skin.count, wanted.size());
  for (size_t k = 0; k < wanted.size(); ++k) {
    EXPECT_EQ(skin.joint[k], wanted[k].first) << "influence " << k;
    EXPECT_NEAR(skin.weight[k], wanted[k].second, 1e-6f) << "influence " << k;
  }
}

TEST(ImportSkin, ReadsWeightsOfEveryType) {
  for (const bool normalized : {true, false}) {
    Ribbon bytes, shorts;
    bytes.primitive()["attributes"]["WEIGHTS_0"] =
        bytes.accessor<uint8_t>("VEC4", {255, 0, 0, 0, 255, 0, 0, 0, 51, 204, 0, 0, 204, 51, 0, 0}, normalized);
    shorts.primitive()["attributes"]["WEIGHTS_0"] = shorts.accessor<uint16_t>(
        "VEC4", {65535, 0, 0, 0, 65535, 0, 0, 0, 13107, 52428, 0, 0, 52428, 13107, 0, 0}, normalized);
    shorts.primitive()["attributes"]["JOINTS_0"] =
        shorts.accessor<uint16_t>("VEC4", {0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0});
    for (const GltfDraft* builder : {static_cast<GltfDraft*>(&bytes), static_cast<GltfDraft*>(&shorts)}) {
      const Model model = importBuilt(*builder);
      expectSkin(model.skins[0], {{0, 1.0f}});
      expectSkin(model.skins[2], {{1, .8f}, {0, .2f}});
      expectSkin(model.skins[3], {{0, .8f}, {1, .2f}});
      EXPECT_FALSE(warned(model, "sum to one"));
    }
  }
}

TEST(ImportSkin, SortsAndAddsUpEqualJoints) {
  Ribbon ribbon;
  ribbon.primitive()["attributes"]["JOINTS_0"] =
      ribbon.accessor<uint8_t>("VEC4", {1, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 1, 1, 0, 0, 0});
  ribbon.primitive()["attributes"]["WEIGHTS_0"] =
      ribbon.accessor<float>("VEC4", {.5, .5, 0, 0, .25, .75, 0, 0, .2f, .2f, .4f, .2f, 1, 0, 0, 0});
  const Model model = importBuilt(ribbon);
  expectSkin(model.skins[0], {{0, .5f}, {1, .5f}});
  expectSkin(model.skins[1], {{1, .75f}, {0, .25f}});
  expectSkin(model.skins[2], {{1, .6f}, {0, .4f}});
}

TEST(ImportSkin, AWeightThatIsNothingBesideAnotherIsLeftOut) {
  Ribbon ribbon;
  ribbon.primitive()["attributes"]["JOINTS_0"] =
      ribbon.accessor<uint8_t>("VEC4", {0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0});
  ribbon.primitive()["attributes"]["WEIGHTS_0"] =
      ribbon.accessor<float>("VEC4", {3e38f, 1e-45f, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, .5, .5, 0, 0});
  const Model model = importBuilt(ribbon);
  expectSkin(model.skins[0], {{0, 1.0f}});
  expectSkin(model.skins[3], {{0, .5f}, {1, .5f}});
}

TEST(ImportSkin, RepairsBadWeightsAndSaysHowMany) {
  Ribbon ribbon;
  ribbon.primitive()["attributes"]["JOINTS_0"] =
      ribbon.accessor<uint8_t>("VEC4", {0, 0, 0, 0, 1, 0, 0, 0, 0, 9, 1, 0, 1, 0, 7, 0});
  ribbon.primitive()["attributes"]["WEIGHTS_0"] =
      ribbon.accessor<float>("VEC4", {2, 0, 0, 0, 0, 0, 0, 0, .5, .25, .25, 0, 1, -.5, 0, 0});
  const Model model = importBuilt(ribbon);
  expectSkin(model.skins[0], {{0, 1.0f}});
  expectSkin(model.skins[1], {{0, 1.0f}});
  expectSkin(model.skins[2], {{0, 2.0f / 3}, {1, 1.0f / 3}});
  expectSkin(model.skins[3], {{1, 1.0f}});
  EXPECT_TRUE(warned(model, "2 vertices have weights that do not sum to one"));
  EXPECT_TRUE(warned(model, "1 vertices have no weights"));
  EXPECT_TRUE(warned(model, "1 weights are negative"));
  EXPECT_TRUE(warned(model, "1 influences are of joints that their skin lacks"));
}

TEST(ImportSkin, KeepsTheEightLargestOfTwelve) {
  Ribbon ribbon;
  std::vector<uint8_t> joints[3];
  std::vector<float> weights[3];
  ribbon.json["skins"][0].erase("inverseBindMatrices");
  ribbon.json["skins"][0]["joints"] = nlohmann::json::array();
  for (int i = 0; i < 12; ++i)
    ribbon.json["skins"][0]["joints"].push_back(ribbon.add("nodes", {{"name", std::to_string(i)}}));
  for (int vertex = 0; vertex < 4; ++vertex) {
    for (int k = 0; k < 12; ++k) {
      joints[k / 4].push_back(static_cast<uint8_t>(k));
      weights[k / 4].push_back(static_cast<float>(k + 1) / 78.0f);
    }
  }
  for (int set = 0; set < 3; ++set) {
    ribbon.primitive()["attributes"]["JOINTS_" + std::to_string(set)] = ribbon.accessor("VEC4", joints[set]);
    ribbon.primitive()["attributes"]["WEIGHTS_" + std::to_string(set)] = ribbon.accessor("VEC4", weights[set]);
  }
  const Model model = importBuilt(ribbon);
  ASSERT_EQ(model.skins[0].count, 8u);
  for (uint32_t k = 0; k < 8; ++k) {
    EXPECT_EQ(model.nodes[model.joints[model.skins[0].joint[k]].node].name, std::to_string(11 - k));
    EXPECT_NEAR(model.skins[0].weight[k], static_cast<float>(12 - k) / 68.0f, 1e-6f);
  }
  EXPECT_TRUE(warned(model, "4 vertices have more than 8 influences"));
}

TEST(ImportSkin, BindsSkinnedMeshesWithoutWeightsToTheirNode) {
  Ribbon ribbon;
  ribbon.primitive()["attributes"].erase("WEIGHTS_0");
  const Model model = importBuilt(ribbon);
  EXPECT_TRUE(warned(model, "no weights"));
  ASSERT_NE(model.parts[0].rigid_node, kNone);
  EXPECT_EQ(model.nodes[model.parts[0].rigid_node].name, "shows");
}

}  // namespace
}  // namespace lithe::bake
