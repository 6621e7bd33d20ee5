// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Parents and differences of octahedral directions that a reader can undo given only the parent's direction and t8.
/// All points are those of the square whose pole is +z, and border points those of format::octahedralPointOf(): a
/// reader gets no others.
#pragma once

#include <optional>

#include "lithe/format/octahedral_chart.h"

namespace lithe::bake {

/// Where a parent's direction lies, see format::directionEighths().
struct DirectionRule {
  int32_t center;
  int32_t t8;        ///< from b (0) to a (8)
  bool makes_faces;  ///< the split that undoes it makes faces

  int32_t eighths(format::Int2 d) const { return format::directionEighths(d, t8, makes_faces, center); }
  format::ChildDirections split(format::Int2 parent, format::Int2 d) const {
    return format::splitDirection({parent, center}, d, t8, makes_faces);
  }
};

/// The difference D (b to a in the parent's chart, possibly over a fold) with which format::splitDirection() gives b
/// and a. A short one; nothing when there is none.
std::optional<format::Int2> octahedralDifference(format::Int2 parent, format::Int2 b, format::Int2 a,
                                                 DirectionRule rule);

/// A parent between b and a for which octahedralDifference() exists, whichever child comes first.
format::Int2 octahedralBetween(format::Int2 b, format::Int2 a, DirectionRule rule);

}  // namespace lithe::bake
