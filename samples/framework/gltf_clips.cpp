// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The only file that knows the glTF reader.
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include <tiny_gltf.h>

#include <cstring>
#include <map>
#include <optional>

#include "animation.h"
#include "error.h"

namespace sample {
namespace {

using NodeMap = std::vector<uint32_t>;  ///< glTF node -> character's node, LITHE_NO_INDEX where it has none

/// Pictures are not looked at.
bool skipImage(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
  return true;
}

tinygltf::Model readModel(const std::filesystem::path& path) {
  tinygltf::TinyGLTF reader;
  reader.SetImageLoader(skipImage, nullptr);
  tinygltf::Model model;
  std::string errors, warnings;
  const bool binary = path.extension() == ".glb";
  const bool done = binary ? reader.LoadBinaryFromFile(&model, &errors, &warnings, path.string())
                           : reader.LoadASCIIFromFile(&model, &errors, &warnings, path.string());
  if (!done) throw Error(path.string() + ": " + (errors.empty() ? "cannot be read" : errors));
  return model;
}

/// "hips/spine/neck": the names from the root down tell apart what single names may not.
std::vector<std::string> characterPaths(const Character& character) {
  std::vector<std::string> paths(character.nodes.size());
  for (size_t i = 0; i < paths.size(); ++i) {
    const lithe_node& node = character.nodes[i];
    paths[i] = (node.parent == LITHE_NO_INDEX ? "" : paths[node.parent] + "/") + node.name;
  }
  return paths;
}

void walkPaths(const tinygltf::Model& model, int node, const std::string& above, std::vector<std::string>& paths) {
  paths[node] = above + model.nodes[node].name;
  for (const int child : model.nodes[node].children) walkPaths(model, child, paths[node] + "/", paths);
}

std::vector<std::string> gltfPaths(const tinygltf::Model& model) {
  std::vector<bool> is_child(model.nodes.size(), false);
  for (const tinygltf::Node& node : model.nodes) {
    for (const int child : node.children) is_child[child] = true;
  }
  std::vector<std::string> paths(model.nodes.size());
  for (size_t i = 0; i < paths.size(); ++i) {
    if (!is_child[i]) walkPaths(model, static_cast<int>(i), "", paths);
  }
  return paths;
}

NodeMap matchNodes(const Character& character, const tinygltf::Model& model) {
  std::map<std::string, uint32_t> by_path;
  const std::vector<std::string> own = characterPaths(character);
  for (uint32_t i = 0; i < own.size(); ++i) by_path.emplace(own[i], i);
  NodeMap map;
  for (const std::string& path : gltfPaths(model)) {
    const auto found = by_path.find(path);
    map.push_back(found == by_path.end() ? LITHE_NO_INDEX : found->second);
  }
  return map;
}

float component(const uint8_t* at, int type) {
  const auto read = [at](auto value) {
    std::memcpy(&value, at, sizeof value);
    return static_cast<float>(value);
  };
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return read(float{});
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return std::max(read(int8_t{}) / 127.0f, -1.0f);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return read(uint8_t{}) / 255.0f;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return std::max(read(int16_t{}) / 32767.0f, -1.0f);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return read(uint16_t{}) / 65535.0f;
    default:
      throw Error("an animation has a component type that glTF does not allow");
  }
}

/// Every element of an accessor, its missing components 0.
std::vector<glm::vec4> readAccessor(const tinygltf::Model& model, int index) {
  const tinygltf::Accessor& accessor = model.accessors.at(index);
  const int components = tinygltf::GetNumComponentsInType(accessor.type);
  const int size = tinygltf::GetComponentSizeInBytes(accessor.componentType);
  std::vector<glm::vec4> values(accessor.count, glm::vec4(0));
  if (accessor.bufferView < 0 || components < 1 || components > 4) return values;
  const tinygltf::BufferView& view = model.bufferViews.at(accessor.bufferView);
  const std::vector<uint8_t>& bytes = model.buffers.at(view.buffer).data;
  const size_t stride = accessor.ByteStride(view), begin = view.byteOffset + accessor.byteOffset;
  if (accessor.count > 0 && begin + (accessor.count - 1) * stride + components * size > bytes.size()) {
    throw Error("an animation reaches beyond its buffer");
  }
  for (size_t i = 0; i < values.size(); ++i) {
    for (int c = 0; c < components; ++c) {
      values[i][c] = component(&bytes[begin + i * stride + c * size], accessor.componentType);
    }
  }
  return values;
}

std::optional<Channel::Path> channelPath(const std::string& name) {
  if (name == "translation") return Channel::Path::kTranslation;
  if (name == "rotation") return Channel::Path::kRotation;
  if (name == "scale") return Channel::Path::kScale;
  return std::nullopt;
}

/// Cubic splines store (in-tangent, value, out-tangent) per key.
std::vector<glm::vec4> splineValues(const std::vector<glm::vec4>& triples) {
  std::vector<glm::vec4> values;
  for (size_t i = 1; i < triples.size(); i += 3) values.push_back(triples[i]);
  return values;
}

std::optional<Channel> readChannel(const tinygltf::Model& model, const tinygltf::Animation& animation,
                                   const tinygltf::AnimationChannel& source, const NodeMap& nodes) {
  const std::optional<Channel::Path> path = channelPath(source.target_path);
  if (!path || source.target_node < 0 || nodes.at(source.target_node) == LITHE_NO_INDEX) return std::nullopt;
  const tinygltf::AnimationSampler& sampler = animation.samplers.at(source.sampler);
  Channel channel{nodes[source.target_node], *path, sampler.interpolation == "STEP", {}, {}};
  for (const glm::vec4& time : readAccessor(model, sampler.input)) channel.times.push_back(time.x);
  channel.values = readAccessor(model, sampler.output);
  if (sampler.interpolation == "CUBICSPLINE") channel.values = splineValues(channel.values);
  if (channel.times.empty() || channel.values.size() != channel.times.size()) return std::nullopt;
  return channel;
}

Clip readClip(const tinygltf::Model& model, const tinygltf::Animation& animation, const NodeMap& nodes) {
  Clip clip{animation.name, 0, 0, {}};
  for (const tinygltf::AnimationChannel& source : animation.channels) {
    std::optional<Channel> channel = readChannel(model, animation, source, nodes);
    if (!channel) continue;
    const bool first = clip.channels.empty();
    clip.begin = first ? channel->times.front() : std::min(clip.begin, channel->times.front());
    clip.end = first ? channel->times.back() : std::max(clip.end, channel->times.back());
    clip.channels.push_back(std::move(*channel));
  }
  return clip;
}

}  // namespace

std::vector<Clip> readClips(const Character& character, const std::filesystem::path& gltf) {
  const tinygltf::Model model = readModel(gltf);
  const NodeMap nodes = matchNodes(character, model);
  std::vector<Clip> clips;
  for (const tinygltf::Animation& animation : model.animations) {
    Clip clip = readClip(model, animation, nodes);
    if (!clip.channels.empty()) clips.push_back(std::move(clip));
  }
  return clips;
}

}  // namespace sample
