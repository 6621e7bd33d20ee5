// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "scene.h"

#include <cmath>

#include "transform.h"

namespace lithe::bake {

namespace {

using Nodes = std::vector<tinygltf::Node>;

uint32_t checkedNode(const GltfFile& file, int node, const std::string& place) {
  if (node < 0 || static_cast<size_t>(node) >= file.document.nodes.size()) {
    file.name.fail(place, "there is no node " + std::to_string(node) + "; re-export the file");
  }
  return static_cast<uint32_t>(node);
}

std::vector<uint32_t> readParents(const GltfFile& file) {
  const Nodes& nodes = file.document.nodes;
  std::vector<uint32_t> parent(nodes.size(), kNone);
  for (uint32_t i = 0; i < nodes.size(); ++i) {
    for (const int child : nodes[i].children) {
      uint32_t& of_child = parent[checkedNode(file, child, nodePlace(file, i))];
      if (of_child != kNone) {
        file.name.fail(nodePlace(file, static_cast<size_t>(child)),
                       "it is the child of node " + std::to_string(of_child) + " and of node " + std::to_string(i) +
                           "; a scene must be a tree, re-export the file");
      }
      of_child = i;
    }
  }
  return parent;
}

/// With one parent each, nodes form a forest unless a walk up never ends.
std::vector<uint32_t> orderParentsFirst(const GltfFile& file, const std::vector<uint32_t>& parent) {
  std::vector<uint32_t> order;
  std::vector<bool> placed(parent.size(), false);
  for (uint32_t i = 0; i < parent.size(); ++i) {
    std::vector<uint32_t> chain;
    for (uint32_t node = i; node != kNone && !placed[node]; node = parent[node]) {
      if (chain.size() == parent.size()) {
        file.name.fail(nodePlace(file, i), "it is its own ancestor; a scene must be a tree, re-export the file");
      }
      chain.push_back(node);
    }
    for (auto node = chain.rbegin(); node != chain.rend(); ++node) {
      placed[*node] = true;
      order.push_back(*node);
    }
  }
  return order;
}

std::vector<bool> findShown(const GltfFile& file, const SceneTree& tree) {
  const auto& scenes = file.document.scenes;
  if (scenes.empty()) return std::vector<bool>(tree.parent.size(), true);
  const int wanted = file.document.defaultScene < 0 ? 0 : file.document.defaultScene;
  if (static_cast<size_t>(wanted) >= scenes.size()) {
    file.name.fail("", "there is no scene " + std::to_string(wanted) + "; re-export the file");
  }
  std::vector<bool> shown(tree.parent.size(), false);
  for (const int root : scenes[static_cast<size_t>(wanted)].nodes) {
    shown[checkedNode(file, root, "scene " + std::to_string(wanted))] = true;
  }
  for (const uint32_t node : tree.parents_first) {
    if (tree.parent[node] != kNone && shown[tree.parent[node]]) shown[node] = true;
  }
  return shown;
}

void checkSize(const GltfFile& file, size_t node, const std::vector<double>& values, size_t wanted, const char* what) {
  if (values.empty() || values.size() == wanted) return;
  file.name.fail(nodePlace(file, node), std::string("its ") + what + " has " + std::to_string(values.size()) +
                                            " numbers instead of " + std::to_string(wanted) + "; re-export the file");
}

Transform readTransform(const GltfFile& file, size_t index, std::vector<std::string>& warnings) {
  const tinygltf::Node& node = file.document.nodes[index];
  checkSize(file, index, node.matrix, 16, "matrix");
  checkSize(file, index, node.translation, 3, "translation");
  checkSize(file, index, node.rotation, 4, "rotation");
  checkSize(file, index, node.scale, 3, "scale");
  if (!node.matrix.empty()) {
    glm::dmat4 matrix(1.0);
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = node.matrix[static_cast<size_t>(i)];
    bool sheared = false;
    const Transform transform = decompose(matrix, sheared);
    if (sheared) warnings.push_back(nodePlace(file, index) + ": its matrix is sheared; the shear is dropped");
    return transform;
  }
  Transform transform;
  for (int i = 0; i < 3; ++i) {
    if (!node.translation.empty()) transform.translation[i] = node.translation[static_cast<size_t>(i)];
    if (!node.scale.empty()) transform.scale[i] = node.scale[static_cast<size_t>(i)];
  }
  const std::vector<double>& q = node.rotation;
  if (!q.empty()) transform.rotation = glm::normalize(glm::dquat(q[3], q[0], q[1], q[2]));
  return transform;
}

}  // namespace

std::string nodePlace(const GltfFile& file, size_t node) {
  const std::string& name = file.document.nodes[node].name;
  return "node " + std::to_string(node) + (name.empty() ? "" : " '" + name + "'");
}

SceneTree readScene(const GltfFile& file, std::vector<std::string>& warnings) {
  SceneTree tree;
  tree.parent = readParents(file);
  tree.parents_first = orderParentsFirst(file, tree.parent);
  tree.shown = findShown(file, tree);
  tree.world.resize(tree.parent.size());
  for (size_t i = 0; i < tree.parent.size(); ++i) tree.rest.push_back(readTransform(file, i, warnings));
  for (const uint32_t node : tree.parents_first) {
    const uint32_t parent = tree.parent[node];
    tree.world[node] = parent == kNone ? tree.rest[node].matrix() : tree.world[parent] * tree.rest[node].matrix();
  }
  return tree;
}

}  // namespace lithe::bake
