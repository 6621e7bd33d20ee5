// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// What of a file is imported.
#pragma once

#include "primitive.h"
#include "scene.h"

namespace lithe::bake {

struct Inventory {
  std::vector<PrimitiveUse> uses;  ///< by node, then primitive
  AttributeSet attributes;         ///< what any of them has, within the limits of the model; normals always
};

/// Lists the triangle primitives that the scene shows, and warns of what will be left out.
/// Throws Error if a node refers to a mesh or skin that does not exist.
Inventory takeInventory(const GltfFile& file, const SceneTree& tree, std::vector<std::string>& warnings);

/// "TEXCOORD_0" and the like.
std::string attributeName(const char* base, uint32_t set);

}  // namespace lithe::bake
