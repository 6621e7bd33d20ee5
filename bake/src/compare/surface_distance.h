// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The parts of a surface distance that the comparison of whole models uses too.
#pragma once

#include <vector>

#include "lithe/bake/nearest.h"

namespace lithe::bake {

/// rms, mean, max and percentile of the samples' distances. Reorders `distances`, which must not be empty.
SurfaceDistance summarizeDistances(std::vector<double>& distances);

/// The value that `share` (0..1) of the values are at most as large as. Reorders `values`, which must not be empty.
double percentile(std::vector<double>& values, double share);

inline glm::dvec3 pointOf(std::span<const glm::dvec3> positions, const Triangle& triangle,
                          const glm::dvec3& barycentric) {
  return positions[triangle[0]] * barycentric.x + positions[triangle[1]] * barycentric.y +
         positions[triangle[2]] * barycentric.z;
}

}  // namespace lithe::bake
