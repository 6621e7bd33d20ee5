// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "skeleton_code.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "lithe/bake/model.h"
#include "lithe/format/file.h"

namespace lithe::bake {
namespace {

constexpr StoredScale kNoScale = {1.0f, 1.0f, 1.0f, 0.0f, 0.0f, 0.0f};
constexpr double kSameScale = 0x1p-20;

bool isNear(const std::array<double, 6>& a, const StoredScale& b) {
  double size = 0.0, difference = 0.0;
  for (size_t i = 0; i < 6; ++i) {
    size = std::max(size, std::abs(double{b[i]}));
    difference = std::max(difference, std::abs(a[i] - double{b[i]}));
  }
  return difference < kSameScale * size;
}

bool isPure(const StoredScale& scale) { return scale[3] == 0.0f && scale[4] == 0.0f && scale[5] == 0.0f; }

/// The direction of v, or any at right angles to `other` where v is too short to have one.
glm::dvec3 directionOr(const glm::dvec3& v, double size, const glm::dvec3& other) {
  const double length = glm::length(v);
  if (length > 1e-12 * size) return v / length;
  glm::dvec3 axis(0.0);
  const glm::dvec3 a = glm::abs(other);
  axis[a.x <= a.y && a.x <= a.z ? 0 : a.y <= a.z ? 1 : 2] = 1.0;
  return glm::normalize(axis - glm::dot(axis, other) * other);
}

}  // namespace

StoredRotation storedRotation(const glm::dquat& rotation) {
  std::array<double, 4> q = {rotation.x, rotation.y, rotation.z, rotation.w};
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (!(length > 0.0)) return {};
  StoredRotation stored;
  for (uint32_t i = 4; i-- > 0;)
    if (std::abs(q[i]) > std::abs(q[stored.left_out])) stored.left_out = i;
  const double sign = q[stored.left_out] < 0.0 ? -1.0 : 1.0;
  for (int i = 0, to = 0; i < 4; ++i)
    if (static_cast<uint32_t>(i) != stored.left_out) stored.kept[to++] = sign * q[i] / length;
  return stored;
}

uint64_t rotationFields(const StoredRotation& rotation) {
  uint64_t fields = 0;
  for (uint32_t i = 0; i < 3; ++i) {
    const double steps = rotation.kept[static_cast<int>(i)] * 4194304.0 / 3.0;
    const int64_t field = format::kRotationCenter + static_cast<int64_t>(std::llround(steps));
    fields |= static_cast<uint64_t>(field) << (format::kRotationFieldBits * i);
  }
  return fields;
}

RotationAndScale rotationAndScale(const glm::dmat3& matrix) {
  const double size = glm::length(matrix[0]) + glm::length(matrix[1]) + glm::length(matrix[2]);
  glm::dmat3 axes(0.0);
  axes[0] = directionOr(matrix[0], size, glm::dvec3(0.0, 0.0, 1.0));
  const double xy = glm::dot(axes[0], matrix[1]);
  axes[1] = directionOr(matrix[1] - xy * axes[0], size, axes[0]);
  axes[2] = glm::cross(axes[0], axes[1]);
  return {glm::quat_cast(axes),
          {glm::dot(axes[0], matrix[0]), glm::dot(axes[1], matrix[1]), glm::dot(axes[2], matrix[2]), xy,
           glm::dot(axes[0], matrix[2]), glm::dot(axes[1], matrix[2])}};
}

uint32_t ScalePool::add(const std::array<double, 6>& scale) {
  const bool pure = scale[3] == 0.0 && scale[4] == 0.0 && scale[5] == 0.0;
  if (isNear(scale, kNoScale)) return addStored(kNoScale);
  for (size_t i = 0; i < scales_.size(); ++i)
    if (isNear(scale, scales_[i]) && (!pure || isPure(scales_[i]))) return static_cast<uint32_t>(i);
  StoredScale stored;
  std::transform(scale.begin(), scale.end(), stored.begin(), [](double v) { return static_cast<float>(v); });
  return addStored(stored);
}

uint32_t ScalePool::add(const glm::dvec3& scale) { return add({scale.x, scale.y, scale.z, 0.0, 0.0, 0.0}); }

uint32_t ScalePool::addStored(const StoredScale& scale) {
  const auto found = std::find(scales_.begin(), scales_.end(), scale);
  if (found != scales_.end()) return static_cast<uint32_t>(found - scales_.begin());
  if (scales_.size() == format::limits::kScales)
    throw Error("the file format holds at most " + std::to_string(format::limits::kScales) +
                " different scales of nodes and joints together, this character has more");
  scales_.push_back(scale);
  return static_cast<uint32_t>(scales_.size() - 1);
}

}  // namespace lithe::bake
