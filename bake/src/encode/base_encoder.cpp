// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "base_encoder.h"

#include <numeric>

#include "lithe/format/file.h"
#include "residuals.h"

namespace lithe::bake {
namespace {

void addRoots(Cut& cut) {
  const Hierarchy& h = cut.h;
  for (uint32_t n = 0; n < h.nodeCount(); ++n) {
    if (h.parent[n] != kNone) continue;
    std::vector<uint32_t> wedges(h.first_wedge[n + 1] - h.first_wedge[n]);
    std::iota(wedges.begin(), wedges.end(), h.first_wedge[n]);
    cut.addNode(n, wedges);
  }
}

void addStandingFaces(Cut& cut) {
  const Hierarchy& h = cut.h;
  for (uint32_t t = 0; t < h.birth_node.size(); ++t) {
    if (h.birth_node[t] != kNone) continue;
    std::array<uint32_t, 3> wedges;
    for (uint32_t k = 0; k < 3; ++k) {
      const uint32_t leaf = h.face_wedges[t][k];
      wedges[k] = cut.wedgeAt(cut.nodeAbove(h.wedge_node[leaf]), leaf);
    }
    cut.addFace(t, 0, wedges);
  }
}

/// Differences to what came before, of one attribute: cut into high parts and low bits when all are known.
struct Differences {
  StreamData::Attribute* attribute;
  format::LowBits kind;
  uint32_t parameter;  ///< that holds the number of low bits; kNone: there are none
  uint32_t shifted;    ///< components that have low bits
  std::vector<int32_t> values;

  uint8_t chooseShift() const {
    std::vector<int32_t> counted;
    for (size_t i = 0; i < values.size(); ++i)
      if (i % attribute->spec.components < shifted) counted.push_back(values[i]);
    return bestShift(counted);
  }
};

/// Record by record, as a reader takes them.
void writeDifferences(std::vector<Differences>& columns, PageData& page, LowBitsWriter& low_bits) {
  for (Differences& column : columns)
    if (column.parameter != kNone) page.parameters[column.parameter] = column.chooseShift();
  const size_t records = columns.empty() ? 0 : columns[0].values.size() / columns[0].attribute->spec.components;
  for (size_t r = 0; r < records; ++r)
    for (Differences& column : columns) {
      const uint32_t components = column.attribute->spec.components;
      for (uint32_t c = 0; c < components; ++c) {
        const int32_t value = column.values[r * components + c];
        const int32_t low = column.parameter != kNone && c < column.shifted ? page.parameters[column.parameter] : 0;
        column.attribute->putSplit(value, low, low_bits[column.kind]);
      }
    }
}

void writeNodes(const Cut& cut, PageData& page, LowBitsWriter& low_bits) {
  auto& nodes = page.streams[format::kBaseNodes].attributes;
  auto& influences = page.streams[format::kBaseInfluences].attributes;
  std::vector<Differences> positions{{&nodes[0], format::kLowPositions, format::kPositionBias, 3, {}}};
  glm::ivec3 previous(0);
  for (uint32_t n = 0; n < cut.node_hierarchy.size(); ++n) {
    const uint32_t node = cut.node_hierarchy[n];
    const glm::ivec3 position = cut.h.position[node];
    for (int c = 0; c < 3; ++c) positions[0].values.push_back(position[c] - previous[c]);
    previous = position;
    nodes[1].values.push_back(static_cast<int32_t>(cut.node_first_wedge[n + 1] - cut.node_first_wedge[n]) - 1);
    const QuantizedSkin& skin = cut.h.skin[node];
    nodes[2].values.push_back(skin.count - 1);
    for (uint32_t i = 0; i < skin.count; ++i) {
      influences[0].values.push_back(skin.joint[i]);
      influences[1].values.push_back(i + 1 < skin.count ? skin.weight[i] : 0);
    }
  }
  writeDifferences(positions, page, low_bits);
}

std::vector<Differences> wedgeColumns(const WedgeRecord& record, format::WedgeAttributes has, PageData& page) {
  StreamData::Attribute* attribute = page.streams[format::kBaseWedges].attributes.data() + 1;  // the first is the part
  std::vector<Differences> columns;
  if (record.normal != kNone) columns.push_back({attribute++, format::kLowNormals, format::kNormalBias, 2, {}});
  if (record.tangent != kNone) columns.push_back({attribute++, format::kLowTangents, format::kTangentBias, 2, {}});
  for (uint32_t s = 0; s < has.uv_sets; ++s)
    columns.push_back({attribute++, format::kLowUvs, format::kUvBias0 + s, 2, {}});
  for (uint32_t s = 0; s < has.color_sets; ++s) columns.push_back({attribute++, format::kLowExtras, kNone, 0, {}});
  return columns;
}

void writeWedges(const Cut& cut, format::WedgeAttributes has, PageData& page, LowBitsWriter& low_bits) {
  std::vector<Differences> columns = wedgeColumns(cut.h.record, has, page);
  const uint32_t stride = cut.h.record.stride;
  std::vector<int32_t> previous(stride, 0);
  for (uint32_t wedge : cut.wedge_hierarchy) {
    page.streams[format::kBaseWedges].attributes[0].values.push_back(static_cast<int32_t>(cut.h.wedge_part[wedge]));
    const int32_t* values = cut.h.wedge_attributes.data() + size_t{wedge} * stride;
    uint32_t at = 0;
    for (Differences& column : columns)
      for (uint32_t c = 0; c < column.attribute->spec.components; ++c, ++at) {
        column.values.push_back(values[at] - previous[at]);
        previous[at] = values[at];
      }
  }
  writeDifferences(columns, page, low_bits);
}

void writeFaces(const Cut& cut, PageData& page) {
  auto& values = page.streams[format::kBaseFaces].attributes[0].values;
  uint32_t previous = 0;
  for (const auto& wedges : cut.face_wedges) {
    values.push_back(static_cast<int32_t>(wedges[0] - previous));
    values.push_back(static_cast<int32_t>(wedges[1] - wedges[0]));
    values.push_back(static_cast<int32_t>(wedges[2] - wedges[0]));
    previous = wedges[0];
  }
}

}  // namespace

PageData encodeBase(Cut& cut, format::WedgeAttributes has) {
  PageData page = makePage(format::kBasePage, has);
  addRoots(cut);
  if (cut.wedge_node.size() > format::limits::kBaseWedges)
    throw Error("the coarsest level still has " + std::to_string(cut.wedge_node.size()) +
                " vertices: collapse further (the simplifier stopped early)");
  addStandingFaces(cut);
  LowBitsWriter low_bits;
  writeNodes(cut, page, low_bits);
  writeWedges(cut, has, page, low_bits);
  writeFaces(cut, page);
  low_bits.finish(page);
  return page;
}

}  // namespace lithe::bake
