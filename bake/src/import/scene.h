// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The node tree of a glTF file.
#pragma once

#include <glm/glm.hpp>

#include "gltf_file.h"

namespace lithe::bake {

/// Per node of the file. All arrays have one entry per node.
struct SceneTree {
  std::vector<uint32_t> parent;         ///< kNone for roots
  std::vector<uint32_t> parents_first;  ///< all nodes: file order, except that ancestors come before
  std::vector<bool> shown;              ///< part of the scene that is imported
  std::vector<Transform> rest;
  std::vector<glm::dmat4> world;  ///< rest transform to the root
};

/// Throws Error for nodes that form no forest, transforms of the wrong size, and scenes of nodes that do not exist.
SceneTree readScene(const GltfFile& file, std::vector<std::string>& warnings);

/// "node 3 'Hips'"
std::string nodePlace(const GltfFile& file, size_t node);

}  // namespace lithe::bake
