// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "influences.h"

#include <algorithm>
#include <array>
#include <bit>

#include "lithe/bake/simplex.h"
#include "lithe/bake/skin_weights.h"

namespace lithe::bake {

namespace {

// Of naturalProximity(): squared distances that differ by less are the same, so that neighbours choose alike.
constexpr double kNoise = 1e-5;

/// Sum over the poses of |sum_k a_k M_k v - posed|^2, as a quadratic in the weights: since they sum to 1 the target can
/// be taken into the columns, which leaves no linear term.
WeightObjective posedDistance(const std::vector<Pose>& poses, const glm::dvec4& rest, const Skin& skin) {
  WeightObjective objective;
  objective.size = skin.count;
  for (const Pose& pose : poses) {
    glm::dvec3 target(0.0);
    for (uint32_t k = 0; k < skin.count; ++k) {
      target += double{skin.weight[k]} * glm::dvec3(pose.palette[skin.joint[k]] * rest);
    }
    std::array<glm::dvec3, kMaxImportedInfluences> column;
    for (uint32_t k = 0; k < skin.count; ++k) column[k] = glm::dvec3(pose.palette[skin.joint[k]] * rest) - target;
    for (uint32_t i = 0; i < skin.count; ++i) {
      for (uint32_t k = 0; k < skin.count; ++k) objective.H[i][k] += glm::dot(column[i], column[k]);
    }
  }
  return objective;
}

/// Some of a skin's joints, by their places in it, and weights for them.
struct KeptInfluences {
  uint32_t count = 0;
  std::array<uint32_t, kMaxImportedInfluences> place{};
  SimplexWeights weights{};
};

/// The influences whose bits are set, weighed as they were among themselves.
KeptInfluences keep(const Skin& skin, uint32_t bits) {
  KeptInfluences kept;
  double sum = 0.0;
  for (uint32_t k = 0; k < skin.count; ++k) {
    if (bits >> k & 1) kept.place[kept.count++] = k;
  }
  for (uint32_t i = 0; i < kept.count; ++i) sum += skin.weight[kept.place[i]];
  for (uint32_t i = 0; i < kept.count; ++i) kept.weights[i] = skin.weight[kept.place[i]] / sum;
  return kept;
}

WeightObjective restricted(const WeightObjective& all, const KeptInfluences& kept) {
  WeightObjective objective;
  objective.size = kept.count;
  for (uint32_t i = 0; i < kept.count; ++i) {
    for (uint32_t k = 0; k < kept.count; ++k) objective.H[i][k] = all.H[kept.place[i]][kept.place[k]];
  }
  return objective;
}

/// The largest say little about which are needed: of two joints that move alike one is enough. There are at most 70
/// choices, so all are tried; ties go to the larger influences.
KeptInfluences bestInfluences(const WeightObjective& all, const Skin& skin, uint32_t count) {
  const double noise = kNoise * naturalProximity(all);
  KeptInfluences best;
  double least = 0.0;
  for (uint32_t bits = 1; bits < 1u << skin.count; ++bits) {
    if (std::popcount(bits) != static_cast<int>(count)) continue;
    KeptInfluences kept = keep(skin, bits);
    const WeightObjective objective = restricted(all, kept);
    kept.weights = minimizeOnSimplex(objective, kept.weights, naturalProximity(objective));
    const double distance = objectiveValue(objective, kept.weights);
    if (best.count > 0 && !(distance + noise < least)) continue;
    best = kept;
    least = distance;
    if (least <= noise) break;  // none can be better
  }
  return best;
}

}  // namespace

QuantizedSkin capAndQuantize(const Model& model, const std::vector<Pose>& poses, uint32_t vertex,
                             uint32_t max_influences, uint32_t weight_one) {
  const Skin& skin = model.skins[vertex];
  const uint32_t count = std::min<uint32_t>(skin.count, max_influences);
  KeptInfluences kept = keep(skin, (1u << count) - 1);  // the largest
  if (count < skin.count && !poses.empty()) {
    kept = bestInfluences(posedDistance(poses, glm::dvec4(model.positions[vertex], 1.0f), skin), skin, count);
  }
  std::array<uint16_t, kMaxImportedInfluences> joints{};
  for (uint32_t i = 0; i < count; ++i) joints[i] = skin.joint[kept.place[i]];
  return quantizeSkin({joints.data(), count}, {kept.weights.data(), count}, weight_one);
}

}  // namespace lithe::bake
