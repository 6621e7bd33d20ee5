// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Files for the property tests: random characters with random collapses, and a small character baked in earnest.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "lithe/bake/bake.h"
#include "lithe/bake/hierarchy.h"
#include "random_character.h"
#include "shapes.h"

namespace lithe::test {

struct PropertyCharacter {
  std::vector<uint8_t> bytes;
  bool closed = false;  ///< every edge of the input has a face on either side
  bake::Mesh mesh;      ///< of random characters only, likewise the next
  bake::Hierarchy hierarchy;
};

inline PropertyCharacter randomFile(const CharacterShape& shape, uint64_t seed, uint32_t page_splits) {
  PropertyCharacter c;
  c.closed = shape.closed && shape.loose_triangles == 0;
  c.mesh = randomMesh(shape, seed);
  const bake::CollapseSequence sequence = randomCollapses(c.mesh, 7, 5, shape.joints, seed + 1);
  c.hierarchy = bake::buildHierarchy(c.mesh, sequence, 5);
  bake::Model model;
  model.nodes = {{"root", bake::kNone, {}}};
  for (uint32_t j = 0; j < shape.joints; ++j) model.joints.push_back({0, glm::dmat4(1.0)});
  model.parts.resize(shape.parts);
  model.rest_diagonal = 1.0;
  std::vector<bake::LevelPlan> levels;
  double error = 1.0;
  for (uint32_t left = static_cast<uint32_t>(sequence.collapses.size()); left > 0; left = left * 2 / 3, error *= 0.7)
    levels.push_back({left, error, error / 2});
  levels.push_back({0, 0.0, 0.0});
  c.bytes = bake::encodeFile({model, c.mesh, c.hierarchy, levels, 5, 1.0, page_splits, page_splits / 4}, nullptr);
  return c;
}

/// The tube of shapes.h with its ends closed; its uv seam runs along it, so a row of vertices is there twice.
inline bake::Model closedTube(uint32_t around, uint32_t rings) {
  bake::Model model = bake::test::tube(around, rings);
  for (const bool top : {false, true}) {
    const uint32_t ring = top ? rings * (around + 1) : 0, centre = static_cast<uint32_t>(model.positions.size());
    model.positions.push_back({0.0f, 0.0f, top ? 4.0f : 0.0f});
    model.normals.push_back({0.0f, 0.0f, top ? 1.0f : -1.0f});
    model.uvs[0].push_back({0.5f, top ? 1.0f : 0.0f});
    model.skins.push_back(model.skins[ring]);
    for (uint32_t i = 0; i < around; ++i)
      model.triangles.push_back(top ? std::array<uint32_t, 3>{centre, ring + i, ring + i + 1}
                                    : std::array<uint32_t, 3>{centre, ring + i + 1, ring + i});
  }
  model.triangle_part.assign(model.triangles.size(), 0);
  return model;
}

/// The tube of shapes.h with small triangles of two further parts around it: they vanish, and their nodes are absorbed.
inline bake::Model tubeWithFlakes(uint32_t around, uint32_t rings) {
  bake::Model model = bake::test::tube(around, rings);
  model.parts.insert(model.parts.end(), {{"flakes", 0, bake::kNone, 0, 0}, {"more flakes", 0, bake::kNone, 0, 0}});
  const auto vertices = static_cast<uint32_t>(model.positions.size());
  for (uint32_t flake = 0; flake < 60; ++flake) {
    const uint32_t below = flake * 7 % vertices, first = static_cast<uint32_t>(model.positions.size());
    for (uint32_t k = 0; k < 3; ++k) {
      const glm::vec3 aside(k == 1 ? 0.03f : 0.0f, k == 2 ? 0.03f : 0.0f, 0.01f * static_cast<float>(flake % 3));
      model.positions.push_back(1.1f * model.positions[below] + aside);
      model.normals.push_back(model.normals[below]);
      model.uvs[0].push_back(model.uvs[0][below]);
      model.skins.push_back(model.skins[below]);
    }
    model.triangles.push_back({first, first + 1, first + 2});
    model.triangle_part.push_back(1 + flake % 2);
  }
  return model;
}

inline PropertyCharacter bakedFile(const bake::Model& model, bool closed) {
  bake::BakeOptions options;
  options.poses.count = 4;
  options.levels = {0.7, 0.5, 0.3, 0.1, 0.02};
  options.threads = 2;
  PropertyCharacter c;
  c.closed = closed;
  c.bytes = bake::bake(model, options, nullptr);
  return c;
}

/// The characters by name; each is made once per process.
inline const PropertyCharacter& propertyCharacter(const std::string& name) {
  const auto shapeWith = [](auto&& change) {
    CharacterShape shape;
    change(shape);
    return shape;
  };
  const std::map<std::string, std::function<PropertyCharacter()>> makers = {
      {"torus", [&] { return randomFile({}, 501, 8192); }},
      {"torus_small_pages", [&] { return randomFile({}, 502, 9); }},
      {"patch", [&] { return randomFile(shapeWith([](auto& s) { s.closed = false; }), 503, 40); }},
      {"seams_parts_everything",
       [&] {
         return randomFile(shapeWith([](auto& s) {
                             s.seams = true;
                             s.parts = 3;
                             s.attributes = {true, true, 2, 1};
                             s.joints = 12;
                             s.max_influences = 8;
                           }),
                           504, 25);
       }},
      {"non_manifold",
       [&] {
         return randomFile(shapeWith([](auto& s) {
                             s.loose_triangles = 120;
                             s.seams = true;
                             s.parts = 2;
                             s.max_influences = 2;
                           }),
                           505, 30);
       }},
      {"baked_tube", [] { return bakedFile(closedTube(16, 40), true); }},
      {"baked_open_tube", [] { return bakedFile(bake::test::tube(16, 30), false); }},
      {"baked_flakes", [] { return bakedFile(tubeWithFlakes(16, 30), false); }}};
  static std::map<std::string, PropertyCharacter> made;
  const auto at = made.find(name);
  return at != made.end() ? at->second : made.emplace(name, makers.at(name)()).first->second;
}

inline const std::vector<std::string>& propertyCharacterNames() {
  static const std::vector<std::string> names = {
      "torus",        "torus_small_pages", "patch",           "seams_parts_everything",
      "non_manifold", "baked_tube",        "baked_open_tube", "baked_flakes"};
  return names;
}

}  // namespace lithe::test
