// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Moves the nodes of a level to where its posed surface lies closest to the original's.
//
// A collapse sees the surface it replaces, which has errors of its own: they add up. A refit looks at the original
// again: samples of its faces are matched with the nearest points of the faces around the nodes that their corners
// have become part of, and the nodes move so that these points come to lie in the samples' planes in all example poses.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "fan.h"
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

  /// Moves the nodes that have been made since the last call. Their new posed positions are in nodes.posed;
  /// moved(slot, posed before) is called once for each that moved.
  void run(NodeState& nodes, const Surface& surface, const std::function<void(uint32_t, const PosedPoint*)>& moved);

 private:
  /// A face of the original, or an edge of its border.
  struct Sampled {
    std::array<uint32_t, 3> vertex;
    float area;  ///< what its samples count, mean over the poses
  };
  /// A sample, and the nearest point of the surface as shares of a face's corners.
  struct Match {
    const Sampled& from;
    const float* at;  ///< shares of its vertices
    float area;
    bool border;
    uint32_t face;
    float share[3];
  };
  struct Made {
    glm::ivec3 v{0}, d{0};
    int32_t t8 = 4;
  };

  uint32_t slotOf(uint32_t vertex);
  double matchAll(const NodeState& nodes, const Surface& surface);
  void poseSample(const Match& match);
  bool findNearest(const NodeState& nodes, const Surface& surface, Match& match);
  double accumulate(const Match& match, const NodeState& nodes, const Surface& surface);
  bool step(uint32_t slot, NodeState& nodes, const Surface& surface);
  bool mayMove(uint32_t slot, const PosedPoint* to, const NodeState& nodes, const Surface& surface) const;
  std::vector<glm::ivec3> places(const NodeState& nodes) const;
  void putBack(const std::vector<glm::ivec3>& places, NodeState& nodes);

  const EdgeWeights weights_;
  uint32_t blocks_;
  std::vector<PosedPoint> position_;  // of the original's vertices
  std::vector<Sampled> faces_, borders_;
  std::vector<uint32_t> into_;   // per slot: the slot it has become part of
  std::vector<Made> made_;       // per slot
  std::vector<uint8_t> is_new_;  // per slot: made since the last run
  std::vector<uint32_t> new_slots_;

  std::vector<Quadric> quadric_;     // of the new slots, by new_index_
  std::vector<uint32_t> new_index_;  // per slot
  std::vector<PosedPoint> trial_;
  std::vector<PosedPoint> point_, normal_;  // of the sample at hand
  std::vector<Affine> blend_;
};

}  // namespace lithe::bake
