// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "further_encoder.h"

#include <algorithm>

#include "lithe/format/octahedral_chart.h"

namespace lithe::bake {

void FurtherEncoder::writeChild(uint32_t side) {
  const auto hasFurther = [&](const WedgeClass& c) { return c.wedges[side].size() > 1; };
  if (std::none_of(classes_.begin(), classes_.end(), hasFurther)) return;
  child_ = static_cast<uint32_t>(cut_.node_hierarchy.size()) - 2 + side;
  gatherCorners();
  for (const WedgeClass& c : classes_)
    for (size_t m = 1; m < c.wedges[side].size(); ++m) writeWedge(c.wedges[side][0], c.wedges[side][m]);
}

void FurtherEncoder::gatherCorners() {
  corners_.clear();
  for (uint32_t corner : cut_.node_corners[child_]) {
    const uint32_t k = corner % 3;
    const std::array<uint32_t, 3>& wedges = cut_.face_wedges[corner / 3];
    const uint32_t others[2] = {wedges[(k + 1) % 3], wedges[(k + 2) % 3]};
    const format::Int3 at[2] = {cut_.filePosition(cut_.wedge_node[others[0]]),
                                cut_.filePosition(cut_.wedge_node[others[1]])};
    if (!corners_.add(wedges[k], others, at)) return;
  }
}

// Across a seam often only one attribute differs: a mask says which do.
void FurtherEncoder::writeWedge(uint32_t first, uint32_t wedge) {
  const WedgeRecord& record = cut_.h.record;
  const uint32_t mask = maskOf(first, wedge);
  page_.streams[format::kExtraMasks].put(static_cast<int32_t>(mask));
  if (mask >> format::kMaskNormal & 1) writeNormal(first, wedge);
  if (mask >> format::kMaskTangent & 1) writeTangent(first, wedge);
  if (mask >> format::kMaskUv0 & 0xff) writeUvs(mask, first, wedge);
  for (uint32_t s = 0; s < kMaxColorSets; ++s)
    if (mask >> (format::kMaskColor0 + s) & 1) addPlain(first, wedge, record.color[s], 4);
}

uint32_t FurtherEncoder::maskOf(uint32_t first, uint32_t wedge) const {
  const WedgeRecord& record = cut_.h.record;
  const auto bit = [&](uint32_t at, uint32_t count, uint32_t number) {
    if (at == kNone ||
        std::equal(cut_.attributes(wedge) + at, cut_.attributes(wedge) + at + count, cut_.attributes(first) + at))
      return 0u;
    return 1u << number;
  };
  uint32_t mask = bit(record.normal, 2, format::kMaskNormal) | bit(record.tangent, 3, format::kMaskTangent);
  for (uint32_t s = 0; s < kMaxUvSets; ++s) mask |= bit(record.uv[s], 2, format::kMaskUv0 + s);
  for (uint32_t s = 0; s < kMaxColorSets; ++s) mask |= bit(record.color[s], 4, format::kMaskColor0 + s);
  return mask;
}

// Against the normal of the wedge's own faces, without any against the first wedge's.
void FurtherEncoder::writeNormal(uint32_t first, uint32_t wedge) {
  const uint32_t at = cut_.h.record.normal;
  const format::AreaNormal normal = corners_.normalOf(cut_.file_wedge[wedge], cut_.filePosition(child_));
  addTurned(Residual::Kind::kExtraNormal,
            normal.isZero() ? cut_.pairAt(first, at) : format::octahedralPoint(normal, normal_center_),
            cut_.pairAt(wedge, at));
}

void FurtherEncoder::writeTangent(uint32_t first, uint32_t wedge) {
  const uint32_t at = cut_.h.record.tangent;
  addTurned(Residual::Kind::kExtraTangent, cut_.pairAt(first, at), cut_.pairAt(wedge, at));
  addPlain(first, wedge, at + 2, 1);
}

// Against the nearest neighbour's, without any against the first wedge's.
void FurtherEncoder::writeUvs(uint32_t mask, uint32_t first, uint32_t wedge) {
  const uint32_t further = cut_.file_wedge[wedge];
  const uint32_t neighbour = corners_.nearestTo(further, cut_.filePosition(child_),
                                                [&](uint32_t other) { return isReadBefore(other, further); });
  const uint32_t from = neighbour == format::kNoIndex ? first : cut_.wedge_hierarchy[neighbour];
  for (uint32_t s = 0; s < kMaxUvSets; ++s) {
    if (!(mask >> (format::kMaskUv0 + s) & 1)) continue;
    const uint32_t at = cut_.h.record.uv[s];
    addPair(Residual::Kind::kExtraUv, cut_.pairAt(from, at), cut_.pairAt(wedge, at));
  }
}

// In the chart around the predicted direction.
void FurtherEncoder::addTurned(Residual::Kind kind, format::Int2 predicted, format::Int2 point) {
  const format::ChartedDirection from(predicted, normal_center_);
  addPair(kind, from.point, from.chart.fromSquare(point));
}

void FurtherEncoder::addPair(Residual::Kind kind, format::Int2 predicted, format::Int2 value) {
  Residual residual;
  residual.kind = kind;
  residual.components = 2;
  residual.difference = {value.x - predicted.x, value.y - predicted.y, 0};
  residuals_.add(residual);
}

void FurtherEncoder::addPlain(uint32_t first, uint32_t wedge, uint32_t at, uint32_t count) {
  for (uint32_t v = at; v < at + count; ++v) {
    Residual residual;
    residual.kind = Residual::Kind::kExtraPlain;
    residual.difference[0] = cut_.attributes(wedge)[v] - cut_.attributes(first)[v];
    residuals_.add(residual);
  }
}

// Of the children's wedges a reader has the first ones of the classes, and further ones in order.
bool FurtherEncoder::isReadBefore(uint32_t file_wedge, uint32_t further) const {
  const uint32_t child_a = static_cast<uint32_t>(cut_.node_hierarchy.size()) - 2;
  const uint32_t node = cut_.wedge_node[file_wedge];
  if (node < child_a || file_wedge < further) return true;
  const uint32_t wedge = cut_.wedge_hierarchy[file_wedge];
  return std::any_of(classes_.begin(), classes_.end(), [&](const WedgeClass& c) {
    return !c.wedges[node - child_a].empty() && c.wedges[node - child_a][0] == wedge;
  });
}

}  // namespace lithe::bake
