// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Skinning on the CPU, for what needs exact positions of a few vertices.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "character.h"

namespace sample {

/// The posed vertices of a level that is resident.
/// palette   12 * joint_count floats, as posePalette writes them
std::vector<glm::vec3> posedPositions(const Character& character, uint32_t level, const float* palette);

}  // namespace sample
