// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// What an instance asks of its asset's levels, shared by both ways of choosing one.
///
/// An error e of a level is e * demand thresholds on the screen, where demand is the largest over the views. A level is
/// good enough where e * demand <= factor; the factor is 1, or what a budget makes of it.
#pragma once

#include <float.h>
#include <math.h>

#include "asset.h"
#include "crowd.h"

namespace lithe::runtime {

/// A view, as far as it does not depend on the instance.
struct Projection {
  float position[3];
  float near_distance;
  float per_error;  ///< thresholds that a unit of error takes: at distance 1, or anywhere for an orthographic view
  float keep;       ///< 1 / (1 - hysteresis)
  bool is_flat;     ///< orthographic
  bool culls;
  const lithe_view* view;
};

/// False when something is out of its range.
bool readViews(const lithe_view* views, uint32_t view_count, Projection* projections);

/// What is demanded of an instance's levels.
struct Demand {
  float fresh;    ///< of levels finer than the current one
  float held;     ///< of the others: hysteresis holds on to what is there
  uint8_t views;  ///< that see the instance; 0: nothing is demanded
};

inline bool sees(const lithe_view& view, const lithe_instance& instance, float center_distance) {
  const float *const c = instance.center, across = 2 * instance.radius;
  for (uint32_t k = 0; k < view.plane_count; ++k) {
    const float* p = view.planes[k];
    if (p[0] * c[0] + p[1] * c[1] + p[2] * c[2] + p[3] < -instance.radius) return false;
  }
  if (view.pixels_per_radian == 0) return !(across * view.pixels_per_unit < view.least_px);
  const float distance = center_distance > view.near_distance ? center_distance : view.near_distance;
  return !(across * view.pixels_per_radian < view.least_px * distance);
}

inline float distanceTo(const Projection& projection, const lithe_instance& instance) {
  const float x = instance.center[0] - projection.position[0], y = instance.center[1] - projection.position[1],
              z = instance.center[2] - projection.position[2];
  return sqrtf(x * x + y * y + z * z);
}

/// No error times a finite number is no number.
inline float finite(float value) { return value < FLT_MAX ? value : FLT_MAX; }

/// Thresholds that a unit of the asset's error takes on a view's screen.
inline float thresholdsPerError(const Projection& projection, const lithe_instance& instance, float center_distance) {
  const float distance = center_distance - instance.radius;
  const float away = distance > projection.near_distance ? distance : projection.near_distance;
  const float demand = instance.scale * instance.bias * projection.per_error / (projection.is_flat ? 1 : away);
  return demand > 0 ? finite(demand) : 0;
}

/// Of one view that sees everything.
inline Demand demandOf(const Projection& projection, const lithe_instance& instance) {
  const float fresh = thresholdsPerError(projection, instance, distanceTo(projection, instance));
  return {fresh, finite(fresh * projection.keep), 1};
}

/// Of the views that see the instance: the largest.
inline Demand demandOf(const Projection* projections, uint32_t view_count, const lithe_instance& instance) {
  Demand demand = {0, 0, 0};
  for (uint32_t v = 0; v < view_count; ++v) {
    const Projection& projection = projections[v];
    const float center_distance = distanceTo(projection, instance);
    if (projection.culls && !sees(*projection.view, instance, center_distance)) continue;
    const float fresh = thresholdsPerError(projection, instance, center_distance),
                held = finite(fresh * projection.keep);
    demand.fresh = fresh > demand.fresh ? fresh : demand.fresh;
    demand.held = held > demand.held ? held : demand.held;
    demand.views = static_cast<uint8_t>(demand.views | 1u << v);
  }
  return demand;
}

/// Calls work with what gives an instance's demand. One view that culls nothing, which is common, has its own loop.
template <typename Work>
bool withDemands(const Projection* projections, uint32_t view_count, Work work) {
  if (view_count == 1 && !projections[0].culls) {
    const Projection only = projections[0];
    return work([only](const lithe_instance& instance) { return demandOf(only, instance); });
  }
  return work([=](const lithe_instance& instance) { return demandOf(projections, view_count, instance); });
}

inline float errorOf(const lithe_asset& asset, uint32_t level) { return asset.choices[level + 1].coarser_error; }

/// The levels that an instance may have, with what is resident left aside.
struct LevelBounds {
  uint32_t first, last;
};

inline LevelBounds boundsOf(const lithe_asset& asset, const lithe_instance& instance) {
  const uint32_t finest = asset.level_count - 1;
  const uint32_t last = instance.end_level == 0 || instance.end_level > finest ? finest : instance.end_level - 1u;
  return {instance.first_level < last ? instance.first_level : last, last};
}

/// Whether the current level is still the one: good enough, and the next coarser one not better by the hysteresis.
/// Without branches: levels are as mixed as the crowd, that they stay is what can be foreseen.
inline bool keepsLevel(const lithe_asset& asset, uint32_t current, const Demand& demand, float factor) {
  const bool is_one = current < asset.level_count;
  const uint32_t level = is_one ? current : 0;
  return is_one & (errorOf(asset, level) * demand.fresh <= factor) &
         !(asset.choices[level].coarser_error * demand.held <= factor);
}

/// The level for a demand that the current one does not meet, or more than meets.
uint32_t changedLevel(const lithe_asset& asset, uint32_t current, Demand demand, float factor);

/// The level that an instance would have if all were resident.
inline uint32_t likedLevel(const lithe_asset& asset, const lithe_instance& instance, const Demand& demand,
                           float factor) {
  uint32_t level = instance.level;
  if (!keepsLevel(asset, level, demand, factor)) level = changedLevel(asset, level, demand, factor);
  const LevelBounds bounds = boundsOf(asset, instance);
  return level < bounds.first ? bounds.first : level > bounds.last ? bounds.last : level;
}

/// Writes what has changed only: most instances keep their level, and a crowd is larger than a cache.
inline void giveLevel(lithe_instance* instance, uint32_t level, uint8_t views) {
  if (instance->level != level) instance->level = static_cast<uint8_t>(level);
  if (instance->views != views) instance->views = views;
}

/// An instance that no view sees keeps its level for when it is seen again.
inline void leaveUnseen(lithe_instance* instance, lithe_select_stats* stats) {
  giveLevel(instance, instance->level, 0);
  ++stats->unseen;
}

inline void addStats(const lithe_select_stats& more, lithe_select_stats* stats) {
  if (!stats) return;
  stats->triangles += more.triangles;
  stats->undrawable += more.undrawable;
  stats->limited += more.limited;
  stats->unseen += more.unseen;
}

/// Gives a seen instance its level, and notes that and which one it would have liked.
inline void giveSeen(const lithe_asset& asset, lithe_instance* instance, uint8_t views, uint32_t level, uint32_t liked,
                     uint32_t* wanted_levels, lithe_select_stats* stats) {
  giveLevel(instance, level, views);
  if (wanted_levels && liked > wanted_levels[instance->asset]) wanted_levels[instance->asset] = liked;
  const bool drawn = level != LITHE_UNDRAWN;
  stats->triangles += drawn ? asset.choices[level].triangles : 0;
  stats->undrawable += !drawn;
  stats->limited += liked != level;
}

inline bool crowdIsSound(const lithe_crowd& crowd) {
  return instancesAreSound(crowd) && (crowd.assets || !crowd.asset_count);
}

/// NULL when there is no such asset.
inline const lithe_asset* assetOf(const lithe_crowd& crowd, const lithe_instance& instance) {
  return instance.asset < crowd.asset_count ? crowd.assets[instance.asset] : nullptr;
}

}  // namespace lithe::runtime
