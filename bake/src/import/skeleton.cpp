// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "skeleton.h"

#include <algorithm>
#include <map>

#include "box.h"
#include "transform.h"

namespace lithe::bake {

namespace {

/// Posed positions may differ by this part of the character's diagonal for two joints to be one.
constexpr double kSamePosed = 1e-6;
constexpr size_t kMaxJoints = 65536;

/// Per joint: the box of the vertices it influences.
std::vector<Box> influenceBoxes(const Draft& draft) {
  std::vector<Box> boxes(draft.joints.size());
  for (size_t v = 0; v < draft.skins.size(); ++v) {
    const FileSkin& skin = draft.skins[v];
    for (uint32_t k = 0; k < skin.count; ++k) boxes[skin.joint[k]].add(glm::dvec3(draft.model.positions[v]));
  }
  return boxes;
}

double diagonalOf(const std::vector<glm::vec3>& positions) {
  Box box;
  for (const glm::vec3& position : positions) box.add(glm::dvec3(position));
  return box.diagonal();
}

/// Per joint of the file: the joint that stands for it (the first of its kind).
std::vector<uint32_t> findRepresentatives(const Draft& draft) {
  const std::vector<Box> boxes = influenceBoxes(draft);
  const double diagonal = diagonalOf(draft.model.positions);
  std::map<uint32_t, std::vector<uint32_t>> kinds;  // by node: joints that differ
  std::vector<uint32_t> representative(draft.joints.size(), kNone);
  for (uint32_t joint = 0; joint < draft.joints.size(); ++joint) {
    if (boxes[joint].empty()) continue;
    const glm::dmat4& bind = draft.joints[joint].inverse_bind;
    std::vector<uint32_t>& known = kinds[draft.joints[joint].node];
    const auto same = std::find_if(known.begin(), known.end(), [&](uint32_t other) {
      return largestDifference(bind, draft.joints[other].inverse_bind, boxes[joint]) <=
             kSamePosed * lengthScale(bind) * diagonal;
    });
    representative[joint] = same == known.end() ? joint : *same;
    if (same == known.end()) known.push_back(joint);
  }
  for (uint32_t joint = 0; joint < draft.joints.size(); ++joint) {
    if (representative[joint] != kNone) continue;
    std::vector<uint32_t>& known = kinds[draft.joints[joint].node];
    if (known.empty()) known.push_back(joint);
    representative[joint] = known.front();
  }
  return representative;
}

/// Nodes of joints and rigid parts, and their ancestors, parents first and otherwise in the file's order.
std::vector<uint32_t> addNodes(Draft& draft, const SceneTree& tree, const GltfFile& file) {
  std::vector<bool> needed(tree.parent.size(), false);
  for (const FileJoint& joint : draft.joints) {
    for (uint32_t node = joint.node; node != kNone && !needed[node]; node = tree.parent[node]) needed[node] = true;
  }
  std::vector<uint32_t> index(tree.parent.size(), kNone);
  for (const uint32_t node : tree.parents_first) {
    if (!needed[node]) continue;
    index[node] = static_cast<uint32_t>(draft.model.nodes.size());
    const uint32_t parent = tree.parent[node] == kNone ? kNone : index[tree.parent[node]];
    draft.model.nodes.push_back({file.document.nodes[node].name, parent, tree.rest[node]});
  }
  for (Part& part : draft.model.parts) {
    if (part.rigid_node != kNone) part.rigid_node = index[part.rigid_node];
  }
  return index;
}

/// Adds the representatives to the palette in the file's order.
/// @return per joint of the file: its index in the palette
std::vector<uint32_t> addJoints(Draft& draft, const std::vector<uint32_t>& node_index, const GltfFile& file) {
  const std::vector<uint32_t> representative = findRepresentatives(draft);
  std::vector<uint32_t> index(draft.joints.size(), kNone);
  for (uint32_t joint = 0; joint < draft.joints.size(); ++joint) {
    if (representative[joint] != joint) continue;
    index[joint] = static_cast<uint32_t>(draft.model.joints.size());
    draft.model.joints.push_back({node_index[draft.joints[joint].node], draft.joints[joint].inverse_bind});
  }
  if (draft.model.joints.size() > kMaxJoints) {
    file.name.fail("", "its skins need " + std::to_string(draft.model.joints.size()) + " joints, at most " +
                           std::to_string(kMaxJoints) + " are possible; bake one character at a time");
  }
  for (uint32_t joint = 0; joint < draft.joints.size(); ++joint) index[joint] = index[representative[joint]];
  return index;
}

/// Adds an influence; those of one joint are added up.
void addInfluence(Skin& skin, uint16_t joint, float weight) {
  for (uint32_t k = 0; k < skin.count; ++k) {
    if (skin.joint[k] != joint) continue;
    skin.weight[k] += weight;
    return;
  }
  skin.joint[skin.count] = joint;
  skin.weight[skin.count] = weight;
  ++skin.count;
}

/// By descending weight, ties by ascending joint. Eight entries at most: insertion needs no scratch.
void sortInfluences(Skin& skin) {
  const auto before = [&](uint32_t a, uint32_t b) {
    return skin.weight[a] != skin.weight[b] ? skin.weight[a] > skin.weight[b] : skin.joint[a] < skin.joint[b];
  };
  for (uint32_t i = 1; i < skin.count; ++i) {
    for (uint32_t k = i; k > 0 && before(k, k - 1); --k) {
      std::swap(skin.weight[k], skin.weight[k - 1]);
      std::swap(skin.joint[k], skin.joint[k - 1]);
    }
  }
}

Skin toSkin(const FileSkin& file_skin, const std::vector<uint32_t>& joint_index) {
  Skin skin;
  for (uint32_t k = 0; k < file_skin.count; ++k) {
    addInfluence(skin, static_cast<uint16_t>(joint_index[file_skin.joint[k]]), file_skin.weight[k]);
  }
  sortInfluences(skin);
  return skin;
}

}  // namespace

std::vector<uint32_t> buildSkeleton(Draft& draft, const SceneTree& tree, const GltfFile& file) {
  const std::vector<uint32_t> node_index = addNodes(draft, tree, file);
  const std::vector<uint32_t> joint_index = addJoints(draft, node_index, file);
  draft.model.skins.reserve(draft.skins.size());
  for (const FileSkin& skin : draft.skins) draft.model.skins.push_back(toSkin(skin, joint_index));
  return node_index;
}

}  // namespace lithe::bake
