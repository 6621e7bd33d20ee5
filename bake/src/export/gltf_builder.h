// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// A glTF document that grows: its JSON, and the bytes of its one buffer.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lithe::bake {

using Json = nlohmann::ordered_json;

enum class ViewTarget : uint16_t { kPlain = 0, kVertices = 34962, kIndices = 34963 };

struct GltfBuilder {
  Json json;
  std::vector<uint8_t> binary;

  GltfBuilder();

  /// Appends to the top-level array `name`, which appears with its first entry. Returns the entry's index.
  uint32_t append(const char* name, Json entry);

  /// Each returns the index of what it made. Views start at multiples of 4 bytes.
  uint32_t addView(std::span<const uint8_t> bytes, ViewTarget target);
  /// @param type    SCALAR, VEC2, VEC3, VEC4 or MAT4
  /// @param bounds  state the smallest and largest value per component
  uint32_t addFloats(std::span<const float> values, std::string_view type, ViewTarget target, bool bounds = false);
  /// VEC4 of joint indices, as bytes where `joint_count` allows.
  uint32_t addJoints(std::span<const uint16_t> values, uint32_t joint_count);
  /// Triangle corners, as 16 bit where `vertex_count` allows.
  uint32_t addIndices(std::span<const uint32_t> values, uint32_t vertex_count);

  /// States the buffer (with `uri`, or none for the chunk of a GLB). Call once, when everything is in.
  void closeBuffer(const std::string& uri);

 private:
  uint32_t addAccessor(std::span<const uint8_t> bytes, uint32_t component_type, std::string_view type, size_t count,
                       ViewTarget target);
};

/// Components per element of an accessor type.
uint32_t componentsOf(std::string_view type);

}  // namespace lithe::bake
