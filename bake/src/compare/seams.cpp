// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "seams.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace lithe::bake {

namespace {

constexpr double kCoincident = 1e-6;  // of the diagonal: what welders take for the same point

}  // namespace

SeamPlaces seamPlaces(std::span<const glm::dvec3> rest_positions, double tolerance) {
  // Sorted along an oblique axis, coincident vertices are neighbours, and flat models do not fall onto one key.
  const glm::dvec3 axis = glm::normalize(glm::dvec3(0.8147, 0.4421, 0.3751));
  std::vector<std::pair<double, uint32_t>> sorted;
  for (uint32_t i = 0; i < rest_positions.size(); ++i) sorted.emplace_back(glm::dot(rest_positions[i], axis), i);
  std::sort(sorted.begin(), sorted.end());
  SeamPlaces places;
  std::vector<bool> taken(rest_positions.size(), false);
  for (size_t i = 0; i < sorted.size(); ++i) {
    const uint32_t first = sorted[i].second;
    if (taken[first]) continue;
    const size_t before = places.members.size();
    for (size_t j = i + 1; j < sorted.size() && sorted[j].first - sorted[i].first <= tolerance; ++j) {
      const uint32_t other = sorted[j].second;
      if (taken[other] || glm::distance(rest_positions[first], rest_positions[other]) > tolerance) continue;
      if (places.members.size() == before) places.members.push_back(first);
      places.members.push_back(other);
      taken[other] = true;
    }
    if (places.members.size() > before) places.begin.push_back(static_cast<uint32_t>(places.members.size()));
  }
  return places;
}

std::vector<double> seamSpreads(const SeamPlaces& places, std::span<const glm::dvec3> positions) {
  std::vector<double> spreads(places.count(), 0.0);
  for (size_t i = 0; i < places.count(); ++i) {
    const glm::dvec3& first = positions[places.members[places.begin[i]]];
    for (uint32_t k = places.begin[i] + 1; k < places.begin[i + 1]; ++k) {
      spreads[i] = std::max(spreads[i], glm::distance(first, positions[places.members[k]]));
    }
  }
  return spreads;
}

SeamProbe makeSeamProbe(const MeasuredSurface& original, std::span<const glm::dvec3> original_rest,
                        std::span<const glm::dvec3> simplified_rest) {
  const double tolerance = kCoincident * diagonalOf(original_rest);
  SeamProbe probe;
  probe.original = seamPlaces(original_rest, tolerance);
  probe.simplified = seamPlaces(simplified_rest, tolerance);
  probe.original_place_of.assign(original_rest.size(), kNone);
  for (uint32_t place = 0; place < probe.original.count(); ++place) {
    for (uint32_t k = probe.original.begin[place]; k < probe.original.begin[place + 1]; ++k) {
      probe.original_place_of[probe.original.members[k]] = place;
    }
  }
  const TriangleTree tree(original_rest, original.triangles);
  for (size_t place = 0; place < probe.simplified.count(); ++place) {
    const glm::dvec3& point = simplified_rest[probe.simplified.members[probe.simplified.begin[place]]];
    probe.original_triangle_at.push_back(original.triangles[tree.nearest(point).triangle]);
  }
  return probe;
}

SeamError measureSeams(const SeamProbe& probe, std::span<const glm::dvec3> original_posed,
                       std::span<const glm::dvec3> simplified_posed) {
  const std::vector<double> original_spreads = seamSpreads(probe.original, original_posed);
  const std::vector<double> spreads = seamSpreads(probe.simplified, simplified_posed);
  SeamError error;
  for (size_t place = 0; place < spreads.size(); ++place) {
    double allowed = 0.0;
    for (const uint32_t vertex : probe.original_triangle_at[place]) {
      const uint32_t there = probe.original_place_of[vertex];
      if (there != kNone) allowed = std::max(allowed, original_spreads[there]);
    }
    error.gap = std::max(error.gap, spreads[place]);
    error.opened = std::max(error.opened, spreads[place] - allowed);
  }
  return error;
}

}  // namespace lithe::bake
