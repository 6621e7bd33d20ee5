// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// A vertex layout that leaves nothing of an asset out; from the runtime's own header alone.
#pragma once

#include "lithe/runtime.h"

namespace lithe::test {

/// Every attribute that the asset has, in the widest formats.
inline lithe_vertex_layout widestLayout(const lithe_asset_info& info) {
  lithe_vertex_layout layout = {};
  layout.struct_size = sizeof layout;
  layout.influences = LITHE_MAX_INFLUENCES;
  auto place = [&](uint16_t format, uint32_t bytes) {
    const lithe_attribute attribute = {format, static_cast<uint16_t>(layout.stride)};
    layout.stride += bytes;
    return attribute;
  };
  layout.position = place(LITHE_FORMAT_F32, 12);
  layout.joints = place(LITHE_FORMAT_U16, 16);
  layout.weights = place(LITHE_FORMAT_F32, 32);
  if (info.has_normals) layout.normal = place(LITHE_FORMAT_F32, 12);
  if (info.has_tangents) layout.tangent = place(LITHE_FORMAT_F32, 16);
  for (uint32_t s = 0; s < info.uv_sets; ++s) layout.uv[s] = place(LITHE_FORMAT_F32, 8);
  for (uint32_t s = 0; s < info.color_sets; ++s) layout.color[s] = place(LITHE_FORMAT_F32, 16);
  return layout;
}

}  // namespace lithe::test
