// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "edge_placer.h"

#include <algorithm>

#include "lithe/bake/skin_weights.h"
#include "normal_equations.h"
#include "weight_step.h"

namespace lithe::bake {

namespace {

constexpr double kStay = 1e-4;  // of the trace: holds the parent where the quadric says nothing
constexpr uint32_t kMaxAlternations = 4;

/// Without branches or calls: most pairs are asked once.
bool sameSkin(const QuantizedSkin& a, const QuantizedSkin& b) {
  uint32_t difference = a.count ^ b.count;
  for (uint32_t k = 0; k < a.joint.size(); ++k) difference |= (a.joint[k] ^ b.joint[k]) | (a.weight[k] ^ b.weight[k]);
  return difference == 0;
}

}  // namespace

QuantizedSkin EdgePlacer::skinBetween(uint32_t a, uint32_t b, int32_t t8) const {
  if (t8 == 0 || t8 == 8) return nodes_.skins[t8 == 0 ? a : b];
  return interpolateSkin(nodes_.skins[a], nodes_.skins[b], t8, nodes_.weight_one, nodes_.max_influences);
}

double EdgePlacer::energyIn(const glm::dvec3& grid_point, const Affine* blend, uint32_t a,
                            std::vector<PosedPoint>& result) {
  return std::max(0.0f, energyOfPlace(quadric.data(), nodes_.posed.at(a), blend, glm::vec3(grid_point),
                                      nodes_.posed.blocks, result.data()));
}

glm::dvec3 EdgePlacer::minimizer(const glm::dvec3& from, const Affine* blend, uint32_t a,
                                 const std::vector<PosedPoint>& at) const {
  return from + solveNormalEquations(
                    normalEquations(quadric.data(), blend, nodes_.posed.at(a), at.data(), nodes_.posed.blocks), kStay);
}

void EdgePlacer::poseBetween(uint32_t a, uint32_t b, const Placement& placement) {
  const Affine* blend = blendSkin(nodes_.posed, skinBetween(a, b, placement.t8), blend_.data());
  transformPoint(blend, nodes_.posed.blocks, glm::vec3(placement.position), posed.data());
}

Placement EdgePlacer::placeAtEnd(uint32_t a, uint32_t b) {
  const uint32_t blocks = nodes_.posed.blocks;
  const auto [energy_a, energy_b] = energiesAtEnds(quadric.data(), nodes_.posed.at(a), nodes_.posed.at(b), blocks);
  const double at_a = std::max(0.0f, energy_a), at_b = std::max(0.0f, energy_b);
  const uint32_t end = at_b < at_a ? b : a;
  std::copy_n(nodes_.posed.at(end), blocks, posed.begin());
  return {nodes_.positions[end], end == a ? 0 : 8, std::min(at_a, at_b)};
}

Placement EdgePlacer::placeFreely(uint32_t a, uint32_t b) {
  const Segment segment(nodes_.positions[a], nodes_.positions[b], nodes_.placement_shift, nodes_.grid_bits);
  const bool one_skin = sameSkin(nodes_.skins[a], nodes_.skins[b]);
  last_t8_ = kNoBlend;
  Placement best = bestStart(a, b, segment, one_skin);
  // With one skin the energy is a quadratic in the position: one step is all there is to gain.
  for (uint32_t i = 0; i < (one_skin ? 1 : 2); ++i) {
    if (!step(a, b, segment, one_skin, best)) break;
  }
  return best;
}

// With one skin there is one blend between the ends too.
const Affine* EdgePlacer::blendBetween(uint32_t a, uint32_t b, int32_t t8, bool one_skin) {
  if (last_t8_ == t8 || (one_skin && last_t8_ != kNoBlend)) return last_blend_;
  last_t8_ = t8;
  return last_blend_ = blendSkin(nodes_.posed, skinBetween(a, b, t8), blend_.data());
}

Placement EdgePlacer::bestStart(uint32_t a, uint32_t b, const Segment& segment, bool one_skin) {
  Placement best = placeAtEnd(a, b);
  const Affine* blend = blendBetween(a, b, 4, one_skin);
  const glm::ivec3 middle = segment.point(4);
  const double at_middle = energyIn(glm::dvec3(middle), blend, a, trial_);
  if (at_middle <= best.cost) {
    best = {middle, 4, at_middle};
    posed.swap(trial_);
  }
  return best;
}

bool EdgePlacer::step(uint32_t a, uint32_t b, const Segment& segment, bool one_skin, Placement& best) {
  int32_t t8 = best.t8;
  const Affine* blend = blendBetween(a, b, t8, one_skin);
  glm::dvec3 x = minimizer(glm::dvec3(best.position), blend, a, posed);
  const int32_t moved_t8 = segment.nearestEighth(x);
  if (moved_t8 != t8 && !one_skin) {
    blend = blendBetween(a, b, moved_t8, one_skin);
    transformPoint(blend, nodes_.posed.blocks, glm::vec3(x), trial_.data());
    x = minimizer(x, blend, a, trial_);
  }
  t8 = moved_t8;
  const glm::ivec3 position = segment.snap(x, t8);
  const double cost = energyIn(glm::dvec3(position), blend, a, trial_);
  if (!(cost < best.cost)) return false;
  best = {position, t8, cost};
  posed.swap(trial_);
  return true;
}

void EdgePlacer::optimizeSkin(uint32_t a, uint32_t b, double gain, Placement& placement, QuantizedSkin& skin) {
  const Segment segment(nodes_.positions[a], nodes_.positions[b], nodes_.placement_shift, nodes_.grid_bits);
  const JointSet joints = unionOf(nodes_.skins[a], nodes_.skins[b]);
  Placement best = placement;
  QuantizedSkin best_skin = skin;
  best_posed_ = posed;
  at_ = posed;
  for (uint32_t i = 0; i < kMaxAlternations; ++i) {
    const QuantizedSkin next_skin =
        weightStep(nodes_, quadric.data(), nodes_.posed.at(a), joints, best_skin, best.position, candidates_);
    const Affine* blend = blendSkin(nodes_.posed, next_skin, blend_.data());
    Placement next = best;
    next.cost = energyIn(glm::dvec3(best.position), blend, a, at_);
    const glm::dvec3 x = minimizer(glm::dvec3(best.position), blend, a, at_);
    const int32_t t8 = segment.nearestEighth(x);
    const glm::ivec3 position = segment.snap(x, t8);
    const double moved_cost = energyIn(glm::dvec3(position), blend, a, trial_);
    if (moved_cost < next.cost) {
      next = {position, t8, moved_cost};
      at_.swap(trial_);
    }
    if (!(next.cost < best.cost * (1.0 - 0.1 * gain))) break;
    best = next;
    best_skin = next_skin;
    best_posed_ = at_;
  }
  if (best.cost < placement.cost * (1.0 - gain)) {
    placement = best;
    skin = best_skin;
    posed.swap(best_posed_);
  }
}

}  // namespace lithe::bake
