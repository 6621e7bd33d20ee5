// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "nearest_face.h"

#include <algorithm>

namespace lithe::bake {

namespace {

/// Dot products of b - a, c - a and p - a.
struct StackedDots {
  double bb, bc, cc, bp, cp;
};

/// The nearest point of the triangle, as shares of its corners (Ericson 2005, 5.1.5).
void nearestShares(const StackedDots& s, std::array<float, 3>& share) {
  const double d1 = s.bp, d2 = s.cp, d3 = d1 - s.bb, d4 = d2 - s.bc, d5 = d1 - s.bc, d6 = d2 - s.cc;
  double v = 0.0, w = 0.0;
  const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  if (d1 <= 0.0 && d2 <= 0.0) {
  } else if (d3 >= 0.0 && d4 <= d3) {
    v = 1.0;
  } else if (d6 >= 0.0 && d5 <= d6) {
    w = 1.0;
  } else if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    v = d1 / (d1 - d3);
  } else if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    w = d2 / (d2 - d6);
  } else if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    v = 1.0 - w;
  } else {
    const double sum = va + vb + vc;
    if (sum > 0.0) v = vb / sum, w = vc / sum;
  }
  share[0] = static_cast<float>(1.0 - v - w);
  share[1] = static_cast<float>(v);
  share[2] = static_cast<float>(w);
}

}  // namespace

EdgeLengths edgeLengths(const Face& face, const PosedMesh& posed) {
  const PosedPoint *a = posed.at(face.corner[0]), *b = posed.at(face.corner[1]), *c = posed.at(face.corner[2]);
  return {squaredDistances(a, b, posed.blocks), squaredDistances(a, c, posed.blocks),
          squaredDistances(b, c, posed.blocks)};
}

FaceSearch::FaceSearch(const NodeState& nodes, const Surface& surface, const std::vector<EdgeLengths>& lengths)
    : nodes_(nodes),
      surface_(surface),
      lengths_(lengths),
      index_(nodes.positions.size()),
      stamp_(nodes.positions.size(), 0) {}

uint32_t FaceSearch::indexOf(uint32_t slot) {
  if (stamp_[slot] != last_stamp_) {
    stamp_[slot] = last_stamp_;
    index_[slot] = static_cast<uint32_t>(vertices_.size());
    vertices_.push_back(nodes_.posed.at(slot));
  }
  return index_[slot];
}

void FaceSearch::gather(const std::array<uint32_t, 3>& slots) {
  if (slots == slots_) return;
  slots_ = slots;
  ++last_stamp_;
  faces_.clear();
  corners_.clear();
  vertices_.clear();
  for (uint32_t k = 0; k < 3; ++k) {
    if ((k > 0 && slots[k] == slots[0]) || (k > 1 && slots[k] == slots[1])) continue;
    for (uint32_t id : surface_.facesAt(slots[k])) {
      const Face& face = surface_.face(id);
      if ((k > 0 && face.has(slots[0])) || (k > 1 && face.has(slots[1]))) continue;
      faces_.push_back(id);
      corners_.push_back({indexOf(face.corner[0]), indexOf(face.corner[1]), indexOf(face.corner[2])});
    }
  }
  distance_.resize(vertices_.size());
  batch_.assign((faces_.size() + kLanes - 1) / kLanes, FaceDistances{});
  nearness_.resize(kLanes * batch_.size());
  for (uint32_t i = 0; i < faces_.size(); ++i) {
    for (uint32_t k = 0; k < 3; ++k) batch_[i / kLanes].edge[k][i % kLanes] = lengths_[faces_[i]][k];
  }
}

FacePoint FaceSearch::pointOf(uint32_t candidate) const {
  const auto& [a, b, c] = corners_[candidate];
  const double pa = distance_[a], pb = distance_[b], pc = distance_[c];
  const auto& [ab, ac, bc] = lengths_[faces_[candidate]];
  FacePoint point;
  point.face = faces_[candidate];
  nearestShares({ab, 0.5 * (double{ab} + ac - bc), ac, 0.5 * (pa + ab - pb), 0.5 * (pa + ac - pc)}, point.share);
  return point;
}

FacePoint FaceSearch::nearest(const PosedPoint* point, const std::array<uint32_t, 3>& slots) {
  gather(slots);
  if (faces_.empty()) return {};
  squaredDistancesFrom(point, vertices_, nodes_.posed.blocks, distance_.data());
  for (uint32_t i = 0; i < faces_.size(); ++i) {
    for (uint32_t k = 0; k < 3; ++k) batch_[i / kLanes].to[k][i % kLanes] = distance_[corners_[i][k]];
  }
  squaredDistancesToFaces(batch_, nearness_.data());
  const auto best = std::min_element(nearness_.begin(), nearness_.begin() + static_cast<ptrdiff_t>(faces_.size()));
  return pointOf(static_cast<uint32_t>(best - nearness_.begin()));
}

}  // namespace lithe::bake
