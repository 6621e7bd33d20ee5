// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Minimises a sum of posed quadrics over the places and skins that a parent may have.
#pragma once

#include <vector>

#include "kernels.h"
#include "node_state.h"
#include "placement.h"

namespace lithe::bake {

/// One per thread: scratch for a run's number of poses, and the last answer's posed position.
class EdgePlacer {
 public:
  explicit EdgePlacer(const NodeState& nodes)
      : nodes_(nodes),
        quadric(nodes.posed.blocks),
        posed(nodes.posed.blocks),
        blend_(nodes.posed.blocks),
        trial_(nodes.posed.blocks) {}

 private:
  const NodeState& nodes_;

 public:
  std::vector<Quadric> quadric;   // of the edge, about a's posed position; the caller fills it
  std::vector<PosedPoint> posed;  // of the last placement returned
  std::vector<FanFace> fan;       // scratch for the caller, like the next
  std::vector<uint32_t> between;

  /// The cheaper end point, with its own skin.
  Placement placeAtEnd(uint32_t a, uint32_t b);

  /// Starts at the best of the two ends and the middle, moves to the minimum for that skin, then to the nearest place
  /// the file can hold, whose skin is the interpolated one; keeps the start unless the energy falls. cost = energy.
  Placement placeFreely(uint32_t a, uint32_t b);

  /// Poses a placement with the interpolated skin, into `posed`.
  void poseBetween(uint32_t a, uint32_t b, const Placement& placement);

  /// Alternates a weight step on the simplex with a position step, from a placement, until the energy stops falling.
  /// The result has at most the cap's influences; placement and `skin` change only if its energy falls by more than
  /// `gain`.
  void optimizeSkin(uint32_t a, uint32_t b, double gain, Placement& placement, QuantizedSkin& skin);

  /// The skin at t8 eighths from a to b.
  QuantizedSkin skinBetween(uint32_t a, uint32_t b, int32_t t8) const;

 private:
  static constexpr int32_t kNoBlend = -1;

  double energyIn(const glm::dvec3& grid_point, const Affine* blend, uint32_t a, std::vector<PosedPoint>& result);
  glm::dvec3 minimizer(const glm::dvec3& from, const Affine* blend, uint32_t a,
                       const std::vector<PosedPoint>& at) const;
  Placement bestStart(uint32_t a, uint32_t b, const Segment& segment, bool one_skin);
  bool step(uint32_t a, uint32_t b, const Segment& segment, bool one_skin, Placement& best);
  const Affine* blendBetween(uint32_t a, uint32_t b, int32_t t8, bool one_skin);

  std::vector<Affine> blend_;
  const Affine* last_blend_ = nullptr;  // of the placement at hand
  int32_t last_t8_ = kNoBlend;
  std::vector<PosedPoint> trial_, candidates_, best_posed_, at_;
};

}  // namespace lithe::bake
