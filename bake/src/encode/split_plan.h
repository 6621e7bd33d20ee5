// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// What a split does to the fan of its node.
#pragma once

#include <cstdint>
#include <vector>

#include "lithe/bake/octahedral_difference.h"
#include "lithe/format/page.h"

namespace lithe::bake {

struct SplitPlan {
  struct NewFace {
    uint32_t triangle;
    uint32_t rotation;  ///< so that corner 0 is at the child before the cut vertex, 1 at the cut vertex, 2 at the child
                        ///< after
    uint32_t third;     ///< file node of corner 1
    bool first_is_a;    ///< corner 0 is at child A
    uint32_t ring_at;   ///< position of the cut vertex in the ring, kNone where faces are listed
  };

  uint32_t a, b;               ///< hierarchy nodes of the children
  int32_t t8;                  ///< from b (0) to a (8)
  bool listed;                 ///< sides and faces one by one
  std::vector<char> at_b;      ///< per fan corner
  std::vector<NewFace> faces;  ///< in the order of the file

  uint32_t child(bool of_b) const { return of_b ? b : a; }
  DirectionRule directionRule(int32_t normal_center) const { return {normal_center, t8, !faces.empty()}; }
};

}  // namespace lithe::bake
