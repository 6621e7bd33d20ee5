// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Meshes of a few triangles and their collapses, made by hand so that expected values can be worked out by hand.
#pragma once

#include <cstdint>
#include <vector>

#include "lithe/bake/mesh.h"
#include "lithe/format/placement.h"

namespace lithe::test {

inline bake::QuantizedSkin skinOf(const std::vector<std::pair<uint16_t, uint16_t>>& influences) {
  bake::QuantizedSkin skin;
  for (const auto& [joint, weight] : influences) {
    skin.joint[skin.count] = joint;
    skin.weight[skin.count++] = weight;
  }
  return skin;
}

inline bake::Mesh emptyMesh(const bake::AttributeSet& attributes, uint32_t parts = 1) {
  bake::Mesh mesh;
  mesh.grid = {glm::dvec3(0.0), 0.5, 14};
  mesh.attributes = attributes;
  mesh.part_uv.resize(parts);
  return mesh;
}

inline uint32_t addVertex(bake::Mesh& mesh, const glm::ivec3& position,
                          const bake::QuantizedSkin& skin = skinOf({{0, 255}})) {
  mesh.positions.push_back(position);
  mesh.skins.push_back(skin);
  mesh.rigid_vertex.push_back(false);
  return mesh.vertexCount() - 1;
}

/// A wedge with everything zero but the first uv set; the caller changes what it cares for.
inline uint32_t addWedge(bake::Mesh& mesh, uint32_t vertex, const glm::ivec2& uv = {0, 0}, uint32_t part = 0) {
  mesh.wedge_vertex.push_back(vertex);
  mesh.wedge_part.push_back(part);
  if (mesh.attributes.normal) mesh.wedge_normal.push_back({0, 0});
  if (mesh.attributes.tangent) mesh.wedge_tangent.push_back({0, 0, 0});
  for (uint32_t s = 0; s < mesh.attributes.uv_sets; ++s) mesh.wedge_uv[s].push_back(s == 0 ? uv : glm::ivec2(0));
  for (uint32_t s = 0; s < mesh.attributes.color_sets; ++s) mesh.wedge_color[s].push_back({0, 0, 0, 0});
  return mesh.wedgeCount() - 1;
}

/// Vertices with one wedge each, numbered alike.
inline bake::Mesh plainMesh(const std::vector<glm::ivec3>& positions,
                            const std::vector<std::array<uint32_t, 3>>& triangles) {
  bake::Mesh mesh = emptyMesh({});
  for (const glm::ivec3& position : positions) addWedge(mesh, addVertex(mesh, position));
  mesh.triangles = triangles;
  return mesh;
}

/// Collapses, each parent at the rule's point between its children, with the skin of child 0 unless said.
class CollapseList {
 public:
  explicit CollapseList(const bake::Mesh& mesh) : position_(mesh.positions), skin_(mesh.skins) {}

  /// @return the new node's id
  uint32_t add(uint32_t a, uint32_t b, uint8_t t8) { return add(a, b, t8, skin_[a]); }

  uint32_t add(uint32_t a, uint32_t b, uint8_t t8, const bake::QuantizedSkin& skin) {
    bake::Collapse collapse;
    collapse.child[0] = a;
    collapse.child[1] = b;
    collapse.t8 = t8;
    collapse.skin = skin;
    const glm::ivec3 v = position_[a], d = position_[b] - v;
    const format::Int3 centre = format::pointBetween({v.x, v.y, v.z}, {d.x, d.y, d.z}, t8);
    collapse.position = {centre.x, centre.y, centre.z};
    sequence.collapses.push_back(collapse);
    position_.push_back(collapse.position);
    skin_.push_back(skin);
    return static_cast<uint32_t>(position_.size() - 1);
  }

  bake::CollapseSequence sequence;

 private:
  std::vector<glm::ivec3> position_;
  std::vector<bake::QuantizedSkin> skin_;
};

/// A closed tetrahedron: births can be counted on one hand.
inline bake::Mesh tetrahedron() {
  return plainMesh({{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 8}}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}});
}

}  // namespace lithe::test
