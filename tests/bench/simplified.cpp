// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "simplified.h"

#include <algorithm>
#include <ctime>

#include "lithe/bake/simplify.h"
#include "lithe/bake/weld.h"
#include "pipeline/attribute_choice.h"
#include "pipeline/levels.h"
#include "pipeline/weight_bits.h"

namespace lithe::bench {
namespace {

bake::Mesh welded(const bake::Model& model, const std::vector<bake::Pose>& poses, const bake::BakeOptions& options) {
  bake::WeldOptions weld;
  std::vector<std::string> warnings;
  weld.max_influences = options.max_influences;
  weld.position_bits = options.position_bits;
  weld.weight_bits = bake::chooseWeightBits(model, poses, options.position_bits);
  weld.attributes = bake::chooseAttributes(model, {}, warnings);
  return bake::weld(model, poses, weld, warnings);
}

}  // namespace

uint32_t Simplified::triangles(double share) const { return bake::trianglesOf(share, mesh); }

Simplified simplified(const bake::Model& model, const std::vector<bake::Pose>& poses,
                      const bake::BakeOptions& options) {
  Simplified result;
  result.mesh = welded(model, poses, options);
  bake::SimplifyOptions simplify;
  simplify.metric = options.metric;
  simplify.placement_shift = options.precision;
  simplify.refit = options.refit;
  simplify.threads = 1;
  for (const double share : options.levels) simplify.levels.push_back(result.triangles(share));
  simplify.min_triangles = *std::min_element(simplify.levels.begin(), simplify.levels.end());
  const std::clock_t begin = std::clock();
  result.sequence = bake::simplify(result.mesh, model.joints, poses, simplify);
  result.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  return result;
}

}  // namespace lithe::bench
