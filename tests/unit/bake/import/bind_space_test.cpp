// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// One bind space for all skins, and posed positions that do not notice.
#include "gltf_draft.h"
#include "lithe/bake/poses.h"

namespace lithe::bake {
namespace {

std::vector<float> matrix(float scale, glm::vec3 move) {
  return {scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0, move.x, move.y, move.z, 1};
}

std::vector<float> joined(std::vector<float> a, const std::vector<float>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// A second ribbon beside the first with a skin of its own over joints of choice. Its vertices are
/// (position - offset) / unit for positions in the space of the first; its inverse binds undo that.
void addRibbonInUnits(Ribbon& ribbon, float unit, glm::vec3 offset, const std::vector<int>& nodes) {
  std::vector<float> positions;
  for (const glm::vec3 p : {glm::vec3(0, 2, 0), glm::vec3(0, 3, 0), glm::vec3(2, 2, 0), glm::vec3(2, 3, 0)}) {
    for (int k = 0; k < 3; ++k) positions.push_back((p[k] - offset[k]) / unit);
  }
  const std::vector<float> binds = joined(matrix(unit, offset), matrix(unit, offset - glm::vec3(1, 0, 0)));
  nlohmann::json primitive = ribbon.primitive();
  primitive["attributes"]["POSITION"] = ribbon.accessor("VEC3", positions);
  const int mesh = ribbon.add("meshes", {{"primitives", nlohmann::json::array({primitive})}});
  const int skin = ribbon.add("skins", {{"joints", nodes}, {"inverseBindMatrices", ribbon.accessor("MAT4", binds)}});
  ribbon.json["scenes"][0]["nodes"].push_back(ribbon.add("nodes", {{"mesh", mesh}, {"skin", skin}}));
}

/// Posed by hand, independently of the import: b turned by a quarter about z, where b is child of a.
glm::dvec3 bent(const glm::dvec3& bind, double share_b) {
  const glm::dvec3 by_b(1 - bind.y, bind.x - 1, bind.z);
  return bind * (1 - share_b) + by_b * share_b;
}

Pose bendB(const Model& model) {
  std::vector<Transform> locals;
  for (const Node& node : model.nodes) locals.push_back(node.rest);
  for (size_t i = 0; i < model.nodes.size(); ++i) {
    if (model.nodes[i].name == "b") locals[i].rotation = glm::dquat(std::sqrt(0.5), 0, 0, std::sqrt(0.5));
  }
  return localPose(model, locals);
}

void expectBothRibbonsBent(const Model& model) {
  const std::vector<glm::dvec3> posed = skinPositions(model, bendB(model));
  const glm::dvec3 wanted[8] = {bent({0, 0, 0}, 0), bent({0, 1, 0}, 0), bent({2, 0, 0}, .5), bent({2, 1, 0}, .5),
                                bent({0, 2, 0}, 0), bent({0, 3, 0}, 0), bent({2, 2, 0}, .5), bent({2, 3, 0}, .5)};
  ASSERT_EQ(posed.size(), 8u);
  for (size_t v = 0; v < 8; ++v) EXPECT_LT(glm::length(posed[v] - wanted[v]), 1e-5) << "vertex " << v;
}

TEST(ImportBindSpace, LeavesACommonSpaceUntouched) {
  Ribbon ribbon;
  addRibbonInUnits(ribbon, 1.0f, {0, 0, 0}, {0, 1});
  const Model model = importBuilt(ribbon);
  EXPECT_EQ(model.joints.size(), 2u);
  EXPECT_EQ(model.positions[7], glm::vec3(2, 3, 0));
  expectBothRibbonsBent(model);
}

TEST(ImportBindSpace, BringsQuantisedSkinsTogether) {
  Ribbon ribbon;
  addRibbonInUnits(ribbon, 1.0f / 1024, {-1, 1, -2}, {0, 1});
  const Model model = importBuilt(ribbon);
  EXPECT_EQ(model.joints.size(), 2u) << "equal joints are one again";
  EXPECT_LT(glm::length(model.positions[7] - glm::vec3(2, 3, 0)), 1e-5f);
  EXPECT_GT(model.rest_diagonal, 1000.0) << "the unit is that of the file's own numbers";
  expectBothRibbonsBent(model);
}

TEST(ImportBindSpace, BringsGroupsWithoutCommonNodesTogetherByTheRestPose) {
  Ribbon ribbon;
  ribbon.json["nodes"][0]["children"] = {1, 3, 4};
  ribbon.add("nodes", {{"name", "c"}});
  ribbon.add("nodes", {{"name", "d"}, {"translation", {1, 0, 0}}});
  addRibbonInUnits(ribbon, 100.0f, {0, 0, 0}, {3, 4});
  const Model model = importBuilt(ribbon);
  EXPECT_EQ(model.joints.size(), 4u);
  EXPECT_LT(glm::length(model.positions[7] - glm::vec3(2, 3, 0)), 1e-5f);
  const std::vector<glm::dvec3> posed = skinPositions(model, restPose(model));
  EXPECT_LT(glm::length(posed[7] - glm::dvec3(2, 3, 0)), 1e-5);
}

TEST(ImportBindSpace, KeepsDifferentBindsOfOneNodeApart) {
  Ribbon ribbon;
  addRibbonInUnits(ribbon, 1.0f, {0, 0, 0}, {0, 1});
  // The second skin binds b one unit further: no single map takes one skin's space to the other's.
  const int binds = ribbon.accessor("MAT4", joined(matrix(1, {0, 0, 0}), matrix(1, {-2, 0, 0})));
  ribbon.json["skins"][1]["inverseBindMatrices"] = binds;
  const Model model = importBuilt(ribbon);
  EXPECT_EQ(model.joints.size(), 3u);
  const std::vector<glm::dvec3> posed = skinPositions(model, restPose(model));
  EXPECT_LT(glm::length(posed[6] - glm::dvec3(1.5, 2, 0)), 1e-5);
}

TEST(ImportBindSpace, TurnsNormalsAndTangentsAlong) {
  Ribbon ribbon;
  const std::vector<float> normals{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
  const std::vector<float> tangents{1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, -1, 1, 0, 0, -1};
  ribbon.primitive()["attributes"]["NORMAL"] = ribbon.accessor("VEC3", normals);
  ribbon.primitive()["attributes"]["TANGENT"] = ribbon.accessor("VEC4", tangents);
  addRibbonInUnits(ribbon, 10.0f, {0, 0, 0}, {0, 1});
  // Stretch the second skin's space threefold in z and turn it by a quarter about y: x -> -z, z -> x / 3.
  const std::vector<float> turned{0, 0, -10, 0, 0, 10, 0, 0, 30, 0, 0, 0};
  std::vector<float> binds = joined(turned, {0, 0, 0, 1});
  binds = joined(joined(binds, turned), {-1, 0, 0, 1});
  ribbon.json["skins"][1]["inverseBindMatrices"] = ribbon.accessor("MAT4", binds);
  const Model model = importBuilt(ribbon);
  EXPECT_LT(glm::length(model.normals[4] - glm::vec3(1, 0, 0)), 1e-6f);
  EXPECT_LT(glm::length(model.tangents[4] - glm::vec4(0, 0, -1, 1)), 1e-6f);
  EXPECT_EQ(model.tangents[6].w, -1.0f);
}

TEST(ImportBindSpace, KeepsIdleJointsOnce) {
  Ribbon ribbon;
  const int idle = ribbon.add("nodes", {{"name", "idle"}});
  ribbon.json["nodes"][0]["children"].push_back(idle);
  const int binds =
      ribbon.accessor("MAT4", joined(joined(matrix(1, {0, 0, 0}), matrix(1, {-1, 0, 0})), matrix(1, {7, 0, 0})));
  ribbon.json["skins"][0] = {{"joints", {0, 1, idle}}, {"inverseBindMatrices", binds}};
  addRibbonInUnits(ribbon, 1.0f, {0, 0, 0}, {0, 1});
  ribbon.json["skins"][1] = {{"joints", {0, 1, idle}}, {"inverseBindMatrices", binds}};
  const Model model = importBuilt(ribbon);
  ASSERT_EQ(model.joints.size(), 3u);
  EXPECT_EQ(model.nodes[model.joints[2].node].name, "idle");
  EXPECT_EQ(model.joints[2].inverse_bind[3][0], 7.0);
}

TEST(ImportBindSpace, MissingInverseBindsAreIdentity) {
  Ribbon ribbon;
  ribbon.json["skins"][0].erase("inverseBindMatrices");
  const Model model = importBuilt(ribbon);
  const std::vector<glm::dvec3> posed = skinPositions(model, restPose(model));
  EXPECT_LT(glm::length(posed[2] - glm::dvec3(2.5, 0, 0)), 1e-6);
}

TEST(ImportBindSpace, TakesSpacesFromJointsThatAreVisibleAtRest) {
  Ribbon ribbon;
  ribbon.json["nodes"][1]["scale"] = {0, 0, 0};
  addRibbonInUnits(ribbon, 100.0f, {0, 0, 0}, {0, 1});
  const Model model = importBuilt(ribbon);
  EXPECT_LT(glm::length(model.positions[7] - glm::vec3(2, 3, 0)), 1e-5f);
}

}  // namespace
}  // namespace lithe::bake
