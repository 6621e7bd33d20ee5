// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Closed tubes with a pole at either end: heads, legs, antennae, bristles.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "lithe/bake/model.h"
#include "surface_builder.h"

namespace lithe::bake {

struct UvRect {
  glm::dvec2 low{0.0}, high{1.0};

  glm::dvec2 at(double u, double v) const { return {low.x * (1.0 - u) + high.x * u, low.y * (1.0 - v) + high.y * v}; }
};

/// A closed surface over angle in [0, 2 pi) and v in [0, 1]. `position` must give one point for all angles at v = 0 and
/// at v = 1; angles turn counter-clockwise as seen from the end v = 1.
struct Tube {
  uint32_t part = 0;
  uint32_t columns = 8, rows = 8;
  UvRect uv;
  std::function<glm::dvec3(double angle, double v)> position;
  std::function<Skin(double v)> skin;
};

/// The unit normal of position(angle, v) by central differences; at a pole the direction to it from inside.
glm::dvec3 surfaceNormal(const std::function<glm::dvec3(double, double)>& position, double angle, double v);

void addTube(SurfaceBuilder& surface, const Tube& tube);

/// A limb: a smooth curve through its joints, which lie in a plane, and a radius that swells before and narrows at
/// each.
class Limb {
 public:
  /// points: root, joints .. tip, in the plane with unit normal `side`; radii: one per point.
  Limb(std::vector<glm::dvec3> points, std::vector<double> radii, const glm::dvec3& side);

  /// The point of the surface; v in [0, 1] along the limb by chord length.
  glm::dvec3 surfaceAt(double angle, double v) const;
  glm::dvec3 centerAt(double v) const;
  glm::dvec3 tangentAt(double v) const;

  /// v of points[index].
  double vOf(uint32_t index) const { return v_[index]; }
  double length() const { return length_; }

  /// Skin at v: joints[k] holds the piece from points[k] to points[k + 1]; neighbours blend over +- half_width (in v).
  Skin skinAt(double v, const std::vector<uint32_t>& joints, double half_width) const;

 private:
  struct Place {
    uint32_t piece;
    double t;  ///< 0 .. 1 within the piece
  };
  Place placeAt(double v) const;
  double radiusAt(double v) const;

  std::vector<glm::dvec3> points_, tangents_;
  std::vector<double> radii_, v_;
  glm::dvec3 side_;
  double length_ = 0.0;
};

}  // namespace lithe::bake
