// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "transform.h"

#include <algorithm>
#include <cmath>

namespace lithe::bake {

namespace {

/// Cosine between columns that still counts as a right angle.
constexpr double kRightAngle = 1e-4;
constexpr double kFlattest = 1e-6;

}  // namespace

Transform decompose(const glm::dmat4& matrix, bool& sheared) {
  Transform transform;
  transform.translation = glm::dvec3(matrix[3]);
  glm::dmat3 axes(matrix);
  for (int i = 0; i < 3; ++i) transform.scale[i] = glm::length(axes[i]);
  if (glm::determinant(axes) < 0.0) transform.scale.x = -transform.scale.x;
  sheared = false;
  if (transform.scale.x == 0.0 || transform.scale.y == 0.0 || transform.scale.z == 0.0) return transform;
  for (int i = 0; i < 3; ++i) axes[i] /= transform.scale[i];
  for (int i = 0; i < 3; ++i) sheared = sheared || std::abs(glm::dot(axes[i], axes[(i + 1) % 3])) > kRightAngle;
  // Gram-Schmidt: keep the first axis, straighten the others.
  axes[1] = glm::normalize(axes[1] - axes[0] * glm::dot(axes[0], axes[1]));
  axes[2] = glm::cross(axes[0], axes[1]);
  transform.rotation = glm::normalize(glm::quat_cast(axes));
  return transform;
}

double lengthScale(const glm::dmat4& matrix) { return std::cbrt(std::abs(glm::determinant(glm::dmat3(matrix)))); }

bool mirrors(const glm::dmat4& matrix) { return invertible(matrix) && glm::determinant(glm::dmat3(matrix)) < 0.0; }

bool invertible(const glm::dmat4& matrix) {
  const glm::dmat3 linear(matrix);
  double longest = 0.0;
  for (int i = 0; i < 3; ++i) longest = std::max(longest, glm::length(linear[i]));
  const double volume = std::abs(glm::determinant(linear));
  return std::isfinite(volume) && longest > 0.0 && volume > kFlattest * longest * longest * longest;
}

}  // namespace lithe::bake
