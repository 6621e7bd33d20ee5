// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Hand-made models for the simplifier's tests, and what every collapse sequence must satisfy.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "lithe/bake/simplify.h"
#include "lithe/bake/weld.h"
#include "lithe/format/placement.h"

namespace lithe::bake::test {

inline Skin oneJoint(uint16_t joint) {
  Skin skin;
  skin.count = 1;
  skin.joint[0] = joint;
  skin.weight[0] = 1.0f;
  return skin;
}

/// Weight w for joint 1, the rest for joint 0.
inline Skin twoJoints(double w) {
  if (w <= 0.0) return oneJoint(0);
  if (w >= 1.0) return oneJoint(1);
  Skin skin;
  skin.count = 2;
  const uint32_t heavier = w > 0.5 ? 0 : 1;
  skin.joint[heavier] = 1;
  skin.weight[heavier] = static_cast<float>(w);
  skin.joint[1 - heavier] = 0;
  skin.weight[1 - heavier] = static_cast<float>(1.0 - w);
  return skin;
}

inline Model emptyModel(uint32_t joints, uint32_t parts = 1) {
  Model model;
  model.joints.resize(joints);
  model.parts.resize(parts);
  return model;
}

inline uint32_t addVertex(Model& model, const glm::vec3& position, const Skin& skin) {
  model.positions.push_back(position);
  model.skins.push_back(skin);
  return static_cast<uint32_t>(model.positions.size() - 1);
}

inline void addTriangle(Model& model, uint32_t a, uint32_t b, uint32_t c, uint32_t part = 0) {
  model.triangles.push_back({a, b, c});
  model.triangle_part.push_back(part);
}

/// cells x cells quads of size 1 in the plane z = 0 (moved by `height`), skinned by `skin(x, y)`.
template <class SkinAt>
void addGrid(Model& model, uint32_t cells, const SkinAt& skin, const glm::vec3& corner = glm::vec3(0.0f)) {
  const auto first = static_cast<uint32_t>(model.positions.size());
  for (uint32_t y = 0; y <= cells; ++y) {
    for (uint32_t x = 0; x <= cells; ++x) {
      addVertex(model, corner + glm::vec3(float(x), float(y), 0.0f), skin(double(x) / cells, double(y) / cells));
    }
  }
  for (uint32_t y = 0; y < cells; ++y) {
    for (uint32_t x = 0; x < cells; ++x) {
      const uint32_t a = first + y * (cells + 1) + x, b = a + cells + 1;
      addTriangle(model, a, a + 1, b + 1);
      addTriangle(model, a, b + 1, b);
    }
  }
}

/// A closed tube with flat ends along y, from 0 to `length`, `around` x `rings` quads; weights pass from joint 0 to 1.
inline Model tube(uint32_t around, uint32_t rings, double length = 4.0) {
  Model model = emptyModel(2);
  for (uint32_t r = 0; r <= rings; ++r) {
    const double y = length * r / rings;
    for (uint32_t i = 0; i < around; ++i) {
      const double angle = 6.283185307179586 * i / around;
      addVertex(model, glm::vec3(0.5 * std::cos(angle), y, 0.5 * std::sin(angle)), twoJoints((y / length - 0.3) / 0.4));
    }
  }
  const auto at = [&](uint32_t r, uint32_t i) { return r * around + i % around; };
  for (uint32_t r = 0; r < rings; ++r) {
    for (uint32_t i = 0; i < around; ++i) {
      addTriangle(model, at(r, i), at(r + 1, i), at(r, i + 1));
      addTriangle(model, at(r, i + 1), at(r + 1, i), at(r + 1, i + 1));
    }
  }
  const uint32_t bottom = addVertex(model, {0, 0, 0}, oneJoint(0));
  const uint32_t top = addVertex(model, {0.0f, float(length), 0.0f}, oneJoint(1));
  for (uint32_t i = 0; i < around; ++i) {
    addTriangle(model, bottom, at(0, i), at(0, i + 1));
    addTriangle(model, top, at(rings, i + 1), at(rings, i));
  }
  return model;
}

/// Joint 0 rests, joint 1 turns about z at (0, middle, 0): `count` poses from straight to `degrees`.
inline std::vector<Pose> bendingPoses(uint32_t count, double degrees, double middle) {
  std::vector<Pose> poses(count);
  for (uint32_t p = 0; p < count; ++p) {
    const double angle = count == 1 ? degrees : degrees * p / (count - 1);
    const double c = std::cos(angle * 0.017453292519943295), s = std::sin(angle * 0.017453292519943295);
    glm::dmat4 turn(1.0);
    turn[0] = {c, s, 0, 0};
    turn[1] = {-s, c, 0, 0};
    turn[3] = {s * middle, middle - c * middle, 0, 1};
    poses[p].palette = {glm::dmat4(1.0), turn};
  }
  return poses;
}

inline std::vector<Pose> restPoses(uint32_t joints) {
  std::vector<Pose> poses(1);
  poses[0].palette.assign(joints, glm::dmat4(1.0));
  return poses;
}

inline Mesh weldQuietly(const Model& model, const WeldOptions& options = {}) {
  std::vector<std::string> warnings;
  return weld(model, {}, options, warnings);
}

/// The triangles after the first `count` collapses, as nodes, equal ones once; replayed from the collapses alone.
inline std::vector<std::array<uint32_t, 3>> trianglesAfter(const Mesh& mesh, const CollapseSequence& sequence,
                                                           uint32_t count) {
  std::vector<uint32_t> now(mesh.vertexCount() + count);
  for (uint32_t i = 0; i < now.size(); ++i) now[i] = i;
  for (uint32_t i = 0; i < count; ++i) {
    for (uint32_t child : sequence.collapses[i].child) now[child] = mesh.vertexCount() + i;
  }
  for (uint32_t i = static_cast<uint32_t>(now.size()); i-- > 0;) now[i] = now[now[i]];
  std::set<std::array<uint32_t, 3>> unique;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    std::array<uint32_t, 3> nodes{now[mesh.corner(t, 0)], now[mesh.corner(t, 1)], now[mesh.corner(t, 2)]};
    if (nodes[0] == nodes[1] || nodes[1] == nodes[2] || nodes[2] == nodes[0]) continue;
    std::rotate(nodes.begin(), std::min_element(nodes.begin(), nodes.end()), nodes.end());
    unique.insert(nodes);
  }
  return {unique.begin(), unique.end()};
}

/// How often each directed edge occurs without its opposite.
inline uint32_t openEdges(const std::vector<std::array<uint32_t, 3>>& triangles) {
  std::map<std::pair<uint32_t, uint32_t>, int> balance;
  for (const auto& t : triangles) {
    for (uint32_t k = 0; k < 3; ++k) {
      const uint32_t a = t[k], b = t[(k + 1) % 3];
      balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  }
  return static_cast<uint32_t>(
      std::count_if(balance.begin(), balance.end(), [](const auto& e) { return e.second != 0; }));
}

/// Every promise of simplify.h and mesh.h that can be checked from outside.
inline void expectValid(const Mesh& mesh, const CollapseSequence& sequence, const SimplifyOptions& options) {
  const uint32_t vertices = mesh.vertexCount();
  std::vector<glm::ivec3> position = mesh.positions;
  std::vector<bool> gone(vertices + sequence.collapses.size(), false);
  for (uint32_t i = 0; i < sequence.collapses.size(); ++i) {
    const Collapse& c = sequence.collapses[i];
    for (uint32_t child : c.child) {
      ASSERT_LT(child, vertices + i);
      ASSERT_FALSE(gone[child]);
      gone[child] = true;
    }
    ASSERT_NE(c.child[0], c.child[1]);
    ASSERT_LE(c.t8, 8);
    const glm::ivec3 v = position[c.child[0]], d = position[c.child[1]] - v;
    const int32_t step = format::latticeStep({d.x, d.y, d.z}, options.placement_shift);
    const format::Int3 base = format::pointBetween({v.x, v.y, v.z}, {d.x, d.y, d.z}, c.t8);
    for (int axis = 0; axis < 3; ++axis) {
      const int32_t from = axis == 0 ? base.x : axis == 1 ? base.y : base.z;
      EXPECT_EQ((c.position[axis] - from) % step, 0);
      EXPECT_GE(c.position[axis], 0);
      EXPECT_LT(c.position[axis], 1 << mesh.grid.bits);
    }
    uint32_t sum = 0;
    for (uint32_t k = 0; k < c.skin.count; ++k) sum += c.skin.weight[k];
    EXPECT_EQ(sum, mesh.weight_one);
    EXPECT_LE(c.skin.count, mesh.max_influences);
    EXPECT_GE(c.cost, 0.0);
    position.push_back(c.position);
    if (i % 97 == 0 || i + 1 == sequence.collapses.size()) {
      EXPECT_EQ(c.triangles, trianglesAfter(mesh, sequence, i + 1).size()) << "collapse " << i;
    }
  }
}

inline bool sameCollapses(const CollapseSequence& a, const CollapseSequence& b) {
  return std::equal(a.collapses.begin(), a.collapses.end(), b.collapses.begin(), b.collapses.end(),
                    [](const Collapse& x, const Collapse& y) {
                      return x.child[0] == y.child[0] && x.child[1] == y.child[1] && x.position == y.position &&
                             x.skin == y.skin && x.t8 == y.t8 && x.cost == y.cost && x.triangles == y.triangles;
                    });
}

}  // namespace lithe::bake::test
