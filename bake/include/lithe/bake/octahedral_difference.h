// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Differences of octahedral directions that a reader can undo given only the parent direction and t8.
#pragma once

#include <optional>

#include "lithe/format/octahedral.h"

namespace lithe::bake {

/// Where a parent's direction lies, see format::directionEighths().
struct DirectionRule {
  int32_t center;
  int32_t t8;        ///< from b (0) to a (8)
  bool makes_faces;  ///< the split that undoes it makes faces

  int32_t eighths(format::Int2 d) const { return format::directionEighths(d, t8, makes_faces, center); }
};

/// The difference D (b to a, possibly over a fold) with which a reader gets b and a from their parent:
///     x = parent - eighths(D, rule.eighths(D)), b = fold(x), a = fold(x + D).
/// The shortest one; nothing when there is none.
std::optional<format::Int2> octahedralDifference(format::Int2 parent, format::Int2 b, format::Int2 a,
                                                 DirectionRule rule);

/// A parent between b and a for which octahedralDifference exists, whichever child comes first: over the fold
/// when that is the shorter way, else straight across the square. A child on the square's border can only be reached
/// from inside: a reader's fold leaves it where it is, though its other half of the edge is the same direction.
format::Int2 octahedralBetween(format::Int2 b, format::Int2 a, DirectionRule rule);

}  // namespace lithe::bake
