// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Arrays, triangles and attributes in every form that glTF has for them.
#include "gltf_draft.h"

namespace lithe::bake {
namespace {

const std::vector<std::array<uint32_t, 3>> kRibbonTriangles{{0, 2, 1}, {1, 2, 3}};

TEST(ImportGeometry, ReadsAPlainFile) {
  Ribbon ribbon;
  ribbon.add("materials", {{"name", "cloth"}});
  ribbon.primitive()["material"] = 0;
  const Model model = importBuilt(ribbon);
  EXPECT_EQ(model.triangles, kRibbonTriangles);
  ASSERT_EQ(model.positions.size(), 4u);
  EXPECT_EQ(model.positions[3], glm::vec3(2, 1, 0));
  ASSERT_EQ(model.parts.size(), 1u);
  EXPECT_EQ(model.parts[0].name, "ribbon");
  EXPECT_EQ(model.parts[0].rigid_node, kNone);
  EXPECT_EQ(model.materials[model.parts[0].material], "cloth");
  EXPECT_EQ(model.triangle_part, (std::vector<uint32_t>{0, 0}));
  EXPECT_DOUBLE_EQ(model.rest_diagonal, std::sqrt(5.0));
}

TEST(ImportGeometry, ReadsJsonWithEmbeddedAndExternalBuffers) {
  Ribbon ribbon;
  const std::filesystem::path external = tempFile(" data.bin");
  writeBytes(external, ribbon.binary.data(), ribbon.binary.size());
  std::string uri = external.filename().string();
  uri.replace(uri.find(' '), 1, "%20");
  ribbon.json["buffers"] = {{{"byteLength", ribbon.binary.size()}, {"uri", uri}}};
  const std::string document = ribbon.text();
  const Model model = importGltf(writeBytes(tempFile(".gltf"), document.data(), document.size()));
  EXPECT_EQ(model.triangles, kRibbonTriangles);
  // A buffer may be shorter than its file, and a byte order mark is no part of the document.
  ribbon.json["buffers"][0]["byteLength"] = ribbon.binary.size();
  writeBytes(external, (std::string(ribbon.binary.begin(), ribbon.binary.end()) + "padding").data(),
             ribbon.binary.size() + 7);
  const std::string marked = "\xef\xbb\xbf" + document;
  EXPECT_EQ(importGltf(writeBytes(tempFile(".gltf"), marked.data(), marked.size())).positions, model.positions);
}

TEST(ImportGeometry, ReadsDataUrisOfAnyMediaType) {
  // Positions alone: three corners of one rigid triangle, 36 bytes.
  GltfDraft triangle;
  triangle.add("bufferViews", {{"buffer", 0}, {"byteLength", 36}});
  triangle.add("accessors", {{"bufferView", 0}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
  triangle.add("meshes", {{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}});
  triangle.add("nodes", {{"mesh", 0}});
  const std::string data = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
  for (const char* media : {"application/octet-stream", "application/gltf-buffer", "application/x-anything"}) {
    triangle.json["buffers"] = {{{"byteLength", 36}, {"uri", std::string("data:") + media + ";base64," + data}}};
    const std::string document = triangle.text();
    const Model model = importGltf(writeBytes(tempFile(".gltf"), document.data(), document.size()));
    EXPECT_EQ(model.positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})) << media;
  }
}

TEST(ImportGeometry, ResolvesStripsFansAndMissingIndices) {
  Ribbon strip;
  strip.primitive()["mode"] = 5;
  strip.primitive()["indices"] = strip.accessor<uint8_t>("SCALAR", {0, 2, 1, 3, 3, 3});
  EXPECT_EQ(importBuilt(strip).triangles, (std::vector<std::array<uint32_t, 3>>{{0, 2, 1}, {1, 2, 3}}));
  Ribbon fan;
  fan.primitive()["mode"] = 6;
  fan.primitive()["indices"] = fan.accessor<uint32_t>("SCALAR", {0, 2, 3, 1});
  EXPECT_EQ(importBuilt(fan).triangles, (std::vector<std::array<uint32_t, 3>>{{0, 2, 3}, {0, 3, 1}}));
  Ribbon list;
  list.primitive().erase("indices");  // four vertices: one triangle, one vertex left over
  const Model model = importBuilt(list);
  EXPECT_EQ(model.triangles, (std::vector<std::array<uint32_t, 3>>{{0, 1, 2}}));
  EXPECT_EQ(model.positions.size(), 3u);
}

TEST(ImportGeometry, LeavesPointsAndLinesOut) {
  Ribbon ribbon;
  for (const int mode : {0, 1, 3, 7}) {
    nlohmann::json other = ribbon.primitive();
    other["mode"] = mode;
    ribbon.json["meshes"][0]["primitives"].push_back(other);
  }
  const Model model = importBuilt(ribbon);
  EXPECT_EQ(model.parts.size(), 1u);
  for (const char* place : {"primitive 1", "primitive 2", "primitive 3"}) {
    EXPECT_TRUE(warned(model, std::string("mesh 0 'ribbon', ") + place + ": it is made of points or lines")) << place;
  }
  EXPECT_TRUE(warned(model, "primitive 4: its mode 7 is not glTF's"));
}

TEST(ImportGeometry, ReadsInterleavedArrays) {
  Ribbon ribbon;
  std::vector<float> mixed;
  for (int v = 0; v < 4; ++v) {
    const float x = v < 2 ? 0.0f : 2.0f, y = static_cast<float>(v % 2);
    mixed.insert(mixed.end(), {x, y, 0.0f, 0.0f, 0.0f, 1.0f, x / 2, y});
  }
  const int view = ribbon.view(mixed.data(), mixed.size() * 4, 32);
  const auto at = [&](int offset, const char* type) {
    return ribbon.add(
        "accessors",
        {{"bufferView", view}, {"byteOffset", offset}, {"componentType", 5126}, {"count", 4}, {"type", type}});
  };
  ribbon.primitive()["attributes"]["POSITION"] = at(0, "VEC3");
  ribbon.primitive()["attributes"]["NORMAL"] = at(12, "VEC3");
  ribbon.primitive()["attributes"]["TEXCOORD_0"] = at(24, "VEC2");
  const Model model = importBuilt(ribbon);
  EXPECT_EQ(model.positions[2], glm::vec3(2, 0, 0));
  EXPECT_EQ(model.normals[1], glm::vec3(0, 0, 1));
  ASSERT_EQ(model.attributes.uv_sets, 1u);
  EXPECT_EQ(model.uvs[0][3], glm::vec2(1, 1));
  EXPECT_TRUE(model.warnings.empty());
}

TEST(ImportGeometry, AppliesSparseValuesWithAndWithoutABase) {
  Ribbon ribbon;
  const std::vector<uint16_t> elements{1, 3};
  const std::vector<float> values{0, 5, 0, 2, 5, 0};
  const nlohmann::json sparse = {
      {"count", 2},
      {"indices", {{"bufferView", ribbon.view(elements.data(), 4)}, {"componentType", 5123}}},
      {"values", {{"bufferView", ribbon.view(values.data(), 24)}}}};
  ribbon.json["accessors"][static_cast<size_t>(ribbon.position)]["sparse"] = sparse;
  EXPECT_EQ(importBuilt(ribbon).positions, (std::vector<glm::vec3>{{0, 0, 0}, {0, 5, 0}, {2, 0, 0}, {2, 5, 0}}));
  ribbon.json["accessors"][static_cast<size_t>(ribbon.position)].erase("bufferView");
  EXPECT_EQ(importBuilt(ribbon).positions, (std::vector<glm::vec3>{{0, 0, 0}, {0, 5, 0}, {0, 0, 0}, {2, 5, 0}}));
}

TEST(ImportGeometry, DequantisesAsTheAccessorSays) {
  Ribbon ribbon;
  ribbon.json["extensionsRequired"] = {"KHR_mesh_quantization", "KHR_texture_transform"};
  ribbon.primitive()["attributes"]["POSITION"] =
      ribbon.accessor<uint16_t>("VEC3", {0, 0, 0, 0, 7, 0, 9, 0, 0, 9, 7, 0});
  ribbon.primitive()["attributes"]["NORMAL"] =
      ribbon.accessor<int8_t>("VEC3", {0, 0, -128, 0, 0, 127, 0, 0, 127, 127, 0, 0}, true);
  ribbon.primitive()["attributes"]["TEXCOORD_0"] =
      ribbon.accessor<uint16_t>("VEC2", {0, 65535, 0, 0, 0, 0, 65535, 0}, true);
  const Model model = importBuilt(ribbon);
  EXPECT_EQ(model.positions[3], glm::vec3(9, 7, 0));
  EXPECT_EQ(model.normals[0], glm::vec3(0, 0, -1));
  EXPECT_EQ(model.normals[3], glm::vec3(1, 0, 0));
  EXPECT_EQ(model.uvs[0][0], glm::vec2(0, 1));
  EXPECT_DOUBLE_EQ(model.rest_diagonal, std::sqrt(81.0 + 49.0));
  EXPECT_TRUE(model.warnings.empty());
}

TEST(ImportGeometry, LeavesUnusedVerticesOut) {
  Ribbon ribbon;
  ribbon.primitive()["indices"] = ribbon.accessor<uint16_t>("SCALAR", {1, 2, 3});
  const Model model = importBuilt(ribbon);
  EXPECT_EQ(model.positions, (std::vector<glm::vec3>{{0, 1, 0}, {2, 0, 0}, {2, 1, 0}}));
  EXPECT_EQ(model.triangles, (std::vector<std::array<uint32_t, 3>>{{0, 1, 2}}));
  EXPECT_DOUBLE_EQ(model.rest_diagonal, std::sqrt(5.0)) << "the unit of errors is that of the whole array";
}

TEST(ImportGeometry, MakesSmoothNormalsOverEqualPositions) {
  // A roof of two triangles that share an edge only by position: along the edge normals are the mean, weighted by area.
  GltfDraft roof;
  const int position = roof.accessor<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 3});
  roof.add("meshes", {{"primitives", {{{"attributes", {{"POSITION", position}}}}}}});
  roof.add("nodes", {{"mesh", 0}});
  const Model model = importBuilt(roof);
  EXPECT_TRUE(warned(model, "6 vertices have no valid normal"));
  const glm::vec3 edge = glm::normalize(glm::vec3(3, 0, 1));
  for (const size_t v : {0u, 2u, 3u, 4u}) EXPECT_LT(glm::length(model.normals[v] - edge), 1e-6f) << v;
  EXPECT_EQ(model.normals[1], glm::vec3(0, 0, 1));
  EXPECT_EQ(model.normals[5], glm::vec3(1, 0, 0));
}

TEST(ImportGeometry, ReplacesOnlyInvalidDirections) {
  Ribbon ribbon;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  ribbon.primitive()["attributes"]["NORMAL"] = ribbon.accessor<float>("VEC3", {0, 3, 0, nan, 0, 0, 0, 0, 0, 0, 0, -1});
  ribbon.primitive()["attributes"]["TANGENT"] =
      ribbon.accessor<float>("VEC4", {2, 0, 0, -1, nan, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 0});
  const Model model = importBuilt(ribbon);
  EXPECT_EQ(model.normals, (std::vector<glm::vec3>{{0, 1, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, -1}}));
  EXPECT_EQ(model.tangents[0], glm::vec4(1, 0, 0, -1));
  for (size_t v = 0; v < 4; ++v) {
    EXPECT_NEAR(glm::length(glm::vec3(model.tangents[v])), 1.0f, 1e-6f);
    EXPECT_EQ(glm::dot(glm::vec3(model.tangents[v]), model.normals[v]), 0.0f);
  }
  EXPECT_TRUE(warned(model, "2 vertices have no valid normal"));
  EXPECT_TRUE(warned(model, "2 vertices have no valid tangent"));
}

TEST(ImportGeometry, FillsAttributesThatOtherPartsHave) {
  Ribbon ribbon;
  nlohmann::json rich = ribbon.primitive();
  rich["attributes"]["TEXCOORD_0"] = ribbon.accessor<float>("VEC2", {.1f, .1f, .2f, .2f, .3f, .3f, .4f, .4f});
  rich["attributes"]["COLOR_0"] = ribbon.accessor<uint8_t>("VEC3", {255, 0, 51, 0, 0, 0, 0, 0, 0, 0, 0, 0}, true);
  rich["attributes"]["TANGENT"] = ribbon.accessor<float>("VEC4", {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1});
  ribbon.json["meshes"][0]["primitives"].push_back(rich);
  const Model model = importBuilt(ribbon);
  ASSERT_EQ(model.positions.size(), 8u);
  ASSERT_EQ(model.uvs[0].size(), 8u);
  ASSERT_EQ(model.colors[0].size(), 8u);
  ASSERT_EQ(model.tangents.size(), 8u);
  EXPECT_EQ(model.uvs[0][1], glm::vec2(0, 0));
  EXPECT_EQ(model.uvs[0][5], glm::vec2(.2f, .2f));
  EXPECT_EQ(model.colors[0][0], glm::vec4(1, 1, 1, 1));
  EXPECT_EQ(model.colors[0][4], glm::vec4(1, 0, .2f, 1));
  EXPECT_EQ(model.triangle_part, (std::vector<uint32_t>{0, 0, 1, 1}));
}

TEST(ImportGeometry, LimitsSetsAndMentionsMorphTargets) {
  Ribbon ribbon;
  const int uv = ribbon.accessor<float>("VEC2", std::vector<float>(8));
  const int color = ribbon.accessor<float>("VEC4", std::vector<float>(16, 2.0f));
  for (int set = 0; set < 10; ++set) ribbon.primitive()["attributes"]["TEXCOORD_" + std::to_string(set)] = uv;
  for (int set = 0; set < 3; ++set) ribbon.primitive()["attributes"]["COLOR_" + std::to_string(set)] = color;
  ribbon.primitive()["targets"] = {{{"POSITION", ribbon.position}}, {{"POSITION", ribbon.position}}};
  const Model model = importBuilt(ribbon);
  EXPECT_EQ(model.attributes.uv_sets, kMaxUvSets);
  EXPECT_EQ(model.attributes.color_sets, kMaxColorSets);
  EXPECT_EQ(model.colors[1][0], glm::vec4(1, 1, 1, 1)) << "colours are clamped";
  EXPECT_TRUE(warned(model, "10 uv sets"));
  EXPECT_TRUE(warned(model, "3 colour sets"));
  EXPECT_TRUE(warned(model, "up to 2 per mesh are dropped"));
}

TEST(ImportGeometry, NeverOpensImages) {
  Ribbon ribbon;
  ribbon.add("images", {{"uri", "missing.webp"}});
  ribbon.add("images", {{"bufferView", 4711}, {"mimeType", "image/webp"}});
  ribbon.add("textures", {{"source", 0}, {"extensions", {{"EXT_texture_webp", {{"source", 1}}}}}});
  ribbon.json["extensionsRequired"] = {"EXT_texture_webp"};
  const Model model = importBuilt(ribbon);
  EXPECT_EQ(model.triangles.size(), 2u);
  EXPECT_TRUE(warned(model, "no valid normal"));
  EXPECT_EQ(model.warnings.size(), 1u);
}

}  // namespace
}  // namespace lithe::bake
