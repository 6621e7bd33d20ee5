// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Decoded vertices with every attribute as floats: the layout in which nothing is lost between the file and the tool.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <glm/glm.hpp>
#include <vector>

#include "asset.h"

namespace lithe::tool {

/// The GPU vertices [0, count) of an asset. Attributes that the asset lacks must not be asked for.
class FloatVertices {
 public:
  /// The vertices must be resident.
  FloatVertices(const Asset& asset, uint32_t count);

  uint32_t count() const { return count_; }
  uint32_t influences() const { return layout_.influences; }

  glm::vec3 position(uint32_t vertex) const { return read<glm::vec3>(vertex, layout_.position, 0); }
  glm::vec3 normal(uint32_t vertex) const { return read<glm::vec3>(vertex, layout_.normal, 0); }
  glm::vec4 tangent(uint32_t vertex) const { return read<glm::vec4>(vertex, layout_.tangent, 0); }
  glm::vec2 uv(uint32_t vertex, uint32_t set) const { return read<glm::vec2>(vertex, layout_.uv[set], 0); }
  glm::vec4 color(uint32_t vertex, uint32_t set) const { return read<glm::vec4>(vertex, layout_.color[set], 0); }
  float weight(uint32_t vertex, uint32_t i) const { return read<float>(vertex, layout_.weights, i); }
  uint16_t joint(uint32_t vertex, uint32_t i) const { return read<uint16_t>(vertex, layout_.joints, i); }

  /// All bytes, for comparing whole buffers.
  const std::vector<uint8_t>& bytes() const { return bytes_; }

 private:
  template <typename Value>
  Value read(uint32_t vertex, lithe_attribute attribute, uint32_t i) const {
    Value value;
    std::memcpy(&value,
                bytes_.data() + static_cast<size_t>(vertex) * layout_.stride + attribute.offset + i * sizeof value,
                sizeof value);
    return value;
  }

  lithe_vertex_layout layout_{};
  uint32_t count_ = 0;
  std::vector<uint8_t> bytes_;
};

/// The triangles of a level as an engine draws them, grouped by part.
struct LevelIndices {
  std::vector<std::array<uint32_t, 3>> triangles;
  std::vector<lithe_range> ranges;  ///< per part
};

LevelIndices levelIndices(const Asset& asset, uint32_t level);

/// For answers that can only be a bug of the caller or of the runtime.
void require(lithe_result result);

}  // namespace lithe::tool
