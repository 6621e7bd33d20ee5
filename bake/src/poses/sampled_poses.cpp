// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <numbers>

#include "lithe/bake/poses.h"
#include "palette.h"

namespace lithe::bake {

namespace {

/// splitmix64 (Steele, Lea, Flood 2014): every output bit depends on every input bit.
uint64_t mix(uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// Random numbers that depend on where they are used, not on what was drawn before.
class JointNoise {
 public:
  JointNoise(uint32_t pose, uint32_t node) : key_(mix((uint64_t{pose} << 32) | node)) {}

  double signedUnit() { return static_cast<double>(mix(key_ + drawn_++) >> 11) * 0x1p-52 - 1.0; }

 private:
  uint64_t key_;
  uint64_t drawn_ = 0;
};

/// Uniform on the sphere by rejection from the cube.
glm::dvec3 randomAxis(JointNoise& noise) {
  for (;;) {
    glm::dvec3 axis;
    for (int k = 0; k < 3; ++k) axis[k] = noise.signedUnit();
    const double length = std::sqrt(glm::dot(axis, axis));
    if (length > 0.1 && length <= 1.0) return axis / length;
  }
}

glm::dquat randomRotation(JointNoise& noise, double max_angle) {
  const glm::dvec3 axis = randomAxis(noise);
  const double half = 0.5 * max_angle * noise.signedUnit();
  const double sine = std::sin(half);
  return glm::dquat(std::cos(half), axis.x * sine, axis.y * sine, axis.z * sine);
}

std::vector<bool> jointNodes(const Model& model) {
  std::vector<bool> is_joint(model.nodes.size(), false);
  for (const Joint& joint : model.joints) is_joint[joint.node] = true;
  return is_joint;
}

double poseAmplitude(uint32_t pose) {
  constexpr std::array<double, 4> kAmplitudes{1.0, 0.5, 0.75, 0.25};
  return kAmplitudes[pose % kAmplitudes.size()] * kSampledDegrees * std::numbers::pi / 180.0;
}

}  // namespace

std::vector<Pose> sampledPoses(const Model& model, uint32_t count, uint32_t first) {
  const std::vector<bool> is_joint = jointNodes(model);
  std::vector<Pose> poses;
  poses.reserve(count);
  for (uint32_t i = first; i < first + count; ++i) {
    std::vector<Transform> locals = restLocals(model);
    for (uint32_t node = 0; node < locals.size(); ++node) {
      if (!is_joint[node]) continue;
      const uint32_t parent = model.nodes[node].parent;
      const bool root = parent == kNone || !is_joint[parent];
      JointNoise noise(i, node);
      const glm::dquat turn = randomRotation(noise, poseAmplitude(i) * (root ? kSampledRootShare : 1.0));
      locals[node].rotation = glm::normalize(locals[node].rotation) * turn;
    }
    poses.push_back(localPose(model, locals));
  }
  return poses;
}

}  // namespace lithe::bake
