// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "weight_bits.h"

#include <algorithm>
#include <cmath>

#include "lithe/bake/poses.h"

namespace lithe::bake {
namespace {

constexpr size_t kSampledVertices = 4096;

/// The farthest that two of a vertex's joints would carry it apart, squared.
double spread2(const Model& model, uint32_t vertex, const Pose& pose) {
  const Skin& skin = model.skins[vertex];
  glm::dvec3 carried[kMaxImportedInfluences];
  double widest = 0.0;
  for (uint32_t i = 0; i < skin.count; ++i) {
    carried[i] = glm::dvec3(pose.palette[skin.joint[i]] * glm::dvec4(model.positions[vertex], 1.0));
    for (uint32_t k = 0; k < i; ++k) {
      const glm::dvec3 apart = carried[i] - carried[k];
      widest = std::max(widest, glm::dot(apart, apart));
    }
  }
  return widest;
}

}  // namespace

uint32_t chooseWeightBits(const Model& model, const std::vector<Pose>& poses, uint32_t position_bits) {
  const size_t vertices = model.positions.size(), stride = std::max<size_t>(1, vertices / kSampledVertices);
  double sum = 0.0;
  size_t count = 0;
  for (const Pose& pose : poses)
    for (size_t v = 0; v < vertices; v += stride, ++count) sum += spread2(model, static_cast<uint32_t>(v), pose);
  const double spread = count ? std::sqrt(sum / static_cast<double>(count)) : 0.0;
  const double step = posedDiagonal(model, poses) / std::exp2(position_bits);
  uint32_t bits = kLeastWeightBits;
  while (bits < kMostWeightBits && spread / std::exp2(bits) > 2.0 * step) ++bits;
  return bits;
}

}  // namespace lithe::bake
