// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// What a split's attributes are predicted from, gathered around the split node: by the writer from the cut it has, by
/// the reader from what it has decoded.
#pragma once

#include <stdint.h>

#include "lithe/format/page.h"
#include "lithe/format/prediction.h"

namespace lithe::format {

/// The wedges at the next and previous corners of a fan's faces, and the slope that they give.
struct RingNeighbours {
  uint32_t count = 0;
  uint32_t wedge[2 * kMaxRing];
  Int3 r[2 * kMaxRing];  ///< relative to the split node, shifted
  Gradient gradient;

  /// Of an attribute: value(wedge) is the neighbour's less the parent's. Nothing is known without neighbours.
  template <class Value>
  Slope slopeOf(const Value& value) const {
    Moment moment;
    for (uint32_t i = 0; i < count; ++i) moment.add(r[i], value(wedge[i]));
    return gradient.of(moment);
  }

  /// Of a direction: point(wedge) is the neighbour's in the chart around the parent's, which is at `parent`.
  template <class Point>
  void slopesOf(const Point& point, Int2 parent, Slope slope[2]) const {
    Moment moment[2];
    for (uint32_t i = 0; i < count; ++i) {
      const Int2 p = point(wedge[i]);
      moment[0].add(r[i], p.x - parent.x);
      moment[1].add(r[i], p.y - parent.y);
    }
    for (uint32_t c = 0; c < 2; ++c) slope[c] = gradient.of(moment[c]);
  }
};

/// Of the fan's corners for whose index includes(i) is true; a fan beyond kMaxRing has none.
/// center    of the split node; position(node) gives the others
/// d         the difference of the children's positions
/// extent    of the ring and of d
/// wedge_at  (corner id) -> wedge
template <class Includes, class Position, class WedgeAt>
void gatherNeighbours(const Fan& fan, Int3 center, Int3 d, uint32_t extent, const Includes& includes,
                      const Position& position, const WedgeAt& wedge_at, RingNeighbours& out) {
  out.count = 0;
  out.gradient = {};
  if (fan.count > kMaxRing) return;
  const int32_t shift = gradientShift(extent);
  GradientSums sums;
  for (uint32_t i = 0; i < fan.count; ++i) {
    if (!includes(i)) continue;
    const uint32_t k = fan.corner[i] % 3, first = fan.corner[i] - k;
    const uint32_t nodes[2] = {fan.next[i], fan.previous[i]};
    for (uint32_t step = 0; step < 2; ++step) {
      const Int3 r = shifted(minus(position(nodes[step]), center), shift);
      out.wedge[out.count] = wedge_at(first + (k + 1 + step) % 3);
      out.r[out.count++] = r;
      sums.add(r);
    }
  }
  out.gradient = solveGradient(sums, shifted(d, shift));
}

/// The area normals of child A's and child B's faces.
struct ChildNormals {
  Int3 child[2];
  AreaNormal normal[2];

  /// Those of the fan for whose index includes(i) is true.
  template <class Includes, class AtB, class Position>
  void addFan(const Fan& fan, const Includes& includes, const AtB& at_b, const Position& position) {
    for (uint32_t i = 0; i < fan.count; ++i) {
      if (!includes(i)) continue;
      const uint32_t side = at_b[i] ? 1 : 0;
      normal[side].add(child[side], position(fan.next[i]), position(fan.previous[i]));
    }
  }

  /// A new face between the children, (A, third, B) or (B, third, A): it is both children's.
  void addCut(Int3 third, bool first_is_a) {
    for (AreaNormal& n : normal) n.add(child[!first_is_a], third, child[first_is_a]);
  }
};

}  // namespace lithe::format
