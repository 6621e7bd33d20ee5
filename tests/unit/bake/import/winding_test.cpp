// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Mirrored nodes and joints: posed faces point outwards, as viewers draw them, and stay so through the export.
#include "gltf_draft.h"
#include "lithe/bake/export.h"
#include "lithe/bake/poses.h"

namespace lithe::bake {
namespace {

/// Corners of a tetrahedron and its faces, counter-clockwise seen from outside.
const std::vector<float> kCorners{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
const std::vector<uint16_t> kFaces{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
const std::vector<uint16_t> kTurnedFaces{0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2};

nlohmann::json solidPrimitive(GltfDraft& builder, const std::vector<uint16_t>& faces) {
  return {{"attributes", {{"POSITION", builder.accessor("VEC3", kCorners)}}},
          {"indices", builder.accessor("SCALAR", faces)}};
}

int addSolid(GltfDraft& builder, nlohmann::json node, const std::vector<uint16_t>& faces = kFaces) {
  node["mesh"] = builder.add("meshes", {{"primitives", nlohmann::json::array({solidPrimitive(builder, faces)})}});
  return builder.add("nodes", node);
}

/// A tetrahedron whose one joint, scaled by `joint_scale`, moves all of it; `shown_below` it or at the root.
GltfDraft skinnedSolid(const nlohmann::json& joint_scale, const nlohmann::json& mesh_scale, bool shown_below,
                       const std::vector<uint16_t>& faces) {
  GltfDraft builder;
  nlohmann::json primitive = solidPrimitive(builder, faces);
  primitive["attributes"]["JOINTS_0"] = builder.accessor<uint8_t>("VEC4", std::vector<uint8_t>(16));
  primitive["attributes"]["WEIGHTS_0"] =
      builder.accessor<float>("VEC4", {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
  builder.add("meshes", {{"primitives", nlohmann::json::array({primitive})}});
  builder.add("skins", {{"joints", {0}}});
  builder.add("nodes", {{"name", "joint"}, {"scale", joint_scale}});
  builder.add("nodes", {{"name", "shows"}, {"mesh", 0}, {"skin", 0}, {"scale", mesh_scale}});
  if (shown_below) builder.json["nodes"][0]["children"] = {1};
  return builder;
}

/// Six times the volume that the posed faces of one part enclose: positive where they point outwards.
double posedVolume(const Model& model, uint32_t part) {
  const std::vector<glm::dvec3> posed = skinPositions(model, restPose(model));
  double volume = 0.0;
  for (size_t t = 0; t < model.triangles.size(); ++t) {
    const auto& [a, b, c] = model.triangles[t];
    if (model.triangle_part[t] == part) volume += glm::dot(posed[a], glm::cross(posed[b], posed[c]));
  }
  return volume;
}

/// Whether the posed normals of all corners point away from the posed middle.
bool normalsPointOutwards(const Model& model) {
  const Pose rest = restPose(model);
  const std::vector<glm::dvec3> posed = skinPositions(model, rest);
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& p : posed) middle += p / static_cast<double>(posed.size());
  for (size_t v = 0; v < posed.size(); ++v) {
    const glm::dmat3 to_world(rest.palette[model.skins[v].joint[0]]);
    const glm::dvec3 normal = glm::transpose(glm::inverse(to_world)) * glm::dvec3(model.normals[v]);
    if (!(glm::dot(normal, posed[v] - middle) > 0.0)) return false;
  }
  return true;
}

Model exportedAndBack(const Model& model) {
  const std::filesystem::path path = tempFile("_back.glb");
  writeGltf(model, path, {});
  return importGltf(path);
}

void expectSame(const Model& a, const Model& b) {
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.triangle_part, b.triangle_part);
  ASSERT_EQ(a.positions.size(), b.positions.size());
  const std::vector<glm::dvec3> posed_a = skinPositions(a, restPose(a)), posed_b = skinPositions(b, restPose(b));
  for (size_t v = 0; v < a.positions.size(); ++v) {
    EXPECT_LT(glm::length(a.positions[v] - b.positions[v]), 1e-6f) << v;
    EXPECT_LT(glm::length(a.normals[v] - b.normals[v]), 1e-6f) << v;
    EXPECT_LT(glm::length(posed_a[v] - posed_b[v]), 1e-6) << v;
  }
  ASSERT_EQ(a.tangents.size(), b.tangents.size());
  for (size_t v = 0; v < a.tangents.size(); ++v) {
    EXPECT_LT(glm::length(a.tangents[v] - b.tangents[v]), 1e-6f) << v;
  }
}

void expectOutwardsAndBack(const GltfDraft& builder, double volume) {
  const Model model = importBuilt(builder), back = exportedAndBack(model);
  EXPECT_NEAR(posedVolume(model, 0), volume, 1e-6);
  EXPECT_TRUE(normalsPointOutwards(model));
  expectSame(model, back);
  EXPECT_NEAR(posedVolume(back, 0), volume, 1e-6);
}

TEST(ImportWinding, RigidPartsOfMirroredNodesAreTurned) {
  GltfDraft one, two;
  addSolid(one, {{"scale", {-2, 1, 1}}});
  expectOutwardsAndBack(one, 2.0);
  EXPECT_EQ(importBuilt(one).triangles[0], (std::array<uint32_t, 3>{0, 1, 2}));
  addSolid(two, {{"scale", {-2, 1, -1}}});  // mirrored twice: not at all
  expectOutwardsAndBack(two, 2.0);
  EXPECT_EQ(importBuilt(two).triangles[0], (std::array<uint32_t, 3>{0, 2, 1}));
}

TEST(ImportWinding, AMirroringAncestorOrMatrixTurnsToo) {
  GltfDraft below;
  below.add("nodes", {{"scale", {1, 1, -3}}, {"children", {1}}});
  addSolid(below, {{"translation", {5, 0, 0}}});
  expectOutwardsAndBack(below, 3.0);
  GltfDraft matrix;
  addSolid(matrix, {{"matrix", {0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 2, 1}}});
  expectOutwardsAndBack(matrix, 1.0);
}

TEST(ImportWinding, RigidPartsBesideAMirroredSkinKeepTheirOwnSide) {
  // Bind space is mirrored against the rest pose, the rigid part is not, although its way from bind space mirrors.
  GltfDraft builder = skinnedSolid({-1, 1, 1}, {1, 1, 1}, false, kTurnedFaces);
  addSolid(builder, {{"name", "rigid"}, {"translation", {3, 0, 0}}});
  builder.add("nodes", {{"mesh", 0}, {"skin", 0}});  // shown last, where the export puts it
  builder.json["nodes"][1] = {{"name", "nothing"}};
  const Model model = importBuilt(builder), back = exportedAndBack(model);
  EXPECT_NEAR(posedVolume(model, 0), 1.0, 1e-6);
  EXPECT_NEAR(posedVolume(model, 1), 1.0, 1e-6);
  expectSame(model, back);
}

TEST(ImportWinding, SkinnedPartsBelowAMirroringRootAreTurned) {
  // The node that shows the mesh mirrors with the joints: viewers turn the faces round.
  expectOutwardsAndBack(skinnedSolid({-1, 1, 1}, {1, 1, 1}, true, kFaces), 1.0);
}

TEST(ImportWinding, SkinnedPartsAreDrawnAsWoundWhereTheirNodeDoesNotMirror) {
  expectOutwardsAndBack(skinnedSolid({-1, 1, 1}, {1, 1, 1}, false, kTurnedFaces), 1.0);
}

TEST(ImportWinding, TheNodeOfASkinnedMeshAloneTurnsNothing) {
  // glTF ignores its transform, so nothing is mirrored.
  expectOutwardsAndBack(skinnedSolid({1, 1, 1}, {-1, 1, 1}, false, kFaces), 1.0);
}

TEST(ImportWinding, NodesScaledToNothingTurnNothing) {
  GltfDraft builder;
  addSolid(builder, {{"scale", {-1, 0, 0}}});
  const Model model = importBuilt(builder);
  EXPECT_EQ(model.triangles[0], (std::array<uint32_t, 3>{0, 2, 1}));
  expectSame(model, exportedAndBack(model));
}

TEST(ImportWinding, TangentsOfTurnedPartsChangeHands) {
  for (const float hand : {1.0f, -1.0f}) {
    GltfDraft builder;
    const int node = addSolid(builder, {{"scale", {1, -1, 1}}});
    std::vector<float> tangents;
    for (int v = 0; v < 4; ++v) tangents.insert(tangents.end(), {0, 0, 1, hand});
    builder.json["meshes"][0]["primitives"][0]["attributes"]["TANGENT"] = builder.accessor("VEC4", tangents);
    const Model model = importBuilt(builder);
    for (const glm::vec4& tangent : model.tangents) EXPECT_EQ(tangent.w, -hand);
    expectSame(model, exportedAndBack(model));
    builder.json["nodes"][static_cast<size_t>(node)].erase("scale");
    EXPECT_EQ(importBuilt(builder).tangents[0].w, hand);
  }
}

}  // namespace
}  // namespace lithe::bake
