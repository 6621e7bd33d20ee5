// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The figure's anatomy, shared by its skeleton, flesh, skin weights, texture charts and motion.
/// Metres; y up, z forwards, the figure's left is +x. It stands with its arms 45 degrees down to the sides.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "implicit.h"
#include "isosurface.h"
#include "lithe/bake/model.h"
#include "surface_builder.h"

namespace lithe::bake::figure {

enum PartIndex : uint32_t { kSkin, kHair, kShorts, kEyes, kPartCount };

/// Joints of one side; the palette holds the middle's joints, then the left's, then the right's.
enum MiddleJoint : uint32_t { kHips, kWaist, kBelly, kChest, kNeck, kHead, kMiddleJoints };
enum SideJoint : uint32_t {
  kClavicle,
  kUpperArm,
  kForearm,
  kHand,
  kFingers,  ///< first of 5 fingers x 3 joints, thumb first
  kThigh = kFingers + 15,
  kShin,
  kFoot,
  kToes,
  kEye,
  kSideJoints
};
enum Side : uint32_t { kLeft, kRight };

inline constexpr uint32_t kJointCount = kMiddleJoints + 2 * kSideJoints;
inline constexpr uint32_t jointOf(Side side, uint32_t joint) {
  return kMiddleJoints + (side == kRight ? kSideJoints : 0u) + joint;
}

/// What a point of the surface is made of: the labels of the solid's primitives.
enum Label : uint16_t { kFlesh, kHairCap };

inline constexpr double kEyeRadius = 0.0122;
inline constexpr double kWaistband = 0.985, kHem = 0.70;  ///< y of the shorts' upper and lower edge

/// A finger of the left hand: knuckle, two joints and the tip, with the radius at each.
struct Finger {
  std::array<glm::dvec3, 4> points;
  std::array<double, 4> radii;
};

/// Rest positions of the left half and the middle; the right half is the mirror image.
struct Anatomy {
  glm::dvec3 shoulder, elbow, wrist;
  glm::dvec3 hip, knee, ankle, toes, toe_tip;
  glm::dvec3 eye;
  /// Of the left hand: towards the fingertips, towards the thumb's side, out of the palm. Unit, orthogonal.
  glm::dvec3 along, across, palm;
  std::array<Finger, 5> fingers;
};
const Anatomy& anatomy();

glm::dvec3 mirror(const glm::dvec3& point);

/// Adds the node `root` and all joints, in palette order.
void addSkeleton(Model& model);

/// The body without eyeballs.
implicit::Solid makeFlesh();
void addTrunkFlesh(implicit::Solid& solid);
void addHeadFlesh(implicit::Solid& solid);
void addArmFlesh(implicit::Solid& solid);
void addLegFlesh(implicit::Solid& solid);

/// Skins of at most 4 influences, and per vertex the joint whose piece of the body is nearest.
struct Binding {
  std::vector<Skin> skins;
  std::vector<uint32_t> nearest_joint;
};
Binding bindToSkeleton(const Model& model, const ClosedMesh& mesh);

/// Cuts the body along the edges of what it wears. Returns the part of every triangle.
std::vector<PartIndex> dress(const implicit::Solid& flesh, ClosedMesh& mesh);

/// Cuts the body into charts and adds it, a wedge to every vertex, part and chart.
void addBody(SurfaceBuilder& surface, const ClosedMesh& mesh, const std::vector<PartIndex>& parts,
             const Binding& binding);
void addEyeballs(SurfaceBuilder& surface);

std::vector<Clip> makeClips(const Model& model);

}  // namespace lithe::bake::figure
