// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "uv_stretch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lithe::bake {

namespace {

constexpr double kRounding = std::numeric_limits<float>::epsilon();

/// The two edges at a triangle's first corner.
template <typename Vector>
struct Edges {
  explicit Edges(const std::array<Vector, 3>& corners) : ab(corners[1] - corners[0]), ac(corners[2] - corners[0]) {}

  double longest() const { return std::max({glm::length(ab), glm::length(ac), glm::length(ac - ab)}); }

  Vector ab, ac;
};

/// Twice the area, negative where the uvs turn clockwise.
double turn(const Edges<glm::dvec2>& uv) { return uv.ab.x * uv.ac.y - uv.ab.y * uv.ac.x; }

/// Twice the area.
double extent(const Edges<glm::dvec3>& edges) { return glm::length(glm::cross(edges.ab, edges.ac)); }

double largestCoordinate(const std::array<glm::dvec2, 3>& uvs) {
  double largest = 0.0;
  for (const glm::dvec2& uv : uvs) largest = std::max({largest, std::abs(uv.x), std::abs(uv.y)});
  return largest;
}

bool isTextured(const TexturedTriangle& triangle) {
  const Edges<glm::dvec2> uv(triangle.uvs);
  const Edges<glm::dvec3> edges(triangle.positions);
  return std::abs(turn(uv)) > kRounding * largestCoordinate(triangle.uvs) * uv.longest() &&
         extent(edges) > kRounding * edges.longest() * edges.longest();
}

/// The first fundamental form over the texture, J^T J of J = d position / d uv.
struct Form {
  double uu, uv, vv;
  double determinant;  ///< from the areas: uu * vv - uv * uv cancels on long triangles
};

Form formOf(const TexturedTriangle& triangle) {
  const Edges<glm::dvec2> uv(triangle.uvs);
  const Edges<glm::dvec3> edges(triangle.positions);
  const glm::dvec3 along_u = (edges.ab * uv.ac.y - edges.ac * uv.ab.y) / turn(uv);
  const glm::dvec3 along_v = (edges.ac * uv.ab.x - edges.ab * uv.ac.x) / turn(uv);
  const double scale = extent(edges) / turn(uv);
  return {glm::dot(along_u, along_u), glm::dot(along_u, along_v), glm::dot(along_v, along_v), scale * scale};
}

/// max(Gamma, 1 / gamma): the singular values squared are the roots of det(to - root * from) = 0.
double stretchOf(const Form& from, const Form& to) {
  const double middle = to.uu * from.vv + to.vv * from.uu - 2.0 * to.uv * from.uv;
  // middle^2 - 4 det(from) det(to), written so that nothing but rounding is left of it where the roots are equal.
  const double difference = to.uu * from.vv - to.vv * from.uu;
  const double discriminant =
      difference * difference + 4.0 * (to.uu * from.uv - to.uv * from.uu) * (to.vv * from.uv - to.uv * from.vv);
  const double larger = (middle + std::sqrt(std::max(discriminant, 0.0))) / (2.0 * from.determinant);
  const double smaller = to.determinant / (from.determinant * larger);
  return std::sqrt(std::max(larger, 1.0 / smaller));
}

bool isMirrored(const TexturedTriangle& original, const TexturedTriangle& simplified) {
  return (turn(Edges(original.uvs)) < 0.0) != (turn(Edges(simplified.uvs)) < 0.0);
}

}  // namespace

std::optional<double> uvStretch(const TexturedTriangle& original, const TexturedTriangle& simplified) {
  if (!isTextured(original)) return std::nullopt;
  if (!isTextured(simplified) || isMirrored(original, simplified)) return kMostUvStretch;
  return std::clamp(stretchOf(formOf(original), formOf(simplified)), 1.0, kMostUvStretch);
}

}  // namespace lithe::bake
