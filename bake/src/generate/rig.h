// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Building blocks of a generated skeleton: nodes that rest unrotated, skins, and rotation clips.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <span>
#include <string>
#include <vector>

#include "lithe/bake/model.h"

namespace lithe::bake {

struct Influence {
  uint32_t joint = 0;
  double weight = 0.0;
};

/// Appends a node that is not a joint; `world` is its rest position. Every rest rotation is the identity. Returns its
/// index.
uint32_t addNode(Model& model, const std::string& name, uint32_t parent, const glm::dvec3& world);

/// Appends a node and the joint that binds it at rest. Returns the joint's index.
uint32_t addJoint(Model& model, const std::string& name, uint32_t parent_node, const glm::dvec3& world);

/// The rest position of a joint in bind space.
glm::dvec3 jointPosition(const Model& model, uint32_t joint);

/// The largest `cap` (at most 8) of the influences, as Skin wants them: joints named twice are added up, weights sum
/// to 1.
Skin makeSkin(std::span<const Influence> influences, uint32_t cap);

/// A clip whose channels are sampled at `key_count` keys, `interval` seconds apart, starting at 0.
class ClipBuilder {
 public:
  ClipBuilder(std::string name, uint32_t key_count, double interval);

  uint32_t keyCount() const { return static_cast<uint32_t>(times_.size()); }
  /// key / (keyCount() - 1): 0 at the first key, 1 at the last.
  double phase(uint32_t key) const { return key / (keyCount() - 1.0); }

  /// Linear channels; consecutive quaternions are kept in one half-space so that blending takes the short way.
  void rotate(uint32_t node, const std::function<glm::dquat(uint32_t key)>& rotation);
  void translate(uint32_t node, const std::function<glm::dvec3(uint32_t key)>& translation);

  Clip take() { return std::move(clip_); }

 private:
  Channel& addChannel(uint32_t node, Channel::Path path);

  Clip clip_;
  std::vector<float> times_;
};

}  // namespace lithe::bake
