// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "figure_stance.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "exact_math.h"

namespace lithe::bake::figure {
namespace {

using glm::dquat;
using glm::dvec3;

const dvec3 kAxisX(1.0, 0.0, 0.0), kAxisY(0.0, 1.0, 0.0), kAxisZ(0.0, 0.0, 1.0);
const dvec3 kHipsRest(0.0, 0.955, -0.005);

dquat turned(const dvec3& axis, double degrees) { return exact::rotation(axis, exact::radians(degrees)); }

/// The rotation on the other side of the body.
dquat mirrored(const dquat& q) { return {q.w, q.x, -q.y, -q.z}; }

dquat spineRotation(const SpineAngles& angles, double share) {
  return turned(kAxisY, share * angles.turn) * turned(kAxisZ, -share * angles.tilt) *
         turned(kAxisX, share * angles.lean);
}

/// Angle forwards from straight down of a vector in the plane of y and z.
double forwardAngle(const dvec3& v) { return exact::arcTangent2(v.z, -v.y); }

double planarLength(const dvec3& v) { return std::sqrt(v.y * v.y + v.z * v.z); }

/// Where the ankle comes to lie when the foot is placed.
dvec3 anklePlace(const FootPlace& foot) {
  const Anatomy& a = anatomy();
  const dvec3 heel(a.ankle.x, 0.0, -0.075), ball(a.toes.x, 0.0, a.toes.z);
  const dvec3 pivot = foot.pitch > 0.0 ? heel : ball;
  const dvec3 turned_ankle = pivot + turned(kAxisX, -foot.pitch) * (a.ankle - pivot);
  return turned_ankle + dvec3(0.0, foot.lift, foot.forward);
}

struct LegAngles {
  double thigh, shin;  ///< forwards from straight down
};

/// The two-bone triangle in the plane of y and z, knee forwards.
LegAngles solveLeg(const dvec3& hip_to_ankle, double thigh_length, double shin_length) {
  constexpr double kStraightest = 0.9995;
  const double reach = kStraightest * (thigh_length + shin_length);
  const double d = glm::clamp(planarLength(hip_to_ankle), 0.2, reach), towards = forwardAngle(hip_to_ankle);
  const double at_hip = (thigh_length * thigh_length + d * d - shin_length * shin_length) / (2.0 * thigh_length * d);
  const double at_ankle = (shin_length * shin_length + d * d - thigh_length * thigh_length) / (2.0 * shin_length * d);
  return {towards + exact::arcCosine(at_hip), towards - exact::arcCosine(at_ankle)};
}

void poseLeg(JointPose& pose, Side side, const FootPlace& foot) {
  const Anatomy& a = anatomy();
  const double sign = side == kLeft ? 1.0 : -1.0;
  const dquat hips = pose.rotation[kHips];
  const dvec3 hip = pose.hips + hips * ((side == kLeft ? a.hip : mirror(a.hip)) - kHipsRest);
  const dvec3 ankle = anklePlace(foot);
  const LegAngles angles = solveLeg(ankle - hip, planarLength(a.knee - a.hip), planarLength(a.ankle - a.knee));

  // the foot stays under its rest place sideways: the whole leg leans from the hip
  const double sideways = sign * a.ankle.x - hip.x - sign * (a.ankle.x - a.hip.x);
  const dquat lean = exact::rotation(kAxisZ, exact::arcTangent2(sideways, std::max(0.3, hip.y - ankle.y)));
  const dquat thigh = lean * exact::rotation(kAxisX, forwardAngle(a.knee - a.hip) - angles.thigh);
  const dquat shin = lean * exact::rotation(kAxisX, forwardAngle(a.ankle - a.knee) - angles.shin);
  const dquat sole = turned(kAxisX, -foot.pitch);
  pose.rotation[jointOf(side, kThigh)] = glm::conjugate(hips) * thigh;
  pose.rotation[jointOf(side, kShin)] = glm::conjugate(thigh) * shin;
  pose.rotation[jointOf(side, kFoot)] = glm::conjugate(shin) * sole;
  // planted toes stay on the ground while the heel rises
  const double on_ground = 1.0 - exact::smoothStep(0.0, 0.12, foot.lift);
  pose.rotation[jointOf(side, kToes)] = turned(kAxisX, std::min(0.0, foot.pitch) * on_ground);
}

void poseFingers(const Anatomy& a, const ArmAngles& angles, const std::function<void(uint32_t, const dquat&)>& set) {
  const dvec3 flexion = glm::cross(a.along, a.palm);
  for (uint32_t finger = 1; finger < 5; ++finger) {
    const double fan = angles.spread * (2.5 - finger) / 1.5;
    for (uint32_t bone = 0; bone < 3; ++bone) {
      const dquat bend = turned(flexion, angles.curl * (1.0 + 0.12 * (finger - 1.0)));
      set(kFingers + 3 * finger + bone, bone == 0 ? turned(a.palm, fan) * bend : bend);
    }
  }
  const dvec3 thumb = glm::normalize(a.fingers[0].points[2] - a.fingers[0].points[1]);
  const dvec3 thumb_flexion = glm::normalize(glm::cross(thumb, a.palm - 0.8 * a.across));
  for (uint32_t bone = 1; bone < 3; ++bone) set(kFingers + bone, turned(thumb_flexion, 0.7 * angles.curl));
}

void poseArm(JointPose& pose, Side side, const ArmAngles& angles) {
  const Anatomy& a = anatomy();
  const auto set = [&](uint32_t joint, const dquat& q) {
    pose.rotation[jointOf(side, joint)] = side == kLeft ? q : mirrored(q);
  };
  const dvec3 upper = glm::normalize(a.elbow - a.shoulder);
  set(kClavicle, turned(kAxisZ, angles.shrug));
  set(kUpperArm, turned(kAxisX, -angles.swing) * turned(kAxisZ, angles.raise) * turned(upper, -angles.twist));
  set(kForearm, turned(glm::normalize(glm::cross(a.along, kAxisZ)), angles.elbow));
  set(kHand, turned(a.palm, angles.wrist));
  poseFingers(a, angles, set);
}

}  // namespace

JointPose solveStance(const Stance& stance) {
  JointPose pose;
  pose.rotation.fill(dquat(1.0, 0.0, 0.0, 0.0));
  pose.hips = kHipsRest + stance.hips_shift;
  pose.rotation[kHips] = spineRotation(stance.hips, 1.0);
  pose.rotation[kWaist] = spineRotation(stance.spine, 0.30);
  pose.rotation[kBelly] = spineRotation(stance.spine, 0.35);
  pose.rotation[kChest] = spineRotation(stance.spine, 0.35);
  pose.rotation[kNeck] = spineRotation(stance.head, 0.45);
  pose.rotation[kHead] = spineRotation(stance.head, 0.55);
  for (const Side side : {kLeft, kRight}) {
    poseLeg(pose, side, stance.foot[side]);
    poseArm(pose, side, stance.arm[side]);
  }
  return pose;
}

}  // namespace lithe::bake::figure
