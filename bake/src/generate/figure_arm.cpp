// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Flesh of arm and hand, in directions along the arm, towards the thumb and out of the palm.
#include "figure.h"

namespace lithe::bake::figure {
namespace {

using glm::dvec3;
using implicit::ellipsoid;
using implicit::Primitive;
using implicit::roundCone;
using implicit::Solid;

/// Where things lie along a bone of the left arm.
struct ArmFrame {
  dvec3 from, to;
  dvec3 across, palm;  ///< towards the thumb's side (forwards at rest), and out of the palm (downwards at rest)

  dvec3 at(double along, double to_thumb, double to_palm) const {
    return glm::mix(from, to, along) + to_thumb * across + to_palm * palm;
  }
};

ArmFrame frameOf(const dvec3& from, const dvec3& to) {
  const dvec3 along = glm::normalize(to - from);
  const dvec3 across = glm::normalize(dvec3(0, 0, 1) - along * along.z);
  return {from, to, across, glm::cross(along, across)};
}

/// An ellipsoid on the bone: semi-axes along, towards the thumb and out of the palm.
Primitive muscle(const ArmFrame& bone, double along, double to_thumb, double to_palm, const dvec3& radii,
                 double blend) {
  Primitive primitive = ellipsoid(bone.at(along, to_thumb, to_palm), radii, blend);
  primitive.frame = glm::dmat3(glm::normalize(bone.to - bone.from), bone.across, bone.palm);
  return primitive;
}

Primitive flattened(Primitive primitive, const dvec3& axis, double factor) {
  primitive.flat_axis = axis;
  primitive.flat_factor = factor;
  return primitive;
}

void addUpperArm(Solid& solid, const Anatomy& a) {
  const ArmFrame bone = frameOf(a.shoulder, a.elbow);
  solid.addPair(roundCone(bone.at(0.02, 0, 0), 0.052, bone.at(0.98, 0, 0), 0.037, 0.045));
  solid.addPair(muscle(bone, 0.16, 0.002, -0.016, {0.088, 0.056, 0.048}, 0.035));
  solid.addPair(muscle(bone, 0.10, 0.028, -0.004, {0.066, 0.036, 0.042}, 0.03));
  solid.addPair(muscle(bone, 0.58, 0.022, 0.004, {0.088, 0.031, 0.036}, 0.025));
  solid.addPair(muscle(bone, 0.52, -0.023, 0.002, {0.098, 0.034, 0.039}, 0.025));
  solid.addPair(muscle(bone, 0.99, -0.026, 0.0, {0.020, 0.016, 0.018}, 0.025));
}

void addForearm(Solid& solid, const Anatomy& a) {
  const ArmFrame bone = frameOf(a.elbow, a.wrist);
  solid.addPair(roundCone(bone.at(0, 0, 0), 0.039, bone.at(0.5, 0, 0), 0.035, 0.035));
  solid.addPair(flattened(roundCone(bone.at(0.45, 0, 0), 0.035, bone.at(1.0, 0, 0), 0.0275, 0.03), bone.palm, 0.76));
  solid.addPair(muscle(bone, 0.24, 0.022, -0.006, {0.080, 0.030, 0.033}, 0.025));
  solid.addPair(muscle(bone, 0.26, -0.012, 0.018, {0.085, 0.033, 0.030}, 0.025));
  solid.addPair(muscle(bone, 0.93, -0.022, -0.014, {0.013, 0.010, 0.010}, 0.014));
}

void addPalm(Solid& solid, const Anatomy& a) {
  const dvec3 wrist = a.wrist;
  for (uint32_t i = 1; i < 5; ++i) {
    const dvec3 knuckle = a.fingers[i].points[0];
    const double sideways = glm::dot(knuckle - wrist, a.across);
    const dvec3 root = wrist + 0.006 * a.along + 0.62 * sideways * a.across;
    solid.addPair(roundCone(root, 0.0165, knuckle, a.fingers[i].radii[0] * 1.08, 0.014));
  }
  const ArmFrame hand = {wrist, wrist + 0.1 * a.along, a.across, a.palm};
  solid.addPair(muscle(hand, 0.40, 0.021, 0.013, {0.032, 0.017, 0.014}, 0.012));   // ball of the thumb
  solid.addPair(muscle(hand, 0.42, -0.025, 0.010, {0.038, 0.013, 0.012}, 0.012));  // ball of the little finger
  solid.cutPair(muscle(hand, 0.60, 0.000, 0.026, {0.026, 0.014, 0.010}, 0.012));   // hollow of the palm
}

void addFingers(Solid& solid, const Anatomy& a) {
  for (uint32_t i = 0; i < 5; ++i) {
    const Finger& finger = a.fingers[i];
    for (int bone = 0; bone < 3; ++bone) {
      const double blend = bone == 0 ? 0.005 : 0.002;
      solid.addPair(
          roundCone(finger.points[bone], finger.radii[bone], finger.points[bone + 1], finger.radii[bone + 1], blend));
    }
    solid.addPair(ellipsoid(finger.points[0] - 0.0025 * a.palm, dvec3(0.92 * finger.radii[0]), 0.008));
    // the nail's bed: a shallow step on the back of the last bone
    const dvec3 axis = glm::normalize(finger.points[3] - finger.points[2]);
    const dvec3 back =
        glm::normalize(i == 0 ? glm::cross(axis, a.palm) : glm::cross(a.across, axis)) * (i == 0 ? 0.4 : 1.0) -
        (i == 0 ? 0.8 : 0.0) * a.palm;
    const dvec3 out = glm::normalize(back - axis * glm::dot(back, axis));
    const double r = finger.radii[3];
    solid.addPair(
        ellipsoid(finger.points[3] + 0.32 * r * axis + 0.62 * r * out, dvec3(0.62 * r, 0.62 * r, 0.62 * r), 0.001));
  }
}

}  // namespace

void addArmFlesh(Solid& solid) {
  const Anatomy& a = anatomy();
  addUpperArm(solid, a);
  addForearm(solid, a);
  addPalm(solid, a);
  addFingers(solid, a);
}

}  // namespace lithe::bake::figure
