// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "palette.h"

#include <algorithm>
#include <cmath>

namespace lithe::bake {

namespace {

constexpr int kFloatMantissaBits = 24;

double largestEntry(const glm::dmat4& m, int first_column, int last_column) {
  double largest = 0.0;
  for (int column = first_column; column <= last_column; ++column) {
    for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(m[column][row]));
  }
  return largest;
}

/// Rounds to multiples of the spacing that floats have at `largest`: a plain conversion to float would keep the noise
/// of entries that should be zero.
void roundColumns(glm::dmat4& m, int first_column, int last_column) {
  const double largest = largestEntry(m, first_column, last_column);
  if (!(largest > 0.0) || !std::isfinite(largest)) return;
  int exponent = 0;
  std::frexp(largest, &exponent);
  const int shift = kFloatMantissaBits - exponent;
  for (int column = first_column; column <= last_column; ++column) {
    for (int row = 0; row < 3; ++row) {
      m[column][row] = std::ldexp(std::nearbyint(std::ldexp(m[column][row], shift)), -shift) + 0.0;
    }
  }
}

std::vector<glm::dmat4> worldMatrices(const Model& model, std::span<const Transform> locals) {
  std::vector<glm::dmat4> world(model.nodes.size());
  for (size_t i = 0; i < world.size(); ++i) {
    Transform local = locals[i];
    local.rotation = glm::normalize(local.rotation);
    const uint32_t parent = model.nodes[i].parent;
    world[i] = parent == kNone ? local.matrix() : world[parent] * local.matrix();
  }
  return world;
}

}  // namespace

std::vector<Transform> restLocals(const Model& model) {
  std::vector<Transform> locals;
  locals.reserve(model.nodes.size());
  for (const Node& node : model.nodes) locals.push_back(node.rest);
  return locals;
}

std::vector<glm::dmat4> paletteOf(const Model& model, std::span<const Transform> locals) {
  const std::vector<glm::dmat4> world = worldMatrices(model, locals);
  std::vector<glm::dmat4> palette;
  palette.reserve(model.joints.size());
  for (const Joint& joint : model.joints) {
    glm::dmat4 m = world[joint.node] * joint.inverse_bind;
    roundColumns(m, 0, 2);
    roundColumns(m, 3, 3);
    palette.push_back(m);
  }
  return palette;
}

}  // namespace lithe::bake
