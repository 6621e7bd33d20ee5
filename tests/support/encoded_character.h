// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Small .lithe files with everything a file can have, made by the real encoder from a random character.
#pragma once

#include <string>
#include <vector>

#include "lithe/bake/encode.h"
#include "random_character.h"

namespace lithe::test {

struct FileShape {
  CharacterShape character;
  uint64_t seed = 1;
  uint32_t nodes_left = 9;  ///< in the base
  uint32_t placement_shift = 5;
  uint32_t page_splits = 10, shared_page_splits = 6;
};

/// A scene with a root, a chain of joints below it, and one name of every kind.
inline bake::Model smallModel(const CharacterShape& shape) {
  bake::Model model;
  model.nodes = {{"root", bake::kNone, {}}};
  for (uint32_t j = 0; j < shape.joints; ++j) {
    model.nodes.push_back({"joint " + std::to_string(j), j, {}});
    model.joints.push_back({j + 1, glm::dmat4(1.0)});
  }
  model.materials = {"skin"};
  for (uint32_t p = 0; p < shape.parts; ++p) model.parts.push_back({"part " + std::to_string(p), 0, bake::kNone, 0, p});
  model.rest_diagonal = 1.0;
  return model;
}

inline std::vector<uint8_t> encodeSmallFile(const FileShape& shape) {
  const bake::Mesh mesh = randomMesh(shape.character, shape.seed);
  const bake::CollapseSequence sequence =
      randomCollapses(mesh, shape.nodes_left, shape.placement_shift, shape.character.joints, shape.seed + 1);
  const bake::Hierarchy hierarchy = bake::buildHierarchy(mesh, sequence, shape.placement_shift);
  std::vector<bake::LevelPlan> levels;
  uint32_t collapses = static_cast<uint32_t>(sequence.collapses.size());
  for (double error = 1.0; collapses > 0; collapses /= 2, error /= 2) levels.push_back({collapses, error, error / 2});
  levels.push_back({0, 0.0, 0.0});
  const bake::Model model = smallModel(shape.character);
  return bake::encodeFile(
      {model, mesh, hierarchy, levels, shape.placement_shift, 1.0, shape.page_splits, shape.shared_page_splits},
      nullptr);
}

/// Seams, three parts, open and closed rings, fans that are no ring, all attributes, several pages and shared ones.
inline FileShape richShape() {
  FileShape shape;
  shape.character.columns = 8;
  shape.character.rows = 7;
  shape.character.closed = false;
  shape.character.loose_triangles = 12;
  shape.character.parts = 3;
  shape.character.seams = true;
  shape.character.attributes = {true, true, 2, 1};
  shape.seed = 41;
  shape.nodes_left = 5;
  return shape;
}

/// The same on a fraction of the triangles, for tests that read a file very often.
inline FileShape smallRichShape() {
  FileShape shape = richShape();
  shape.character.columns = 5;
  shape.character.rows = 3;
  shape.character.loose_triangles = 3;
  return shape;
}

/// The smallest file with several levels and pages, for tests that break every byte of it.
inline FileShape tinyShape() {
  FileShape shape;
  shape.character.columns = 5;
  shape.character.rows = 4;
  shape.character.joints = 2;
  shape.character.max_influences = 2;
  shape.seed = 5;
  shape.nodes_left = 6;
  shape.page_splits = 4;
  shape.shared_page_splits = 3;
  return shape;
}

/// Open and closed rings only, as far as random collapses leave any.
inline FileShape patchShape() {
  FileShape shape;
  shape.character.closed = false;
  shape.seed = 3;
  shape.nodes_left = 60;
  return shape;
}

}  // namespace lithe::test
