// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Floats -> the integers of the file: positions, directions, texture coordinates.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "lithe/bake/mesh.h"

namespace lithe::bake {

// The cube at the box's lower corner that holds all positions of the given vertices; step 1 where they coincide.
Grid positionGrid(const std::vector<glm::vec3>& positions, const std::vector<uint32_t>& vertices, uint32_t bits);

glm::ivec3 toGrid(const Grid& grid, const glm::vec3& position);

// The octahedral point whose direction is closest in angle among the nine around the exact one (ties: the first by
// row). A zero or non-finite vector becomes +z.
glm::ivec2 toOctahedral(const glm::vec3& direction, uint32_t bits);

UvGrid uvGrid(const glm::dvec2& lower, const glm::dvec2& upper, uint32_t bits);
glm::ivec2 toUv(const UvGrid& grid, const glm::vec2& uv, uint32_t bits);

glm::ivec4 toUnorm8(const glm::vec4& color);

}  // namespace lithe::bake
