// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <math.h>

#include "arguments.h"
#include "asset.h"

namespace lithe::runtime {
namespace {

bool isSound(const lithe_view& view) {
  const bool projects = view.pixels_per_radian > 0 || (view.pixels_per_radian == 0 && view.pixels_per_unit > 0);
  return projects && view.near_distance > 0 && view.threshold_px > 0 && view.hysteresis >= 0 && view.hysteresis <= 0.9f;
}

bool allNameAnAsset(const lithe_asset* const* assets, uint32_t asset_count, const lithe_instance* instances,
                    uint32_t instance_count) {
  for (uint32_t i = 0; i < instance_count; ++i)
    if (instances[i].asset >= asset_count || !assets[instances[i].asset]) return false;
  return true;
}

/// Pixels that one bind-space unit of error takes on the screen.
float pixelsPerError(const lithe_view& view, const lithe_instance& instance) {
  const float size = instance.scale * instance.bias;
  if (view.pixels_per_radian == 0) return size * view.pixels_per_unit;
  const float x = instance.center[0] - view.position[0], y = instance.center[1] - view.position[1],
              z = instance.center[2] - view.position[2];
  const float distance = sqrtf(x * x + y * y + z * z) - instance.radius;
  return size * view.pixels_per_radian / (distance > view.near_distance ? distance : view.near_distance);
}

/// The coarsest level whose error is within the threshold, the finest when there is none: errors never grow from a
/// level to the next.
uint32_t coarsestWithin(const lithe_asset& asset, float pixels_per_error, float threshold_px) {
  uint32_t level = 0;
  while (level + 1 < asset.level_count && !(asset.level_error[level] * pixels_per_error <= threshold_px)) ++level;
  return level;
}

/// The level an instance would like if all were resident.
uint32_t likedLevel(const lithe_view& view, const lithe_asset& asset, const lithe_instance& instance) {
  const float pixels_per_error = pixelsPerError(view, instance);
  const uint32_t level = coarsestWithin(asset, pixels_per_error, view.threshold_px);
  if (instance.level >= asset.level_count || level >= instance.level) return level;
  const uint32_t surely = coarsestWithin(asset, pixels_per_error, view.threshold_px * (1 - view.hysteresis));
  return surely < instance.level ? surely : instance.level;
}

void selectOne(const lithe_view& view, const lithe_asset& asset, lithe_instance* instance, uint32_t* wanted_level,
               lithe_select_stats* stats) {
  const uint32_t liked = likedLevel(view, asset, *instance);
  const uint32_t resident = asset.resident_level;
  if (wanted_level && liked > *wanted_level) *wanted_level = liked;
  const bool drawable = resident != LITHE_NO_LEVEL;
  instance->level = drawable && liked > resident ? resident : drawable ? liked : LITHE_NO_LEVEL;
  if (!stats) return;
  if (!drawable)
    ++stats->undrawable;
  else
    stats->triangles +=
        asset.levels[instance->level].entry.face_count - asset.levels[instance->level].entry.hidden_count;
  if (!drawable || liked > resident) ++stats->limited;
}

}  // namespace
}  // namespace lithe::runtime

using namespace lithe::runtime;  // NOLINT: the C function below is the outside of this namespace

lithe_result lithe_select(const lithe_view* view, const lithe_asset* const* assets, uint32_t asset_count,
                          lithe_instance* instances, uint32_t instance_count, uint32_t* wanted_levels,
                          lithe_select_stats* stats) {
  if (!view || !isSound(*view) || (!assets && asset_count) || (!instances && instance_count) ||
      !allNameAnAsset(assets, asset_count, instances, instance_count))
    return invalidArgument();
  for (uint32_t i = 0; i < instance_count; ++i) {
    const uint32_t asset = instances[i].asset;
    selectOne(*view, *assets[asset], &instances[i], wanted_levels ? wanted_levels + asset : nullptr, stats);
  }
  return LITHE_OK;
}
