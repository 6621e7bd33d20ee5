// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/simplify.h"

#include <algorithm>

#include "collapser.h"

namespace lithe::bake {

CollapseSequence simplify(const Mesh& mesh, const std::vector<Joint>& joints, const std::vector<Pose>& poses,
                          const SimplifyOptions& options) {
  Collapser collapser(mesh, palettesOf(options.metric, joints, poses), options);
  collapser.placeAllEdges();
  const uint32_t from = collapser.triangleCount();
  std::vector<uint32_t> refit_at = options.refit_at;
  std::sort(refit_at.begin(), refit_at.end());
  CollapseSequence sequence;
  while (collapser.triangleCount() > options.min_triangles) {
    Collapse collapse;
    if (!collapser.collapseNext(collapse)) break;
    // The last collapse of a closed surface takes two triangles at once.
    if (collapse.triangles == 0 && options.min_triangles > 0) break;
    sequence.collapses.push_back(collapse);
    if (!refit_at.empty() && collapse.triangles <= refit_at.back()) {
      collapser.refit(sequence.collapses);
      while (!refit_at.empty() && collapse.triangles <= refit_at.back()) refit_at.pop_back();
    }
    if (options.progress && sequence.collapses.size() % 1024 == 0) {
      options.progress(double(from - collapse.triangles) / (from - options.min_triangles));
    }
  }
  if (options.progress) options.progress(1.0);
  return sequence;
}

}  // namespace lithe::bake
