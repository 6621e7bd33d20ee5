// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "cut.h"

#include <algorithm>

namespace lithe::bake {

Cut::Cut(const Hierarchy& hierarchy) : h(hierarchy) {
  file_node.assign(h.nodeCount(), kNone);
  file_wedge.assign(h.wedge_node.size(), kNone);
  node_first_wedge.push_back(0);
}

uint32_t Cut::addNode(uint32_t hierarchy_node, const std::vector<uint32_t>& wedges) {
  const uint32_t node = static_cast<uint32_t>(node_hierarchy.size());
  node_hierarchy.push_back(hierarchy_node);
  node_split.push_back(0);
  node_corners.emplace_back();
  file_node[hierarchy_node] = node;
  for (uint32_t wedge : wedges) {
    file_wedge[wedge] = static_cast<uint32_t>(wedge_node.size());
    wedge_node.push_back(node);
    wedge_hierarchy.push_back(wedge);
  }
  node_first_wedge.push_back(static_cast<uint32_t>(wedge_node.size()));
  return node;
}

void Cut::addFace(uint32_t triangle, uint32_t rotation, std::array<uint32_t, 3> wedges) {
  const uint32_t face = static_cast<uint32_t>(face_wedges.size());
  face_wedges.push_back(wedges);
  face_triangle.push_back(triangle);
  face_rotation.push_back(static_cast<uint8_t>(rotation));
  for (uint32_t k = 0; k < 3; ++k) node_corners[wedge_node[wedges[k]]].push_back(3 * face + k);
}

uint32_t Cut::nodeAbove(uint32_t vertex) const {
  uint32_t node = vertex;
  while (file_node[node] == kNone) node = h.parent[node];
  return file_node[node];
}

uint32_t Cut::wedgeAt(uint32_t node, uint32_t leaf_wedge) const {
  const uint32_t first = node_first_wedge[node];
  if (node_first_wedge[node + 1] - first == 1) return first;
  const uint32_t hierarchy_node = node_hierarchy[node];
  uint32_t wedge = leaf_wedge;
  while (h.wedge_node[wedge] != hierarchy_node) wedge = h.wedge_parent[wedge];
  return file_wedge[wedge];
}

const format::Fan& Cut::fanOf(uint32_t node) {
  fan_corner_ = node_corners[node];
  std::sort(fan_corner_.begin(), fan_corner_.end());
  fan_next_.clear();
  fan_previous_.clear();
  for (uint32_t corner : fan_corner_) {
    const uint32_t face = corner / 3, k = corner % 3;
    fan_next_.push_back(wedge_node[face_wedges[face][(k + 1) % 3]]);
    fan_previous_.push_back(wedge_node[face_wedges[face][(k + 2) % 3]]);
  }
  fan_ = {static_cast<uint32_t>(fan_corner_.size()), fan_corner_.data(), fan_next_.data(), fan_previous_.data()};
  return fan_;
}

void Cut::moveCorner(uint32_t corner, uint32_t wedge) {
  face_wedges[corner / 3][corner % 3] = wedge;
  node_corners[wedge_node[wedge]].push_back(corner);
}

std::vector<uint32_t> hiddenFaces(const Cut& cut) {
  struct Key {
    std::array<uint32_t, 3> nodes;
    uint32_t face;
  };
  std::vector<Key> keys(cut.face_wedges.size());
  for (uint32_t f = 0; f < keys.size(); ++f) {
    std::array<uint32_t, 3>& n = keys[f].nodes;
    for (uint32_t k = 0; k < 3; ++k) n[k] = cut.wedge_node[cut.face_wedges[f][k]];
    std::rotate(n.begin(), std::min_element(n.begin(), n.end()), n.end());
    keys[f].face = f;
  }
  std::sort(keys.begin(), keys.end(),
            [](const Key& a, const Key& b) { return a.nodes != b.nodes ? a.nodes < b.nodes : a.face < b.face; });
  std::vector<uint32_t> hidden;
  for (size_t i = 1; i < keys.size(); ++i)
    if (keys[i].nodes == keys[i - 1].nodes) hidden.push_back(keys[i].face);
  std::sort(hidden.begin(), hidden.end());
  return hidden;
}

}  // namespace lithe::bake
