// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "rig.h"

#include <algorithm>

namespace lithe::bake {
namespace {

glm::dvec3 worldPosition(const Model& model, uint32_t node) {
  glm::dvec3 position(0.0);
  for (; node != kNone; node = model.nodes[node].parent) position += model.nodes[node].rest.translation;
  return position;
}

std::vector<Influence> mergedByJoint(std::span<const Influence> influences) {
  std::vector<Influence> merged;
  for (const Influence& influence : influences) {
    const auto same = [&](const Influence& other) { return other.joint == influence.joint; };
    const auto found = std::find_if(merged.begin(), merged.end(), same);
    if (found != merged.end()) {
      found->weight += influence.weight;
    } else if (influence.weight > 0.0) {
      merged.push_back(influence);
    }
  }
  return merged;
}

}  // namespace

uint32_t addNode(Model& model, const std::string& name, uint32_t parent, const glm::dvec3& world) {
  Node node;
  node.name = name;
  node.parent = parent;
  node.rest.translation = parent == kNone ? world : world - worldPosition(model, parent);
  model.nodes.push_back(node);
  return static_cast<uint32_t>(model.nodes.size() - 1);
}

uint32_t addJoint(Model& model, const std::string& name, uint32_t parent_node, const glm::dvec3& world) {
  Joint joint;
  joint.node = addNode(model, name, parent_node, world);
  joint.inverse_bind[3] = glm::dvec4(-worldPosition(model, joint.node), 1.0);
  model.joints.push_back(joint);
  return static_cast<uint32_t>(model.joints.size() - 1);
}

glm::dvec3 jointPosition(const Model& model, uint32_t joint) {
  return -glm::dvec3(model.joints[joint].inverse_bind[3]);
}

Skin makeSkin(std::span<const Influence> influences, uint32_t cap) {
  constexpr double kNegligible = 1.0 / 512.0;  // below half a step of an 8 bit weight
  std::vector<Influence> kept = mergedByJoint(influences);
  std::sort(kept.begin(), kept.end(), [](const Influence& a, const Influence& b) {
    return a.weight != b.weight ? a.weight > b.weight : a.joint < b.joint;
  });
  double total = 0.0;
  for (const Influence& influence : kept) total += influence.weight;
  while (kept.size() > cap || (kept.size() > 1 && kept.back().weight < kNegligible * total)) kept.pop_back();

  total = 0.0;
  for (const Influence& influence : kept) total += influence.weight;
  Skin skin;
  for (const Influence& influence : kept) {
    skin.joint[skin.count] = static_cast<uint16_t>(influence.joint);
    skin.weight[skin.count++] = static_cast<float>(influence.weight / total);
  }
  return skin;
}

ClipBuilder::ClipBuilder(std::string name, uint32_t key_count, double interval) {
  for (uint32_t key = 0; key < key_count; ++key) times_.push_back(static_cast<float>(key * interval));
  clip_.name = std::move(name);
  clip_.end = times_.back();
}

Channel& ClipBuilder::addChannel(uint32_t node, Channel::Path path) {
  Channel& channel = clip_.channels.emplace_back();
  channel.node = node;
  channel.path = path;
  channel.times = times_;
  return channel;
}

void ClipBuilder::rotate(uint32_t node, const std::function<glm::dquat(uint32_t key)>& rotation) {
  Channel& channel = addChannel(node, Channel::Path::kRotation);
  glm::dquat previous(1.0, 0.0, 0.0, 0.0);
  for (uint32_t key = 0; key < keyCount(); ++key) {
    glm::dquat q = rotation(key);
    if (glm::dot(q, previous) < 0.0) q = -q;
    channel.values.emplace_back(q.x, q.y, q.z, q.w);
    previous = q;
  }
}

void ClipBuilder::translate(uint32_t node, const std::function<glm::dvec3(uint32_t key)>& translation) {
  Channel& channel = addChannel(node, Channel::Path::kTranslation);
  for (uint32_t key = 0; key < keyCount(); ++key) channel.values.emplace_back(glm::vec3(translation(key)), 0.0f);
}

}  // namespace lithe::bake
