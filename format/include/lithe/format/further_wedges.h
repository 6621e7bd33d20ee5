// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// What a class's further wedges at a child of a split are predicted from: the faces that they have there.
#pragma once

#include <stdint.h>

#include "lithe/format/file.h"
#include "lithe/format/page.h"
#include "lithe/format/prediction.h"

namespace lithe::format {

/// The corners at a child once they have gone there and the new faces are made.
class ChildCorners {
 public:
  void clear() { count_ = 0; }

  /// Adds a corner: its wedge, and wedges and positions of its face's next and previous corner. Returns false beyond
  /// kMaxRing of them: then the child counts as having none.
  bool add(uint32_t wedge, const uint32_t others[2], const Int3 at[2]) {
    if (count_ == kMaxRing) {
      count_ = 0;
      return false;
    }
    wedge_[count_] = wedge;
    for (uint32_t step = 0; step < 2; ++step) {
      other_[step][count_] = others[step];
      at_[step][count_] = at[step];
    }
    ++count_;
    return true;
  }

  /// Of a wedge's faces, seen from the child's position; zero without faces.
  AreaNormal normalOf(uint32_t wedge, Int3 child) const {
    AreaNormal normal;
    for (uint32_t i = 0; i < count_; ++i)
      if (wedge_[i] == wedge) normal.add(child, at_[0][i], at_[1][i]);
    return normal;
  }

  /// Of the wedges at the other corners of a wedge's faces for which known(wedge) is true the nearest, of equally near
  /// ones the lowest; kNoIndex when there is none.
  template <class Known>
  uint32_t nearestTo(uint32_t wedge, Int3 child, const Known& known) const {
    uint32_t nearest = kNoIndex;
    int64_t least = 0;
    for (uint32_t i = 0; i < count_; ++i) {
      if (wedge_[i] != wedge) continue;
      for (uint32_t step = 0; step < 2; ++step) {
        const uint32_t other = other_[step][i];
        if (!known(other)) continue;
        const Int3 r = minus(at_[step][i], child);
        const int64_t distance = int64_t{r.x} * r.x + int64_t{r.y} * r.y + int64_t{r.z} * r.z;
        if (nearest != kNoIndex && (distance > least || (distance == least && other >= nearest))) continue;
        nearest = other;
        least = distance;
      }
    }
    return nearest;
  }

 private:
  uint32_t count_ = 0;
  uint32_t wedge_[kMaxRing];
  uint32_t other_[2][kMaxRing];
  Int3 at_[2][kMaxRing];
};

}  // namespace lithe::format
