// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "weight_step.h"

#include <algorithm>

#include "lithe/bake/skin_weights.h"

namespace lithe::bake {

namespace {

SimplexWeights weightsOf(const QuantizedSkin& skin, const JointSet& joints, uint32_t weight_one) {
  SimplexWeights weights{};
  for (uint32_t i = 0; i < joints.size; ++i) {
    for (uint32_t k = 0; k < skin.count; ++k) {
      if (skin.joint[k] == joints.joint[i]) weights[i] = skin.weight[k] / double(weight_one);
    }
  }
  return weights;
}

/// Where each joint alone would put the position, joint-major.
void poseByEach(const PosedMesh& posed, const JointSet& joints, const glm::ivec3& position,
                std::vector<PosedPoint>& candidates) {
  candidates.resize(std::max(candidates.size(), size_t{joints.size} * posed.blocks));
  for (uint32_t i = 0; i < joints.size; ++i) {
    const Affine* matrices = posed.palette.data() + size_t{joints.joint[i]} * posed.blocks;
    transformPoint(matrices, posed.blocks, glm::vec3(position), candidates.data() + size_t{i} * posed.blocks);
  }
}

WeightObjective objectiveOf(const Quadric* quadric, const PosedPoint* origin, const PosedPoint* candidates,
                            uint32_t size, uint32_t blocks) {
  std::array<double, size_t{kMaxSimplexSize} * kMaxSimplexSize> matrix;
  WeightObjective objective;
  objective.size = size;
  weightTerms(quadric, origin, candidates, size, blocks, matrix.data(), objective.h.data());
  for (uint32_t i = 0; i < size; ++i) {
    for (uint32_t k = 0; k < size; ++k) objective.H[i][k] = matrix[i * size + k];
  }
  return objective;
}

}  // namespace

JointSet unionOf(const QuantizedSkin& a, const QuantizedSkin& b) {
  JointSet joints = jointsOf(a);
  for (uint32_t k = 0; k < b.count; ++k) {
    const auto end = joints.joint.begin() + joints.size;
    if (std::find(joints.joint.begin(), end, b.joint[k]) == end) joints.joint[joints.size++] = b.joint[k];
  }
  return joints;
}

QuantizedSkin weightStep(const NodeState& nodes, const Quadric* quadric, const PosedPoint* origin,
                         const JointSet& joints, const QuantizedSkin& start, const glm::ivec3& position,
                         std::vector<PosedPoint>& candidates) {
  poseByEach(nodes.posed, joints, position, candidates);
  const WeightObjective objective = objectiveOf(quadric, origin, candidates.data(), joints.size, nodes.posed.blocks);
  const SimplexWeights weights = minimizeOnSimplexCapped(objective, weightsOf(start, joints, nodes.weight_one),
                                                         naturalProximity(objective), nodes.max_influences);
  return quantizeSkin(joints.span(), {weights.data(), joints.size}, nodes.weight_one);
}

}  // namespace lithe::bake
