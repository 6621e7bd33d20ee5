// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Draco and meshopt compression.
#include <draco/compression/expert_encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>

#include <algorithm>

#include "gltf_draft.h"

namespace lithe::bake {
namespace {

/// Replaces the data of an accessor's view by a compressed one whose uncompressed bytes lie in buffer 1, which is
/// absent.
void compressView(Ribbon& ribbon, int view, const std::vector<uint8_t>& data, size_t count, size_t stride,
                  const char* mode, const char* extension = "EXT_meshopt_compression", const char* filter = "NONE") {
  const int compressed = ribbon.view(data.data(), data.size());
  const nlohmann::json source = ribbon.json["bufferViews"][static_cast<size_t>(compressed)];
  ribbon.json["bufferViews"][static_cast<size_t>(view)] = {{"buffer", 1},
                                                           {"byteLength", count * stride},
                                                           {"extensions",
                                                            {{extension,
                                                              {{"buffer", 0},
                                                               {"byteOffset", source["byteOffset"]},
                                                               {"byteLength", data.size()},
                                                               {"byteStride", stride},
                                                               {"count", count},
                                                               {"mode", mode},
                                                               {"filter", filter}}}}}};
  if (std::string(mode) == "ATTRIBUTES") ribbon.json["bufferViews"][static_cast<size_t>(view)]["byteStride"] = stride;
  ribbon.json["buffers"] = {{{"byteLength", ribbon.binary.size()}},
                            {{"byteLength", 4096}, {"extensions", {{extension, {{"fallback", true}}}}}}};
}

std::vector<uint8_t> encodeVertices(const void* data, size_t count, size_t stride) {
  std::vector<uint8_t> out(meshopt_encodeVertexBufferBound(count, stride));
  out.resize(meshopt_encodeVertexBuffer(out.data(), out.size(), data, count, stride));
  return out;
}

int viewOf(Ribbon& ribbon, int accessor) {
  return ribbon.json["accessors"][static_cast<size_t>(accessor)]["bufferView"];
}

TEST(ImportMeshopt, DecodesAttributesTrianglesAndSequences) {
  const Model plain = importBuilt(Ribbon());
  for (const char* extension : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    for (const bool sequence : {false, true}) {
      Ribbon ribbon;
      const float positions[12] = {0, 0, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0};
      compressView(ribbon, viewOf(ribbon, ribbon.position), encodeVertices(positions, 4, 12), 4, 12, "ATTRIBUTES",
                   extension);
      const unsigned indices[6] = {0, 2, 1, 1, 2, 3};
      std::vector<uint8_t> coded(256);
      coded.resize(sequence ? meshopt_encodeIndexSequence(coded.data(), coded.size(), indices, 6)
                            : meshopt_encodeIndexBuffer(coded.data(), coded.size(), indices, 6));
      compressView(ribbon, viewOf(ribbon, ribbon.indices), coded, 6, 2, sequence ? "INDICES" : "TRIANGLES", extension);
      const Model model = importBuilt(ribbon);
      EXPECT_EQ(model.positions, plain.positions);
      ASSERT_EQ(model.triangles.size(), plain.triangles.size());
      for (size_t t = 0; t < 2; ++t) {  // the codec may turn a triangle's corners round
        auto corners = model.triangles[t];
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        EXPECT_EQ(corners, plain.triangles[t]);
      }
    }
  }
}

TEST(ImportMeshopt, AppliesFilters) {
  Ribbon ribbon;
  const float normals[16] = {0, 0, 1, 0, 1, 0, 0, 0, 0, -1, 0, 0, .6f, 0, .8f, 0};
  int8_t octahedral[16];
  meshopt_encodeFilterOct(octahedral, 4, 4, 8, normals);
  const int normal = ribbon.accessor<int8_t>("VEC3", std::vector<int8_t>(12), true);
  compressView(ribbon, viewOf(ribbon, normal), encodeVertices(octahedral, 4, 4), 4, 4, "ATTRIBUTES",
               "EXT_meshopt_compression", "OCTAHEDRAL");
  ribbon.primitive()["attributes"]["NORMAL"] = normal;
  const float positions[12] = {0, 0, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0};
  uint32_t exponential[12];
  meshopt_encodeFilterExp(exponential, 4, 12, 15, positions);
  compressView(ribbon, viewOf(ribbon, ribbon.position), encodeVertices(exponential, 4, 12), 4, 12, "ATTRIBUTES",
               "EXT_meshopt_compression", "EXPONENTIAL");
  const Model model = importBuilt(ribbon);
  EXPECT_LT(glm::length(model.positions[3] - glm::vec3(2, 1, 0)), 1e-3f);
  EXPECT_LT(glm::length(model.normals[1] - glm::vec3(1, 0, 0)), 1e-2f);
  EXPECT_LT(glm::length(model.normals[3] - glm::vec3(.6f, 0, .8f)), 1e-2f);
}

TEST(ImportMeshopt, RefusesWhatItCannotDecode) {
  const float positions[12] = {0, 0, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0};
  const std::vector<uint8_t> good = encodeVertices(positions, 4, 12);
  const auto complaint = [&](std::vector<uint8_t> data, size_t count, size_t stride, const char* mode,
                             const char* filter) {
    Ribbon ribbon;
    compressView(ribbon, viewOf(ribbon, ribbon.position), data, count, stride, mode, "EXT_meshopt_compression", filter);
    return complaintAbout(ribbon.glb());
  };
  EXPECT_EQ(complaint(good, 4, 12, "ATTRIBUTES", "NONE"), "nothing");
  std::vector<uint8_t> newer = good, cut(good.begin(), good.end() - 5);
  newer[0] = 0xa1;
  EXPECT_NE(complaint(newer, 4, 12, "ATTRIBUTES", "NONE").find("version 1 of meshopt's vertex codec"),
            std::string::npos);
  EXPECT_NE(complaint(cut, 4, 12, "ATTRIBUTES", "NONE").find("buffer view 0: its compressed data is damaged"),
            std::string::npos);
  EXPECT_NE(complaint(good, 1u << 30, 12, "ATTRIBUTES", "NONE").find("claims more elements"), std::string::npos);
  EXPECT_NE(complaint(good, 4, 10, "TRIANGLES", "NONE").find("sizes of its compression"), std::string::npos);
  EXPECT_NE(complaint(good, 4, 12, "TRIANGLES", "NONE").find("sizes of its compression"), std::string::npos);
  EXPECT_NE(complaint(good, 4, 12, "VERTICES", "NONE").find("mode 'VERTICES'"), std::string::npos);
  EXPECT_NE(complaint(good, 4, 12, "ATTRIBUTES", "COLOR").find("filter 'COLOR'"), std::string::npos);
  EXPECT_NE(complaint(good, 4, 12, "ATTRIBUTES", "OCTAHEDRAL").find("filter 'OCTAHEDRAL'"), std::string::npos);
}

/// The ribbon with positions, joints and weights in one Draco mesh. `quantised` weights are normalised bytes.
Ribbon dracoRibbon() {
  Ribbon ribbon;
  const float position[4][3] = {{0, 0, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}};
  const uint8_t joint[4][4] = {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}};
  const uint8_t weight[4][4] = {{255, 0, 0, 0}, {255, 0, 0, 0}, {204, 51, 0, 0}, {204, 51, 0, 0}};
  const int corners[2][3] = {{0, 2, 1}, {1, 2, 3}};
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(2);
  const int positions = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const int joints = builder.AddAttribute(draco::GeometryAttribute::GENERIC, 4, draco::DT_UINT8);
  const int weights = builder.AddAttribute(draco::GeometryAttribute::GENERIC, 4, draco::DT_UINT8);
  for (int t = 0; t < 2; ++t) {
    const int* c = corners[t];
    const draco::FaceIndex face(static_cast<uint32_t>(t));
    builder.SetAttributeValuesForFace(positions, face, position[c[0]], position[c[1]], position[c[2]]);
    builder.SetAttributeValuesForFace(joints, face, joint[c[0]], joint[c[1]], joint[c[2]]);
    builder.SetAttributeValuesForFace(weights, face, weight[c[0]], weight[c[1]], weight[c[2]]);
  }
  const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
  draco::ExpertEncoder encoder(*mesh);
  encoder.SetAttributeQuantization(positions, 14);
  draco::EncoderBuffer coded;
  EXPECT_TRUE(encoder.EncodeToBuffer(&coded).ok());
  const int view = ribbon.view(coded.data(), coded.size());
  for (const int accessor : {ribbon.position, ribbon.joints, ribbon.weights, ribbon.indices}) {
    ribbon.json["accessors"][static_cast<size_t>(accessor)].erase("bufferView");
  }
  ribbon.json["accessors"][static_cast<size_t>(ribbon.weights)]["normalized"] = true;
  const auto id = [&](int attribute) { return mesh->attribute(attribute)->unique_id(); };
  ribbon.primitive()["extensions"]["KHR_draco_mesh_compression"] = {
      {"bufferView", view},
      {"attributes", {{"POSITION", id(positions)}, {"JOINTS_0", id(joints)}, {"WEIGHTS_0", id(weights)}}}};
  ribbon.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  return ribbon;
}

TEST(ImportDraco, DecodesPrimitives) {
  const Model model = importBuilt(dracoRibbon());
  ASSERT_EQ(model.positions.size(), 4u);
  ASSERT_EQ(model.triangles.size(), 2u);
  double area = 0.0;
  for (const auto& [a, b, c] : model.triangles) {
    const glm::vec3 normal =
        glm::cross(model.positions[b] - model.positions[a], model.positions[c] - model.positions[a]);
    area += normal.z / 2;
  }
  EXPECT_NEAR(area, 2.0, 1e-3) << "the ribbon, facing the same way";
  for (size_t v = 0; v < 4; ++v) {
    const bool at_a = model.positions[v].x < 1.0f;
    EXPECT_EQ(model.skins[v].count, at_a ? 1 : 2);
    EXPECT_NEAR(model.skins[v].weight[0], at_a ? 1.0f : 0.8f, 1e-6f);
  }
  EXPECT_FALSE(warned(model, "sum to one"));
}

TEST(ImportDraco, ReadsUncompressedAttributesBesideIt) {
  Ribbon ribbon = dracoRibbon();
  ribbon.primitive()["attributes"]["TEXCOORD_0"] =
      ribbon.accessor<float>("VEC2", {.1f, .1f, .2f, .2f, .3f, .3f, .4f, .4f});
  EXPECT_EQ(importBuilt(ribbon).uvs[0][1], glm::vec2(.2f, .2f));
  ribbon.primitive()["attributes"]["TEXCOORD_0"] = ribbon.accessor<float>("VEC2", {.1f, .1f});
  EXPECT_NE(complaintAbout(ribbon.glb()).find("TEXCOORD_0: it has 1 elements for 4 vertices"), std::string::npos);
}

TEST(ImportDraco, RefusesDamagedData) {
  const Ribbon good = dracoRibbon();
  const nlohmann::json view = good.json["bufferViews"].back();
  const size_t begin = view["byteOffset"], size = view["byteLength"];
  uint32_t refused = 0;
  for (size_t i = 0; i < size; ++i) {
    for (const uint8_t flip : {0x01, 0x80, 0xff}) {
      Ribbon damaged = good;
      damaged.binary[begin + i] ^= flip;
      const std::string complaint = complaintAbout(damaged.glb());
      if (complaint.find("Draco data cannot be decoded") != std::string::npos) ++refused;
    }
  }
  EXPECT_GT(refused, size / 2) << "most flips break the decoding, none the process";
  Ribbon cut = good;
  cut.json["bufferViews"].back()["byteLength"] = size / 2;
  EXPECT_NE(complaintAbout(cut.glb()).find("Draco data cannot be decoded"), std::string::npos);
  Ribbon missing = good;
  missing.primitive()["extensions"]["KHR_draco_mesh_compression"]["attributes"]["POSITION"] = 77;
  EXPECT_NE(complaintAbout(missing.glb()).find("there is no attribute 77"), std::string::npos);
}

}  // namespace
}  // namespace lithe::bake
