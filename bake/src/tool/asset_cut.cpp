// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "asset_cut.h"

#include <algorithm>
#include <utility>

namespace lithe::tool {
namespace {

bool repeats(const CutFace& nodes) { return nodes[0] == nodes[1] || nodes[1] == nodes[2] || nodes[2] == nodes[0]; }

uint64_t distance(uint64_t a, uint64_t b) { return a > b ? a - b : b - a; }

/// A closed surface grows by two faces at a time: one off is as close as a split gets.
bool isClose(uint64_t count, uint64_t target) { return distance(count, target) <= std::max<uint64_t>(1, target / 100); }

constexpr uint32_t kTrials = 32;  // splits that may take the turn of one that brings too many faces

}  // namespace

Cuts::Cuts(const Asset& asset) : order_(orderSplits(asset)) { lithe_asset_hierarchy(asset.get(), &hierarchy_); }

/// For each wedge, the one that is there instead of it (itself, if its node is): wedges come after their parents.
std::vector<uint32_t> Cuts::standIns(uint32_t splits, uint32_t also) const {
  std::vector<uint32_t> wedges(hierarchy_.wedge_count);
  for (uint32_t wedge = 0; wedge < hierarchy_.wedge_count; ++wedge) {
    const uint32_t parent = hierarchy_.node_parent[hierarchy_.wedge_node[wedge]];
    const bool exists = parent == LITHE_NO_INDEX || order_.rank[parent] < splits || order_.rank[parent] == also;
    wedges[wedge] = exists ? wedge : wedges[hierarchy_.wedge_parent[wedge]];
  }
  return wedges;
}

CutFace Cuts::nodesOf(const CutFace& face) const {
  return {hierarchy_.wedge_node[face[0]], hierarchy_.wedge_node[face[1]], hierarchy_.wedge_node[face[2]]};
}

std::vector<CutFace> Cuts::faces(uint32_t splits, uint32_t also) const {
  const std::vector<uint32_t> wedges = standIns(splits, also);
  std::vector<CutFace> faces;
  for (uint32_t face = 0; face < hierarchy_.face_count; ++face) {
    const uint32_t* corner = hierarchy_.face_wedges + 3 * static_cast<size_t>(face);
    const CutFace cut_face{wedges[corner[0]], wedges[corner[1]], wedges[corner[2]]};
    if (!repeats(nodesOf(cut_face))) faces.push_back(cut_face);
  }
  dropEqual(faces);
  return faces;
}

void Cuts::dropEqual(std::vector<CutFace>& faces) const {
  std::vector<std::pair<CutFace, uint32_t>> order(faces.size());
  for (uint32_t i = 0; i < faces.size(); ++i) {
    CutFace nodes = nodesOf(faces[i]);
    std::rotate(nodes.begin(), std::min_element(nodes.begin(), nodes.end()), nodes.end());
    order[i] = {nodes, i};
  }
  std::sort(order.begin(), order.end());
  std::vector<bool> repeated(faces.size(), false);
  for (size_t i = 1; i < order.size(); ++i) repeated[order[i].second] = order[i].first == order[i - 1].first;
  size_t kept = 0;
  for (size_t i = 0; i < faces.size(); ++i) {
    if (!repeated[i]) faces[kept++] = faces[i];
  }
  faces.resize(kept);
}

/// The first `count` places in the order, from `splits` on, whose nodes the splits before have made.
std::vector<uint32_t> Cuts::possibleSplits(uint32_t splits, uint32_t count) const {
  std::vector<uint32_t> places;
  for (uint32_t node = 0; node < hierarchy_.node_count; ++node) {
    const uint32_t place = order_.rank[node], parent = hierarchy_.node_parent[node];
    const bool exists = parent == LITHE_NO_INDEX || order_.rank[parent] < splits;
    if (exists && place != LITHE_NO_INDEX && place >= splits) places.push_back(place);
  }
  std::sort(places.begin(), places.end());
  if (places.size() > count) places.resize(count);
  return places;
}

/// The count grows with the splits, but for a few faces that become equal to others, so halving finds the target.
std::vector<CutFace> Cuts::facesNear(uint32_t target) const {
  uint32_t low = 0, high = splits();
  std::vector<CutFace> best = faces(low);
  const auto consider = [&](std::vector<CutFace> candidate) {
    const size_t count = candidate.size();
    if (distance(count, target) < distance(best.size(), target)) best = std::move(candidate);
    return count;
  };
  consider(faces(high));
  while (low < high) {
    const uint32_t middle = low + (high - low) / 2;
    if (consider(faces(middle)) < target) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  if (low == 0) return best;
  for (const uint32_t place : possibleSplits(low - 1, kTrials)) {
    if (isClose(best.size(), target)) break;
    consider(faces(low - 1, place));
  }
  return best;
}

}  // namespace lithe::tool
