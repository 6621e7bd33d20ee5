// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "skinning.h"

#include <cstddef>

#include "error.h"

namespace sample {
namespace {

struct Vertex {
  float position[3];
  uint16_t joints[LITHE_MAX_INFLUENCES];
  float weights[LITHE_MAX_INFLUENCES];
};

std::vector<Vertex> readVertices(const Character& character, uint32_t count) {
  lithe_vertex_layout layout{};
  layout.struct_size = sizeof layout;
  layout.stride = sizeof(Vertex);
  layout.influences = LITHE_MAX_INFLUENCES;
  layout.position = {LITHE_FORMAT_F32, offsetof(Vertex, position)};
  layout.joints = {LITHE_FORMAT_U16, offsetof(Vertex, joints)};
  layout.weights = {LITHE_FORMAT_F32, offsetof(Vertex, weights)};
  std::vector<Vertex> vertices(count);
  check(lithe_asset_write_vertices(character.asset.get(), &layout, 0, count, vertices.data(), count * sizeof(Vertex)),
        character.name + ": vertices");
  return vertices;
}

/// Three rows of four times (position, 1).
glm::vec3 transformed(const float* rows, const float* position) {
  glm::vec3 out;
  for (int row = 0; row < 3; ++row, rows += 4) {
    out[row] = rows[0] * position[0] + rows[1] * position[1] + rows[2] * position[2] + rows[3];
  }
  return out;
}

}  // namespace

std::vector<glm::vec3> posedPositions(const Character& character, uint32_t level, const float* palette) {
  std::vector<glm::vec3> positions;
  for (const Vertex& vertex : readVertices(character, character.levels[level].vertex_count)) {
    glm::vec3 posed(0);
    for (int k = 0; k < LITHE_MAX_INFLUENCES; ++k) {
      if (vertex.weights[k] > 0)
        posed += vertex.weights[k] * transformed(palette + 12 * vertex.joints[k], vertex.position);
    }
    positions.push_back(posed);
  }
  return positions;
}

}  // namespace sample
