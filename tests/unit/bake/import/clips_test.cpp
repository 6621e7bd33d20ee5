// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "gltf_draft.h"
#include "lithe/bake/poses.h"

namespace lithe::bake {
namespace {

/// Adds an animation of one channel.
void addClip(GltfDraft& builder, int node, const std::string& path, int times, int values,
             const std::string& interpolation = "LINEAR") {
  builder.add("animations", {{"name", path},
                             {"channels", {{{"sampler", 0}, {"target", {{"node", node}, {"path", path}}}}}},
                             {"samplers", {{{"input", times}, {"output", values}, {"interpolation", interpolation}}}}});
}

TEST(ImportClips, ReadsEveryPathAndInterpolation) {
  Ribbon ribbon;
  const int times = ribbon.accessor<float>("SCALAR", {0.5f, 2.0f});
  addClip(ribbon, 0, "translation", times, ribbon.accessor<float>("VEC3", {1, 2, 3, 4, 5, 6}), "STEP");
  addClip(ribbon, 1, "rotation", times, ribbon.accessor<float>("VEC4", {0, 0, 0, 1, 0, 0, 1, 0}));
  addClip(ribbon, 1, "scale", times, ribbon.accessor<float>("VEC3", std::vector<float>(18, 1.5f)), "CUBICSPLINE");
  const Model model = importBuilt(ribbon);
  ASSERT_EQ(model.clips.size(), 3u);
  EXPECT_EQ(model.clips[0].name, "translation");
  EXPECT_EQ(model.clips[0].begin, 0.5);
  EXPECT_EQ(model.clips[0].end, 2.0);
  const Channel& step = model.clips[0].channels.at(0);
  EXPECT_EQ(step.interpolation, Channel::Interpolation::kStep);
  EXPECT_EQ(step.path, Channel::Path::kTranslation);
  EXPECT_EQ(step.values[1], glm::vec4(4, 5, 6, 0));
  EXPECT_EQ(model.clips[1].channels.at(0).interpolation, Channel::Interpolation::kLinear);
  EXPECT_EQ(model.clips[2].channels.at(0).values.size(), 6u);
  EXPECT_EQ(model.nodes[model.clips[2].channels[0].node].name, "b");
}

TEST(ImportClips, ReadsNormalisedIntegers) {
  Ribbon ribbon;
  const int times = ribbon.accessor<float>("SCALAR", {0, 1, 2});
  addClip(ribbon, 0, "rotation", times,
          ribbon.accessor<int16_t>("VEC4", {0, 0, 0, 32767, 0, 0, -32768, 0, 0, 0, 16384, 0}, true));
  addClip(ribbon, 0, "rotation", times,
          ribbon.accessor<uint8_t>("VEC4", {0, 0, 0, 255, 0, 0, 255, 0, 0, 0, 51, 0}, true));
  const Model model = importBuilt(ribbon);
  EXPECT_EQ(model.clips[0].channels[0].values[0].w, 1.0f);
  EXPECT_EQ(model.clips[0].channels[0].values[1].z, -1.0f);
  EXPECT_FLOAT_EQ(model.clips[0].channels[0].values[2].z, 16384.0f / 32767.0f);
  EXPECT_FLOAT_EQ(model.clips[1].channels[0].values[2].z, 0.2f);
}

TEST(ImportClips, LeavesOutWhatMovesNothingButKeepsItsTime) {
  Ribbon ribbon;
  const int times = ribbon.accessor<float>("SCALAR", {1, 4});
  const int moves = ribbon.accessor<float>("VEC3", {0, 0, 0, 1, 1, 1});
  const int lamp = ribbon.add("nodes", {{"name", "lamp"}});
  addClip(ribbon, lamp, "translation", times, moves);
  addClip(ribbon, 2, "weights", times, ribbon.accessor<float>("SCALAR", {0, 1}));
  ribbon.json["animations"][1].erase("name");
  ribbon.json["animations"][1]["channels"].push_back({{"sampler", 0}, {"target", {{"path", "pointer"}}}});
  const Model model = importBuilt(ribbon);
  ASSERT_EQ(model.clips.size(), 2u);
  for (const Clip& clip : model.clips) {
    EXPECT_TRUE(clip.channels.empty());
    EXPECT_EQ(clip.begin, 1.0);
    EXPECT_EQ(clip.end, 4.0);
  }
  EXPECT_EQ(model.clips[1].name, "anim1");
}

TEST(ImportClips, DropsKeysOutOfOrder) {
  Ribbon ribbon;
  const int times = ribbon.accessor<float>("SCALAR", {0, 1, 1, 0.5f, 2});
  addClip(ribbon, 0, "scale", times, ribbon.accessor<float>("VEC3", {1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4, 5, 5, 5}));
  const Model model = importBuilt(ribbon);
  EXPECT_EQ(model.clips[0].channels[0].times, (std::vector<float>{0, 1, 2}));
  EXPECT_EQ(model.clips[0].channels[0].values[2].x, 5.0f);
  EXPECT_TRUE(warned(model, "2 animation keys"));
}

TEST(ImportClips, RefusesDamagedKeys) {
  const auto complaint = [](const std::vector<float>& times, const std::vector<float>& values,
                            const std::string& interpolation = "LINEAR", int node = 0) {
    Ribbon ribbon;
    addClip(ribbon, node, "scale", ribbon.accessor("SCALAR", times), ribbon.accessor("VEC3", values), interpolation);
    return complaintAbout(ribbon.glb());
  };
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
  EXPECT_EQ(complaint({0, 1}, {1, 1, 1, 2, 2, 2}), "nothing");
  EXPECT_EQ(complaint({0, 1}, {1, 1, 1}),
            "animation 0 'scale', channel 0: it has 1 values for 2 keys; re-export the file");
  EXPECT_NE(complaint({0, nan}, {1, 1, 1, 2, 2, 2}).find("a key's time is not a number"), std::string::npos);
  EXPECT_NE(complaint({0, 1}, {1, 1, 1, 2, infinite, 2}).find("value 1 is not a number"), std::string::npos);
  EXPECT_NE(complaint({0, 1}, {1, 1, 1, 2, 2, 2}, "BEZIER").find("interpolation 'BEZIER'"), std::string::npos);
  EXPECT_NE(complaint({0, 1}, {1, 1, 1, 2, 2, 2}, "LINEAR", 44).find("there is no node 44"), std::string::npos);
}

}  // namespace
}  // namespace lithe::bake
