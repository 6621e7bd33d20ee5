// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "skeleton_writer.h"

#include <set>

namespace lithe::bake {

namespace {

Json nodeJson(const Node& node) {
  Json json = Json::object();
  if (!node.name.empty()) json["name"] = node.name;
  const glm::dvec3 &t = node.rest.translation, &s = node.rest.scale;
  const glm::dquat r = glm::normalize(node.rest.rotation);
  if (t != glm::dvec3(0.0)) json["translation"] = {t.x, t.y, t.z};
  if (r != glm::dquat(1.0, 0.0, 0.0, 0.0)) json["rotation"] = {r.x, r.y, r.z, r.w};
  if (s != glm::dvec3(1.0)) json["scale"] = {s.x, s.y, s.z};
  return json;
}

uint32_t rootOf(const Model& model, uint32_t node) {
  while (model.nodes[node].parent != kNone) node = model.nodes[node].parent;
  return node;
}

std::set<uint32_t> rootsOfJoints(const Model& model) {
  std::set<uint32_t> roots;
  for (const Joint& joint : model.joints) roots.insert(rootOf(model, joint.node));
  return roots;
}

/// glTF wants the joints of a skin below one node: where the model has several roots, one that does not move is put
/// above.
void joinRoots(const std::set<uint32_t>& roots, GltfBuilder& gltf) {
  Json children = Json::array();
  for (const uint32_t root : roots) children.push_back(root);
  Json& shown = gltf.json["scenes"][0]["nodes"];
  for (size_t i = shown.size(); i-- > 0;) {
    if (roots.contains(shown[i].get<uint32_t>())) shown.erase(i);
  }
  appendSceneNode({{"name", "skeleton"}, {"children", std::move(children)}}, gltf);
}

}  // namespace

void writeNodes(const Model& model, GltfBuilder& gltf) {
  gltf.json["scene"] = 0;
  gltf.json["scenes"] = Json::array({{{"nodes", Json::array()}}});
  for (uint32_t i = 0; i < model.nodes.size(); ++i) {
    gltf.append("nodes", nodeJson(model.nodes[i]));
    const uint32_t parent = model.nodes[i].parent;
    Json& siblings = parent == kNone ? gltf.json["scenes"][0]["nodes"] : gltf.json["nodes"][parent]["children"];
    siblings.push_back(i);
  }
}

void appendSceneNode(Json entry, GltfBuilder& gltf) {
  gltf.json["scenes"][0]["nodes"].push_back(gltf.append("nodes", std::move(entry)));
}

uint32_t appendChildNode(Json entry, uint32_t parent, GltfBuilder& gltf) {
  const uint32_t node = gltf.append("nodes", std::move(entry));
  gltf.json["nodes"][parent]["children"].push_back(node);
  return node;
}

uint32_t writeSkin(const Model& model, GltfBuilder& gltf) {
  std::vector<bool> listed(model.nodes.size(), false);
  std::vector<float> inverse_binds;
  Json joints = Json::array();
  for (const Joint& joint : model.joints) {
    uint32_t node = joint.node;
    if (listed[node]) {
      Json twin = Json::object();
      if (!model.nodes[node].name.empty()) twin["name"] = model.nodes[node].name;
      node = appendChildNode(std::move(twin), node, gltf);
    } else {
      listed[node] = true;
    }
    joints.push_back(node);
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 4; ++row) inverse_binds.push_back(static_cast<float>(joint.inverse_bind[column][row]));
    }
  }
  const std::set<uint32_t> roots = rootsOfJoints(model);
  if (roots.size() > 1) joinRoots(roots, gltf);
  const uint32_t accessor = gltf.addFloats(inverse_binds, "MAT4", ViewTarget::kPlain);
  return gltf.append("skins", {{"inverseBindMatrices", accessor}, {"joints", std::move(joints)}});
}

}  // namespace lithe::bake
