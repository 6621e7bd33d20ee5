// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "page_base.h"

#include "lithe/format/file.h"
#include "skin_order.h"

namespace lithe::runtime {
namespace {

uint32_t decodeSkin(const PageFormat& format, IntReader* joints, IntReader* weights, uint32_t count, NodeSkin* skin) {
  *skin = {};
  skin->count = count;
  int64_t left = format.weight_one;
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t joint = static_cast<uint32_t>(joints->next());
    const int64_t stored = weights->next();
    const int64_t weight = i + 1 < count ? stored : left;
    if (joint >= format.joint_count || weight <= 0 || weight > format.weight_one || (i + 1 == count && stored != 0))
      return kCheckSkin;
    skin->joint[i] = static_cast<uint16_t>(joint);
    skin->weight[i] = static_cast<uint16_t>(weight);
    left -= weight;
  }
  return failUnless(skinIsOrdered(*skin), kCheckSkin);
}

uint32_t decodeNodes(const PageFormat& format, const PagePlan& plan, PageStreams* streams, Decoded* out) {
  IntReader* nodes = streams->values[format::kBaseNodes];
  IntReader* influences = streams->values[format::kBaseInfluences];
  const int32_t low = streams->parameters[format::kPositionBias];
  int64_t position[3] = {0, 0, 0};
  uint64_t wedge = 0;
  for (uint32_t n = 0; n < plan.node_count; ++n) {
    for (int c = 0; c < 3; ++c) {
      position[c] += splitValue(&streams->low_bits[format::kLowPositions], &nodes[0], low);
      if (position[c] < 0 || position[c] >> format.position_bits) return kCheckNode;
      out->node_position[3 * n + static_cast<uint32_t>(c)] = static_cast<uint16_t>(position[c]);
    }
    out->node_first_wedge[n] = static_cast<uint32_t>(wedge);
    wedge += static_cast<uint64_t>(nodes[1].next()) + 1;
    const uint32_t influence_count = static_cast<uint32_t>(nodes[2].next()) + 1;
    if (wedge > plan.wedge_count || influence_count > format.max_influences) return kCheckNode;
    NodeSkin skin;
    if (decodeSkin(format, &influences[0], &influences[1], influence_count, &skin)) return kCheckSkin;
    storeSkin(skin, n, format.max_influences, out);
    out->node_parent[n] = format::kNoIndex;
    out->node_first_child[n] = format::kNoIndex;
    out->node_first_corner[n] = format::kNoIndex;
    for (uint32_t w = out->node_first_wedge[n]; w < wedge; ++w) out->wedge_node[w] = n;
  }
  out->node_first_wedge[plan.node_count] = static_cast<uint32_t>(wedge);
  return failUnless(wedge == plan.wedge_count, kCheckNode);
}

uint32_t decodeWedges(const PageFormat& format, const PagePlan& plan, PageStreams* streams, Decoded* out) {
  IntReader* columns = streams->values[format::kBaseWedges];
  const uint8_t* parameters = streams->parameters;
  int64_t previous[kMaxStride] = {};
  int64_t greatest[kMaxStride];
  attributeLimits(format, greatest);
  for (uint32_t w = 0; w < plan.wedge_count; ++w) {
    const uint32_t part = static_cast<uint32_t>(columns[0].next());
    if (part >= format.part_count) return kCheckWedge;
    out->wedge_part[w] = static_cast<uint16_t>(part);
    out->wedge_parent[w] = format::kNoIndex;
    uint32_t at = 0, column = 1;
    auto take = [&](uint32_t components, format::LowBits kind, int32_t low) {
      for (uint32_t c = 0; c < components; ++c, ++at) {
        previous[at] += splitValue(&streams->low_bits[kind], &columns[column], c < 2 ? low : 0);
        if (previous[at] < 0 || previous[at] > greatest[at]) return false;
        out->wedge_attributes[static_cast<size_t>(w) * format.layout.stride + at] = static_cast<uint16_t>(previous[at]);
      }
      ++column;
      return true;
    };
    bool valid = true;
    if (format.has.normals) valid = take(2, format::kLowNormals, parameters[format::kNormalBias]);
    if (format.has.tangents) valid = valid && take(3, format::kLowTangents, parameters[format::kTangentBias]);
    for (uint32_t s = 0; s < format.has.uv_sets; ++s)
      valid = valid && take(2, format::kLowUvs, parameters[format::kUvBias0 + s]);
    for (uint32_t s = 0; s < format.has.color_sets; ++s) valid = valid && take(4, format::kLowExtras, 0);
    if (!valid) return kCheckWedge;
  }
  return 0;
}

uint32_t decodeFaces(const PagePlan& plan, PageStreams* streams, Decoded* out) {
  IntReader* values = streams->values[format::kBaseFaces];
  int64_t first = 0;
  for (uint32_t f = 0; f < plan.face_count; ++f) {
    first += values->next();
    const int64_t wedges[3] = {first, first + values->next(), first + values->next()};
    for (int k = 0; k < 3; ++k)
      if (wedges[k] < 0 || wedges[k] >= plan.wedge_count) return kCheckBaseFace;
    uint32_t nodes[3];
    for (uint32_t k = 0; k < 3; ++k) {
      out->face_wedges[3 * f + k] = static_cast<uint32_t>(wedges[k]);
      nodes[k] = out->wedge_node[wedges[k]];
    }
    if (nodes[0] == nodes[1] || nodes[1] == nodes[2] || nodes[0] == nodes[2]) return kCheckBaseFace;
    if (out->wedge_part[wedges[0]] != out->wedge_part[wedges[1]] ||
        out->wedge_part[wedges[0]] != out->wedge_part[wedges[2]])
      return kCheckBaseFace;
    for (uint32_t k = 0; k < 3; ++k) linkCorner(out, 3 * f + k);
  }
  return 0;
}

}  // namespace

uint32_t decodeBase(const PageFormat& format, const PagePlan& plan, PageStreams* streams, Decoded* out) {
  if (streams->records[format::kBaseNodes] != plan.node_count ||
      streams->records[format::kBaseWedges] != plan.wedge_count ||
      streams->records[format::kBaseFaces] != plan.face_count)
    return kCheckCounts;
  if (const uint32_t check = decodeNodes(format, plan, streams, out)) return check;
  if (const uint32_t check = decodeWedges(format, plan, streams, out)) return check;
  return decodeFaces(plan, streams, out);
}

}  // namespace lithe::runtime
