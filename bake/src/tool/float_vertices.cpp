// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "float_vertices.h"

#include <stdexcept>
#include <string>

namespace lithe::tool {
namespace {

/// Attributes one after the other, stride a multiple of 4.
lithe_vertex_layout floatLayout(const lithe_asset_info& info) {
  lithe_vertex_layout layout{};
  layout.struct_size = sizeof layout;
  layout.influences = info.max_influences;
  const auto floats = [&](uint32_t count) {
    const lithe_attribute attribute{LITHE_FORMAT_F32, static_cast<uint16_t>(layout.stride)};
    layout.stride += 4 * count;
    return attribute;
  };
  layout.position = floats(3);
  if (info.has_normals) layout.normal = floats(3);
  if (info.has_tangents) layout.tangent = floats(4);
  for (uint32_t set = 0; set < info.uv_sets; ++set) layout.uv[set] = floats(2);
  for (uint32_t set = 0; set < info.color_sets; ++set) layout.color[set] = floats(4);
  layout.weights = floats(info.max_influences);
  layout.joints = {LITHE_FORMAT_U16, static_cast<uint16_t>(layout.stride)};
  layout.stride += (2 * info.max_influences + 3) / 4 * 4;
  return layout;
}

}  // namespace

FloatVertices::FloatVertices(const Asset& asset, uint32_t count) : layout_(floatLayout(asset.info())), count_(count) {
  bytes_.resize(static_cast<size_t>(count) * layout_.stride);
  require(lithe_asset_write_vertices(asset.get(), &layout_, 0, count, bytes_.data(), bytes_.size()));
}

LevelIndices levelIndices(const Asset& asset, uint32_t level) {
  LevelIndices indices;
  indices.triangles.resize(asset.level(level).triangle_count);
  indices.ranges.resize(asset.info().part_count);
  require(lithe_asset_write_indices(asset.get(), level, LITHE_INDEX_U32, indices.triangles.data(),
                                    indices.triangles.size() * sizeof indices.triangles[0], indices.ranges.data()));
  return indices;
}

void require(lithe_result result) {
  if (result != LITHE_OK) throw std::logic_error(std::string("the runtime answered ") + lithe_result_name(result));
}

}  // namespace lithe::tool
