// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "clip_writer.h"

#include <map>
#include <utility>

namespace lithe::bake {

namespace {

const char* pathName(Channel::Path path) {
  switch (path) {
    case Channel::Path::kTranslation:
      return "translation";
    case Channel::Path::kRotation:
      return "rotation";
    case Channel::Path::kScale:
      break;
  }
  return "scale";
}

const char* interpolationName(Channel::Interpolation interpolation) {
  switch (interpolation) {
    case Channel::Interpolation::kStep:
      return "STEP";
    case Channel::Interpolation::kCubicSpline:
      return "CUBICSPLINE";
    case Channel::Interpolation::kLinear:
      break;
  }
  return "LINEAR";
}

std::vector<float> outputsOf(const Channel& channel) {
  const bool rotation = channel.path == Channel::Path::kRotation;
  const bool unit = rotation && channel.interpolation != Channel::Interpolation::kCubicSpline;
  std::vector<float> outputs;
  for (const glm::vec4& value : channel.values) {
    const glm::dvec4 exact(value);
    const double length = glm::length(exact);
    const glm::dvec4 written = unit && length > 0.0 ? exact / length : exact;
    for (int i = 0; i < (rotation ? 4 : 3); ++i) outputs.push_back(static_cast<float>(written[i]));
  }
  return outputs;
}

/// Accessors of key times by their content: the channels of a clip mostly share them.
using TimeAccessors = std::map<std::vector<float>, uint32_t>;

uint32_t timesAccessor(const Channel& channel, TimeAccessors& known, GltfBuilder& gltf) {
  const auto found = known.find(channel.times);
  if (found != known.end()) return found->second;
  const uint32_t accessor = gltf.addFloats(channel.times, "SCALAR", ViewTarget::kPlain, true);
  known.emplace(channel.times, accessor);
  return accessor;
}

Json samplerOf(const Channel& channel, TimeAccessors& known, GltfBuilder& gltf) {
  const uint32_t input = timesAccessor(channel, known, gltf);
  const char* type = channel.path == Channel::Path::kRotation ? "VEC4" : "VEC3";
  const uint32_t output = gltf.addFloats(outputsOf(channel), type, ViewTarget::kPlain);
  return {{"input", input}, {"interpolation", interpolationName(channel.interpolation)}, {"output", output}};
}

/// A node's property may be animated once per clip in glTF; the last channel is the one that counts in a Model.
std::vector<const Channel*> effectiveChannels(const Clip& clip) {
  std::map<std::pair<uint32_t, Channel::Path>, const Channel*> last;
  for (const Channel& channel : clip.channels) {
    if (!channel.times.empty()) last[{channel.node, channel.path}] = &channel;
  }
  std::vector<const Channel*> channels;
  for (const Channel& channel : clip.channels) {
    const auto found = last.find({channel.node, channel.path});
    if (found != last.end() && found->second == &channel) channels.push_back(&channel);
  }
  return channels;
}

/// The only node of that name, or kNone.
std::map<std::string, uint32_t> uniqueNames(const std::vector<Node>& nodes) {
  std::map<std::string, uint32_t> names;
  for (uint32_t i = 0; i < nodes.size(); ++i) {
    const auto [entry, is_new] = names.emplace(nodes[i].name, i);
    if (!is_new) entry->second = kNone;
  }
  return names;
}

}  // namespace

void writeClips(const std::vector<Clip>& clips, GltfBuilder& gltf) {
  TimeAccessors times;
  for (const Clip& clip : clips) {
    Json channels = Json::array(), samplers = Json::array();
    for (const Channel* channel : effectiveChannels(clip)) {
      channels.push_back(
          {{"sampler", samplers.size()}, {"target", {{"node", channel->node}, {"path", pathName(channel->path)}}}});
      samplers.push_back(samplerOf(*channel, times, gltf));
    }
    if (channels.empty()) continue;
    Json animation = Json::object();
    if (!clip.name.empty()) animation["name"] = clip.name;
    animation["channels"] = std::move(channels);
    animation["samplers"] = std::move(samplers);
    gltf.append("animations", std::move(animation));
  }
}

std::vector<Clip> retargetedClips(const Model& source, const Model& target) {
  const std::map<std::string, uint32_t> names = uniqueNames(target.nodes);
  const auto targetOf = [&](uint32_t node) {
    const std::string& name = source.nodes[node].name;
    const auto found = names.find(name);
    if (found != names.end() && found->second != kNone && !name.empty()) return found->second;
    const bool same_place = node < target.nodes.size() &&
                            (target.nodes[node].name == name || target.nodes[node].name.empty() || name.empty());
    return same_place ? node : kNone;
  };
  std::vector<Clip> clips;
  for (const Clip& clip : source.clips) {
    Clip moved{clip.name, clip.begin, clip.end, {}};
    for (const Channel& channel : clip.channels) {
      if (targetOf(channel.node) == kNone) continue;
      moved.channels.push_back(channel);
      moved.channels.back().node = targetOf(channel.node);
    }
    clips.push_back(std::move(moved));
  }
  return clips;
}

}  // namespace lithe::bake
