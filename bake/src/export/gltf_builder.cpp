// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "gltf_builder.h"

#include <algorithm>
#include <bit>

namespace lithe::bake {

namespace {

static_assert(std::endian::native == std::endian::little,
              "glTF buffers are little-endian and are written as memory holds them");

constexpr uint32_t kUnsignedByte = 5121, kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126;

template <typename T>
std::span<const uint8_t> bytesOf(std::span<const T> values) {
  return {reinterpret_cast<const uint8_t*>(values.data()), values.size_bytes()};
}

/// The smallest (or largest) value of every component. Floats are stated exactly: as the doubles they equal.
template <typename Pick>
Json extremes(std::span<const float> values, uint32_t components, Pick pick) {
  std::vector<double> result(values.begin(), values.begin() + components);
  for (size_t i = components; i < values.size(); ++i) {
    double& extreme = result[i % components];
    extreme = pick(extreme, static_cast<double>(values[i]));
  }
  return result;
}

}  // namespace

uint32_t componentsOf(std::string_view type) {
  return type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 16;
}

GltfBuilder::GltfBuilder() { json["asset"] = {{"version", "2.0"}, {"generator", "lithe"}}; }

uint32_t GltfBuilder::append(const char* name, Json entry) {
  Json& array = json[name];
  array.push_back(std::move(entry));
  return static_cast<uint32_t>(array.size() - 1);
}

uint32_t GltfBuilder::addView(std::span<const uint8_t> bytes, ViewTarget target) {
  binary.resize((binary.size() + 3) / 4 * 4, 0);
  Json view = {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}};
  if (target != ViewTarget::kPlain) view["target"] = static_cast<uint16_t>(target);
  binary.insert(binary.end(), bytes.begin(), bytes.end());
  return append("bufferViews", std::move(view));
}

uint32_t GltfBuilder::addAccessor(std::span<const uint8_t> bytes, uint32_t component_type, std::string_view type,
                                  size_t count, ViewTarget target) {
  const uint32_t view = addView(bytes, target);
  return append("accessors",
                {{"bufferView", view}, {"componentType", component_type}, {"count", count}, {"type", type}});
}

uint32_t GltfBuilder::addFloats(std::span<const float> values, std::string_view type, ViewTarget target, bool bounds) {
  const uint32_t components = componentsOf(type);
  const uint32_t accessor = addAccessor(bytesOf(values), kFloat, type, values.size() / components, target);
  if (bounds) {
    json["accessors"][accessor]["min"] =
        extremes(values, components, [](double a, double b) { return std::min(a, b); });
    json["accessors"][accessor]["max"] =
        extremes(values, components, [](double a, double b) { return std::max(a, b); });
  }
  return accessor;
}

uint32_t GltfBuilder::addJoints(std::span<const uint16_t> values, uint32_t joint_count) {
  if (joint_count > 256)
    return addAccessor(bytesOf(values), kUnsignedShort, "VEC4", values.size() / 4, ViewTarget::kVertices);
  const std::vector<uint8_t> narrow(values.begin(), values.end());
  return addAccessor(narrow, kUnsignedByte, "VEC4", values.size() / 4, ViewTarget::kVertices);
}

uint32_t GltfBuilder::addIndices(std::span<const uint32_t> values, uint32_t vertex_count) {
  constexpr uint32_t kMost16 = 65535;  // index 65535 itself restarts primitives
  if (vertex_count > kMost16)
    return addAccessor(bytesOf(values), kUnsignedInt, "SCALAR", values.size(), ViewTarget::kIndices);
  const std::vector<uint16_t> narrow(values.begin(), values.end());
  return addAccessor(bytesOf(std::span<const uint16_t>(narrow)), kUnsignedShort, "SCALAR", values.size(),
                     ViewTarget::kIndices);
}

void GltfBuilder::closeBuffer(const std::string& uri) {
  Json buffer = {{"byteLength", binary.size()}};
  if (!uri.empty()) buffer["uri"] = uri;
  append("buffers", std::move(buffer));
}

}  // namespace lithe::bake
