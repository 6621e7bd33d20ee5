// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// What is lost when a connected component disappears: its area times the squared distance to what would be left.
#pragma once

#include <array>
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
  };
  struct Box {
    glm::vec3 lower, upper;
    uint32_t begin, end;      // of sorted_
    uint32_t left, right;     // kNone at leaves, and until a search comes by
    uint32_t only_component;  // kNone when several
  };

  uint32_t componentOf(uint32_t face) const { return component_[corner_[face][0]]; }
  Triangle triangle(uint32_t face) const;
  void sortByComponent();
  void startTree();
  uint32_t addBox(uint32_t begin, uint32_t end);
  bool split(uint32_t box);
  double squaredDistanceToOthers(const glm::vec3& point, uint32_t component);

  uint32_t pose_count_;
  std::vector<uint32_t> component_;              // per slot
  std::vector<double> loss_;                     // per component, negative: not known yet
  std::vector<glm::vec3> position_;              // per slot, in the first pose
  std::vector<std::array<uint32_t, 3>> corner_;  // per face: slots

  // Made when the first loss is asked for: most characters of one component never do.
  std::vector<uint32_t> first_, members_;  // faces by component: members_[first_[c] .. first_[c + 1])
  std::vector<uint32_t> sorted_;           // faces by box
  std::vector<glm::vec3> thrice_centre_;   // per face
  std::vector<Box> boxes_;                 // none where there is one component only; split as searches need it
};

}  // namespace lithe::bake
