// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Whole files as people have them: names in every script, scaled skeletons, much beside the character.
#include <algorithm>

#include "gltf_draft.h"
#include "lithe/bake/export.h"
#include "lithe/bake/poses.h"

namespace lithe::bake {
namespace {

void expectNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-6) {
  EXPECT_LT(glm::length(a - b), tolerance) << a.x << " " << a.y << " " << a.z;
}

TEST(ImportUserFiles, SkeletonsBelowAScaledRoot) {
  // Centimetres below a root that makes metres of them, as some tools write every character.
  Ribbon ribbon;
  ribbon.json["nodes"][1]["translation"] = {100, 0, 0};
  const int root = ribbon.add("nodes", {{"name", "root"}, {"scale", {.01, .01, .01}}, {"children", {0, 2}}});
  ribbon.json["scenes"][0]["nodes"] = {root};
  const std::vector<float> binds{100, 0, 0, 0, 0, 100, 0, 0, 0, 0, 100, 0, 0,    0, 0, 1,
                                 100, 0, 0, 0, 0, 100, 0, 0, 0, 0, 100, 0, -100, 0, 0, 1};
  ribbon.json["skins"][0]["inverseBindMatrices"] = ribbon.accessor("MAT4", binds);
  const Model model = importBuilt(ribbon);
  EXPECT_EQ(model.positions[3], glm::vec3(2, 1, 0)) << "bind space is as in the file";
  EXPECT_EQ(model.nodes[0].name, "root");
  const std::vector<glm::dvec3> posed = skinPositions(model, restPose(model));
  for (size_t v = 0; v < 4; ++v) expectNear(posed[v], glm::dvec3(model.positions[v]));
  // Moving the second joint by 100 centimetres moves its half of a vertex by half a metre.
  std::vector<Transform> locals;
  for (const Node& node : model.nodes) locals.push_back(node.rest);
  for (size_t i = 0; i < locals.size(); ++i) {
    if (model.nodes[i].name == "b") locals[i].translation.y += 100;
  }
  expectNear(skinPositions(model, localPose(model, locals))[3], {2, 1.5, 0});
}

TEST(ImportUserFiles, CamerasAndLightsAreNoPartOfTheCharacter) {
  Ribbon ribbon;
  ribbon.json["extensionsUsed"] = {"KHR_lights_punctual"};
  ribbon.json["extensionsRequired"] = {"KHR_lights_punctual"};
  ribbon.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
  ribbon.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", .1}}}});
  const int camera = ribbon.add("nodes", {{"name", "eye"}, {"camera", 0}});
  const int light = ribbon.add("nodes", {{"name", "sun"}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  ribbon.json["scenes"][0]["nodes"] = {0, 2, camera, light};
  ribbon.json["nodes"][1]["camera"] = 99;  // of a joint, and not even there: nobody looks
  const Model model = importBuilt(ribbon);
  ASSERT_EQ(model.nodes.size(), 2u);
  EXPECT_EQ(model.parts.size(), 1u);
  EXPECT_EQ(model.warnings.size(), 1u) << "of missing normals alone";
}

TEST(ImportUserFiles, EmptyPrimitivesAreLeftOut) {
  Ribbon ribbon;
  nlohmann::json empty = ribbon.primitive(), unplaced = ribbon.primitive();
  empty["indices"] = ribbon.accessor<uint16_t>("SCALAR", {});
  unplaced["attributes"].erase("POSITION");
  ribbon.json["meshes"][0]["primitives"] = {empty, unplaced, ribbon.primitive()};
  const Model model = importBuilt(ribbon);
  ASSERT_EQ(model.parts.size(), 1u);
  EXPECT_EQ(model.parts[0].source_primitive, 2u);
  EXPECT_TRUE(warned(model, "primitive 0: it has no triangles"));
  EXPECT_TRUE(warned(model, "primitive 1: it has no positions"));
}

TEST(ImportUserFiles, MoreVerticesThanSixteenBitsCount) {
  constexpr uint32_t kColumns = 300, kRows = 240;
  Ribbon ribbon;
  std::vector<float> positions, weights;
  std::vector<uint32_t> indices;
  for (uint32_t v = 0; v < kColumns * kRows; ++v) {
    const float x = static_cast<float>(v % kColumns), y = static_cast<float>(v / kColumns);
    positions.insert(positions.end(), {x, y, 0});
    weights.insert(weights.end(), {1, 0, 0, 0});
    if (v % kColumns + 1 < kColumns && v / kColumns + 1 < kRows) {
      indices.insert(indices.end(), {v, v + 1, v + kColumns, v + 1, v + kColumns + 1, v + kColumns});
    }
  }
  ribbon.primitive()["attributes"] = {
      {"POSITION", ribbon.accessor("VEC3", positions)},
      {"JOINTS_0", ribbon.accessor("VEC4", std::vector<uint16_t>(4 * kColumns * kRows))},
      {"WEIGHTS_0", ribbon.accessor("VEC4", weights)}};
  ribbon.primitive()["indices"] = ribbon.accessor("SCALAR", indices);
  const Model model = importBuilt(ribbon);
  ASSERT_EQ(model.positions.size(), size_t{kColumns} * kRows);
  EXPECT_EQ(model.triangles.size(), indices.size() / 3);
  EXPECT_EQ(model.triangles.back()[1], kColumns * kRows - 1);
  EXPECT_EQ(model.positions.back(), glm::vec3(kColumns - 1, kRows - 1, 0));
}

TEST(ImportUserFiles, NamesOfEveryScriptSurvive) {
  const std::string joint =
                        "H\xc3\xbc"
                        "fte",
                    mesh = "\xe9\xab\x94", clip = "\xf0\x9f\x8f\x83 laufen", cloth = "\xd1\x88\xd1\x91\xd0\xbb\xd0\xba";
  Ribbon ribbon;
  ribbon.json["nodes"][0]["name"] = joint;
  ribbon.json["meshes"][0]["name"] = mesh;
  ribbon.add("materials", {{"name", cloth}});
  ribbon.primitive()["material"] = 0;
  const int times = ribbon.accessor<float>("SCALAR", {0, 1});
  const int moves = ribbon.accessor<float>("VEC3", {0, 0, 0, 0, 1, 0});
  ribbon.add("animations", {{"name", clip},
                            {"samplers", {{{"input", times}, {"output", moves}}}},
                            {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}});
  // "Knöchel #1 50%.bin" beside a .gltf whose own name is no ASCII either.
  const std::filesystem::path folder = tempFile(" \xe5\xa4\xb9");
  std::filesystem::create_directories(folder);
  writeBytes(folder /
                 "Kn\xc3\xb6"
                 "chel #1 50%.bin",
             ribbon.binary.data(), ribbon.binary.size());
  ribbon.json["buffers"] = {{{"byteLength", ribbon.binary.size()}, {"uri", "Kn%c3%B6chel%20%231%2050%25.bin"}}};
  const std::string document = ribbon.text();
  const Model model = importGltf(writeBytes(folder / "\xe5\x85\x94.gltf", document.data(), document.size()));
  writeGltf(model, folder / "\xe5\x87\xba %41.gltf", {});
  for (const Model& named : {model, importGltf(folder / "\xe5\x87\xba %41.gltf")}) {
    EXPECT_EQ(named.nodes[0].name, joint);
    EXPECT_EQ(named.parts[0].name, mesh);
    EXPECT_EQ(named.materials[0], cloth);
    ASSERT_EQ(named.clips.size(), 1u);
    EXPECT_EQ(named.clips[0].name, clip);
  }
}

TEST(ImportUserFiles, TrianglesWithoutAreaAreHarmless) {
  Ribbon ribbon;
  // One with a corner twice, one whose corners lie in a line, one that lies in one point.
  ribbon.primitive()["attributes"]["POSITION"] =
      ribbon.accessor<float>("VEC3", {0, 0, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0, 1, 0, 0, 5, 5, 5, 5, 5, 5, 5, 5, 5});
  std::vector<float> weights;
  for (int v = 0; v < 8; ++v) weights.insert(weights.end(), {1, 0, 0, 0});
  ribbon.primitive()["attributes"]["JOINTS_0"] = ribbon.accessor("VEC4", std::vector<uint8_t>(32));
  ribbon.primitive()["attributes"]["WEIGHTS_0"] = ribbon.accessor("VEC4", weights);
  ribbon.primitive()["indices"] = ribbon.accessor<uint16_t>("SCALAR", {0, 2, 1, 1, 2, 3, 0, 0, 1, 0, 4, 2, 5, 6, 7});
  const Model model = importBuilt(ribbon);
  EXPECT_EQ(model.triangles.size(), 5u) << "what to do about them is for the weld to say";
  for (const glm::vec3& normal : model.normals) EXPECT_NEAR(glm::length(normal), 1.0f, 1e-6f);
}

TEST(ImportUserFiles, SeveralSkinsWithASecondSetOfJointsAndMixedTypes) {
  Ribbon ribbon;
  // A second mesh with a skin of its own, in the other order of joints, whose fifth influence says what the others
  // lack.
  nlohmann::json primitive = ribbon.primitive();
  primitive["attributes"]["JOINTS_0"] = ribbon.accessor("VEC4", std::vector<uint16_t>(16, 1));
  primitive["attributes"]["WEIGHTS_0"] =
      ribbon.accessor<uint16_t>("VEC4", {32768, 0, 0, 0, 32768, 0, 0, 0, 32768, 0, 0, 0, 32768, 0, 0, 0}, true);
  primitive["attributes"]["JOINTS_1"] = ribbon.accessor("VEC4", std::vector<uint8_t>(16, 0));
  primitive["attributes"]["WEIGHTS_1"] =
      ribbon.accessor<uint8_t>("VEC4", {127, 0, 0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0, 0, 0}, true);
  const int mesh = ribbon.add("meshes", {{"primitives", nlohmann::json::array({primitive})}});
  const std::vector<float> binds{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1,
                                 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,  0, 0, 1};
  const int skin = ribbon.add("skins", {{"joints", {1, 0}}, {"inverseBindMatrices", ribbon.accessor("MAT4", binds)}});
  ribbon.json["scenes"][0]["nodes"].push_back(ribbon.add("nodes", {{"mesh", mesh}, {"skin", skin}}));
  const Model model = importBuilt(ribbon);
  ASSERT_EQ(model.joints.size(), 2u) << "one palette";
  ASSERT_EQ(model.skins.size(), 8u);
  const Skin& mixed = model.skins[6];
  ASSERT_EQ(mixed.count, 2u);
  EXPECT_NEAR(mixed.weight[0] + mixed.weight[1], 1.0f, 1e-6f);
  EXPECT_NEAR(mixed.weight[0], 0.5f, 2e-3f);
  EXPECT_EQ(model.nodes[model.joints[mixed.joint[0]].node].name, "a") << "the second skin's joint 1";
}

}  // namespace
}  // namespace lithe::bake
