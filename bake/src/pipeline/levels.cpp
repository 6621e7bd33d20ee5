// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "levels.h"

#include <algorithm>
#include <cmath>

#include "lithe/bake/cut.h"

namespace lithe::bake {

uint32_t trianglesOf(double share, const Mesh& mesh) {
  return static_cast<uint32_t>(std::max(1.0, std::round(share * mesh.triangleCount())));
}

std::vector<LevelPlan> planLevels(const CollapseSequence& sequence, const Mesh& mesh,
                                  const std::vector<double>& shares) {
  std::vector<uint32_t> collapses = {0};
  std::vector<double> descending = shares;
  std::sort(descending.rbegin(), descending.rend());
  for (double share : descending) {
    const uint32_t count = collapsesToReach(sequence, mesh, trianglesOf(share, mesh));
    if (count >= collapses.back() + kMinLevelCollapses) collapses.push_back(count);
  }
  // The sequence's end is the base, whatever the distance to the last level.
  const uint32_t end = static_cast<uint32_t>(sequence.collapses.size());
  if (collapses.back() != end) {
    if (collapses.size() > 1 && end < collapses.back() + kMinLevelCollapses) collapses.pop_back();
    collapses.push_back(end);
  }
  std::vector<LevelPlan> levels;
  for (size_t i = collapses.size(); i-- > 0;) levels.push_back({collapses[i], 0.0, 0.0});
  return levels;
}

}  // namespace lithe::bake
