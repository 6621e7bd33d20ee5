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
  Int3 r[2 * kMaxRing];  ///< relative to the split node, shifted; twice that for a wedge that is at two corners
  Gradient gradient;

  /// Of an attribute: value(wedge) is the neighbour's less the parent's. Nothing is known without neighbours.
  template <class Value>
  Slope slopeOf(const Value& value) const {
    Moment moment;
    for (uint32_t i = 0; i < count; ++i) moment.add(r[i], value(wedge[i]));
    return gradient.of(moment);
  }

  /// Of a pair of attributes: point(wedge) is the neighbour's, the parent's is `parent`.
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
  GradientSums sums;
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
        sums.add(out.r[other]);
        out.r[other] = doubled(out.r[other]);
        continue;
      }
      const Int3 r = shifted(minus(position(i, step), center), shift);
      out.wedge[out.count] = wedge;
      out.r[out.count++] = r;
      sums.add(r);
    }
    follows = ordered && included;
  }
  out.gradient = solveGradient(sums, shifted(d, shift));
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
