// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "further_decoder.h"

#include <string.h>

#include "lithe/format/octahedral_chart.h"
#include "sort.h"

namespace lithe::runtime {

using format::kNoIndex;

bool FurtherDecoder::readChild(uint32_t side) {
  uint32_t most = 0;
  for (uint32_t i = 0; i < class_count_; ++i) most = greatest(most, classes_[i].members[side].count);
  if (most < 2) return true;
  child_ = out_->node_count - 2 + side;
  gatherCorners();
  for (uint32_t i = 0; i < class_count_; ++i) {
    const uint32_t first = classes_[i].first[side];
    for (uint32_t m = 1; m < classes_[i].members[side].count; ++m)
      if (!readWedge(first, first + m)) return false;
  }
  return true;
}

void FurtherDecoder::gatherCorners() {
  corners_.clear();
  for (uint32_t corner = out_->node_first_corner[child_]; corner != kNoIndex; corner = out_->corner_next[corner]) {
    const uint32_t k = corner % 3;
    const uint32_t* wedges = out_->face_wedges + (corner - k);
    const uint32_t others[2] = {wedges[(k + 1) % 3], wedges[(k + 2) % 3]};
    const format::Int3 at[2] = {position(out_->wedge_node[others[0]]), position(out_->wedge_node[others[1]])};
    if (!corners_.add(wedges[k], others, at)) return;
  }
}

bool FurtherDecoder::readWedge(uint32_t first_wedge, uint32_t wedge) {
  const uint32_t mask = static_cast<uint32_t>(streams_->values[format::kExtraMasks][0].next());
  if (mask >> format::kMaskEnd) return false;
  const WedgeLayout& layout = format_.layout;
  const uint16_t* first = record(first_wedge);
  uint16_t* out = record(wedge);
  memcpy(out, first, layout.stride * sizeof(uint16_t));
  if (format_.has.normals && (mask >> format::kMaskNormal & 1) && !readNormal(wedge, first, out)) return false;
  if (format_.has.tangents && (mask >> format::kMaskTangent & 1) && !readTangent(first, out)) return false;
  if ((mask >> format::kMaskUv0 & 0xff) && !readUvs(wedge, mask, first, out)) return false;
  for (uint32_t s = 0; s < format_.has.color_sets; ++s)
    if ((mask >> (format::kMaskColor0 + s) & 1) && !readEntries(0, layout.color[s], 4, first, out)) return false;
  return true;
}

/// Against the normal of the wedge's own faces, without any against the first wedge's.
bool FurtherDecoder::readNormal(uint32_t wedge, const uint16_t* first, uint16_t* out) {
  const uint32_t at = format_.layout.normal;
  const format::AreaNormal normal = corners_.normalOf(wedge, position(child_));
  const format::Int2 predicted = normal.isZero()
                                     ? format::Int2{first[at], first[at + 1]}
                                     : format::octahedralPoint(normal, static_cast<int32_t>(format_.normal_center));
  return readTurned(format::kExtraNormalShift, predicted, out + at);
}

bool FurtherDecoder::readTangent(const uint16_t* first, uint16_t* out) {
  const uint32_t at = format_.layout.tangent;
  return readTurned(format::kExtraTangentShift, {first[at], first[at + 1]}, out + at) &&
         readEntries(0, at + 2, 1, first, out);
}

/// Against the nearest neighbour's, without any against the first wedge's.
bool FurtherDecoder::readUvs(uint32_t wedge, uint32_t mask, const uint16_t* first, uint16_t* out) {
  const uint32_t neighbour =
      corners_.nearestTo(wedge, position(child_), [&](uint32_t other) { return isReadBefore(other, wedge); });
  const uint16_t* predicted = neighbour == kNoIndex ? first : record(neighbour);
  for (uint32_t s = 0; s < format_.has.uv_sets; ++s)
    if ((mask >> (format::kMaskUv0 + s) & 1) &&
        !readEntries(streams_->parameters[format::kExtraUvShift], format_.layout.uv[s], 2, predicted, out))
      return false;
  return true;
}

/// A direction, in the chart around the predicted one.
bool FurtherDecoder::readTurned(format::Parameter shift, format::Int2 predicted, uint16_t* out) {
  const int32_t center = static_cast<int32_t>(format_.normal_center);
  const format::ChartedDirection from(predicted, center);
  const int64_t x = int64_t{from.point.x} + residual(streams_->parameters[shift]);
  const int64_t y = int64_t{from.point.y} + residual(streams_->parameters[shift]);
  if (x < 0 || x > 2 * center || y < 0 || y > 2 * center) return false;
  const format::Int2 point = from.chart.toSquare({static_cast<int32_t>(x), static_cast<int32_t>(y)});
  out[0] = static_cast<uint16_t>(point.x);
  out[1] = static_cast<uint16_t>(point.y);
  return true;
}

bool FurtherDecoder::readEntries(int32_t low, uint32_t at, uint32_t count, const uint16_t* predicted, uint16_t* out) {
  for (uint32_t v = at; v < at + count; ++v) {
    const int64_t value = int64_t{predicted[v]} + residual(low);
    if (value < 0 || value > greatest_[v]) return false;
    out[v] = static_cast<uint16_t>(value);
  }
  return true;
}

/// Of the children's wedges the first ones of the classes are read before the further ones, and those in order.
bool FurtherDecoder::isReadBefore(uint32_t wedge, uint32_t further) const {
  const uint32_t child_a = out_->node_count - 2, node = out_->wedge_node[wedge];
  if (node < child_a || wedge < further) return true;
  return classes_[out_->wedge_parent[wedge] - first_parent_wedge_].first[node - child_a] == wedge;
}

}  // namespace lithe::runtime
