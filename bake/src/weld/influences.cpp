// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "influences.h"

#include <algorithm>
#include <array>

#include "lithe/bake/simplex.h"
#include "lithe/bake/skin_weights.h"

namespace lithe::bake {

namespace {

/// Sum over the poses of |sum_k a_k M_k v - posed|^2, as a quadratic in the kept weights: since they sum to 1 the
/// target can be taken into the columns, which leaves no linear term.
WeightObjective posedDistance(const std::vector<Pose>& poses, const glm::dvec4& rest, const Skin& skin, uint32_t kept) {
  WeightObjective objective;
  objective.size = kept;
  for (const Pose& pose : poses) {
    glm::dvec3 target(0.0);
    for (uint32_t k = 0; k < skin.count; ++k) {
      target += double{skin.weight[k]} * glm::dvec3(pose.palette[skin.joint[k]] * rest);
    }
    std::array<glm::dvec3, kMaxImportedInfluences> column;
    for (uint32_t k = 0; k < kept; ++k) column[k] = glm::dvec3(pose.palette[skin.joint[k]] * rest) - target;
    for (uint32_t i = 0; i < kept; ++i) {
      for (uint32_t k = 0; k < kept; ++k) objective.H[i][k] += glm::dot(column[i], column[k]);
    }
  }
  return objective;
}

}  // namespace

QuantizedSkin capAndQuantize(const Model& model, const std::vector<Pose>& poses, uint32_t vertex,
                             uint32_t max_influences, uint32_t weight_one) {
  const Skin& skin = model.skins[vertex];
  const uint32_t kept = std::min<uint32_t>(skin.count, max_influences);
  SimplexWeights weights{};
  double sum = 0.0;
  for (uint32_t k = 0; k < kept; ++k) sum += skin.weight[k];
  for (uint32_t k = 0; k < kept; ++k) weights[k] = skin.weight[k] / sum;
  if (kept < skin.count && !poses.empty()) {
    const WeightObjective objective = posedDistance(poses, glm::dvec4(model.positions[vertex], 1.0f), skin, kept);
    weights = minimizeOnSimplex(objective, weights, naturalProximity(objective));
  }
  return quantizeSkin({skin.joint.data(), kept}, {weights.data(), kept}, weight_one);
}

}  // namespace lithe::bake
