// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Local transforms to palettes.
#pragma once

#include <span>
#include <vector>

#include "lithe/bake/model.h"

namespace lithe::bake {

/// The rest transform of every node.
std::vector<Transform> restLocals(const Model& model);

/// world(node) * inverse_bind per joint, rounded as poses.h says.
std::vector<glm::dmat4> paletteOf(const Model& model, std::span<const Transform> locals);

}  // namespace lithe::bake
