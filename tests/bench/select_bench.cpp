// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// What choosing levels costs per instance, beside a plain pass that reads the same instances once; one thread.
//
//     bench_select
//
// 20 assets, each opened on its own, all levels resident: four bakes of the column with different levels, five
// times each. Instances stand at random on a disc and the camera comes nearer from round to round, so that levels
// change and no branch is always the same. "select" is lithe_select with hysteresis, wanted levels and stats; "draws"
// is lithe_build_draws on what it chose; "within" is lithe_select_within, on instances of its own, with half of the
// triangles that the threshold takes; "read" adds up every field of every instance.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>

#include "bench_character.h"
#include "lithe/bake/generate.h"
#include "random.h"
#include "timing.h"

namespace lithe::bench {
namespace {

constexpr uint32_t kAssets = 20;
constexpr uint32_t kCounts[] = {1000, 10000, 1000000};
constexpr float kCrowdRadius = 150;        ///< metres
constexpr float kScale = 0.2f;             ///< the column becomes 1.6 m high
constexpr float kThresholdPixels = 0.02f;  ///< the column is easy: at 1 nearly all would have its coarsest level
constexpr int kCameraPlaces = 16;

// ---- The crowd
// -------------------------------------------------------------------------------------------------------

struct Assets {
  std::vector<AssetHandle> handles;
  std::vector<const lithe_asset*> pointers;
  std::vector<std::vector<lithe_range>> ranges;
  std::vector<lithe_placement> placements;
};

/// Different error tables, as different characters would have.
std::vector<std::vector<uint8_t>> bakedFiles() {
  const bake::Model column = bake::generate("column");
  std::vector<std::vector<uint8_t>> files;
  for (const std::vector<double>& levels :
       {bake::BakeOptions{}.levels, std::vector<double>{0.6, 0.35, 0.2, 0.12, 0.07, 0.04, 0.02, 0.01},
        std::vector<double>{0.8, 0.45, 0.25, 0.11, 0.06, 0.03, 0.008},
        std::vector<double>{0.5, 0.25, 0.12, 0.06, 0.03}}) {
    bake::BakeOptions options;
    options.levels = levels;
    options.poses.clips = {"examples"};
    std::fprintf(stderr, "baking the column with %zu levels\n", levels.size() + 1);
    files.push_back(bake::bake(column, options, nullptr));
  }
  return files;
}

/// Where a host that packs all levels of an asset one after the other would have them.
void place(const lithe_asset& asset, Assets& assets) {
  lithe_asset_info info;
  lithe_asset_describe(&asset, &info);
  std::vector<lithe_range>& ranges = assets.ranges.emplace_back();
  uint32_t first = 0;
  for (uint32_t level = 0; level < info.level_count; ++level) {
    lithe_level described;
    if (lithe_asset_level(&asset, level, &described) != LITHE_OK) throw bake::Error("a level is missing");
    ranges.push_back({first, described.index_count});  // the column has one part
    first += described.index_count;
  }
  assets.placements.push_back({0, info.part_count, info.level_count, ranges.data()});
}

Assets openAssets() {
  const std::vector<std::vector<uint8_t>> files = bakedFiles();
  Assets assets;
  assets.ranges.reserve(kAssets);
  for (uint32_t i = 0; i < kAssets; ++i) {
    const std::vector<uint8_t>& file = files[i % files.size()];
    assets.handles.push_back(openAsset(file));
    supplyAll(*assets.handles.back(), file);
    assets.pointers.push_back(assets.handles.back().get());
    place(*assets.pointers.back(), assets);
  }
  return assets;
}

std::vector<lithe_instance> crowdOf(uint32_t count) {
  test::Random random(count);
  const auto unit = [&] { return static_cast<float>(random.unit()); };
  std::vector<lithe_instance> crowd;
  for (uint32_t i = 0; i < count; ++i) {
    const float angle = 6.2831853f * unit(), from_centre = kCrowdRadius * unit();  // denser where the camera is
    lithe_instance instance = {};
    instance.center[0] = from_centre * std::cos(angle);
    instance.center[1] = 0.8f;
    instance.center[2] = from_centre * std::sin(angle);
    instance.radius = 0.9f;
    instance.scale = kScale * (0.9f + 0.2f * unit());
    instance.bias = 1;
    instance.asset = random.below(kAssets);
    instance.level = LITHE_UNDRAWN;
    crowd.push_back(instance);
  }
  return crowd;
}

/// There and back again, in small steps: most instances keep their level.
lithe_view viewOf(int round) {
  const int place = round % (2 * kCameraPlaces), step = place < kCameraPlaces ? place : 2 * kCameraPlaces - place;
  lithe_view view = {};
  view.position[0] = 0.5f * static_cast<float>(step);
  view.position[1] = 1.7f;
  view.pixels_per_radian = 1080 / (2 * std::tan(0.5f));
  view.near_distance = 0.1f;
  view.threshold_px = kThresholdPixels;
  view.hysteresis = 0.2f;
  return view;
}

// ---- What is timed
// ---------------------------------------------------------------------------------------------------

struct Times {
  uint32_t instances = 0;
  double select = 0, draws = 0, within = 0, read = 0;  ///< seconds per pass
  double common = 0;                                   ///< share of instances with the most common level
  double triangles = 0;                                ///< per instance
  double spent = 0;                                    ///< of the budget, least of all passes
  double changed = 0;                                  ///< share of instances whose level a budgeted pass changes, mean
};

/// Every byte once, in order: what memory alone costs.
uint64_t readAll(const std::vector<lithe_instance>& crowd) {
  constexpr size_t kWords = sizeof(lithe_instance) / sizeof(uint32_t);
  uint64_t sum = 0;
  for (const lithe_instance& instance : crowd) {
    uint32_t words[kWords];
    std::memcpy(words, &instance, sizeof words);
    for (const uint32_t word : words) sum += word;
  }
  return sum;
}

class Passes {
 public:
  Passes(const Assets& assets, uint32_t count)
      : assets_(assets),
        crowd_(crowdOf(count)),
        budgeted_(crowd_),
        scratch_(lithe_budget_scratch(count) / 8 + 1),
        wanted_(kAssets),
        order_(count),
        draws_(lithe_draws_bound(assets.placements.data(), kAssets)),
        keys_(draws_.size()),
        counters_(draws_.size()) {}

  void select() {
    const lithe_view view = viewOf(round_++);
    stats_ = {};
    std::fill(wanted_.begin(), wanted_.end(), 0u);
    const lithe_crowd crowd = of(crowd_);
    if (lithe_select(&crowd, &view, 1, wanted_.data(), &stats_) != LITHE_OK) throw bake::Error("lithe_select fails");
  }

  /// The budget stays what the first threshold's triangles make it.
  void selectWithin() {
    if (budget_ == 0) budget_ = stats_.triangles / 2;
    const lithe_view view = viewOf(budgeted_round_++);
    lithe_select_stats stats = {};
    const lithe_crowd crowd = of(budgeted_);
    if (lithe_select_within(&crowd, &view, 1, budget_, wanted_.data(), &stats, scratch_.data(), scratch_.size() * 8,
                            nullptr) != LITHE_OK)
      throw bake::Error("lithe_select_within fails");
    if (stats.triangles > budget_) throw bake::Error("more triangles than the budget");
    spent_ = std::min(spent_, static_cast<double>(stats.triangles) / static_cast<double>(budget_));
  }

  /// Of the instances per round trip's step, not timed.
  double changedShare() {
    uint64_t changes = 0;
    for (int i = 0; i < 2 * kCameraPlaces; ++i) {
      const std::vector<lithe_instance> before = budgeted_;
      selectWithin();
      for (size_t k = 0; k < before.size(); ++k) changes += before[k].level != budgeted_[k].level;
    }
    return static_cast<double>(changes) / (2.0 * kCameraPlaces * count());
  }

  void buildDraws() {
    uint32_t draw_count = 0;
    const lithe_crowd crowd = of(crowd_);
    if (lithe_build_draws(&crowd, assets_.placements.data(), ~0u, order_.data(), draws_.data(), keys_.data(),
                          &draw_count, counters_.data()) != LITHE_OK)
      throw bake::Error("lithe_build_draws fails");
    benchmark::DoNotOptimize(draw_count);
  }

  void read() { benchmark::DoNotOptimize(readAll(crowd_)); }

  uint32_t count() const { return static_cast<uint32_t>(crowd_.size()); }
  double spent() const { return spent_; }
  double trianglesPerInstance() const { return static_cast<double>(stats_.triangles) / count(); }
  double shareOfMostCommonLevel() const {
    std::map<uint32_t, uint32_t> counts;
    uint32_t most = 0;
    for (const lithe_instance& instance : crowd_) most = std::max(most, ++counts[instance.level]);
    return static_cast<double>(most) / count();
  }

 private:
  lithe_crowd of(std::vector<lithe_instance>& instances) const {
    return {assets_.pointers.data(), instances.data(), 0, kAssets, count()};
  }

  const Assets& assets_;
  std::vector<lithe_instance> crowd_, budgeted_;
  std::vector<uint64_t> scratch_;
  uint64_t budget_ = 0;
  double spent_ = 1;
  std::vector<uint32_t> wanted_, order_;
  std::vector<lithe_draw> draws_;
  std::vector<lithe_draw_key> keys_;
  std::vector<uint32_t> counters_;
  lithe_select_stats stats_{};
  int round_ = 0, budgeted_round_ = 0;
};

Times measure(const Assets& assets, uint32_t count) {
  Passes passes(assets, count);
  const std::vector<double> seconds = medianSeconds(
      {[&] { passes.select(); }, [&] { passes.buildDraws(); }, [&] { passes.selectWithin(); }, [&] { passes.read(); }},
      33, 0.5);
  Times times;
  times.instances = count;
  times.select = seconds[0];
  times.draws = seconds[1];
  times.within = seconds[2];
  times.read = seconds[3];
  times.common = passes.shareOfMostCommonLevel();
  times.triangles = passes.trianglesPerInstance();
  times.changed = passes.changedShare();
  times.spent = passes.spent();
  return times;
}

void print(const std::vector<Times>& all) {
  std::printf(
      "| instances | select ns each | draws ns each | within ns each | read ns each | select / read | select + draws "
      "ms "
      "| within + draws ms | budget spent, at least | levels changed a frame | most common level | triangles each |\n"
      "|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const Times& times : all) {
    const double each = 1e9 / times.instances;
    std::printf("| %u | %.2f | %.2f | %.2f | %.2f | %.1f | %.4f | %.4f | %.2f %% | %.2f %% | %.0f %% | %.0f |\n",
                times.instances, times.select * each, times.draws * each, times.within * each, times.read * each,
                times.select / times.read, 1e3 * (times.select + times.draws), 1e3 * (times.within + times.draws),
                100 * times.spent, 100 * times.changed, 100 * times.common, times.triangles);
  }
}

int run() {
  const Assets assets = openAssets();
  std::vector<Times> all;
  for (const uint32_t count : kCounts) all.push_back(measure(assets, count));
  print(all);
  return 0;
}

}  // namespace
}  // namespace lithe::bench

int main(int argc, char**) try {
  if (argc > 1) return std::fprintf(stderr, "bench_select takes no arguments\n"), 2;
  return lithe::bench::run();
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
