// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "vertex_layout.h"

#include "arguments.h"

namespace lithe::runtime {
namespace {

constexpr uint32_t kMaxStrideBytes = 2048;

/// How many components of how many bytes a format has; none when the attribute cannot have the format.
struct Shape {
  uint32_t components, bytes;
};

Shape directionShape(uint32_t format, uint32_t floats) {
  switch (format) {
    case LITHE_FORMAT_F32:
      return {floats, 4};
    case LITHE_FORMAT_SNORM16:
      return {2, 2};
    case LITHE_FORMAT_SNORM8:
      return {4, 1};
    default:
      return {0, 0};
  }
}

Shape positionShape(uint32_t format) {
  return format == LITHE_FORMAT_F32 ? Shape{3, 4} : format == LITHE_FORMAT_SNORM16 ? Shape{4, 2} : Shape{0, 0};
}

Shape uvShape(uint32_t format) {
  const bool is_short = format == LITHE_FORMAT_F16 || format == LITHE_FORMAT_UNORM16;
  return format == LITHE_FORMAT_F32 ? Shape{2, 4} : is_short ? Shape{2, 2} : Shape{0, 0};
}

Shape colorShape(uint32_t format) {
  return format == LITHE_FORMAT_F32 ? Shape{4, 4} : format == LITHE_FORMAT_UNORM8 ? Shape{4, 1} : Shape{0, 0};
}

Shape jointShape(uint32_t format, uint32_t influences, uint32_t joint_count) {
  const bool fits_u8 = joint_count <= 256;
  return format == LITHE_FORMAT_U16             ? Shape{influences, 2}
         : format == LITHE_FORMAT_U8 && fits_u8 ? Shape{influences, 1}
                                                : Shape{0, 0};
}

Shape weightShape(uint32_t format, uint32_t influences) {
  return format == LITHE_FORMAT_F32       ? Shape{influences, 4}
         : format == LITHE_FORMAT_UNORM16 ? Shape{influences, 2}
         : format == LITHE_FORMAT_UNORM8  ? Shape{influences, 1}
                                          : Shape{0, 0};
}

/// Collects the uses in ascending order of offset; remembers whether one was impossible.
struct UseList {
  LayoutPlan* plan;
  bool valid = true;

  void add(VertexAttribute attribute, uint32_t set, const lithe_attribute& request, bool exists, Shape shape) {
    if (request.format == LITHE_FORMAT_NONE) return;
    if (!exists || shape.components == 0 || request.offset % shape.bytes) {
      valid = false;
      return;
    }
    insert({attribute, static_cast<uint8_t>(set), request.format, request.offset, shape.components * shape.bytes});
  }

  void insert(const AttributeUse& use) {
    uint32_t at = plan->use_count++;
    for (; at > 0 && plan->uses[at - 1].offset > use.offset; --at) plan->uses[at] = plan->uses[at - 1];
    plan->uses[at] = use;
  }
};

/// Joins the uses to spans. Returns false when two overlap or one leaves the vertex.
bool joinSpans(LayoutPlan* plan) {
  uint32_t end = 0;
  for (uint32_t i = 0; i < plan->use_count; ++i) {
    const AttributeUse& use = plan->uses[i];
    if (use.offset < end || use.offset + use.bytes > plan->stride) return false;
    if (i > 0 && use.offset == end)
      plan->spans[plan->span_count - 1].bytes += use.bytes;
    else
      plan->spans[plan->span_count++] = {use.offset, use.bytes};
    end = use.offset + use.bytes;
  }
  return true;
}

}  // namespace

bool planLayout(const lithe_asset& asset, const lithe_vertex_layout& layout, LayoutPlan* plan) {
  const Info& info = asset.head.info;
  *plan = {};
  plan->stride = layout.stride;
  plan->influences = layout.influences;
  const bool skinned = layout.joints.format != LITHE_FORMAT_NONE || layout.weights.format != LITHE_FORMAT_NONE;
  if (layout.struct_size != sizeof layout || layout.stride == 0 || layout.stride > kMaxStrideBytes) return false;
  if (skinned && (layout.influences < info.max_influences || layout.influences > LITHE_MAX_INFLUENCES)) return false;

  UseList list = {plan};
  list.add(VertexAttribute::kPosition, 0, layout.position, true, positionShape(layout.position.format));
  list.add(VertexAttribute::kNormal, 0, layout.normal, info.has_normals, directionShape(layout.normal.format, 3));
  list.add(VertexAttribute::kTangent, 0, layout.tangent, info.has_tangents, directionShape(layout.tangent.format, 4));
  for (uint32_t s = 0; s < LITHE_MAX_UV_SETS; ++s)
    list.add(VertexAttribute::kUv, s, layout.uv[s], s < info.uv_sets, uvShape(layout.uv[s].format));
  for (uint32_t s = 0; s < LITHE_MAX_COLOR_SETS; ++s)
    list.add(VertexAttribute::kColor, s, layout.color[s], s < info.color_sets, colorShape(layout.color[s].format));
  list.add(VertexAttribute::kJoints, 0, layout.joints, true,
           jointShape(layout.joints.format, layout.influences, asset.head.joints.count));
  list.add(VertexAttribute::kWeights, 0, layout.weights, true, weightShape(layout.weights.format, layout.influences));
  return list.valid && joinSpans(plan);
}

}  // namespace lithe::runtime

lithe_vertex_layout lithe_vertex_layout_default(const lithe_asset* asset) {
  lithe_vertex_layout layout = {};
  if (!asset) return lithe::runtime::invalidArgument(), layout;
  const lithe::runtime::Info& info = asset->head.info;
  uint32_t at = 0;
  auto place = [&](lithe_format format, uint32_t bytes) {
    const lithe_attribute attribute = {static_cast<uint16_t>(format), static_cast<uint16_t>(at)};
    at += bytes;
    return attribute;
  };
  layout.struct_size = sizeof layout;
  layout.influences = info.max_influences <= 4 ? 4 : 8;  // what vertex formats of four components can fetch
  layout.position = place(LITHE_FORMAT_F32, 12);
  if (info.has_normals) layout.normal = place(LITHE_FORMAT_SNORM16, 4);
  if (info.has_tangents) layout.tangent = place(LITHE_FORMAT_SNORM16, 4);
  for (uint32_t s = 0; s < info.uv_sets; ++s) layout.uv[s] = place(LITHE_FORMAT_F16, 4);
  for (uint32_t s = 0; s < info.color_sets; ++s) layout.color[s] = place(LITHE_FORMAT_UNORM8, 4);
  const bool few_joints = asset->head.joints.count <= 256;
  layout.joints = place(few_joints ? LITHE_FORMAT_U8 : LITHE_FORMAT_U16, (few_joints ? 1 : 2) * layout.influences);
  layout.weights = place(LITHE_FORMAT_UNORM8, layout.influences);
  layout.stride = at;
  return layout;
}
