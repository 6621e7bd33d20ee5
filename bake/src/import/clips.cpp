// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "clips.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "accessor.h"

namespace lithe::bake {

namespace {

/// Empty for morph weights and whatever extensions add.
std::optional<Channel::Path> pathOf(const std::string& name) {
  if (name == "translation") return Channel::Path::kTranslation;
  if (name == "rotation") return Channel::Path::kRotation;
  if (name == "scale") return Channel::Path::kScale;
  return std::nullopt;
}

class ClipReader {
 public:
  ClipReader(const GltfFile& file, const std::vector<uint32_t>& node_index) : file_(file), node_index_(node_index) {}

  Clip read(size_t animation);
  uint64_t keysOutOfOrder() const { return keys_out_of_order_; }

 private:
  struct Source {
    const tinygltf::AnimationSampler* sampler;
    std::string place;
    AccessorView times;
  };

  Source openSource(size_t animation, size_t channel) const;
  Channel::Interpolation interpolationOf(const Source& source) const;
  Channel readChannel(const Source& source, Channel::Path path);
  void addKey(const AccessorView& values, uint64_t first, uint64_t count, const Source& source, Channel& channel) const;
  double timeAt(const Source& source, uint64_t key) const;

  const GltfFile& file_;
  const std::vector<uint32_t>& node_index_;
  uint64_t keys_ = 0, keys_out_of_order_ = 0;
};

ClipReader::Source ClipReader::openSource(size_t animation, size_t channel) const {
  const tinygltf::Animation& stated = file_.document.animations[animation];
  const int sampler = stated.channels[channel].sampler;
  Source source;
  source.place = "animation " + std::to_string(animation) + (stated.name.empty() ? "" : " '" + stated.name + "'") +
                 ", channel " + std::to_string(channel);
  if (sampler < 0 || static_cast<size_t>(sampler) >= stated.samplers.size()) {
    file_.name.fail(source.place, "there is no sampler " + std::to_string(sampler) + "; re-export the file");
  }
  source.sampler = &stated.samplers[static_cast<size_t>(sampler)];
  source.times = AccessorView::open(file_, source.sampler->input, {TINYGLTF_TYPE_SCALAR}, source.place + ", times");
  return source;
}

double ClipReader::timeAt(const Source& source, uint64_t key) const {
  const double time = source.times.number(key, 0);
  if (!std::isfinite(time)) file_.name.fail(source.place, "a key's time is not a number; re-export the file");
  return time;
}

Channel::Interpolation ClipReader::interpolationOf(const Source& source) const {
  const std::string& name = source.sampler->interpolation;
  if (name == "STEP") return Channel::Interpolation::kStep;
  if (name == "CUBICSPLINE") return Channel::Interpolation::kCubicSpline;
  if (name != "LINEAR" && !name.empty()) {
    file_.name.fail(source.place, "its interpolation '" + name + "' is not glTF's; re-export the file");
  }
  return Channel::Interpolation::kLinear;
}

void ClipReader::addKey(const AccessorView& values, uint64_t first, uint64_t count, const Source& source,
                        Channel& channel) const {
  for (uint64_t i = first; i < first + count; ++i) {
    glm::vec4 value(0.0f);
    for (uint32_t k = 0; k < values.components(); ++k) {
      value[static_cast<int>(k)] = static_cast<float>(values.number(i, k));
      if (!std::isfinite(value[static_cast<int>(k)])) {
        file_.name.fail(source.place, "value " + std::to_string(i) + " is not a number; re-export the file");
      }
    }
    channel.values.push_back(value);
  }
}

Channel ClipReader::readChannel(const Source& source, Channel::Path path) {
  Channel channel;
  channel.path = path;
  channel.interpolation = interpolationOf(source);
  const int type = path == Channel::Path::kRotation ? TINYGLTF_TYPE_VEC4 : TINYGLTF_TYPE_VEC3;
  const AccessorView values = AccessorView::open(file_, source.sampler->output, {type}, source.place + ", values");
  const uint64_t keys = source.times.count();
  const uint64_t per_key = channel.interpolation == Channel::Interpolation::kCubicSpline ? 3 : 1;
  if (values.count() != keys * per_key) {
    file_.name.fail(source.place, "it has " + std::to_string(values.count()) + " values for " + std::to_string(keys) +
                                      " keys; re-export the file");
  }
  keys_ += keys * per_key;
  if (keys_ > file_.elementLimit()) {
    file_.name.fail(source.place, "channels share samplers so often that too many keys result; remove some animations");
  }
  for (uint64_t i = 0; i < keys; ++i) {
    const float time = static_cast<float>(timeAt(source, i));
    if (!channel.times.empty() && time <= channel.times.back()) {
      ++keys_out_of_order_;
      continue;
    }
    channel.times.push_back(time);
    addKey(values, i * per_key, per_key, source, channel);
  }
  return channel;
}

Clip ClipReader::read(size_t animation) {
  const tinygltf::Animation& stated = file_.document.animations[animation];
  Clip clip;
  clip.name = stated.name.empty() ? "anim" + std::to_string(animation) : stated.name;
  bool any_key = false;
  for (size_t i = 0; i < stated.channels.size(); ++i) {
    const int node = stated.channels[i].target_node;
    if (node < 0) continue;
    const Source source = openSource(animation, i);
    if (static_cast<size_t>(node) >= node_index_.size()) {
      file_.name.fail(source.place, "there is no node " + std::to_string(node) + "; re-export the file");
    }
    if (source.times.count() == 0) continue;
    const double first = timeAt(source, 0), last = timeAt(source, source.times.count() - 1);
    clip.begin = any_key ? std::min(clip.begin, first) : first;
    clip.end = any_key ? std::max(clip.end, last) : last;
    any_key = true;
    const std::optional<Channel::Path> path = pathOf(stated.channels[i].target_path);
    if (!path || node_index_[static_cast<size_t>(node)] == kNone) continue;
    clip.channels.push_back(readChannel(source, *path));
    clip.channels.back().node = node_index_[static_cast<size_t>(node)];
  }
  return clip;
}

}  // namespace

std::vector<Clip> readClips(const GltfFile& file, const std::vector<uint32_t>& node_index,
                            std::vector<std::string>& warnings) {
  std::vector<Clip> clips;
  ClipReader reader(file, node_index);
  for (size_t i = 0; i < file.document.animations.size(); ++i) clips.push_back(reader.read(i));
  if (reader.keysOutOfOrder() > 0) {
    warnings.push_back(std::to_string(reader.keysOutOfOrder()) +
                       " animation keys are not later than the one before; they are dropped");
  }
  return clips;
}

}  // namespace lithe::bake
