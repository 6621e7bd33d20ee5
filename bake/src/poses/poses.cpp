// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/poses.h"

#include <algorithm>

#include "channel.h"
#include "palette.h"

namespace lithe::bake {

Pose localPose(const Model& model, std::span<const Transform> locals) {
  if (locals.size() != model.nodes.size()) {
    throw Error("a pose needs one transform for each of the " + std::to_string(model.nodes.size()) + " nodes, not " +
                std::to_string(locals.size()));
  }
  Pose pose;
  pose.palette = paletteOf(model, locals);
  return pose;
}

Pose restPose(const Model& model) { return localPose(model, restLocals(model)); }

Pose clipPose(const Model& model, uint32_t clip, double time) {
  if (clip >= model.clips.size()) {
    throw Error("there is no clip " + std::to_string(clip) + "; the character has " +
                std::to_string(model.clips.size()));
  }
  std::vector<Transform> locals = restLocals(model);
  for (const Channel& channel : model.clips[clip].channels) applyChannel(channel, time, locals[channel.node]);
  Pose pose = localPose(model, locals);
  pose.clip = model.clips[clip].name;
  pose.time = time;
  return pose;
}

std::vector<glm::dvec3> skinPositions(const Model& model, const Pose& pose) {
  std::vector<glm::dvec3> posed(model.positions.size());
  for (size_t v = 0; v < posed.size(); ++v) {
    const glm::dvec4 position(glm::dvec3(model.positions[v]), 1.0);
    const Skin& skin = model.skins[v];
    glm::dvec3 sum(0.0);
    for (uint32_t k = 0; k < skin.count; ++k) {
      sum += static_cast<double>(skin.weight[k]) * glm::dvec3(pose.palette[skin.joint[k]] * position);
    }
    posed[v] = sum;
  }
  return posed;
}

double posedDiagonal(const Model& model, const std::vector<Pose>& poses) {
  if (poses.empty() || model.positions.empty()) return 0.0;
  double sum = 0.0;
  for (const Pose& pose : poses) {
    const std::vector<glm::dvec3> posed = skinPositions(model, pose);
    glm::dvec3 low = posed.front(), high = posed.front();
    for (const glm::dvec3& p : posed) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    sum += glm::length(high - low);
  }
  return sum / static_cast<double>(poses.size());
}

}  // namespace lithe::bake
