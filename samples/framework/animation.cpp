// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "animation.h"

#include <algorithm>
#include <glm/gtc/quaternion.hpp>

namespace sample {
namespace {

struct Local {
  glm::vec3 translation, scale;
  glm::quat rotation;
};

Local restOf(const lithe_node& node) {
  return {{node.translation[0], node.translation[1], node.translation[2]},
          {node.scale[0], node.scale[1], node.scale[2]},
          glm::quat(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2])};
}

glm::quat quaternion(const glm::vec4& value) { return glm::normalize(glm::quat(value.w, value.x, value.y, value.z)); }

/// The keys around a time and how far it lies between them.
struct Between {
  size_t before, after;
  float fraction;
};

Between keysAround(const std::vector<float>& times, float seconds) {
  const size_t after = std::upper_bound(times.begin(), times.end(), seconds) - times.begin();
  if (after == 0) return {0, 0, 0};
  if (after == times.size()) return {after - 1, after - 1, 0};
  return {after - 1, after, (seconds - times[after - 1]) / (times[after] - times[after - 1])};
}

void applyChannel(const Channel& channel, float seconds, Local& local) {
  Between keys = keysAround(channel.times, seconds);
  if (channel.step) keys.fraction = 0;
  const glm::vec4 &a = channel.values[keys.before], &b = channel.values[keys.after];
  const glm::vec4 mixed = glm::mix(a, b, keys.fraction);
  switch (channel.path) {
    case Channel::Path::kTranslation:
      local.translation = mixed;
      break;
    case Channel::Path::kScale:
      local.scale = mixed;
      break;
    case Channel::Path::kRotation:
      local.rotation = glm::slerp(quaternion(a), quaternion(b), keys.fraction);
      break;
  }
}

glm::mat4 matrixOf(const Local& local) {
  glm::mat4 matrix = glm::mat4_cast(local.rotation);
  for (int axis = 0; axis < 3; ++axis) matrix[axis] *= local.scale[axis];
  matrix[3] = glm::vec4(local.translation, 1);
  return matrix;
}

std::vector<glm::mat4> poseWorld(const Character& character, const Clip* clip, float seconds) {
  std::vector<Local> locals(character.nodes.size());
  std::transform(character.nodes.begin(), character.nodes.end(), locals.begin(), restOf);
  if (clip) {
    for (const Channel& channel : clip->channels) applyChannel(channel, seconds, locals[channel.node]);
  }
  std::vector<glm::mat4> world(locals.size());
  for (size_t i = 0; i < world.size(); ++i) {
    const uint32_t parent = character.nodes[i].parent;
    world[i] = parent == LITHE_NO_INDEX ? matrixOf(locals[i]) : world[parent] * matrixOf(locals[i]);
  }
  return world;
}

glm::mat4 fromRows(const float* rows) {
  glm::mat4 matrix(1);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) matrix[column][row] = rows[4 * row + column];
  }
  return matrix;
}

}  // namespace

void posePalette(const Character& character, const Clip* clip, float seconds, float* palette) {
  const std::vector<glm::mat4> world = poseWorld(character, clip, seconds);
  for (const lithe_joint& joint : character.joints) {
    const glm::mat4 matrix = world[joint.node] * fromRows(joint.inverse_bind);
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) *palette++ = matrix[column][row];
    }
  }
}

}  // namespace sample
