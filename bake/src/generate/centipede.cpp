// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "centipede.h"

#include "characters.h"
#include "exact_math.h"
#include "rig.h"

namespace lithe::bake {
namespace centipede {

double segmentFront(uint32_t segment) {
  constexpr double kPair = 2.0 * (kNeckZ - kTailZ) / kSegments;
  return kNeckZ - kPair * (segment / 2) - (segment % 2 ? 0.46 * kPair : 0.0);
}

double trunkHalfWidth(double z) {
  const double t = (z - kTailZ) / (kNeckZ - kTailZ);
  return 0.125 + 0.07 * exact::smoothStep(0.0, 0.35, t) - 0.03 * exact::smoothStep(0.75, 1.0, t);
}

namespace {

/// Adds a chain of joints at the limb's points, the first under `parent`.
void addLimbJoints(Model& model, JointedLimb& limb, const std::string& name, uint32_t parent) {
  for (size_t piece = 0; piece + 1 < limb.points.size(); ++piece) {
    const uint32_t joint = addJoint(model, name + "_" + std::to_string(piece), parent, limb.points[piece]);
    limb.joints.push_back(joint);
    parent = model.joints[joint].node;
  }
}

/// The unit normal of the vertical plane through direction (x, 0, z), so that `angle 90 degrees` of a tube looks up.
glm::dvec3 sideOf(double x, double z) { return glm::normalize(glm::dvec3(-z, 0.0, x)); }

/// Points in a vertical plane: `steps` are (outwards, upwards) pairs that follow `root`.
std::vector<glm::dvec3> fanOut(const glm::dvec3& root, const glm::dvec3& outwards,
                               const std::vector<std::array<double, 2>>& steps) {
  std::vector<glm::dvec3> points = {root};
  for (const auto& [out, up] : steps) points.push_back(points.back() + out * outwards + glm::dvec3(0.0, up, 0.0));
  return points;
}

JointedLimb walkingLeg(uint32_t segment, double side) {
  const double z = 0.5 * (segmentFront(segment) + segmentFront(segment + 1));
  const double reach =
      0.85 + 0.15 * exact::smoothStep(0.0, 6.0, segment) + 0.12 * exact::smoothStep(12.0, 19.0, segment);
  // legs at the front reach forwards, legs at the rear backwards
  const double sweep = exact::radians(24.0 - 56.0 * segment / (kSegments - 1.0));
  const glm::dvec3 outwards(side * exact::cosine(sweep), 0.0, exact::sine(sweep));
  JointedLimb leg;
  leg.points = fanOut({side * 0.62 * trunkHalfWidth(z), kBodyY - 0.035, z}, outwards,
                      {{0.10 * reach, -0.005}, {0.13 * reach, 0.085}, {0.15 * reach, -0.09}, {0.12 * reach, -0.22}});
  leg.radii = {0.034, 0.03, 0.026, 0.019, 0.005};
  leg.side = sideOf(outwards.x, outwards.z);
  return leg;
}

JointedLimb trailingLeg(double side) {
  const glm::dvec3 backwards = glm::normalize(glm::dvec3(side * 0.42, 0.0, -1.0));
  JointedLimb leg;
  leg.points = fanOut({side * 0.06, kBodyY - 0.01, kTailZ + 0.05}, backwards,
                      {{0.16, 0.01}, {0.22, 0.05}, {0.2, 0.01}, {0.2, -0.06}});
  leg.radii = {0.042, 0.04, 0.034, 0.026, 0.006};
  leg.side = sideOf(backwards.x, backwards.z);
  return leg;
}

JointedLimb antenna(double side) {
  const glm::dvec3 forwards = glm::normalize(glm::dvec3(side * 0.5, 0.0, 1.0));
  JointedLimb limb;
  limb.points = fanOut({side * 0.07, kBodyY + 0.05, kNeckZ + 0.27}, forwards,
                       {{0.14, 0.06}, {0.17, 0.09}, {0.2, 0.06}, {0.22, -0.02}, {0.2, -0.08}});
  limb.radii = {0.024, 0.021, 0.018, 0.015, 0.011, 0.005};
  limb.side = sideOf(forwards.x, forwards.z);
  return limb;
}

/// The poison fangs lie in a horizontal plane under the head and close towards the middle.
JointedLimb fang(double side) {
  const double y = kBodyY - 0.055, z = kNeckZ;
  JointedLimb limb;
  limb.points = {
      {side * 0.08, y, z + 0.02}, {side * 0.165, y, z + 0.12}, {side * 0.15, y, z + 0.25}, {side * 0.03, y, z + 0.34}};
  limb.radii = {0.05, 0.052, 0.036, 0.006};
  limb.side = {0.0, 1.0, 0.0};
  return limb;
}

}  // namespace

Plan addSkeleton(Model& model) {
  Plan plan;
  const uint32_t root = addNode(model, "root", kNone, glm::dvec3(0.0));
  uint32_t parent = root;
  for (uint32_t s = 0; s < kSegments; ++s) {
    plan.segment[s] = addJoint(model, "segment_" + std::to_string(s), parent, {0.0, kBodyY, segmentFront(s)});
    parent = model.joints[plan.segment[s]].node;
  }
  const uint32_t first_node = model.joints[plan.segment.front()].node, last_node = parent;
  plan.head = addJoint(model, "head", first_node, {0.0, kBodyY, kNeckZ});
  const uint32_t head_node = model.joints[plan.head].node;
  for (uint32_t i = 0; i < 2; ++i) {
    const std::string suffix = i == 0 ? "_l" : "_r";
    plan.antenna[i] = antenna(kSides[i]);
    plan.fang[i] = fang(kSides[i]);
    plan.trailing[i] = trailingLeg(kSides[i]);
    addLimbJoints(model, plan.antenna[i], "antenna" + suffix, head_node);
    addLimbJoints(model, plan.fang[i], "fang" + suffix, head_node);
    addLimbJoints(model, plan.trailing[i], "trailing" + suffix, last_node);
  }
  for (uint32_t s = 0; s < kLegPairs; ++s) {
    auto& pair = plan.legs.emplace_back();
    for (uint32_t i = 0; i < 2; ++i) {
      pair[i] = walkingLeg(s, kSides[i]);
      const std::string name = "leg_" + std::to_string(s) + (i == 0 ? "_l" : "_r");
      addLimbJoints(model, pair[i], name, model.joints[plan.segment[s]].node);
    }
  }
  return plan;
}

}  // namespace centipede

Model generateCentipede() {
  Model model;
  addPart(model, "shell", "shell");
  addPart(model, "flesh", "flesh");
  const centipede::Plan plan = centipede::addSkeleton(model);
  SurfaceBuilder surface(2);
  centipede::addTrunk(surface, plan);
  centipede::addHead(surface, plan);
  centipede::addLimbs(surface, plan);
  surface.finish(model);
  model.clips = {centipede::walkClip(model, plan), centipede::curlClip(model, plan)};
  return model;
}

}  // namespace lithe::bake
