// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Nodes, the parts they show, and rigid parts.
#include "gltf_draft.h"
#include "lithe/bake/poses.h"

namespace lithe::bake {
namespace {

void expectNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-6) {
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], tolerance) << "component " << k;
}

std::vector<std::string> nodeNames(const Model& model) {
  std::vector<std::string> names;
  for (const Node& node : model.nodes) names.push_back(node.name);
  return names;
}

/// Adds a node that shows one triangle (0,0,0) (1,0,0) (0,1,0) without a skin.
int addProp(GltfDraft& builder, nlohmann::json node) {
  const int position = builder.accessor<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0});
  node["mesh"] =
      builder.add("meshes", {{"name", "prop"}, {"primitives", {{{"attributes", {{"POSITION", position}}}}}}});
  return builder.add("nodes", node);
}

TEST(ImportScene, KeepsJointsTheirAncestorsAndRigidNodesParentsFirst) {
  Ribbon ribbon;
  // File order: a, b, shows, prop, root; prop hangs on b, a hangs on root; "idle" is of no use.
  ribbon.json["nodes"][1]["children"] = {addProp(ribbon, {{"name", "prop"}})};
  const int root = ribbon.add("nodes", {{"name", "root"}, {"children", {0}}});
  const int idle = ribbon.add("nodes", {{"name", "idle"}});
  ribbon.json["scenes"][0]["nodes"] = {root, 2, idle};
  const Model model = importBuilt(ribbon);
  EXPECT_EQ(nodeNames(model), (std::vector<std::string>{"root", "a", "b", "prop"}));
  for (size_t i = 0; i < model.nodes.size(); ++i)
    EXPECT_TRUE(model.nodes[i].parent == kNone || model.nodes[i].parent < i);
  EXPECT_EQ(model.nodes[2].parent, 1u);
  ASSERT_EQ(model.parts.size(), 2u);
  EXPECT_EQ(model.parts[1].rigid_node, 3u);
  EXPECT_EQ(model.parts[1].source_mesh, 1u);
}

TEST(ImportScene, ReadsOnlyTheDefaultScene) {
  Ribbon ribbon;
  addProp(ribbon, {{"name", "elsewhere"}});
  EXPECT_EQ(importBuilt(ribbon).parts.size(), 1u);
  ribbon.add("scenes", {{"nodes", {3}}});
  ribbon.json["scene"] = 1;
  EXPECT_EQ(nodeNames(importBuilt(ribbon)), (std::vector<std::string>{"elsewhere"}));
  ribbon.json.erase("scene");
  ribbon.json.erase("scenes");
  EXPECT_EQ(importBuilt(ribbon).parts.size(), 2u);
}

TEST(ImportScene, ImportsAMeshOncePerNodeThatShowsIt) {
  Ribbon ribbon;
  const int first = addProp(ribbon, {{"name", "left"}, {"translation", {5, 0, 0}}});
  nlohmann::json copy = ribbon.json["nodes"][static_cast<size_t>(first)];
  copy["name"] = "right";
  copy["translation"] = {-5, 0, 0};
  ribbon.json["scenes"][0]["nodes"] = {0, 2, first, ribbon.add("nodes", copy)};
  const Model model = importBuilt(ribbon);
  ASSERT_EQ(model.parts.size(), 3u);
  ASSERT_EQ(model.joints.size(), 4u);
  const std::vector<glm::dvec3> posed = skinPositions(model, restPose(model));
  expectNear(posed[4], {5, 0, 0});
  expectNear(posed[7], {-5, 0, 0});
}

TEST(ImportScene, DecomposesMatrices) {
  Ribbon ribbon;
  // Half a turn about z, scale (2, 3, -4), then moved to (5, 6, 7).
  ribbon.json["nodes"][0]["matrix"] = {-2, 0, 0, 0, 0, -3, 0, 0, 0, 0, -4, 0, 5, 6, 7, 1};
  const Model model = importBuilt(ribbon);
  const glm::dmat4 wanted(-2, 0, 0, 0, 0, -3, 0, 0, 0, 0, -4, 0, 5, 6, 7, 1);
  const glm::dmat4 matrix = model.nodes[0].rest.matrix();
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) EXPECT_NEAR(matrix[c][r], wanted[c][r], 1e-12);
  }
  EXPECT_FALSE(warned(model, "sheared"));
  ribbon.json["nodes"][0]["matrix"] = {1, 0, 0, 0, .5, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  EXPECT_TRUE(warned(importBuilt(ribbon), "node 0 'a': its matrix is sheared"));
}

TEST(ImportScene, NormalisesRotations) {
  Ribbon ribbon;
  ribbon.json["nodes"][0]["rotation"] = {0, 0, 3, 3};
  ribbon.json["nodes"][1]["rotation"] = {0, 0, 0, 0};
  const Model model = importBuilt(ribbon);
  EXPECT_NEAR(model.nodes[0].rest.rotation.z, std::sqrt(0.5), 1e-12);
  EXPECT_EQ(model.nodes[1].rest.rotation.w, 1.0);
}

TEST(ImportScene, PutsRigidPartsBesideSkinnedOnesInBindSpace) {
  Ribbon ribbon;
  // The skeleton stands 10 above and twice as large as bind space; the prop hangs on b.
  ribbon.json["nodes"][0]["translation"] = {0, 10, 0};
  ribbon.json["nodes"][0]["scale"] = {2, 2, 2};
  ribbon.json["nodes"][1]["children"] = {addProp(ribbon, {{"name", "prop"}, {"translation", {3, 0, 0}}})};
  const Model model = importBuilt(ribbon);
  expectNear(model.positions[0], {0, 0, 0});  // the skinned part is as in the file
  expectNear(model.positions[4], {4, 0, 0});  // and the prop where it is seen from there
  const std::vector<glm::dvec3> posed = skinPositions(model, restPose(model));
  expectNear(posed[4], {8, 10, 0});
  EXPECT_EQ(model.skins[4].count, 1u);
  EXPECT_EQ(model.nodes[model.joints[model.skins[4].joint[0]].node].name, "prop");
  EXPECT_DOUBLE_EQ(model.rest_diagonal, std::sqrt(5.0)) << "of the skinned part alone";
}

TEST(ImportScene, CharactersMayBeRigidAltogether) {
  GltfDraft builder;
  builder.json["nodes"] = {{{"name", "root"}, {"children", {1}}, {"translation", {0, 1, 0}}}};
  addProp(builder, {{"name", "prop"}, {"scale", {0, 0, 0}}});
  const Model hidden = importBuilt(builder);
  EXPECT_EQ(hidden.positions[1], glm::vec3(1, 0, 0)) << "scaled to nothing at rest, kept as it is";
  expectNear(skinPositions(hidden, restPose(hidden))[1], {0, 1, 0});
  EXPECT_DOUBLE_EQ(hidden.rest_diagonal, std::sqrt(2.0));
  builder.json["nodes"][1]["scale"] = {3, 3, 3};
  const Model shown = importBuilt(builder);
  expectNear(shown.positions[1], {3, 1, 0});
  expectNear(skinPositions(shown, restPose(shown))[1], {3, 1, 0});
}

}  // namespace
}  // namespace lithe::bake
