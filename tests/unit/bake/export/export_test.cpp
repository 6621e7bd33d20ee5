// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/export.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "lithe/bake/compare.h"
#include "lithe/bake/import.h"
#include "lithe/bake/poses.h"
#include "shapes.h"
#include "written_file.h"

namespace lithe::bake {
namespace {

using test::binaryOf;
using test::floatsOf;
using test::jsonOf;
using test::TemporaryFolder;
using test::tube;

/// Largest distance between equally numbered posed vertices, over some instants of every clip and the rest pose.
double largestPosedDifference(const Model& a, const Model& b) {
  double largest = 0.0;
  const auto look = [&](const Pose& pose_a, const Pose& pose_b) {
    const std::vector<glm::dvec3> posed_a = skinPositions(a, pose_a), posed_b = skinPositions(b, pose_b);
    for (size_t i = 0; i < posed_a.size(); ++i) largest = std::max(largest, glm::distance(posed_a[i], posed_b[i]));
  };
  look(restPose(a), restPose(b));
  for (uint32_t clip = 0; clip < a.clips.size(); ++clip) {
    for (const double along : {0.0, 0.3, 1.0}) {
      const double time = a.clips[clip].begin + along * (a.clips[clip].end - a.clips[clip].begin);
      look(clipPose(a, clip, time), clipPose(b, clip, time));
    }
  }
  return largest;
}

Model roundTrip(const Model& model, const std::string& name = "model.glb") {
  const TemporaryFolder folder;
  writeGltf(model, folder / name, {});
  return importGltf(folder / name);
}

void expectSameSurface(const Model& a, const Model& b) {
  ASSERT_EQ(a.positions.size(), b.positions.size());
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.triangle_part, b.triangle_part);
  for (size_t i = 0; i < a.positions.size(); ++i) {
    ASSERT_LT(glm::distance(a.normals[i], b.normals[i]), 1e-6f) << i;
    ASSERT_EQ(a.uvs[0][i], b.uvs[0][i]) << i;
    ASSERT_EQ(a.skins[i].count, b.skins[i].count) << i;
    ASSERT_EQ(a.skins[i].joint, b.skins[i].joint) << i;
  }
}

TEST(Export, ComesBackAsItWas) {
  const Model model = tube(12, 9);
  for (const char* name : {"model.glb", "mo del%.gltf"}) {
    const Model back = roundTrip(model, name);
    expectSameSurface(model, back);
    EXPECT_LT(largestPosedDifference(model, back), 1e-6) << name;
    ASSERT_EQ(back.clips.size(), 2u);
    EXPECT_EQ(back.clips[0].name, "bend");
    EXPECT_EQ(back.clips[1].end, 2.0);
    EXPECT_EQ(back.materials, model.materials);
    EXPECT_EQ(back.parts[0].name, "tube");
    EXPECT_EQ(back.nodes[1].name, "elbow");
    EXPECT_TRUE(back.warnings.empty());
  }
}

TEST(Export, WritesTheSameBytesEveryTime) {
  const TemporaryFolder folder;
  writeGltf(tube(12, 9), folder / "a.glb", {});
  writeGltf(tube(12, 9), folder / "b.glb", {});
  EXPECT_EQ(test::bytesOf(folder / "a.glb"), test::bytesOf(folder / "b.glb"));
}

TEST(Export, StatesBoundsAndTypesAsGltfWantsThem) {
  const TemporaryFolder folder;
  writeGltf(tube(12, 9), folder / "model.glb", {});
  const nlohmann::json json = jsonOf(folder / "model.glb");
  const nlohmann::json& primitive = json["meshes"][0]["primitives"][0];
  const nlohmann::json& position = json["accessors"][primitive["attributes"]["POSITION"].get<size_t>()];
  EXPECT_EQ(position["min"], (nlohmann::json{-0.5, -0.5, 0.0}));
  EXPECT_EQ(position["max"], (nlohmann::json{0.5, 0.5, 4.0}));
  EXPECT_EQ(json["accessors"][primitive["indices"].get<size_t>()]["componentType"], 5123);
  EXPECT_EQ(json["accessors"][primitive["attributes"]["JOINTS_0"].get<size_t>()]["componentType"], 5121);
  EXPECT_FALSE(primitive["attributes"].contains("JOINTS_1"));
  for (const nlohmann::json& view : json["bufferViews"]) EXPECT_EQ(view["byteOffset"].get<size_t>() % 4, 0u);
  EXPECT_EQ(json["buffers"][0]["byteLength"], binaryOf(folder / "model.glb").size());
}

TEST(Export, LargePartsGetWideIndices) {
  const TemporaryFolder folder;
  writeGltf(tube(255, 256), folder / "wide.glb", {});    // 256 * 257 vertices
  writeGltf(tube(254, 256), folder / "narrow.glb", {});  // 255 * 257 = 65535
  const auto indexType = [&](const char* name) {
    const nlohmann::json json = jsonOf(folder / name);
    return json["accessors"][json["meshes"][0]["primitives"][0]["indices"].get<size_t>()]["componentType"].get<int>();
  };
  EXPECT_EQ(indexType("wide.glb"), 5125);
  EXPECT_EQ(indexType("narrow.glb"), 5123);
}

TEST(Export, EightInfluencesTakeASecondSet) {
  Model model = tube(6, 3);
  for (uint32_t i = 0; i < 300; ++i) {
    model.nodes.push_back({"extra" + std::to_string(i), 0, {{0.001 * i, 0.0, 0.0}}});
    model.joints.push_back({i + 2, glm::dmat4(1.0)});
  }
  Skin& skin = model.skins[0];
  skin.count = 6;
  skin.joint = {301, 300, 5, 4, 3, 2};
  skin.weight = {0.3f, 0.2f, 0.2f, 0.1f, 0.1f, 0.1f};
  const TemporaryFolder folder;
  writeGltf(model, folder / "model.glb", {});
  const nlohmann::json json = jsonOf(folder / "model.glb");
  const nlohmann::json& attributes = json["meshes"][0]["primitives"][0]["attributes"];
  EXPECT_TRUE(attributes.contains("JOINTS_1"));
  EXPECT_FALSE(attributes.contains("JOINTS_2"));
  EXPECT_EQ(json["accessors"][attributes["JOINTS_0"].get<size_t>()]["componentType"], 5123);
  const Model back = importGltf(folder / "model.glb");
  EXPECT_EQ(back.skins[0].count, 6u);
  EXPECT_LT(largestPosedDifference(model, back), 1e-6);
}

TEST(Export, WeightsAreNormalised) {
  Model model = tube(6, 3);
  for (Skin& skin : model.skins) {
    for (uint32_t k = 0; k < skin.count; ++k) skin.weight[k] *= 0.9f;
  }
  const TemporaryFolder folder;
  writeGltf(model, folder / "model.glb", {});
  const nlohmann::json json = jsonOf(folder / "model.glb");
  const std::vector<float> weights =
      floatsOf(folder / "model.glb", json["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"]);
  for (size_t i = 0; i < weights.size(); i += 4) {
    EXPECT_NEAR(double{weights[i]} + weights[i + 1] + weights[i + 2] + weights[i + 3], 1.0, 1e-7);
  }
}

TEST(Export, ANodeThatThePaletteHasTwiceGetsATwin) {
  Model model = tube(12, 9);
  glm::dmat4 shifted = model.joints[1].inverse_bind;
  shifted[3].x += 0.25;
  model.joints.push_back({1, shifted});
  for (size_t i = 0; i < model.skins.size() / 2; ++i) {
    for (uint32_t k = 0; k < model.skins[i].count; ++k) {
      if (model.skins[i].joint[k] == 1) model.skins[i].joint[k] = 2;
    }
  }
  const TemporaryFolder folder;
  writeGltf(model, folder / "model.glb", {});
  const nlohmann::json json = jsonOf(folder / "model.glb");
  const nlohmann::json& joints = json["skins"][0]["joints"];
  ASSERT_EQ(joints.size(), 3u);
  const uint32_t twin = joints[2].get<uint32_t>();
  EXPECT_NE(twin, 1u);
  EXPECT_EQ(json["nodes"][twin]["name"], "elbow");
  EXPECT_EQ(json["nodes"][1]["children"], nlohmann::json::array({twin}));
  EXPECT_LT(largestPosedDifference(model, importGltf(folder / "model.glb")), 1e-6);
}

TEST(Export, SeveralRootsAreJoinedUnderOne) {
  Model model = tube(12, 9);
  model.nodes[1].parent = kNone;
  const TemporaryFolder folder;
  writeGltf(model, folder / "model.glb", {});
  const nlohmann::json json = jsonOf(folder / "model.glb");
  ASSERT_EQ(json["scenes"][0]["nodes"].size(), 2u);  // the mesh and the common root
  bool joined = false;
  for (const nlohmann::json& node : json["nodes"])
    joined |= node.value("children", nlohmann::json()) == nlohmann::json({0, 1});
  EXPECT_TRUE(joined);
  EXPECT_LT(largestPosedDifference(model, importGltf(folder / "model.glb")), 1e-6);
}

/// The tube with a rigid triangle on a node of its own below the elbow, scaled by `scale`.
Model tubeWithHat(const glm::dvec3& scale) {
  Model model = tube(12, 9);
  model.nodes.push_back({"hat node", 1, {{0.0, 0.0, 3.0}}});
  model.nodes.back().rest.scale = scale;
  glm::dmat4 world(1.0);
  for (int i = 0; i < 3; ++i) world[i][i] = scale[i];
  world[3] = {0.0, 0.0, 5.0, 1.0};  // the elbow is at z = 2
  model.joints.push_back({2, glm::inverse(world)});
  model.parts.push_back({"hat", kNone, 2, 1, 0});
  const uint32_t first = static_cast<uint32_t>(model.positions.size());
  for (const glm::vec3 corner : {glm::vec3(0, 0, 5), glm::vec3(1, 0, 5), glm::vec3(0, 1, 5)}) {
    model.positions.push_back(corner);
    model.normals.emplace_back(0, 0, 1);
    model.uvs[0].emplace_back(0, 0);
    Skin skin;
    skin.count = 1;
    skin.joint[0] = 2;
    skin.weight[0] = 1.0f;
    model.skins.push_back(skin);
  }
  model.triangles.push_back({first, first + 1, first + 2});
  model.triangle_part.push_back(1);
  return model;
}

TEST(Export, RigidPartsAreUnskinnedMeshesOfTheirNode) {
  const Model model = tubeWithHat({2.0, 2.0, 2.0});
  const TemporaryFolder folder;
  writeGltf(model, folder / "model.glb", {});
  const nlohmann::json json = jsonOf(folder / "model.glb");
  const nlohmann::json& node = json["nodes"][2];
  ASSERT_TRUE(node.contains("mesh"));
  EXPECT_FALSE(node.contains("skin"));
  const nlohmann::json& attributes = json["meshes"][node["mesh"].get<size_t>()]["primitives"][0]["attributes"];
  EXPECT_FALSE(attributes.contains("JOINTS_0"));
  EXPECT_EQ(floatsOf(folder / "model.glb", attributes["POSITION"]),
            (std::vector<float>{0, 0, 0, 0.5, 0, 0, 0, 0.5, 0}));
  const Model back = importGltf(folder / "model.glb");
  EXPECT_TRUE(std::any_of(back.parts.begin(), back.parts.end(), [](const Part& part) { return part.rigid_node == 2; }));
  CompareOptions options;
  options.frames = 3;
  options.samples = 500;
  options.include_rigid = true;
  EXPECT_LT(compare(model, back, options).worst.max, 1e-6);
}

TEST(Export, MirroredRigidPartsKeepTheirOutside) {
  const TemporaryFolder folder;
  writeGltf(tubeWithHat({-1.0, 1.0, 1.0}), folder / "model.glb", {});
  const nlohmann::json json = jsonOf(folder / "model.glb");
  const nlohmann::json& primitive = json["meshes"][json["nodes"][2]["mesh"].get<size_t>()]["primitives"][0];
  const std::vector<float> p = floatsOf(folder / "model.glb", primitive["attributes"]["POSITION"]);
  EXPECT_EQ(p, (std::vector<float>{0, 0, 0, -1, 0, 0, 0, 1, 0}));
  EXPECT_EQ(floatsOf(folder / "model.glb", primitive["attributes"]["NORMAL"])[2], 1.0f);
  // glTF 2.0, 3.7.4: counter-clockwise in the node's own space; a viewer turns it round where the node mirrors.
  const nlohmann::json& view =
      json["bufferViews"][json["accessors"][primitive["indices"].get<size_t>()]["bufferView"].get<size_t>()];
  const std::vector<uint8_t> binary = binaryOf(folder / "model.glb");
  const size_t at = view["byteOffset"];
  EXPECT_EQ((std::vector<uint8_t>{binary[at], binary[at + 2], binary[at + 4]}), (std::vector<uint8_t>{0, 2, 1}));
}

TEST(Export, PartsOfOneNameAreOneMeshAndEmptyPartsNone) {
  Model model = tube(12, 8);
  model.materials = {"a", "b", "c"};
  model.parts = {
      {"body", 0, kNone, 0, 0}, {"body", 1, kNone, 0, 1}, {"ghost", 2, kNone, 1, 0}, {"boots", 2, kNone, 2, 0}};
  for (size_t i = 0; i < model.triangles.size(); ++i) {
    const size_t third = 3 * i / model.triangles.size();
    model.triangle_part[i] = third == 2 ? 3 : static_cast<uint32_t>(third);
  }
  const TemporaryFolder folder;
  writeGltf(model, folder / "model.glb", {});
  const nlohmann::json json = jsonOf(folder / "model.glb");
  ASSERT_EQ(json["meshes"].size(), 2u);
  EXPECT_EQ(json["meshes"][0]["name"], "body");
  EXPECT_EQ(json["meshes"][0]["primitives"].size(), 2u);
  EXPECT_EQ(json["meshes"][0]["primitives"][1]["material"], 1);
  EXPECT_EQ(json["meshes"][1]["name"], "boots");
  EXPECT_EQ(json["meshes"][1]["primitives"][0]["material"], 2);
}

TEST(ExportLevels, ShareTheSkeletonAndAreNamedByLevel) {
  const TemporaryFolder folder;
  Model coarse = tubeWithHat({1, 1, 1});
  coarse.triangles.erase(coarse.triangles.begin(), coarse.triangles.begin() + 100);
  coarse.triangle_part.erase(coarse.triangle_part.begin(), coarse.triangle_part.begin() + 100);
  writeGltfLevels({tubeWithHat({1, 1, 1}), coarse}, folder / "levels.glb", {});
  const nlohmann::json json = jsonOf(folder / "levels.glb");
  std::vector<std::string> names;
  for (const nlohmann::json& mesh : json["meshes"]) names.push_back(mesh["name"]);
  EXPECT_EQ(names, (std::vector<std::string>{"tube_LOD0", "hat_LOD0", "tube_LOD1", "hat_LOD1"}));
  EXPECT_EQ(json["skins"].size(), 1u);
  std::vector<std::string> skinned, on_hat;
  for (const nlohmann::json& node : json["nodes"]) {
    if (node.contains("skin")) skinned.push_back(node["name"]);
  }
  for (const nlohmann::json& child : json["nodes"][2]["children"])
    on_hat.push_back(json["nodes"][child.get<size_t>()]["name"]);
  EXPECT_EQ(skinned, (std::vector<std::string>{"tube_LOD0", "tube_LOD1"}));
  EXPECT_EQ(on_hat, (std::vector<std::string>{"hat_LOD0", "hat_LOD1"}));
}

TEST(ExportFailures, LeaveNothingBehind) {
  const TemporaryFolder folder;
  Model empty = tube(4, 2);
  empty.triangles.clear();
  empty.triangle_part.clear();
  EXPECT_THROW(writeGltf(empty, folder / "empty.glb", {}), Error);
  EXPECT_THROW(writeGltf(tube(4, 2), folder / "missing" / "model.glb", {}), Error);
  EXPECT_THROW(writeGltf(tube(4, 2), folder / "model.glb", {folder / "no such original.glb"}), Error);
  EXPECT_THROW(writeGltfLevels({}, folder / "none.glb", {}), Error);
  EXPECT_THROW(writeGltfLevels({tube(4, 2), tubeWithHat({1, 1, 1})}, folder / "mixed.glb", {}), Error);
  std::filesystem::create_directory(folder / "taken.gltf");  // the .bin is written first, then the name proves taken
  EXPECT_THROW(writeGltf(tube(4, 2), folder / "taken.gltf", {}), Error);
  std::vector<std::string> left;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    left.push_back(entry.path().filename().string());
  EXPECT_EQ(left, std::vector<std::string>{"taken.gltf"});
}

TEST(ExportFailures, KeepTheFileThatWasThere) {
  const TemporaryFolder folder;
  writeGltf(tube(4, 2), folder / "model.glb", {});
  const std::vector<uint8_t> before = test::bytesOf(folder / "model.glb");
  EXPECT_THROW(writeGltf(tube(8, 2), folder / "model.glb", {folder / "nowhere.glb"}), Error);
  EXPECT_EQ(test::bytesOf(folder / "model.glb"), before);
}

/// Real characters: written and read again, every one moves as before, rigid parts included.
class ExportSharedModels : public testing::TestWithParam<const char*> {};

TEST_P(ExportSharedModels, MoveAsBefore) {
  const std::filesystem::path file = std::filesystem::path(LITHE_SHARED_DIR) / "models" / GetParam();
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  const Model model = importGltf(file);
  const TemporaryFolder folder;
  writeGltf(model, folder / "back.glb", {file});
  const Model back = importGltf(folder / "back.glb");
  CompareOptions options;
  options.frames = 3;
  options.samples = 2000;
  options.include_rigid = true;
  const CompareReport report = compare(model, back, options);
  EXPECT_EQ(report.original_triangles, report.simplified_triangles);
  EXPECT_LT(report.worst.max, 2e-6);
  EXPECT_LT(report.worst.normal_degrees, 0.1);
  EXPECT_LT(report.worst.uv_rms, 1e-4);
  EXPECT_EQ(back.clips.size(), model.clips.size());
}

INSTANTIATE_TEST_SUITE_P(Real, ExportSharedModels,
                         testing::Values("knight.glb", "pumpkin/scene.gltf", "alien/Alien_Scolitex.gltf", "robot.glb",
                                         "eight_influences.glb", "fox.glb", "valid_asian_f3.glb", "sintel.glb"));

}  // namespace
}  // namespace lithe::bake
