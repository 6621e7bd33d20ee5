// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The skin for which a sum of posed quadrics is least at a given place.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "kernels.h"
#include "lithe/bake/simplex.h"
#include "node_state.h"

namespace lithe::bake {

/// Joints without repetition.
struct JointSet {
  uint32_t size = 0;
  std::array<uint16_t, kMaxSimplexSize> joint{};

  std::span<const uint16_t> span() const { return {joint.data(), size}; }
};

inline JointSet jointsOf(const QuantizedSkin& skin) {
  JointSet joints{skin.count, {}};
  std::copy_n(skin.joint.begin(), skin.count, joints.joint.begin());
  return joints;
}

/// The joints of both skins, a's first.
JointSet unionOf(const QuantizedSkin& a, const QuantizedSkin& b);

/// Weights on the simplex of `joints` that minimise the quadrics (after Landreneau and Schaefer 2009, who leave their
/// signs free) with the bind position held, rounded to integers; at most nodes.max_influences of them.
/// @param quadric     [block], about origin[block]
/// @param start       where the search begins: its joints are among `joints`
/// @param candidates  scratch
QuantizedSkin weightStep(const NodeState& nodes, const Quadric* quadric, const PosedPoint* origin,
                         const JointSet& joints, const QuantizedSkin& start, const glm::ivec3& position,
                         std::vector<PosedPoint>& candidates);

}  // namespace lithe::bake
