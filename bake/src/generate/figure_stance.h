// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// How the figure's body is put into a pose: hips and feet are placed, legs follow by inverse kinematics, arms, spine
/// and fingers by the angles of their joints. Angles in degrees.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "figure.h"

namespace lithe::bake::figure {

/// Where a foot stands: `forward` and `lift` of the ankle from its rest place, and the sole's pitch (toes up is
/// positive). The sole turns about the ball of the foot when the heel rises and about the heel when the toes do.
struct FootPlace {
  double forward = 0.0, lift = 0.0, pitch = 0.0;
};

struct ArmAngles {
  double raise = 0.0;   ///< sideways and up, from the rest pose 45 degrees down
  double swing = 0.0;   ///< forwards
  double twist = 0.0;   ///< of the upper arm; positive turns the elbow's hinge so that the forearm bends upwards
  double elbow = 0.0;   ///< flexion, 0 is the rest pose
  double wrist = 0.0;   ///< towards the thumb's side
  double shrug = 0.0;   ///< of the clavicle, upwards
  double curl = 0.0;    ///< of every finger joint, towards the palm
  double spread = 0.0;  ///< of the fingers
};

/// Lean is forwards, turn to the left, tilt to the left; each shared out over the spine.
struct SpineAngles {
  double lean = 0.0, turn = 0.0, tilt = 0.0;
};

struct Stance {
  glm::dvec3 hips_shift{0.0};
  SpineAngles hips, spine, head;
  std::array<FootPlace, 2> foot;
  std::array<ArmAngles, 2> arm;
};

/// Local rotations of all joints, and the hips' local position.
struct JointPose {
  std::array<glm::dquat, kJointCount> rotation;
  glm::dvec3 hips{0.0};
};
JointPose solveStance(const Stance& stance);

}  // namespace lithe::bake::figure
