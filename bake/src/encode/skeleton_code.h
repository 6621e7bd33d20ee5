// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Rotations and scales as the head stores them (docs/format.md, NODE, JOIN, SCAL).
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <vector>

namespace lithe::bake {

/// A unit quaternion without its largest component, of the two of that rotation the one where that is not negative.
struct StoredRotation {
  uint32_t left_out = 3;  ///< 0..3: x y z w; of equal ones the last
  glm::dvec3 kept = glm::dvec3(0.0);
};
StoredRotation storedRotation(const glm::dquat& rotation);

/// The kept components as the head's 64 bits: each at most 3.6e-7 away.
uint64_t rotationFields(const StoredRotation& rotation);

using StoredScale = std::array<float, 6>;  ///< xx, yy, zz, xy, xz, yz

/// A matrix as rotation * upper triangle (QR by Gram and Schmidt); the mirrored ones have a negative zz.
struct RotationAndScale {
  glm::dquat rotation;
  std::array<double, 6> scale;
};
RotationAndScale rotationAndScale(const glm::dmat3& matrix);

/// The scales of a character, each once. Exporters leave rounding in them: what differs from one that is there by less
/// than 2^-20 of its size is that one, a sixteenth of the step of the finest grid.
class ScalePool {
 public:
  uint32_t add(const std::array<double, 6>& scale);
  uint32_t add(const glm::dvec3& scale);  ///< of a node: never one with shear
  const std::vector<StoredScale>& all() const { return scales_; }

 private:
  uint32_t addStored(const StoredScale& scale);

  std::vector<StoredScale> scales_;
};

}  // namespace lithe::bake
