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
  std::vector<uint32_t> levels = options.levels;
  std::sort(levels.begin(), levels.end());
  CollapseSequence sequence;
  sequence.collapses.reserve(mesh.vertexCount());
  while (collapser.triangleCount() > options.min_triangles) {
    Collapse collapse;
    if (!collapser.collapseNext(collapse)) break;
    sequence.collapses.push_back(collapse);
    if (!levels.empty() && collapse.triangles <= levels.back()) {
      collapser.endLevel(sequence.collapses);
      while (!levels.empty() && collapse.triangles <= levels.back()) levels.pop_back();
    }
    if (options.progress && sequence.collapses.size() % 1024 == 0) {
      options.progress(double(from - collapse.triangles) / (from - options.min_triangles));
    }
  }
  collapser.endLevel(sequence.collapses);
  if (options.progress) options.progress(1.0);
  return sequence;
}

}  // namespace lithe::bake
