// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "arguments.h"
#include "asset.h"
#include "rotation.h"

using namespace lithe::format;   // NOLINT: the records' field names
using namespace lithe::runtime;  // NOLINT

namespace {

void loadFloats(const uint8_t* p, uint32_t count, float* out) {
  for (uint32_t i = 0; i < count; ++i) out[i] = loadF32(p + 4 * i);
}

/// The rotation and the six numbers of the scale of a record's form.
struct Linear {
  float rotation[4], scale[6];
};

Linear linearOf(const lithe_asset& asset, uint32_t form, const uint8_t* kept_rotation) {
  Linear out;
  const uint64_t fields = loadU64(kept_rotation);
  const float kept[3] = {rotationComponent(fields, 0), rotationComponent(fields, 1), rotationComponent(fields, 2)};
  wholeRotation(formLeftOut(form), kept, out.rotation);
  loadFloats(asset.head.scales.record(formScale(form)), 6, out.scale);
  return out;
}

lithe_level describeLevel(const Level& level) {
  lithe_level out = {};
  out.error = level.entry.error;
  out.error_rms = level.entry.error_rms;
  out.triangle_count = level.entry.face_count - level.entry.hidden_count;
  out.index_count = 3 * out.triangle_count;
  out.vertex_count = level.entry.wedge_count;
  out.page_end = level.entry.page_end;
  out.bytes_end = level.bytes_end;
  out.joint_count = level.entry.joint_count;
  return out;
}

}  // namespace

void lithe_asset_describe(const lithe_asset* asset, lithe_asset_info* out) {
  if (!asset || !out) return void(invalidArgument());
  const Info& info = asset->head.info;
  *out = {};
  out->file_bytes = asset->head.file_bytes;
  out->node_count = asset->head.nodes.count;
  out->joint_count = asset->head.joints.count;
  out->part_count = asset->head.parts.count;
  out->material_count = asset->head.materials.count;
  out->level_count = asset->level_count;
  out->page_count = asset->page_count;
  out->vertex_count = info.wedge_count;
  out->triangle_count = describeLevel(asset->levels[asset->level_count - 1]).triangle_count;
  out->max_influences = info.max_influences;
  out->has_normals = info.has_normals;
  out->has_tangents = info.has_tangents;
  out->uv_sets = info.uv_sets;
  out->color_sets = info.color_sets;
  // The middle of the grid is the snorm16's zero: the two have the same step, so a position is exact in either.
  const float middle = static_cast<float>(1u << (info.position_bits - 1));
  out->position_scale = info.grid_step * 32767;
  for (uint32_t c = 0; c < 3; ++c) {
    out->position_offset[c] = bindCoordinate(info, c, middle);
    out->box_min[c] = bindCoordinate(info, c, static_cast<float>(info.grid_min[c]));
    out->box_max[c] = bindCoordinate(info, c, static_cast<float>(info.grid_max[c]));
  }
  out->rest_diagonal = info.rest_diagonal;
  out->posed_diagonal = info.posed_diagonal;
}

lithe_result lithe_asset_node(const lithe_asset* asset, uint32_t index, lithe_node* out) {
  if (!asset || !out || index >= asset->head.nodes.count) return invalidArgument();
  const uint8_t* p = asset->head.nodes.record(index);
  out->name = nameAt(*asset, loadU32(p + node::kNameAt));
  const uint32_t parent = loadU16(p + node::kParentAt);
  out->parent = parent == node::kNoParent ? LITHE_NO_INDEX : parent;
  loadFloats(p + node::kTranslationAt, 3, out->translation);
  const Linear linear = linearOf(*asset, loadU16(p + node::kFormAt), p + node::kRotationAt);
  for (uint32_t i = 0; i < 4; ++i) out->rotation[i] = linear.rotation[i];
  for (uint32_t i = 0; i < 3; ++i) out->scale[i] = linear.scale[i];
  return LITHE_OK;
}

lithe_result lithe_asset_joint(const lithe_asset* asset, uint32_t index, lithe_joint* out) {
  if (!asset || !out || index >= asset->head.joints.count) return invalidArgument();
  const uint8_t* p = asset->head.joints.record(index);
  out->node = loadU16(p + joint::kNodeAt);
  float translation[3];
  loadFloats(p + joint::kTranslationAt, 3, translation);
  const Linear linear = linearOf(*asset, loadU16(p + joint::kFormAt), p + joint::kRotationAt);
  matrixOf(linear.rotation, linear.scale, translation, out->inverse_bind);
  jointBox(asset->head, index, out->box_min, out->box_max);
  return LITHE_OK;
}

lithe_result lithe_asset_part(const lithe_asset* asset, uint32_t index, lithe_part* out) {
  if (!asset || !out || index >= asset->head.parts.count) return invalidArgument();
  const uint8_t* p = asset->head.parts.record(index);
  out->name = nameAt(*asset, loadU32(p + part::kNameAt));
  out->material_index = loadU32(p + part::kMaterialAt);
  out->rigid_node = loadU32(p + part::kRigidNodeAt);
  out->material = "";
  if (out->material_index != LITHE_NO_INDEX)
    out->material = nameAt(*asset, loadU32(asset->head.materials.record(out->material_index) + material::kNameAt));
  return LITHE_OK;
}

lithe_result lithe_asset_level(const lithe_asset* asset, uint32_t index, lithe_level* out) {
  if (!asset || !out || index >= asset->level_count) return invalidArgument();
  *out = describeLevel(asset->levels[index]);
  return LITHE_OK;
}

lithe_result lithe_asset_page(const lithe_asset* asset, uint32_t index, lithe_page* out) {
  if (!asset || !out || index >= asset->page_count) return invalidArgument();
  const PageEntry entry = pageEntry(*asset, index);
  *out = {asset->page_offset[index], entry.size, entry.level};
  return LITHE_OK;
}

void lithe_asset_hierarchy(const lithe_asset* asset, lithe_hierarchy* out) {
  if (!asset || !out) return void(invalidArgument());
  const Decoded& d = asset->decoded;
  *out = {};
  out->node_count = d.node_count;
  out->wedge_count = d.wedge_count;
  out->face_count = d.face_count;
  out->node_position = d.node_position;
  out->node_parent = d.node_parent;
  out->node_first_child = d.node_first_child;
  out->wedge_node = d.wedge_node;
  out->wedge_parent = d.wedge_parent;
  out->wedge_part = d.wedge_part;
  out->face_wedges = d.face_wedges;
  for (uint32_t c = 0; c < 3; ++c) out->grid_origin[c] = asset->head.info.grid_origin[c];
  out->grid_step = asset->head.info.grid_step;
}

lithe_result lithe_asset_level_extent(const lithe_asset* asset, uint32_t level, lithe_level_extent* out) {
  if (!asset || !out || level >= asset->level_count) return invalidArgument();
  const LevelEntry& entry = asset->levels[level].entry;
  *out = {entry.node_count, entry.wedge_count, entry.face_count};
  return LITHE_OK;
}
