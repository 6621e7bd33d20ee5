// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "arguments.h"
#include "selection.h"

namespace lithe::runtime {
namespace {

bool isSound(const lithe_view& view) {
  const bool projects = view.pixels_per_radian > 0 || (view.pixels_per_radian == 0 && view.pixels_per_unit > 0);
  return projects && view.near_distance > 0 && view.threshold_px > 0 && view.hysteresis >= 0 &&
         view.hysteresis <= 0.9f && view.least_px >= 0 && view.plane_count <= LITHE_MAX_PLANES;
}

inline void selectOne(const lithe_asset& asset, const Demand& demand, lithe_instance* instance, uint32_t* wanted_levels,
                      lithe_select_stats* stats) {
  if (demand.views == 0) return leaveUnseen(instance, stats);
  const uint32_t liked = likedLevel(asset, *instance, demand, 1), resident = asset.resident_level;
  const uint32_t level = resident == LITHE_NO_LEVEL ? LITHE_UNDRAWN : liked < resident ? liked : resident;
  giveSeen(asset, instance, demand.views, level, liked, wanted_levels, stats);
}

/// False when an instance's asset is not one.
template <typename DemandOf>
bool selectAll(const lithe_crowd& crowd, DemandOf demand_of, uint32_t* wanted_levels, lithe_select_stats* stats) {
  InstanceCursor instances(crowd);
  for (uint32_t i = 0; i < crowd.instance_count; ++i) {
    lithe_instance* instance = instances.next();
    const lithe_asset* asset = assetOf(crowd, *instance);
    if (!asset) return false;
    selectOne(*asset, demand_of(*instance), instance, wanted_levels, stats);
  }
  return true;
}

/// The coarsest level whose error is within the factor, the finest when there is none: errors never grow from a level
/// to the next.
uint32_t coarsestWithin(const lithe_asset& asset, float demand, float factor) {
  uint32_t level = 0;
  while (level + 1 < asset.level_count && !(errorOf(asset, level) * demand <= factor)) ++level;
  return level;
}

}  // namespace

uint32_t changedLevel(const lithe_asset& asset, uint32_t current, Demand demand, float factor) {
  const uint32_t level = coarsestWithin(asset, demand.fresh, factor);
  if (level >= current || current >= asset.level_count) return level;
  const uint32_t surely = coarsestWithin(asset, demand.held, factor);
  return surely < current ? surely : current;
}

bool readViews(const lithe_view* views, uint32_t view_count, Projection* projections) {
  if (!views || view_count == 0 || view_count > LITHE_MAX_VIEWS) return false;
  for (uint32_t v = 0; v < view_count; ++v) {
    const lithe_view& view = views[v];
    if (!isSound(view)) return false;
    const bool flat = view.pixels_per_radian == 0;
    projections[v] = {{view.position[0], view.position[1], view.position[2]},
                      view.near_distance,
                      (flat ? view.pixels_per_unit : view.pixels_per_radian) / view.threshold_px,
                      1 / (1 - view.hysteresis),
                      flat,
                      view.plane_count > 0 || view.least_px > 0,
                      &view};
  }
  return true;
}

}  // namespace lithe::runtime

using namespace lithe::runtime;  // NOLINT: the C function below is the outside of this namespace

lithe_result lithe_select(const lithe_crowd* crowd, const lithe_view* views, uint32_t view_count,
                          uint32_t* wanted_levels, lithe_select_stats* stats) {
  Projection projections[LITHE_MAX_VIEWS];
  if (!crowd || !crowdIsSound(*crowd) || !readViews(views, view_count, projections)) return invalidArgument();
  lithe_select_stats own = {};  // in registers: what the caller gave might be anything that is read here
  const bool done = withDemands(projections, view_count,
                                [&](auto demand_of) { return selectAll(*crowd, demand_of, wanted_levels, &own); });
  addStats(own, stats);
  return done ? LITHE_OK : invalidArgument();
}
