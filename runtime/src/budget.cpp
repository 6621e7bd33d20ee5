// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The best levels for a number of triangles.
///
/// From each level to the next finer one is a step: it costs the difference of their triangles, and it is due as long
/// as the coarser level's error, in thresholds on the screen, is above the factor. Which factor spends the budget is
/// found without sorting, by a histogram of the steps' triangles over the leading bits of their errors (positive floats
/// are ordered like their bits). Errors of one bucket, which differ by less than a 128th, count as alike.
#include <string.h>

#include "arguments.h"
#include "selection.h"

namespace lithe::runtime {
namespace {

constexpr uint32_t kOne = 0x3f800000, kGreatest = 0x7f7fffff;  // the bits of 1 and of the greatest float
constexpr uint32_t kBucketShift = 16, kBuckets = 1u << 14;
static_assert((kGreatest - kOne) >> kBucketShift < kBuckets, "all errors above 1 have a bucket");

float floatOf(uint32_t bits) {
  float value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

/// Ascending with the error, which is not negative. Infinity counts as the greatest float.
uint32_t bitsOf(float error) {
  uint32_t bits;
  memcpy(&bits, &error, sizeof bits);
  return bits < kGreatest ? bits : kGreatest;
}

struct Scratch {
  int64_t* triangles;  ///< [kBuckets] of the steps in each bucket
  Demand* demands;     ///< [instances]
};

/// A seen instance with its asset, and the levels that the budget may choose from.
struct Chooser {
  const lithe_asset* asset;
  const lithe_instance* instance;
  Demand demand;
  LevelBounds bounds;

  Chooser(const lithe_asset& of, const lithe_instance& which, const Demand& asked)
      : asset(&of), instance(&which), demand(asked), bounds(boundsOf(of, which)) {
    if (of.resident_level < bounds.last) bounds.last = of.resident_level;
    if (bounds.first > bounds.last) bounds.first = bounds.last;
  }

  /// The error of a level that a step leads away from, in thresholds; the current level's own and finer ones count as
  /// they are.
  uint32_t errorBits(uint32_t level) const {
    const bool held = level < instance->level && instance->level < asset->level_count;
    return bitsOf(errorOf(*asset, level) * (held ? demand.held : demand.fresh));
  }
  int64_t triangles(uint32_t level) const { return asset->choices[level].triangles; }
  int64_t stepTriangles(uint32_t level) const { return triangles(level + 1) - triangles(level); }
};

class Budget {
 public:
  Budget(const lithe_crowd& crowd, uint64_t triangles, const Scratch& scratch)
      : crowd_(crowd), scratch_(scratch), left_(triangles > INT64_MAX ? INT64_MAX : static_cast<int64_t>(triangles)) {}

  /// Notes what every instance demands, spends its coarsest level and adds its steps to the histogram. False when one
  /// names no asset.
  template <typename DemandOf>
  bool takeDemands(DemandOf demand_of) {
    memset(scratch_.triangles, 0, kBuckets * sizeof(int64_t));
    InstanceCursor instances(crowd_);
    for (uint32_t i = 0; i < crowd_.instance_count; ++i) {
      const lithe_instance& instance = *instances.next();
      const lithe_asset* asset = assetOf(crowd_, instance);
      if (!asset) return false;
      const Demand demand = scratch_.demands[i] = demand_of(instance);
      if (isChosen(*asset, demand)) addInstance({*asset, instance, demand});
    }
    return true;
  }

  /// Finds the bucket of errors in which the budget runs out: from `first` on all steps can be taken, and of those
  /// from `alike` to there some.
  void findFactor() {
    alike_ = first_ = kOne + 1;
    for (uint32_t bucket = kBuckets; bucket-- > 0;) {
      if (scratch_.triangles[bucket] > left_) {
        alike_ = kOne + 1 + (bucket << kBucketShift);
        first_ = alike_ + (1u << kBucketShift);
        return;
      }
      left_ -= scratch_.triangles[bucket];
    }
  }

  /// What `error * demand <= factor` compares with: steps from `first` on are above.
  float factor() const { return floatOf(first_ - 1); }

  /// Gives out the levels.
  void choose(uint32_t* wanted_levels, lithe_select_stats* stats) {
    InstanceCursor instances(crowd_);
    lithe_select_stats own = {};
    for (uint32_t i = 0; i < crowd_.instance_count; ++i) {
      lithe_instance* instance = instances.next();
      chooseOne(*assetOf(crowd_, *instance), scratch_.demands[i], instance, wanted_levels, &own);
    }
    addStats(own, stats);
  }

 private:
  static bool isChosen(const lithe_asset& asset, const Demand& demand) {
    return demand.views != 0 && asset.resident_level != LITHE_NO_LEVEL;
  }

  /// Errors fall from level to level, so those above 1 come first.
  void addInstance(const Chooser& chooser) {
    int64_t before = chooser.triangles(chooser.bounds.first);
    left_ -= before;
    for (uint32_t level = chooser.bounds.first; level < chooser.bounds.last; ++level) {
      const uint32_t bits = chooser.errorBits(level);
      if (bits <= kOne) return;
      const int64_t after = chooser.triangles(level + 1);
      scratch_.triangles[(bits - kOne - 1) >> kBucketShift] += after - before;
      before = after;
    }
  }

  void chooseOne(const lithe_asset& asset, const Demand& demand, lithe_instance* instance, uint32_t* wanted_levels,
                 lithe_select_stats* stats) {
    if (demand.views == 0) return leaveUnseen(instance, stats);
    uint32_t liked = likedLevel(asset, *instance, demand, factor()), level = LITHE_UNDRAWN;
    if (isChosen(asset, demand)) {
      level = spendRest({asset, *instance, demand}, liked);
      if (level > liked) liked = level;
    }
    giveSeen(asset, instance, demand.views, level, liked, wanted_levels, stats);
  }

  /// From the level that the factor gives on: the steps that are alike, as long as they fit.
  uint32_t spendRest(const Chooser& chooser, uint32_t liked) {
    uint32_t level = liked < chooser.bounds.last ? liked : chooser.bounds.last;
    if (level < chooser.bounds.first) level = chooser.bounds.first;
    while (level < chooser.bounds.last && chooser.errorBits(level) >= alike_ && chooser.stepTriangles(level) <= left_) {
      left_ -= chooser.stepTriangles(level);
      ++level;
    }
    return level;
  }

  const lithe_crowd& crowd_;
  const Scratch scratch_;
  int64_t left_;  ///< triangles
  uint32_t alike_ = 0, first_ = 0;
};

}  // namespace
}  // namespace lithe::runtime

using namespace lithe::runtime;  // NOLINT: the C functions below are the outside of this namespace

uint64_t lithe_budget_scratch(uint32_t instance_count) {
  return kBuckets * sizeof(int64_t) + uint64_t{instance_count} * sizeof(Demand);
}

lithe_result lithe_select_within(const lithe_crowd* crowd, const lithe_view* views, uint32_t view_count,
                                 uint64_t triangles, uint32_t* wanted_levels, lithe_select_stats* stats, void* scratch,
                                 size_t scratch_bytes, float* factor) {
  Projection projections[LITHE_MAX_VIEWS];
  if (!crowd || !crowdIsSound(*crowd) || !readViews(views, view_count, projections) || !scratch ||
      reinterpret_cast<uintptr_t>(scratch) % alignof(int64_t) != 0)
    return invalidArgument();
  if (scratch_bytes < lithe_budget_scratch(crowd->instance_count)) return LITHE_ERROR_BUFFER_TOO_SMALL;
  int64_t* histogram = static_cast<int64_t*>(scratch);
  Budget budget(*crowd, triangles, {histogram, reinterpret_cast<Demand*>(histogram + kBuckets)});
  const bool taken =
      withDemands(projections, view_count, [&](auto demand_of) { return budget.takeDemands(demand_of); });
  if (!taken) return invalidArgument();
  budget.findFactor();
  budget.choose(wanted_levels, stats);
  if (factor) *factor = budget.factor();
  return LITHE_OK;
}
