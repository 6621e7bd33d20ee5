// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// What the children of a split node get for one of its wedges.
#pragma once

#include <stdint.h>

#include "lithe/format/picks.h"

namespace lithe::runtime {

/// [0] is child A's, [1] child B's.
struct WedgeClass {
  uint32_t first[2];  ///< wedge at the child
  format::Members members[2];
  bool has_corners[2];  ///< of the fan

  bool atBoth() const { return members[0].count > 0 && members[1].count > 0; }
  bool lacksCorners() const { return members[0].lacksCorners() || members[1].lacksCorners(); }
};

}  // namespace lithe::runtime
