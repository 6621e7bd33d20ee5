// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// A map from lattice space to model space that shrinks around given spots, so that a regular lattice is denser there.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

namespace lithe::bake {

/// p(q) = q - sum over spots of shift(|q - c|) * unit(q - c). Each shift grows with a slope below 1 and then falls back
/// to 0 slowly, so that every term's second derivatives stay well below 1, p is the gradient of a convex function and
/// therefore one-to-one, as long as the spots are far apart.
class LatticeWarp {
 public:
  struct Spot {
    glm::dvec3 center{0.0};  ///< in model space
    double radius = 0.0;     ///< in model space
    double magnification = 1.0;
  };

  explicit LatticeWarp(std::vector<Spot> spots) : spots_(std::move(spots)) {
    for (const Spot& spot : spots_) lattice_centers_.push_back(spot.center);
    // the spots push each other's centers; they are so far apart that this settles at once
    for (int round = 0; round < 30; ++round) {
      for (size_t i = 0; i < spots_.size(); ++i) {
        lattice_centers_[i] = spots_[i].center + shift(lattice_centers_[i]);
      }
    }
  }

  glm::dvec3 toModel(const glm::dvec3& q) const { return q - shift(q); }

  /// An upper bound of how far the map moves a point.
  double largestShift() const {
    double sum = 0.0;
    for (const Spot& spot : spots_) sum += spot.radius * (spot.magnification - 1.0);
    return sum;
  }

 private:
  static constexpr double kFall = 0.35;

  glm::dvec3 shift(const glm::dvec3& q) const {
    glm::dvec3 sum(0.0);
    for (size_t i = 0; i < spots_.size(); ++i) {
      const glm::dvec3 away = q - lattice_centers_[i];
      const double distance = std::sqrt(glm::dot(away, away));
      if (distance == 0.0) continue;
      const double m = spots_[i].magnification, edge = spots_[i].radius * m;
      // inside, 1 - 1/m of the distance; from 0.6 to 1.4 edges the slope fades to nothing; then the shift dies out
      const double inner = 0.6 * edge, outer = 1.4 * edge, slope = 1.0 - 1.0 / m;
      const double t = std::clamp((distance - inner) / (outer - inner), 0.0, 1.0);
      const double grown = slope * (std::min(distance, inner) + (outer - inner) * (t - 0.5 * t * t));
      const double length = std::max(0.0, grown - kFall * std::max(0.0, distance - outer));
      sum += away * (length / distance);
    }
    return sum;
  }

  std::vector<Spot> spots_;
  std::vector<glm::dvec3> lattice_centers_;
};

}  // namespace lithe::bake
