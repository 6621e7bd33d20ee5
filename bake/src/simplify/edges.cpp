// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "edges.h"

#include <algorithm>

namespace lithe::bake {

namespace {

std::vector<std::array<uint32_t, 2>> sortedPairs(const Surface& surface) {
  std::vector<std::array<uint32_t, 2>> pairs;
  pairs.reserve(size_t{3} * surface.faceCount());
  for (uint32_t id = 0; id < surface.faceCount(); ++id) {
    const auto& corner = surface.face(id).corner;
    for (uint32_t k = 0; k < 3; ++k) {
      const uint32_t a = corner[k], b = corner[(k + 1) % 3];
      pairs.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

std::vector<uint32_t> edgesPerSlot(const std::vector<std::array<uint32_t, 2>>& ends, uint32_t slot_count) {
  std::vector<uint32_t> count(slot_count, 0);
  for (const auto& pair : ends) {
    for (uint32_t slot : pair) ++count[slot];
  }
  return count;
}

}  // namespace

Edges::Edges(const Surface& surface, uint32_t slot_count)
    : ends(sortedPairs(surface)), at(edgesPerSlot(ends, slot_count)) {
  for (uint32_t edge = 0; edge < count(); ++edge) {
    for (uint32_t slot : ends[edge]) at.append(slot, edge);
  }
}

}  // namespace lithe::bake
