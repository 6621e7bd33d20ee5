// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The pairs of live nodes that share a triangle.
#pragma once

#include <array>
#include <vector>

#include "large_vector.h"
#include "list_pool.h"
#include "surface.h"

namespace lithe::bake {

struct Edges {
  LargeVector<std::array<uint32_t, 2>> ends;  // per edge, slots; kNone when the edge is gone
  ListPool at;                                // per slot: its edges

  Edges() = default;
  /// In ascending order of (lower, higher slot).
  Edges(const Surface& surface, uint32_t slot_count);

  uint32_t count() const { return static_cast<uint32_t>(ends.size()); }
  bool alive(uint32_t edge) const { return ends[edge][0] != kNone; }
  uint32_t other(uint32_t edge, uint32_t slot) const { return ends[edge][0] == slot ? ends[edge][1] : ends[edge][0]; }
  uint32_t find(uint32_t a, uint32_t b) const {
    for (uint32_t edge : at[a]) {
      if (other(edge, a) == b) return edge;
    }
    return kNone;
  }
  void remove(uint32_t edge) {
    for (uint32_t slot : ends[edge]) at.remove(slot, edge);
    ends[edge] = {kNone, kNone};
  }
};

}  // namespace lithe::bake
