// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Joints and weights as files have them, made into valid influences.
#pragma once

#include "draft.h"
#include "primitive.h"

namespace lithe::bake {

/// The joints of one skin within Draft::joints.
struct JointRange {
  uint32_t first = 0, count = 0;
};

/// Counts what had to be repaired, for one warning each.
class SkinRepairs {
 public:
  void addTo(std::vector<std::string>& warnings) const;

  uint64_t not_normalized = 0;   ///< vertices whose weights do not sum to one
  uint64_t without_weights = 0;  ///< vertices bound to the first joint
  uint64_t negative = 0;         ///< weights
  uint64_t foreign_joints = 0;   ///< influences of joints that the skin lacks
  uint64_t too_many = 0;         ///< vertices with more influences than are kept
};

/// The JOINTS_n and WEIGHTS_n of a primitive.
class InfluenceArrays {
 public:
  /// Throws Error if the arrays of a set are not of glTF's types.
  InfluenceArrays(const GltfFile& file, const PrimitiveArrays& arrays, JointRange joints, std::string place);

  /// The influences of a vertex: weights > 0 that sum to 1. Throws Error for a weight that is not a number.
  FileSkin read(uint64_t vertex, SkinRepairs& repairs) const;

 private:
  struct Influence {
    uint32_t joint;
    double weight;
  };
  std::vector<Influence> collect(uint64_t vertex, SkinRepairs& repairs) const;
  double checkedWeight(uint64_t vertex, double weight, SkinRepairs& repairs) const;

  const GltfFile& file_;
  JointRange joints_;
  std::string place_;
  std::vector<AccessorView> joint_sets_, weight_sets_;
};

}  // namespace lithe::bake
