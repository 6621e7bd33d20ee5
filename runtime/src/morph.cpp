// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "arguments.h"
#include "selection.h"

namespace lithe::runtime {
namespace {

/// @param beyond  how many thresholds the coarser level's error is above the first
float morphOf(float beyond, float width) { return beyond <= 0 ? 1.0f : beyond < width ? 1.0f - beyond / width : 0.0f; }

template <typename DemandOf>
bool morphAll(const lithe_crowd& crowd, DemandOf demand_of, float factor, float width, float* morphs) {
  InstanceCursor instances(crowd);
  for (uint32_t i = 0; i < crowd.instance_count; ++i) {
    const lithe_instance& instance = *instances.next();
    const lithe_asset* asset = assetOf(crowd, instance);
    if (!asset) return false;
    const Demand demand = demand_of(instance);
    const bool morphs_at_all = demand.views != 0 && instance.level > 0 && instance.level < asset->level_count;
    // Without hysteresis: what is drawn must not depend on where an instance came from.
    morphs[i] = morphs_at_all ? morphOf(errorOf(*asset, instance.level - 1u) * demand.fresh / factor - 1, width) : 0.0f;
  }
  return true;
}

}  // namespace
}  // namespace lithe::runtime

using namespace lithe::runtime;  // NOLINT: the C function below is the outside of this namespace

lithe_result lithe_morph_factors(const lithe_crowd* crowd, const lithe_view* views, uint32_t view_count, float factor,
                                 float width, float* morphs) {
  Projection projections[LITHE_MAX_VIEWS];
  if (!crowd || !crowdIsSound(*crowd) || !readViews(views, view_count, projections) || !(factor >= 1) || !(width > 0) ||
      (!morphs && crowd->instance_count))
    return invalidArgument();
  const bool done = withDemands(projections, view_count,
                                [&](auto demand_of) { return morphAll(*crowd, demand_of, factor, width, morphs); });
  return done ? LITHE_OK : invalidArgument();
}
