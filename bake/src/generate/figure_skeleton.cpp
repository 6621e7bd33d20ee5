// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>

#include "exact_math.h"
#include "figure.h"
#include "rig.h"

namespace lithe::bake::figure {
namespace {

using glm::dvec3;

/// A finger in the hand's own directions, lengths in metres.
struct FingerPlan {
  double along, across, palm;  ///< of the knuckle, from the wrist
  double spread;               ///< how far it points to the thumb's side
  std::array<double, 3> bones;
  double radius;
};
constexpr std::array<FingerPlan, 5> kFingerPlans = {{
    {0.026, 0.023, 0.011, 0.95, {0.044, 0.034, 0.028}, 0.0115},
    {0.086, 0.0290, 0.0, 0.20, {0.043, 0.026, 0.022}, 0.0091},
    {0.090, 0.0070, -0.001, 0.04, {0.048, 0.030, 0.023}, 0.0094},
    {0.086, -0.0150, 0.0, -0.12, {0.044, 0.028, 0.023}, 0.0089},
    {0.078, -0.0350, 0.003, -0.30, {0.035, 0.021, 0.020}, 0.0079},
}};

Finger makeFinger(const Anatomy& a, uint32_t index) {
  const FingerPlan& plan = kFingerPlans[index];
  const bool thumb = index == 0;
  // relaxed fingers bend towards the palm, each joint more than the one before
  const std::array<double, 3> curl = thumb ? std::array{0.38, 0.30, 0.22} : std::array{0.06, 0.24, 0.40};
  Finger finger;
  finger.points[0] = a.wrist + plan.along * a.along + plan.across * a.across + plan.palm * a.palm;
  finger.radii[0] = plan.radius * (thumb ? 1.1 : 1.06);
  for (int bone = 0; bone < 3; ++bone) {
    const double spread = thumb ? plan.spread - 0.18 * bone : plan.spread;
    const dvec3 direction = glm::normalize(a.along + spread * a.across + curl[bone] * a.palm);
    finger.points[bone + 1] = finger.points[bone] + plan.bones[bone] * direction;
    finger.radii[bone + 1] = plan.radius * (1.0 - 0.09 * (bone + 1));
  }
  finger.points[3] -= 0.55 * finger.radii[3] * glm::normalize(finger.points[3] - finger.points[2]);
  return finger;
}

Anatomy makeAnatomy() {
  Anatomy a;
  a.shoulder = {0.172, 1.405, -0.022};
  a.elbow = a.shoulder + 0.285 * glm::normalize(dvec3(0.72, -0.70, -0.02));
  a.along = glm::normalize(dvec3(0.70, -0.705, 0.11));
  a.wrist = a.elbow + 0.252 * a.along;
  a.across = glm::normalize(dvec3(0, 0, 1) - a.along * a.along.z);
  a.palm = glm::cross(a.along, a.across);
  a.hip = {0.090, 0.915, -0.005};
  a.knee = {0.098, 0.500, 0.008};
  a.ankle = {0.104, 0.082, -0.022};
  a.toes = {0.118, 0.022, 0.095};
  a.toe_tip = {0.125, 0.018, 0.165};
  a.eye = {0.0315, 1.6425, 0.0725};
  for (uint32_t i = 0; i < 5; ++i) a.fingers[i] = makeFinger(a, i);
  return a;
}

struct MiddlePlan {
  const char* name;
  dvec3 position;
};

void addMiddle(Model& model) {
  const std::array<MiddlePlan, kMiddleJoints> plans = {{
      {"hips", {0.0, 0.955, -0.005}},
      {"waist", {0.0, 1.045, -0.012}},
      {"belly", {0.0, 1.150, -0.022}},
      {"chest", {0.0, 1.270, -0.030}},
      {"neck", {0.0, 1.470, -0.038}},
      {"head", {0.0, 1.560, -0.018}},
  }};
  uint32_t parent = addNode(model, "root", kNone, dvec3(0.0));
  for (const MiddlePlan& plan : plans) {
    const uint32_t joint = addJoint(model, plan.name, parent, plan.position);
    parent = model.joints[joint].node;
  }
}

void addSide(Model& model, Side side) {
  const Anatomy& a = anatomy();
  const std::string suffix = side == kLeft ? "_l" : "_r";
  const auto add = [&](const std::string& name, uint32_t parent, const dvec3& position) {
    return addJoint(model, name + suffix, model.joints[parent].node, side == kLeft ? position : mirror(position));
  };
  const uint32_t clavicle = add("clavicle", kChest, {0.022, 1.420, 0.0});
  const uint32_t upper_arm = add("upper_arm", clavicle, a.shoulder);
  const uint32_t forearm = add("forearm", upper_arm, a.elbow);
  const uint32_t hand = add("hand", forearm, a.wrist);
  const std::array names = {"thumb", "index", "middle", "ring", "little"};
  for (uint32_t finger = 0; finger < 5; ++finger) {
    uint32_t parent = hand;
    for (uint32_t bone = 0; bone < 3; ++bone) {
      parent = add(std::string(names[finger]) + "_" + std::to_string(bone), parent, a.fingers[finger].points[bone]);
    }
  }
  const uint32_t thigh = add("thigh", kHips, a.hip);
  const uint32_t shin = add("shin", thigh, a.knee);
  const uint32_t foot = add("foot", shin, a.ankle);
  add("toes", foot, a.toes);
  add("eye", kHead, a.eye);
}

}  // namespace

const Anatomy& anatomy() {
  static const Anatomy instance = makeAnatomy();
  return instance;
}

dvec3 mirror(const dvec3& point) { return {-point.x, point.y, point.z}; }

void addSkeleton(Model& model) {
  addMiddle(model);
  addSide(model, kLeft);
  addSide(model, kRight);
}

}  // namespace lithe::bake::figure
