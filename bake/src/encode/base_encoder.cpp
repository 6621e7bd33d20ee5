// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "base_encoder.h"

#include <numeric>

#include "lithe/format/file.h"

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

void writeNodes(const Cut& cut, PageData& page) {
  auto& nodes = page.streams[format::kBaseNodes].attributes;
  auto& influences = page.streams[format::kBaseInfluences].attributes;
  glm::ivec3 previous(0);
  for (uint32_t n = 0; n < cut.node_hierarchy.size(); ++n) {
    const uint32_t node = cut.node_hierarchy[n];
    const glm::ivec3 position = cut.h.position[node];
    for (int c = 0; c < 3; ++c) nodes[0].values.push_back(position[c] - previous[c]);
    previous = position;
    nodes[1].values.push_back(static_cast<int32_t>(cut.node_first_wedge[n + 1] - cut.node_first_wedge[n]) - 1);
    const QuantizedSkin& skin = cut.h.skin[node];
    nodes[2].values.push_back(skin.count - 1);
    for (uint32_t i = 0; i < skin.count; ++i) {
      influences[0].values.push_back(skin.joint[i]);
      influences[1].values.push_back(i + 1 < skin.count ? skin.weight[i] : 0);
    }
  }
}

void writeWedges(const Cut& cut, PageData& page) {
  auto& attributes = page.streams[format::kBaseWedges].attributes;
  const uint32_t stride = cut.h.record.stride;
  std::vector<int32_t> previous(stride, 0);
  for (uint32_t wedge : cut.wedge_hierarchy) {
    attributes[0].values.push_back(static_cast<int32_t>(cut.h.wedge_part[wedge]));
    const int32_t* values = cut.h.wedge_attributes.data() + size_t{wedge} * stride;
    uint32_t at = 0;
    for (size_t a = 1; a < attributes.size(); ++a)
      for (uint32_t c = 0; c < attributes[a].spec.components; ++c, ++at) {
        attributes[a].values.push_back(values[at] - previous[at]);
        previous[at] = values[at];
      }
  }
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
  writeNodes(cut, page);
  writeWedges(cut, page);
  writeFaces(cut, page);
  return page;
}

}  // namespace lithe::bake
