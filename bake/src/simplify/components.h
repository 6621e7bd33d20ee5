// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// What is lost when a connected component disappears: its area times the squared distance to what would be left.
#pragma once

#include <vector>

#include "posed_mesh.h"
#include "surface.h"

namespace lithe::bake {

/// A quadric says nothing about a surface that vanishes: it measures distances to planes that reach to infinity.
class Components {
 public:
  /// Of the surface as it is now, in the first pose.
  Components(const Surface& surface, const PosedMesh& posed);

  /// pose_count * sum over the faces of area * squared distance to the nearest face of another component; the posed
  /// diagonal stands for the distance where there is none. Found on first use, from at most 300 faces.
  double lossOf(uint32_t slot);

 private:
  struct Triangle {
    glm::vec3 a, b, c;
    uint32_t component;
  };
  struct Box {
    glm::vec3 lower, upper;
    uint32_t begin, end;      // of sorted_
    uint32_t left, right;     // kNone at leaves
    uint32_t only_component;  // kNone when several
  };

  uint32_t buildBox(uint32_t begin, uint32_t end);
  double squaredDistanceToOthers(const glm::vec3& point, uint32_t component) const;

  uint32_t pose_count_;
  std::vector<uint32_t> component_;  // per slot
  std::vector<double> loss_;         // per component, negative: not known yet
  std::vector<Triangle> triangles_;
  std::vector<uint32_t> first_, members_;  // triangles by component: members_[first_[c] .. first_[c + 1])
  std::vector<uint32_t> sorted_;           // triangles by box
  std::vector<Box> boxes_;
};

}  // namespace lithe::bake
