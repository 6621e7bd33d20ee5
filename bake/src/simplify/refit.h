// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Moves the nodes of a level, and gives them new weights, so that its posed surface lies closest to the original's.
//
// A collapse sees the surface it replaces, which has errors of its own: they add up. A refit looks at the original
// again: samples of its faces are matched with the nearest points of the faces around the nodes that their corners
// have become part of, and the nodes move so that these points come to lie in the samples' planes in all example poses.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "fan.h"
#include "large_vector.h"
#include "nearest_face.h"
#include "node_state.h"
#include "placement.h"
#include "surface.h"

namespace lithe::bake {

class Refit {
 public:
  /// Takes the original as it is now: before the first collapse.
  Refit(const NodeState& nodes, const Surface& surface, const SimplifyOptions& options);

  /// Slot b has become part of slot a, whose place is `t8` eighths along `segment`, or a lattice point near it.
  void merged(uint32_t a, uint32_t b, const Segment& segment, int32_t t8);

  /// Moves the nodes that have been made since the last call; their weights change only where that lowers what their
  /// matches cost by more than the share SimplifyOptions::weight_gain, and no joint is added. What they are afterwards
  /// is in `nodes`; moved(slot, posed before) is called once for each that has another position or skin.
  void run(NodeState& nodes, const Surface& surface, const std::function<void(uint32_t, const PosedPoint*)>& moved);

 private:
  /// A face of the original, or an edge of its border.
  struct Sampled {
    std::array<uint32_t, 3> vertex;
    float area;  ///< what its samples count, mean over the poses
  };
  struct Sample {
    const Sampled& from;
    const float* at;  ///< shares of its vertices
    float area;
    bool border;
  };
  struct Made {
    glm::ivec3 v{0}, d{0};
    int32_t t8 = 4;
  };
  struct Place {
    glm::ivec3 position;
    QuantizedSkin skin;

    bool operator==(const Place&) const = default;
  };

  // Samples
  uint32_t sampleCount() const;
  Sample sampleAt(uint32_t index) const;
  void chooseSamples(const Surface& surface);
  std::array<uint32_t, 3> slotsOf(const Sample& sample) const;
  const PosedPoint* originalAt(uint32_t vertex) const { return position_.data() + size_t{vertex} * blocks_; }
  void poseSample(const Sample& sample, std::vector<PosedPoint>& point) const;
  void poseNormal(const Sample& sample, std::vector<PosedPoint>& normal) const;

  // Matching
  void findRoots();
  void measureEdges(const NodeState& nodes, const Surface& surface);
  void noteChange(uint32_t slot, const Surface& surface);
  double match(const NodeState& nodes, const Surface& surface);
  void findNearest(const NodeState& nodes, const Surface& surface);
  double accumulateAll(const NodeState& nodes, const Surface& surface);
  void noteFaces(const Surface& surface);
  void accumulateAt(uint32_t first_slot, uint32_t end_slot, const NodeState& nodes, const Surface& surface);
  Quadric* quadricAt(uint32_t new_slot) { return quadric_.data() + size_t{new_index_[new_slot]} * blocks_; }
  const Quadric* quadricAt(uint32_t new_slot) const { return quadric_.data() + size_t{new_index_[new_slot]} * blocks_; }

  // Moving
  bool stepAll(NodeState& nodes, const Surface& surface);
  bool step(uint32_t slot, NodeState& nodes, const Surface& surface);
  bool stepPosition(uint32_t slot, NodeState& nodes, const Surface& surface);
  bool stepWeights(uint32_t slot, NodeState& nodes, const Surface& surface);
  glm::dvec3 bestMove(uint32_t slot, const Affine* blend, const PosedPoint* from) const;
  glm::ivec3 placeAfter(uint32_t slot, const glm::dvec3& move, const NodeState& nodes) const;
  bool mayMove(uint32_t slot, const PosedPoint* to, const NodeState& nodes, const Surface& surface) const;
  std::vector<Place> places(const NodeState& nodes) const;
  const PosedPoint* pose(const Place& place, const NodeState& nodes);
  void putBack(const std::vector<Place>& places, NodeState& nodes);

  const EdgeWeights weights_;
  const double weight_gain_;
  const uint32_t threads_;
  uint32_t blocks_;
  LargeVector<PosedPoint> position_;  // of the original's vertices
  std::vector<Sampled> faces_, borders_;
  std::vector<uint32_t> into_;   // per slot: the slot it has become part of
  std::vector<Made> made_;       // per slot
  std::vector<uint8_t> is_new_;  // per slot: made since the last run
  std::vector<uint32_t> new_slots_;

  // During a run
  uint32_t stride_ = 1;                   // of the sampled faces
  uint32_t per_face_ = 1;                 // samples
  std::vector<uint32_t> root_;            // per vertex: the slot it has become part of in the end
  std::vector<EdgeLengths> lengths_;      // per face
  std::vector<FacePoint> nearest_;        // per sample
  std::vector<float> energy_;             // per sample
  std::vector<uint8_t> has_changed_;      // per slot: one of its faces has, since the samples were matched
  std::vector<uint8_t> matches_changed_;  // per slot: since its quadric was filled
  std::vector<uint8_t> face_concerns_;    // per face: the matches of one of its corners have changed
  std::vector<Quadric> quadric_;          // of the new slots, by new_index_
  std::vector<uint32_t> new_index_;       // per slot
  std::vector<PosedPoint> matched_;       // of the slot at hand: where its quadric was filled
  std::vector<PosedPoint> trial_, reweighted_, candidates_;
  std::vector<Affine> blend_;
};

}  // namespace lithe::bake
