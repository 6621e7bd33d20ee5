// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Random meshes and random collapse sequences: what the codec must carry, however odd.
#pragma once

#include <algorithm>
#include <cstdint>
#include <set>
#include <vector>

#include "lithe/bake/mesh.h"
#include "lithe/format/placement.h"
#include "random.h"

namespace lithe::test {

struct CharacterShape {
  uint32_t columns = 12, rows = 10;  ///< of the grid of vertices
  bool closed = true;                ///< a torus; else an open patch
  uint32_t loose_triangles = 0;      ///< between random vertices: non-manifold
  uint32_t parts = 1;                ///< strips of rows in different parts
  bool seams = false;                ///< some corners get attributes of their own
  bake::AttributeSet attributes{true, false, 1, 0};
  uint32_t joints = 5;
  uint32_t max_influences = 4;
  uint32_t position_bits = 14;
};

inline bake::QuantizedSkin skinFrom(std::vector<std::pair<uint16_t, int32_t>> weights, uint32_t one) {
  int32_t left = static_cast<int32_t>(one);
  for (auto& [joint, weight] : weights) left -= weight;
  weights[0].second += left;
  std::sort(weights.begin(), weights.end(), [](const auto& a, const auto& b) {
    return a.second != b.second ? a.second > b.second : a.first < b.first;
  });
  bake::QuantizedSkin skin;
  for (const auto& [joint, weight] : weights) {
    if (weight <= 0) continue;
    skin.joint[skin.count] = joint;
    skin.weight[skin.count++] = static_cast<uint16_t>(weight);
  }
  return skin;
}

inline bake::QuantizedSkin randomSkin(Random& random, uint32_t joints, uint32_t max_influences, uint32_t one) {
  std::set<uint16_t> chosen;
  const uint32_t count = 1 + random.below(std::min(joints, max_influences));
  while (chosen.size() < count) chosen.insert(static_cast<uint16_t>(random.below(joints)));
  std::vector<std::pair<uint16_t, int32_t>> weights;
  const int32_t share = static_cast<int32_t>(one / count);
  for (uint16_t joint : chosen) weights.push_back({joint, std::max(1, share - random.between(0, share / 2))});
  return skinFrom(weights, one);
}

/// A mesh that welds nothing: one vertex per grid cell, wedges where seams ask for them.
inline bake::Mesh randomMesh(const CharacterShape& shape, uint64_t seed) {
  Random random(seed);
  bake::Mesh mesh;
  mesh.grid = {glm::dvec3(-1, -2, 0.5), 0.001953125, shape.position_bits};
  mesh.attributes = shape.attributes;
  mesh.max_influences = shape.max_influences;
  mesh.part_uv.assign(shape.parts, {});
  for (auto& grids : mesh.part_uv)
    for (auto& grid : grids) grid = {glm::dvec2(0.25, -0.5), 0.0009765625};
  const int32_t size = 1 << shape.position_bits;
  for (uint32_t y = 0; y < shape.rows; ++y)
    for (uint32_t x = 0; x < shape.columns; ++x) {
      mesh.positions.push_back(
          {random.between(0, size / 64) + static_cast<int32_t>(x) * (size / 2 / static_cast<int32_t>(shape.columns)),
           random.between(0, size / 64) + static_cast<int32_t>(y) * (size / 2 / static_cast<int32_t>(shape.rows)),
           random.between(0, size / 4)});
      mesh.skins.push_back(mesh.skins.empty() || random.below(3) == 0
                               ? randomSkin(random, shape.joints, shape.max_influences, mesh.weight_one)
                               : mesh.skins.back());
      mesh.rigid_vertex.push_back(false);
    }
  auto addWedge = [&](uint32_t vertex, uint32_t part) {
    const int32_t top = (1 << mesh.normal_bits) - 2;
    mesh.wedge_vertex.push_back(vertex);
    mesh.wedge_part.push_back(part);
    if (shape.attributes.normal) mesh.wedge_normal.push_back({random.between(0, top), random.between(0, top)});
    if (shape.attributes.tangent)
      mesh.wedge_tangent.push_back({random.between(0, top), random.between(0, top), random.between(0, 1)});
    for (uint32_t s = 0; s < shape.attributes.uv_sets; ++s)
      mesh.wedge_uv[s].push_back({random.between(0, 4095), random.between(0, 4095)});
    for (uint32_t s = 0; s < shape.attributes.color_sets; ++s)
      mesh.wedge_color[s].push_back(
          {random.between(0, 255), random.between(0, 255), random.between(0, 255), random.between(0, 255)});
    return static_cast<uint32_t>(mesh.wedge_vertex.size() - 1);
  };
  std::vector<std::vector<uint32_t>> wedge_of(shape.parts, std::vector<uint32_t>(mesh.positions.size(), bake::kNone));
  auto corner = [&](uint32_t vertex, uint32_t part) {
    uint32_t& wedge = wedge_of[part][vertex];
    if (wedge == bake::kNone || (shape.seams && random.below(8) == 0)) wedge = addWedge(vertex, part);
    return wedge;
  };
  auto addTriangle = [&](uint32_t a, uint32_t b, uint32_t c, uint32_t part) {
    mesh.triangles.push_back({corner(a, part), corner(b, part), corner(c, part)});
  };
  const uint32_t last_column = shape.closed ? shape.columns : shape.columns - 1;
  const uint32_t last_row = shape.closed ? shape.rows : shape.rows - 1;
  for (uint32_t y = 0; y < last_row; ++y)
    for (uint32_t x = 0; x < last_column; ++x) {
      const uint32_t part = y * shape.parts / last_row;
      const uint32_t x1 = (x + 1) % shape.columns, y1 = (y + 1) % shape.rows;
      const uint32_t a = y * shape.columns + x, b = y * shape.columns + x1, c = y1 * shape.columns + x1,
                     d = y1 * shape.columns + x;
      addTriangle(a, b, c, part);
      addTriangle(a, c, d, part);
    }
  for (uint32_t i = 0; i < shape.loose_triangles; ++i) {
    const uint32_t count = static_cast<uint32_t>(mesh.positions.size());
    const uint32_t a = random.below(count), b = (a + 1 + random.below(count - 1)) % count;
    uint32_t c = random.below(count);
    while (c == a || c == b) c = random.below(count);
    addTriangle(a, b, c, random.below(shape.parts));
  }
  return mesh;
}

/// Collapses random edges (now and then random pairs) until `nodes_left` nodes are left, placed anywhere the rule
/// allows.
inline bake::CollapseSequence randomCollapses(const bake::Mesh& mesh, uint32_t nodes_left, uint32_t placement_shift,
                                              uint32_t joints, uint64_t seed) {
  Random random(seed);
  bake::CollapseSequence sequence;
  std::vector<glm::ivec3> position = mesh.positions;
  std::vector<bake::QuantizedSkin> skin = mesh.skins;
  std::vector<uint32_t> top(mesh.vertexCount());
  for (uint32_t v = 0; v < top.size(); ++v) top[v] = v;
  uint32_t alive = mesh.vertexCount();
  const int32_t size = 1 << mesh.grid.bits;
  while (alive > nodes_left) {
    const auto& triangle = mesh.triangles[random.below(mesh.triangleCount())];
    uint32_t a = top[mesh.wedge_vertex[triangle[0]]], b = top[mesh.wedge_vertex[triangle[1 + random.below(2)]]];
    if (random.below(20) == 0) b = top[random.below(mesh.vertexCount())];
    if (a == b) continue;
    bake::Collapse c;
    c.child[0] = a;
    c.child[1] = b;
    c.t8 = static_cast<uint8_t>(random.below(9));
    const glm::ivec3 d = position[b] - position[a];
    const format::Int3 difference{d.x, d.y, d.z};
    const format::Int3 centre = format::pointBetween({position[a].x, position[a].y, position[a].z}, difference, c.t8);
    const int32_t step = format::latticeStep(difference, placement_shift);
    const int32_t centres[3] = {centre.x, centre.y, centre.z};
    for (int i = 0; i < 3; ++i) {
      const int32_t moved = centres[i] + random.between(-3, 3) * step;
      c.position[i] = moved < 0 || moved >= size ? centres[i] : moved;
    }
    switch (random.below(3)) {
      case 0:
        c.skin = skin[a];
        break;
      case 1:
        c.skin = skin[b];
        break;
      default:
        c.skin = randomSkin(random, joints, mesh.max_influences, mesh.weight_one);
        break;
    }
    const uint32_t node = static_cast<uint32_t>(position.size());
    position.push_back(c.position);
    skin.push_back(c.skin);
    for (uint32_t& t : top)
      if (t == a || t == b) t = node;
    sequence.collapses.push_back(c);
    --alive;
  }
  return sequence;
}

}  // namespace lithe::test
