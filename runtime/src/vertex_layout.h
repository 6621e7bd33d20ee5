// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// A host's vertex layout, checked and put in order.
#pragma once

#include "asset.h"

namespace lithe::runtime {

enum class VertexAttribute : uint8_t { kPosition, kNormal, kTangent, kUv, kColor, kJoints, kWeights };

/// One attribute to be written.
struct AttributeUse {
  VertexAttribute attribute;
  uint8_t set;
  uint16_t format;         ///< a lithe_format that the attribute can have
  uint32_t offset, bytes;  ///< within the vertex
};

inline constexpr uint32_t kMaxUses = 3 + LITHE_MAX_UV_SETS + LITHE_MAX_COLOR_SETS + 2;

/// Bytes of a vertex that are written, without gaps.
struct VertexSpan {
  uint32_t offset, bytes;
};

struct LayoutPlan {
  uint32_t stride, influences;
  uint32_t use_count, span_count;
  AttributeUse uses[kMaxUses];  ///< ascending by offset
  VertexSpan spans[kMaxUses];   ///< what the uses cover, neighbours joined
};

/// Returns false when the layout is not one that the asset can be written in.
bool planLayout(const lithe_asset& asset, const lithe_vertex_layout& layout, LayoutPlan* plan);

}  // namespace lithe::runtime
