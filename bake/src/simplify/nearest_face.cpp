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
    : nodes_(nodes), surface_(surface), lengths_(lengths), marks_(nodes.positions.size()) {}

void FaceSearch::makeRoom(const std::array<uint32_t, 3>& slots) {
  size_t faces = 0;
  for (uint32_t slot : slots) faces += surface_.facesAt(slot).size();
  if (faces <= candidates_.size()) return;
  candidates_.resize(faces);
  vertices_.resize(3 * faces);
  distance_.resize(3 * faces);
  batch_.resize((faces + kLanes - 1) / kLanes);
  nearness_.resize(kLanes * batch_.size());
}

uint32_t FaceSearch::indexOf(uint32_t slot) {
  Mark& mark = marks_[slot];
  if (mark.stamp != last_stamp_) {
    mark = {last_stamp_, vertex_count_};
    vertices_[vertex_count_++] = nodes_.posed.at(slot);
  }
  return mark.index;
}

void FaceSearch::gather(const std::array<uint32_t, 3>& slots) {
  if (slots == slots_) return;
  slots_ = slots;
  makeRoom(slots);
  ++last_stamp_;
  candidate_count_ = vertex_count_ = 0;
  for (uint32_t slot : slots) {
    for (uint32_t id : surface_.facesAt(slot)) {
      __builtin_prefetch(&surface_.face(id));
      __builtin_prefetch(&lengths_[id]);
    }
  }
  for (uint32_t k = 0; k < 3; ++k) {
    if ((k > 0 && slots[k] == slots[0]) || (k > 1 && slots[k] == slots[1])) continue;
    for (uint32_t id : surface_.facesAt(slots[k])) {
      const Face& face = surface_.face(id);
      if ((k > 0 && face.has(slots[0])) || (k > 1 && face.has(slots[1]))) continue;
      const auto& [a, b, c] = face.corner;
      const uint32_t i = candidate_count_++;
      candidates_[i] = {id, {indexOf(a), indexOf(b), indexOf(c)}};
      for (uint32_t edge = 0; edge < 3; ++edge) batch_[i / kLanes].edge[edge][i % kLanes] = lengths_[id][edge];
    }
  }
}

FacePoint FaceSearch::pointOf(const Candidate& candidate) const {
  const auto& [a, b, c] = candidate.corner;
  const double pa = distance_[a], pb = distance_[b], pc = distance_[c];
  const auto& [ab, ac, bc] = lengths_[candidate.face];
  FacePoint point;
  point.face = candidate.face;
  nearestShares({ab, 0.5 * (double{ab} + ac - bc), ac, 0.5 * (pa + ab - pb), 0.5 * (pa + ac - pc)}, point.share);
  return point;
}

FacePoint FaceSearch::nearest(const PosedPoint* point, const std::array<uint32_t, 3>& slots) {
  gather(slots);
  if (candidate_count_ == 0) return {};
  squaredDistancesFrom(point, {vertices_.data(), vertex_count_}, nodes_.posed.blocks, distance_.data());
  for (uint32_t i = 0; i < candidate_count_; ++i) {
    for (uint32_t k = 0; k < 3; ++k) batch_[i / kLanes].to[k][i % kLanes] = distance_[candidates_[i].corner[k]];
  }
  squaredDistancesToFaces({batch_.data(), (candidate_count_ + kLanes - 1) / kLanes}, nearness_.data());
  const float* begin = nearness_.data();
  return pointOf(candidates_[static_cast<size_t>(std::min_element(begin, begin + candidate_count_) - begin)]);
}

}  // namespace lithe::bake
