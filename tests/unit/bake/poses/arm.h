// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// A two-joint arm along x small enough to pose by hand.
#pragma once

#include "lithe/bake/model.h"

namespace lithe::bake {

/// Shoulder at the origin, elbow at x = 2. Vertices: (1,0,0) on the shoulder, (2,0,0) and (3,0,0) on the elbow,
/// (2.5,0,0) half on each.
inline Model makeArm() {
  Model model;
  model.nodes = {{"shoulder", kNone, {}}, {"elbow", 0, {{2, 0, 0}, {1, 0, 0, 0}, {1, 1, 1}}}};
  glm::dmat4 to_elbow(1.0);
  to_elbow[3] = {-2, 0, 0, 1};
  model.joints = {{0, glm::dmat4(1.0)}, {1, to_elbow}};
  model.positions = {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {2.5f, 0, 0}};
  model.skins = {{1, {0}, {1.0f}}, {1, {1}, {1.0f}}, {1, {1}, {1.0f}}, {2, {0, 1}, {0.5f, 0.5f}}};
  return model;
}

}  // namespace lithe::bake
