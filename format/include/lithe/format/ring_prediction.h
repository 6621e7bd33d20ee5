// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// What a split's attributes are predicted from, gathered around the split node: by the writer from the cut it has, by
/// the reader from what it has decoded.
#pragma once

#include <stdint.h>

#include "lithe/format/page.h"
#include "lithe/format/prediction.h"

namespace lithe::format {

/// How much a ring's attribute differs from the parent's: what the size of the children's difference goes by.
struct Spread {
  uint32_t spread = 0;  ///< the greatest difference; 0 without neighbours

  constexpr void widen(int32_t e) {
    const uint32_t size = static_cast<uint32_t>(absolute(e));
    if (size > spread) spread = size;
  }
  /// Without neighbours, of an attribute of 0 .. greatest, an eighth of that.
  constexpr uint32_t among(uint32_t neighbour_count, uint32_t greatest) const {
    return neighbour_count > 0 ? spread : greatest / 8;
  }
};
struct RingSlope : Spread {
  Slope slope;
};
struct PairSlope : Spread {
  Slope x, y;
};

/// The wedges at the next and previous corners of a fan's faces, and the slope that they give.
struct RingNeighbours {
  uint32_t count = 0;
  uint32_t wedge[2 * kMaxRing];
  Int3 r[2 * kMaxRing];  ///< relative to the split node, shifted; twice that for a wedge that is at two corners
  Gradient gradient;

  /// Of an attribute: value(wedge) is the neighbour's less the parent's.
  template <class Value>
  RingSlope slopeOf(const Value& value) const {
    RingSlope ring;
    Moment moment;
    for (uint32_t i = 0; i < count; ++i) {
      const int32_t e = value(wedge[i]);
      moment.add(r[i], e);
      ring.widen(e);
    }
    ring.slope = gradient.of(moment);
    return ring;
  }

  /// Of a pair of attributes: point(wedge) is the neighbour's, the parent's is `parent`.
  template <class Point>
  PairSlope slopesOf(const Point& point, Int2 parent) const {
    PairSlope ring;
    Moment x, y;
    for (uint32_t i = 0; i < count; ++i) {
      const Int2 p = point(wedge[i]), e{p.x - parent.x, p.y - parent.y};
      x.add(r[i], e.x);
      y.add(r[i], e.y);
      ring.widen(e.x);
      ring.widen(e.y);
    }
    ring.x = gradient.of(x);
    ring.y = gradient.of(y);
    return ring;
  }
};

/// The neighbours' joints that a split node lacks, by their greatest weight: at most kMaxSkinJoints, the first that are
/// met.
struct RingJoints {
  uint32_t count = 0;
  uint32_t joint[kMaxSkinJoints];
  uint32_t weight[kMaxSkinJoints];  ///< the greatest among the neighbours

  void add(uint32_t of_joint, uint32_t of_weight) {
    uint32_t at = 0;
    while (at < count && joint[at] != of_joint) ++at;
    if (at == kMaxSkinJoints) return;
    if (at == count) {
      joint[count] = of_joint;
      weight[count++] = 0;
    }
    if (weight[at] < of_weight) weight[at] = of_weight;
  }

  /// The heaviest first, of equal ones the lowest id.
  void sort() {
    for (uint32_t i = 1; i < count; ++i) {
      const uint32_t j = joint[i], w = weight[i];
      uint32_t at = i;
      for (; at > 0 && (weight[at - 1] < w || (weight[at - 1] == w && joint[at - 1] > j)); --at) {
        joint[at] = joint[at - 1];
        weight[at] = weight[at - 1];
      }
      joint[at] = j;
      weight[at] = w;
    }
  }
};

/// M of the neighbours: what is there twice counts as two, and its doubled product is that of four.
inline GradientSums sumsOf(const RingNeighbours& neighbours, const bool* twice) {
  GradientSums sums, doubles;
  for (uint32_t i = 0; i < neighbours.count; ++i) (twice[i] ? doubles : sums).add(neighbours.r[i]);
  sums.xx += doubles.xx >> 1;
  sums.xy += doubles.xy >> 1;
  sums.xz += doubles.xz >> 1;
  sums.yy += doubles.yy >> 1;
  sums.yz += doubles.yz >> 1;
  sums.zz += doubles.zz >> 1;
  return sums;
}

/// Of the fan's corners for whose index includes(i) is true; a fan beyond kMaxRing has none.
/// center    of the split node
/// d         the difference of the children's positions
/// extent    of the ring and of d
/// position  (index in the fan, 0: next corner, 1: previous corner) -> the node's
/// wedge_at  the same -> wedge
template <class Includes, class Position, class WedgeAt>
void gatherNeighbours(const Fan& fan, const Ring& ring, Int3 center, Int3 d, uint32_t extent, const Includes& includes,
                      const Position& position, const WedgeAt& wedge_at, RingNeighbours& out) {
  out.count = 0;
  out.gradient = {};
  if (fan.count > kMaxRing) return;
  const int32_t shift = gradientShift(extent);
  bool twice[2 * kMaxRing];
  // Along a ring an edge ends where the next one begins: mostly in one wedge, which is then added once for both.
  const bool ordered = ring.kind != RingKind::kIrregular;
  const uint32_t first = ordered ? ring.edge[0] : 0;
  bool follows = false;
  for (uint32_t e = 0; e < fan.count; ++e) {
    const uint32_t i = ordered ? ring.edge[e] : e;
    const bool included = includes(i), last = ring.kind == RingKind::kClosed && e + 1 == fan.count;
    for (uint32_t step = 0; step < 2 && included; ++step) {
      const uint32_t wedge = wedge_at(i, step);
      const bool meets = step == 0 ? follows : last && includes(first);
      const uint32_t other = step == 0 ? out.count - 1 : 0;
      if (meets && out.wedge[other] == wedge) {
        twice[other] = true;
        out.r[other] = doubled(out.r[other]);
        continue;
      }
      twice[out.count] = false;
      out.wedge[out.count] = wedge;
      out.r[out.count++] = shifted(minus(position(i, step), center), shift);
    }
    follows = ordered && included;
  }
  out.gradient = solveGradient(sumsOf(out, twice), shifted(d, shift));
}

/// The area normals of child A's and child B's faces.
struct ChildNormals {
  Int3 child[2];
  AreaNormal normal[2];

  /// Those of the fan for whose index includes(i) is true; position as in gatherNeighbours.
  template <class Includes, class AtB, class Position>
  void addFan(const Fan& fan, const Includes& includes, const AtB& at_b, const Position& position) {
    for (uint32_t i = 0; i < fan.count; ++i) {
      if (!includes(i)) continue;
      const uint32_t side = at_b[i] ? 1 : 0;
      normal[side].add(child[side], position(i, 0), position(i, 1));
    }
  }

  /// A new face between the children, (A, third, B) or (B, third, A): it is both children's.
  void addCut(Int3 third, bool first_is_a) {
    for (AreaNormal& n : normal) n.add(child[!first_is_a], third, child[first_is_a]);
  }
};

}  // namespace lithe::format
