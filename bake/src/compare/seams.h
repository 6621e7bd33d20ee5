// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Places where vertices coincide at rest, and how far they part in a pose.
#pragma once

#include "posed_surface.h"

namespace lithe::bake {

/// Vertices that coincide in the rest pose, grouped; groups of one are left out. A place's vertices are
/// members[begin[i] .. begin[i + 1]).
struct SeamPlaces {
  std::vector<uint32_t> begin{0};
  std::vector<uint32_t> members;

  size_t count() const { return begin.size() - 1; }
};

/// Vertices closer than `tolerance` to a place's first vertex belong to it. Only vertices, no triangles, are looked at.
SeamPlaces seamPlaces(std::span<const glm::dvec3> rest_positions, double tolerance);

/// Per place: the largest distance of a member from the first member.
std::vector<double> seamSpreads(const SeamPlaces& places, std::span<const glm::dvec3> positions);

/// The simplified model's seams and, for each, where the original is to be asked what opens there.
struct SeamProbe {
  SeamPlaces original;
  SeamPlaces simplified;
  std::vector<uint32_t> original_place_of;     ///< per original vertex: its place or kNone
  std::vector<Triangle> original_triangle_at;  ///< per simplified place: the original's nearest triangle at rest
};

SeamProbe makeSeamProbe(const MeasuredSurface& original, std::span<const glm::dvec3> original_rest,
                        std::span<const glm::dvec3> simplified_rest);

/// In units of the positions.
SeamError measureSeams(const SeamProbe& probe, std::span<const glm::dvec3> original_posed,
                       std::span<const glm::dvec3> simplified_posed);

}  // namespace lithe::bake
