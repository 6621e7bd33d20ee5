// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Smooth solids put together from simple ones: the figure's flesh. Distances are negative inside; only the zero set is
/// exact, elsewhere they are lower in magnitude than the true distance by at most a small factor.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace lithe::bake::implicit {

/// A distance and its gradient.
struct Sample {
  double distance = 0.0;
  glm::dvec3 gradient{0.0};
};

enum class Shape : uint8_t {
  kRoundCone,  ///< the hull of two balls, squeezed along `flat_axis` by `flat_factor`
  kEllipsoid,  ///< semi-axes `radii` along the columns of `frame`
  kLens,       ///< the intersection of two equal balls around a and b
  kHalfSpace,  ///< below the plane through a with normal `flat_axis`
  kRidges,     ///< an ellipsoid whose surface is combed: ridges run from pole to pole of the third column of `frame`
};

enum class Operation : uint8_t {
  kAdd,
  kCut,
  kSwell,  ///< pushes the surface out by radius_a between the planes y = a.y and y = b.y; the blend is the planes'
           ///< softness
};

/// One step of the construction. Unused fields keep their defaults.
struct Primitive {
  Shape shape = Shape::kRoundCone;
  Operation operation = Operation::kAdd;
  uint16_t label = 0;  ///< the caller's; see Solid::labelAt
  double blend = 0.0;  ///< width over which the surface is rounded where this meets what came before
  glm::dvec3 a{0.0}, b{0.0};
  double radius_a = 0.0, radius_b = 0.0;
  glm::dvec3 flat_axis{0.0, 0.0, 1.0};
  double flat_factor = 1.0;
  glm::dmat3 frame{1.0};
  glm::dvec3 radii{1.0};
  double ridge_count = 0.0, ridge_height = 0.0;
};

Primitive roundCone(const glm::dvec3& a, double radius_a, const glm::dvec3& b, double radius_b, double blend);
Primitive ellipsoid(const glm::dvec3& center, const glm::dvec3& radii, double blend);
Primitive lens(const glm::dvec3& center, double half_width, double half_height, double blend);
/// The same primitive on the other side of the plane x = 0.
Primitive mirrored(const Primitive& primitive);

/// A list of primitives applied in order.
class Solid {
 public:
  void add(const Primitive& primitive);
  void cut(Primitive primitive);
  /// Adds the primitive and its mirror image.
  void addPair(const Primitive& primitive);
  void cutPair(const Primitive& primitive);

  /// Indices of the primitives that can matter within `radius` of `center`, for points near the surface.
  std::vector<uint32_t> activeNear(const glm::dvec3& center, double radius) const;

  /// Those of `candidates` (ascending) that can matter within `reach` of a point near the surface; a closer look than
  /// activeNear().
  std::vector<uint32_t> activeAt(const glm::dvec3& point, double reach, std::span<const uint32_t> candidates) const;

  Sample sample(const glm::dvec3& point, std::span<const uint32_t> active) const;

  /// The label of the added primitive that is nearest by its own distance.
  uint16_t labelAt(const glm::dvec3& point, std::span<const uint32_t> active) const;

  /// The box of all added primitives.
  void bounds(glm::dvec3& low, glm::dvec3& high) const;

 private:
  std::vector<Primitive> primitives_;
  double widest_blend_ = 0.0;
};

}  // namespace lithe::bake::implicit
