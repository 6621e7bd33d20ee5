// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "edges.h"

#include <algorithm>

namespace lithe::bake {

namespace {

LargeVector<std::array<uint32_t, 2>> sortedPairs(const Surface& surface, uint32_t slot_count) {
  LargeVector<std::array<uint32_t, 2>> pairs;
  pairs.reserve(size_t{3} * surface.faceCount() / 2 + slot_count);
  std::vector<uint32_t> higher;
  for (uint32_t slot = 0; slot < slot_count; ++slot) {
    higher.clear();
    for (uint32_t id : surface.facesAt(slot)) {
      for (uint32_t other : surface.face(id).corner) {
        if (other > slot) higher.push_back(other);
      }
    }
    std::sort(higher.begin(), higher.end());
    higher.erase(std::unique(higher.begin(), higher.end()), higher.end());
    for (uint32_t other : higher) pairs.push_back({slot, other});
  }
  return pairs;
}

std::vector<uint32_t> edgesPerSlot(const LargeVector<std::array<uint32_t, 2>>& ends, uint32_t slot_count) {
  std::vector<uint32_t> count(slot_count, 0);
  for (const auto& pair : ends) {
    for (uint32_t slot : pair) ++count[slot];
  }
  return count;
}

}  // namespace

Edges::Edges(const Surface& surface, uint32_t slot_count)
    : ends(sortedPairs(surface, slot_count)), at(edgesPerSlot(ends, slot_count)) {
  for (uint32_t edge = 0; edge < count(); ++edge) {
    for (uint32_t slot : ends[edge]) at.append(slot, edge);
  }
}

}  // namespace lithe::bake
