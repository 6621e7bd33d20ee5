// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Skin weights: every joint moves some capsules of flesh; a vertex follows the nearest and, where they are almost as
/// near, that joint's parent and children. Averaging over the mesh then rounds off what the capsules leave.
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "figure.h"
#include "mesh_relax.h"
#include "rig.h"

namespace lithe::bake::figure {
namespace {

using glm::dvec3;

/// A piece of flesh that follows a joint. Two pieces that meet share a vertex as long as its distances to them differ
/// by less than the mean of their softnesses.
struct Capsule {
  uint32_t joint;
  dvec3 a, b;
  double radius, softness;
};

double distanceTo(const Capsule& capsule, const dvec3& point) {
  const dvec3 axis = capsule.b - capsule.a, from = point - capsule.a;
  const double length2 = glm::dot(axis, axis);
  const double t = length2 > 0.0 ? glm::clamp(glm::dot(from, axis) / length2, 0.0, 1.0) : 0.0;
  const dvec3 off = from - t * axis;
  return std::sqrt(glm::dot(off, off)) - capsule.radius;
}

/// Ends are placed so that neighbours along the spine meet at the pivot between them.
std::vector<Capsule> middleCapsules() {
  return {{kHips, {-0.08, 0.985, -0.010}, {0.08, 0.985, -0.010}, 0.105, 0.035},
          {kWaist, {-0.03, 1.103, -0.005}, {0.03, 1.107, -0.005}, 0.105, 0.035},
          {kBelly, {-0.03, 1.195, -0.010}, {0.03, 1.225, -0.010}, 0.110, 0.035},
          {kChest, {-0.05, 1.315, -0.020}, {0.05, 1.315, -0.020}, 0.110, 0.035},
          {kChest, {0.00, 1.315, -0.020}, {0.00, 1.425, -0.030}, 0.070, 0.035},
          {kNeck, {0.00, 1.500, -0.038}, {0.00, 1.530, -0.034}, 0.055, 0.025},
          {kHead, {0.00, 1.600, -0.020}, {0.00, 1.680, -0.010}, 0.085, 0.025},
          {kHead, {-0.02, 1.580, 0.020}, {0.02, 1.550, 0.060}, 0.045, 0.025}};
}

void addArmCapsules(std::vector<Capsule>& capsules, const Anatomy& a) {
  const auto between = [](const dvec3& from, const dvec3& to, double t) { return glm::mix(from, to, t); };
  capsules.push_back({kClavicle, {0.075, 1.415, -0.022}, {0.145, 1.410, -0.022}, 0.055, 0.030});
  capsules.push_back({kUpperArm, between(a.shoulder, a.elbow, 0.10), between(a.shoulder, a.elbow, 0.93), 0.045, 0.024});
  capsules.push_back({kForearm, between(a.elbow, a.wrist, 0.08), between(a.elbow, a.wrist, 0.93), 0.035, 0.018});
  for (uint32_t f = 0; f < 5; ++f) {
    const Finger& finger = a.fingers[f];
    const dvec3 wrist = a.wrist + 0.018 * a.along;
    if (f > 0) capsules.push_back({kHand, wrist, between(wrist, finger.points[0], 0.88), 0.015, 0.010});
    for (uint32_t bone = 0; bone < 3; ++bone) {
      const double last = bone == 2 ? 1.0 : 0.84;
      capsules.push_back({kFingers + 3 * f + bone, between(finger.points[bone], finger.points[bone + 1], 0.18),
                          between(finger.points[bone], finger.points[bone + 1], last), finger.radii[bone],
                          bone == 0 ? 0.007 : 0.004});
    }
  }
}

void addLegCapsules(std::vector<Capsule>& capsules, const Anatomy& a) {
  capsules.push_back({kThigh, {0.092, 0.845, -0.004}, glm::mix(a.hip, a.knee, 0.94), 0.075, 0.040});
  capsules.push_back({kShin, glm::mix(a.knee, a.ankle, 0.06), glm::mix(a.knee, a.ankle, 0.93), 0.045, 0.024});
  capsules.push_back({kFoot, a.ankle - dvec3(0, 0.030, -0.005), a.toes + dvec3(-0.004, 0.010, -0.022), 0.034, 0.016});
  capsules.push_back({kFoot, {0.104, 0.036, -0.040}, {0.104, 0.032, -0.055}, 0.034, 0.016});
  capsules.push_back({kToes, {0.096, 0.020, 0.118}, {0.090, 0.016, 0.165}, 0.018, 0.012});
  capsules.push_back({kToes, {0.138, 0.020, 0.112}, {0.150, 0.014, 0.150}, 0.018, 0.012});
}

std::vector<Capsule> allCapsules() {
  std::vector<Capsule> left;
  addArmCapsules(left, anatomy());
  addLegCapsules(left, anatomy());
  std::vector<Capsule> all = middleCapsules();
  for (const Side side : {kLeft, kRight}) {
    for (Capsule capsule : left) {
      capsule.joint = jointOf(side, capsule.joint);
      if (side == kRight) capsule.a = mirror(capsule.a), capsule.b = mirror(capsule.b);
      all.push_back(capsule);
    }
  }
  return all;
}

/// Parent joint of every joint, kNone for the hips.
std::vector<uint32_t> parentJoints(const Model& model) {
  std::vector<uint32_t> joint_of_node(model.nodes.size(), kNone), parents;
  for (uint32_t j = 0; j < model.joints.size(); ++j) joint_of_node[model.joints[j].node] = j;
  for (const Joint& joint : model.joints) {
    const uint32_t parent = model.nodes[joint.node].parent;
    parents.push_back(parent == kNone ? kNone : joint_of_node[parent]);
  }
  return parents;
}

using Row = std::vector<Influence>;

class Binder {
 public:
  Binder(const Model& model, const ClosedMesh& mesh)
      : mesh_(mesh), capsules_(allCapsules()), parents_(parentJoints(model)) {}

  Binding run(uint32_t rounds) {
    std::vector<Row> rows;
    for (const dvec3& point : mesh_.positions) rows.push_back(capsuleWeights(point));
    const Neighbours neighbours = neighboursOf(static_cast<uint32_t>(rows.size()), mesh_.triangles);
    for (uint32_t round = 0; round < rounds; ++round) rows = averaged(rows, neighbours);
    for (const Row& row : rows) binding_.skins.push_back(makeSkin(row, 4));
    return std::move(binding_);
  }

 private:
  Row capsuleWeights(const dvec3& point) {
    struct Reach {
      double distance = std::numeric_limits<double>::max(), softness = 0.0;
    };
    std::vector<Reach> reach(parents_.size());
    uint32_t nearest = 0;
    for (const Capsule& capsule : capsules_) {
      const double distance = distanceTo(capsule, point);
      if (distance < reach[capsule.joint].distance) reach[capsule.joint] = {distance, capsule.softness};
      if (distance < reach[nearest].distance) nearest = capsule.joint;
    }
    binding_.nearest_joint.push_back(nearest);

    Row row = {{nearest, 1.0}};
    for (uint32_t joint = 0; joint < parents_.size(); ++joint) {
      if (!share(nearest, joint)) continue;
      const double softness = 0.5 * (reach[joint].softness + reach[nearest].softness);
      const double nearness = 1.0 - (reach[joint].distance - reach[nearest].distance) / softness;
      if (nearness > 0.0) row.push_back({joint, nearness * nearness});
    }
    return row;
  }

  /// Parent and child; and chest and upper arm, which meet in the armpit.
  bool share(uint32_t a, uint32_t b) const {
    if (parents_[a] == b || parents_[b] == a) return true;
    const auto isUpperArm = [](uint32_t j) {
      return j == jointOf(kLeft, kUpperArm) || j == jointOf(kRight, kUpperArm);
    };
    return (a == kChest && isUpperArm(b)) || (b == kChest && isUpperArm(a));
  }

  /// Half of the vertex itself and half of its neighbours.
  static std::vector<Row> averaged(const std::vector<Row>& rows, const Neighbours& neighbours) {
    constexpr double kNegligible = 1e-4;
    std::vector<Row> result(rows.size());
    std::vector<double> sum(kJointCount, 0.0);
    for (uint32_t v = 0; v < rows.size(); ++v) {
      std::fill(sum.begin(), sum.end(), 0.0);
      addNormalised(rows[v], 0.5, sum);
      const uint32_t begin = neighbours.first[v], end = neighbours.first[v + 1];
      for (uint32_t i = begin; i < end; ++i) addNormalised(rows[neighbours.list[i]], 0.5 / (end - begin), sum);
      for (uint32_t joint = 0; joint < kJointCount; ++joint) {
        if (sum[joint] > kNegligible) result[v].push_back({joint, sum[joint]});
      }
    }
    return result;
  }

  static void addNormalised(const Row& row, double share, std::vector<double>& sum) {
    double total = 0.0;
    for (const Influence& influence : row) total += influence.weight;
    for (const Influence& influence : row) sum[influence.joint] += share * influence.weight / total;
  }

  const ClosedMesh& mesh_;
  const std::vector<Capsule> capsules_;
  const std::vector<uint32_t> parents_;
  Binding binding_;
};

}  // namespace

Binding bindToSkeleton(const Model& model, const ClosedMesh& mesh) {
  constexpr uint32_t kRounds = 18;
  return Binder(model, mesh).run(kRounds);
}

}  // namespace lithe::bake::figure
