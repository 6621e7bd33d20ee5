// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The centipede's plan, shared by its skeleton, surface and motion. Head first: segment 0 follows the head, +z is
/// forward.
#pragma once

#include <array>
#include <vector>

#include "lithe/bake/model.h"
#include "surface_builder.h"
#include "tube.h"

namespace lithe::bake::centipede {

inline constexpr uint32_t kSegments = 20;
inline constexpr uint32_t kLegPairs = 19;          ///< the last segment carries the trailing pair instead
inline constexpr double kNeckZ = 1.75;             ///< front edge of segment 0
inline constexpr double kTailZ = -1.95;            ///< rear edge of the last segment
inline constexpr double kBodyY = 0.27;             ///< height of the axis over the ground
inline constexpr std::array kSides = {1.0, -1.0};  ///< left is +x

enum PartIndex : uint32_t { kShell, kFlesh };

/// A limb of the rest pose: its centre line with one joint per piece.
struct JointedLimb {
  std::vector<glm::dvec3> points;
  std::vector<double> radii;
  glm::dvec3 side{0.0, 0.0, 1.0};  ///< unit normal of the plane the points lie in
  std::vector<uint32_t> joints;    ///< one per piece
};

/// Joints and limbs, made by addSkeleton().
struct Plan {
  uint32_t head = 0;
  std::array<uint32_t, kSegments> segment{};
  std::vector<std::array<JointedLimb, 2>> legs;  ///< per pair, per side
  std::array<JointedLimb, 2> trailing, antenna, fang;
};

/// z of the front edge of a segment; index kSegments is the rear edge of the last. Long and short segments alternate.
double segmentFront(uint32_t segment);

/// Half the width of the trunk at z, without its plates' relief.
double trunkHalfWidth(double z);

Plan addSkeleton(Model& model);
void addTrunk(SurfaceBuilder& surface, const Plan& plan);
void addHead(SurfaceBuilder& surface, const Plan& plan);
void addLimbs(SurfaceBuilder& surface, const Plan& plan);
Clip walkClip(const Model& model, const Plan& plan);
Clip curlClip(const Model& model, const Plan& plan);

}  // namespace lithe::bake::centipede
