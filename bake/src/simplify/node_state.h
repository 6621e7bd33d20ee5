// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// What a live node is, apart from its triangles. A slot is where a live node's data lie: it starts as a vertex and
// stays in use when the vertex becomes a parent, so that all arrays keep their length.
#pragma once

#include <vector>

#include "lithe/bake/mesh.h"
#include "lithe/bake/simplify.h"
#include "posed_mesh.h"

namespace lithe::bake {

struct NodeState {
  uint32_t grid_bits, placement_shift, weight_one, max_influences;
  std::vector<glm::ivec3> positions;  // per slot
  std::vector<QuantizedSkin> skins;   // per slot
  PosedMesh posed;
};

/// Where two nodes would meet.
struct Placement {
  glm::ivec3 position{0};
  int32_t t8 = 4;
  double cost = 0.0;  // in the posed mesh's units
};

}  // namespace lithe::bake
