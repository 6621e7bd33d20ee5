// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The base page: the coarsest cut, given outright.
#pragma once

#include "page_streams.h"

namespace lithe::runtime {

/// Fills the (empty) arrays. Returns the check that failed, 0 when all is well.
uint32_t decodeBase(const PageFormat& format, const PagePlan& plan, PageStreams* streams, Decoded* decoded);

/// Puts a corner in front of its node's list.
inline void linkCorner(Decoded* decoded, uint32_t corner) {
  const uint32_t node = decoded->wedge_node[decoded->face_wedges[corner]];
  decoded->corner_next[corner] = decoded->node_first_corner[node];
  decoded->node_first_corner[node] = corner;
}

}  // namespace lithe::runtime
