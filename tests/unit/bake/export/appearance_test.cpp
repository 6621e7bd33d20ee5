// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// What export takes over from the file a model came from: materials, textures, images and clips.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "lithe/bake/export.h"
#include "lithe/bake/import.h"
#include "lithe/bake/poses.h"
#include "shapes.h"
#include "written_file.h"

namespace lithe::bake {
namespace {

using nlohmann::json;
using test::jsonOf;
using test::TemporaryFolder;
using test::tube;

void writeText(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

std::string textOf(const std::filesystem::path& path) {
  const std::vector<uint8_t> bytes = test::bytesOf(path);
  return {bytes.begin(), bytes.end()};
}

/// What the tests add to an exported tube to make it look like something: materials with textures from a file with a
/// blank in its name, a missing file, a data URI, and the buffer.
json decorated(json gltf) {
  gltf["images"] = {{{"uri", "bark%20map.PNG"}, {"name", "bark"}},
                    {{"uri", "lost.jpg"}},
                    {{"uri", "data:image/png;base64,AAAA"}},
                    {{"bufferView", 0}, {"mimeType", "image/png"}}};
  gltf["samplers"] = {{{"magFilter", 9728}}};
  gltf["textures"] = {{{"source", 0}, {"sampler", 0}}, {{"source", 1}}, {{"source", 2}}, {{"source", 3}}};
  const json moved = {{"KHR_texture_transform", {{"offset", {0.5, 0.0}}}}};
  const json wood = {{"name", "wood"},
                     {"doubleSided", true},
                     {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}, {"extensions", moved}}}}},
                     {"normalTexture", {{"index", 1}, {"scale", 0.5}}},
                     {"occlusionTexture", {{"index", 2}, {"texCoord", 3}}}};
  const json rubber = {{"name", "rubber"}, {"emissiveFactor", {1.0, 0.0, 0.5}}, {"emissiveTexture", {{"index", 3}}}};
  gltf["materials"] = {wood, rubber};
  gltf["extensionsUsed"] = {"KHR_texture_transform", "KHR_materials_variants"};
  return gltf;
}

class ExportFrom : public testing::Test {
 protected:
  void SetUp() override {
    writeGltf(tube(12, 9), original(), {});
    json gltf = json::parse(textOf(original()));
    view_length_ = gltf["bufferViews"][0]["byteLength"];
    writeText(original(), decorated(gltf).dump());
    writeText(folder_ / "bark map.PNG", "not really a picture");
  }

  std::filesystem::path original() const { return folder_ / "original.gltf"; }
  std::filesystem::path output() const { return folder_ / "output.glb"; }

  json exported(const Model& model) {
    writeGltf(model, output(), {original()});
    return jsonOf(output());
  }

  /// The tube as a baked file would give it back: fewer triangles, materials known by name, no clips.
  static Model simplified() {
    Model model = tube(6, 4);
    model.clips.clear();
    return model;
  }

  std::string imageBytes(const json& gltf, size_t image) const {
    const json& view = gltf["bufferViews"][gltf["images"][image]["bufferView"].get<size_t>()];
    const std::vector<uint8_t> binary = test::binaryOf(output());
    const auto begin = binary.begin() + view["byteOffset"].get<std::ptrdiff_t>();
    return {begin, begin + view["byteLength"].get<std::ptrdiff_t>()};
  }

  TemporaryFolder folder_;
  size_t view_length_ = 0;
};

TEST_F(ExportFrom, MaterialsAreTheOriginalsFoundByName) {
  const json gltf = exported(simplified());
  ASSERT_EQ(gltf["materials"].size(), 2u);
  EXPECT_EQ(gltf["meshes"][0]["primitives"][0]["material"], 1);  // rubber is index 0 in the model, 1 in the original
  EXPECT_EQ(gltf["materials"][1]["emissiveFactor"], (json{1.0, 0.0, 0.5}));
  EXPECT_EQ(gltf["materials"][0]["normalTexture"]["scale"], 0.5);
  EXPECT_EQ(gltf["samplers"][0]["magFilter"], 9728);
}

TEST_F(ExportFrom, AMaterialThatTheOriginalLacksIsAdded) {
  Model model = simplified();
  model.materials = {"glass"};
  const json gltf = exported(model);
  ASSERT_EQ(gltf["materials"].size(), 3u);
  EXPECT_EQ(gltf["materials"][2]["name"], "glass");
  EXPECT_EQ(gltf["meshes"][0]["primitives"][0]["material"], 2);
}

TEST_F(ExportFrom, ImagesAreEmbeddedWhereTheyAre) {
  const json gltf = exported(simplified());
  ASSERT_EQ(gltf["images"].size(), 4u);
  EXPECT_EQ(imageBytes(gltf, 0), "not really a picture");
  EXPECT_EQ(gltf["images"][0]["mimeType"], "image/png");
  EXPECT_EQ(gltf["images"][0]["name"], "bark");
  EXPECT_FALSE(gltf["images"][0].contains("uri"));
  EXPECT_EQ(gltf["images"][1], (json{{"uri", "lost.jpg"}}));
  EXPECT_EQ(gltf["images"][2], (json{{"uri", "data:image/png;base64,AAAA"}}));
  EXPECT_EQ(imageBytes(gltf, 3).size(), view_length_);
  const std::string binary = textOf(folder_ / "original.bin");
  EXPECT_EQ(imageBytes(gltf, 3), binary.substr(0, view_length_));
}

TEST_F(ExportFrom, OnlyExtensionsInUseAreStated) {
  const json gltf = exported(simplified());
  EXPECT_EQ(gltf["extensionsUsed"], json{"KHR_texture_transform"});
  EXPECT_FALSE(gltf.contains("extensionsRequired"));
}

TEST_F(ExportFrom, TexturesWithoutTheirUvSetAreTakenOff) {
  const json with_uv = exported(simplified());
  EXPECT_TRUE(with_uv["materials"][0].contains("normalTexture"));
  EXPECT_FALSE(with_uv["materials"][0].contains("occlusionTexture"));  // wants uv set 3
  Model bare = simplified();
  bare.attributes.uv_sets = 0;
  bare.uvs[0].clear();
  const json without = exported(bare);
  EXPECT_FALSE(without["materials"][0].contains("normalTexture"));
  EXPECT_FALSE(without["materials"][0]["pbrMetallicRoughness"].contains("baseColorTexture"));
  EXPECT_TRUE(without["materials"][0]["doubleSided"].get<bool>());
}

TEST_F(ExportFrom, ClipsFollowTheNodesByName) {
  // The same skeleton stored in another order: a node in front, so that no index agrees.
  Model model = simplified();
  model.nodes = {{"world", kNone, {}}, {"root", 0, {}}, {"elbow", 1, {{0.0, 0.0, 2.0}}}};
  model.joints[0].node = 1;
  model.joints[1].node = 2;
  exported(model);
  const Model back = importGltf(output()), source = importGltf(original());
  ASSERT_EQ(back.clips.size(), 2u);
  EXPECT_EQ(back.clips[0].name, "bend");
  EXPECT_EQ(back.nodes[back.clips[0].channels[0].node].name, "elbow");
  for (const double time : {0.0, 0.4, 1.0}) {
    const Pose a = clipPose(source, 0, time), b = clipPose(back, 0, time);
    for (size_t joint = 0; joint < 2; ++joint) {
      for (int column = 0; column < 4; ++column) {
        EXPECT_LT(glm::distance(a.palette[joint][column], b.palette[joint][column]), 1e-6) << time;
      }
    }
  }
}

TEST_F(ExportFrom, ClipsFollowTheNodesByOrderWhereTheyHaveNoNames) {
  Model model = simplified();
  for (Node& node : model.nodes) node.name.clear();
  const json gltf = exported(model);
  ASSERT_EQ(gltf["animations"].size(), 2u);
  EXPECT_EQ(gltf["animations"][0]["channels"][0]["target"]["node"], 1);
}

TEST_F(ExportFrom, ADamagedImageIsAnError) {
  json gltf = json::parse(textOf(original()));
  gltf["images"][3]["bufferView"] = 1000;
  writeText(original(), gltf.dump());
  try {
    writeGltf(simplified(), output(), {original()});
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("image 3"), std::string::npos) << error.what();
  }
  EXPECT_FALSE(std::filesystem::exists(output()));
}

}  // namespace
}  // namespace lithe::bake
