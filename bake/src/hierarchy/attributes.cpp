// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "attributes.h"

#include "lithe/bake/octahedral_difference.h"
#include "lithe/format/placement.h"

namespace lithe::bake {

WedgeRecord wedgeRecord(const AttributeSet& attributes) {
  WedgeRecord record;
  record.uv.fill(kNone);
  record.color.fill(kNone);
  auto take = [&record](uint32_t values) {
    const uint32_t at = record.stride;
    record.stride += values;
    return at;
  };
  if (attributes.normal) record.normal = take(2);
  if (attributes.tangent) record.tangent = take(3);
  for (uint32_t s = 0; s < attributes.uv_sets; ++s) record.uv[s] = take(2);
  for (uint32_t s = 0; s < attributes.color_sets; ++s) record.color[s] = take(4);
  return record;
}

namespace {

/// The square's border has some directions twice: a reader gets one of the two points.
void useReadersPoint(int32_t* point, int32_t center) {
  int32_t direction[3];
  format::octahedralDirection({point[0], point[1]}, center, direction);
  const format::Int2 p = format::octahedralPointOf(direction, center);
  point[0] = p.x;
  point[1] = p.y;
}

}  // namespace

void gatherAttributes(const Mesh& mesh, uint32_t wedge, const WedgeRecord& record, int32_t* out) {
  auto put = [out](uint32_t at, const auto& value) {
    for (int i = 0; i < value.length(); ++i) out[at + i] = value[i];
  };
  const int32_t center = format::octahedralCenter(mesh.normal_bits);
  if (record.normal != kNone) {
    put(record.normal, mesh.wedge_normal[wedge]);
    useReadersPoint(out + record.normal, center);
  }
  if (record.tangent != kNone) {
    put(record.tangent, mesh.wedge_tangent[wedge]);
    useReadersPoint(out + record.tangent, center);
  }
  for (uint32_t s = 0; s < mesh.attributes.uv_sets; ++s) put(record.uv[s], mesh.wedge_uv[s][wedge]);
  for (uint32_t s = 0; s < mesh.attributes.color_sets; ++s) put(record.color[s], mesh.wedge_color[s][wedge]);
}

namespace {

void directionBetween(uint32_t at, const int32_t* from, const int32_t* to, DirectionRule rule, int32_t* out) {
  const format::Int2 p = octahedralBetween({from[at], from[at + 1]}, {to[at], to[at + 1]}, rule);
  out[at] = p.x;
  out[at + 1] = p.y;
}

}  // namespace

void attributesBetween(const WedgeRecord& record, const int32_t* from, const int32_t* to, DirectionRule rule,
                       int32_t* out) {
  const int32_t t8 = rule.t8;
  for (uint32_t i = 0; i < record.stride; ++i) out[i] = from[i] + format::eighths(to[i] - from[i], t8);
  if (record.normal != kNone) directionBetween(record.normal, from, to, rule, out);
  if (record.tangent != kNone) {
    directionBetween(record.tangent, from, to, rule, out);
    // A handedness cannot be interpolated: the nearer child's, either child's order giving the same.
    out[record.tangent + 2] = t8 < 4   ? from[record.tangent + 2]
                              : t8 > 4 ? to[record.tangent + 2]
                                       : from[record.tangent + 2] & to[record.tangent + 2];
  }
}

}  // namespace lithe::bake
