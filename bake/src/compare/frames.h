// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Which instants a comparison looks at, and where the original's nodes are at each.
#pragma once

#include <string>
#include <vector>

#include "lithe/bake/compare.h"

namespace lithe::bake {

/// A moment of the original: the world matrix of every one of its nodes.
struct Instant {
  std::string clip;
  double time = 0.0;
  std::vector<glm::dmat4> node_world;
};

/// A (clip, time) pair of Model::clips.
struct ClipTime {
  uint32_t clip = 0;
  double time = 0.0;
};

/// The frames that the options ask for, from the given clips. Clips get one frame each, then the rest one by one where
/// a frame covers the longest time.
std::vector<ClipTime> chooseFrames(const std::vector<Clip>& clips, const CompareOptions& options);

Instant restInstant(const Model& original);
std::vector<Instant> chosenInstants(const Model& original, const CompareOptions& options);

}  // namespace lithe::bake
