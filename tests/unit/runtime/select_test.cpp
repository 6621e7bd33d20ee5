// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>
#include <vector>

#include "crowds.h"
#include "hand_made_asset.h"

namespace lithe::test {
namespace {

/// Ten levels with errors 4.5, 4, ... 0.
AssetShape manyLevels() {
  AssetShape shape;
  shape.splits = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  return shape;
}

class Select : public testing::Test {
 protected:
  Select() : hand_(manyLevels(), 4), asset_(hand_.open()) {}

  uint32_t selected(const lithe_view& view, lithe_instance instance) {
    EXPECT_EQ(select({view}, &instance), LITHE_OK);
    return instance.level;
  }
  lithe_result select(const std::vector<lithe_view>& views, lithe_instance* instance,
                      lithe_select_stats* stats = nullptr) const {
    const lithe_asset* assets[] = {asset_.get()};
    const lithe_crowd crowd = {assets, instance, 0, 1, 1};
    return lithe_select(&crowd, views.data(), static_cast<uint32_t>(views.size()), nullptr, stats);
  }

  /// The definition, level by level.
  uint32_t coarsestWithin(double pixels_per_error, double threshold) const {
    for (uint32_t l = 0; l < hand_.errors.size(); ++l)
      if (hand_.errors[l] * pixels_per_error <= threshold) return l;
    return static_cast<uint32_t>(hand_.errors.size() - 1);
  }

  HandMade hand_;
  std::unique_ptr<lithe_asset, void (*)(lithe_asset*)> asset_;
};

TEST_F(Select, TakesTheCoarsestLevelWithinTheThreshold) {
  Random random(3);
  for (uint32_t i = 0; i < 5000; ++i) {
    lithe_view view = perspective(static_cast<float>(0.5 + 20 * random.unit()));
    for (float& x : view.position) x = static_cast<float>(10 * random.unit());
    lithe_instance instance = instanceAt(0);
    for (float& x : instance.center) x = static_cast<float>(400 * random.unit());
    instance.radius = static_cast<float>(3 * random.unit());
    instance.scale = static_cast<float>(0.5 + random.unit());
    instance.bias = static_cast<float>(0.5 + random.unit());
    double squared = 0;
    for (int c = 0; c < 3; ++c) squared += std::pow(double(instance.center[c]) - view.position[c], 2);
    const double distance = std::max(std::sqrt(squared) - instance.radius, 0.1);
    const double pixels = double(instance.scale) * instance.bias * 500 / distance;
    // Within rounding of a level's border either side is right.
    const uint32_t low = coarsestWithin(pixels * (1 - 1e-5), view.threshold_px);
    const uint32_t high = coarsestWithin(pixels * (1 + 1e-5), view.threshold_px);
    const uint32_t level = selected(view, instance);
    ASSERT_GE(level, low);
    ASSERT_LE(level, high);
  }
}

TEST_F(Select, OrthographicDoesNotDependOnTheDistance) {
  lithe_view view = perspective(3);
  view.pixels_per_radian = 0;
  view.pixels_per_unit = 2;  // error 1.5 is 3 pixels
  for (const float distance : {0.0f, 1.0f, 1e6f}) EXPECT_EQ(hand_.errors[selected(view, instanceAt(distance))], 1.5f);
}

TEST_F(Select, NearerThanNearIsNear) {
  EXPECT_EQ(selected(perspective(1), instanceAt(0)), hand_.levels.size() - 1);
  lithe_view view = perspective(1);
  view.near_distance = 500;
  EXPECT_EQ(selected(view, instanceAt(0)), selected(view, instanceAt(500)));
}

// Finer threshold, nearer camera, more bias: never fewer triangles.
TEST_F(Select, IsMonotone) {
  Random random(8);
  auto triangles = [&](const lithe_view& view, const lithe_instance& instance) {
    return hand_.levels[selected(view, instance)].faces.size();
  };
  for (uint32_t i = 0; i < 1000; ++i) {
    const float threshold = static_cast<float>(0.1 + 10 * random.unit()),
                factor = 1 + static_cast<float>(random.unit());
    lithe_instance instance = instanceAt(static_cast<float>(600 * random.unit()));
    const size_t reference = triangles(perspective(threshold), instance);
    EXPECT_GE(triangles(perspective(threshold / factor), instance), reference);
    lithe_instance nearer = instance, finer = instance;
    nearer.center[2] /= factor;
    finer.bias *= factor;
    EXPECT_GE(triangles(perspective(threshold), nearer), reference);
    EXPECT_GE(triangles(perspective(threshold), finer), reference);
  }
}

TEST_F(Select, HysteresisHoldsTheLevelUntilTheErrorIsWellBelow) {
  lithe_view view = perspective(5);
  view.hysteresis = 0.5f;
  // At distance d level l has 500 errors[l] / d pixels. The current level is the one with error 1.
  const uint32_t current = static_cast<uint32_t>(hand_.errors.size()) - 3, coarser = current - 1;
  EXPECT_EQ(hand_.errors[current], 1.0f);
  EXPECT_EQ(selected(view, instanceAt(101, current)), current);  // just right
  EXPECT_EQ(selected(view, instanceAt(160, current)), current);  // error 1.5: 4.7 px, not below 2.5
  EXPECT_EQ(selected(view, instanceAt(299, current)), current);
  EXPECT_EQ(selected(view, instanceAt(301, current)), coarser);     // 2.49 px
  EXPECT_EQ(selected(view, instanceAt(301)), 3u);                   // without a current level: error 3, 4.98 px
  EXPECT_EQ(selected(view, instanceAt(99, current)), current + 1);  // finer at once
}

// A camera that swings a little never makes a level go back and forth.
TEST_F(Select, HysteresisStopsFlicker) {
  for (const float hysteresis : {0.0f, 0.2f}) {
    lithe_view view = perspective(5);
    view.hysteresis = hysteresis;
    lithe_instance instance = instanceAt(150);
    uint32_t changes = 0, last = LITHE_UNDRAWN;
    for (uint32_t frame = 0; frame < 100; ++frame) {
      instance.center[2] = frame % 2 ? 149.0f : 151.0f;
      ASSERT_EQ(select({view}, &instance), LITHE_OK);
      changes += instance.level != last;
      last = instance.level;
    }
    EXPECT_EQ(changes, hysteresis > 0 ? 2u : 100u);
  }
}

TEST_F(Select, DrawsWhatIsResidentAndSaysWhatIsWanted) {
  ASSERT_EQ(lithe_asset_evict(asset_.get(), 2), LITHE_OK);
  const HandMade other({}, 2);
  const auto empty = other.open(*mallocAllocator(), false);
  const lithe_asset* assets[] = {asset_.get(), empty.get()};
  std::vector<lithe_instance> instances = {instanceAt(50), instanceAt(1e6f), instanceAt(100), instanceAt(100)};
  instances[2].asset = 1;
  instances[3].level = 77;  // no level of this asset: as if there were none
  uint32_t wanted[2] = {0, 0};
  lithe_select_stats stats = {};
  const lithe_view view = perspective(5);
  const lithe_crowd crowd = {assets, instances.data(), 0, 2, 4};
  ASSERT_EQ(lithe_select(&crowd, &view, 1, wanted, &stats), LITHE_OK);
  EXPECT_EQ(instances[0].level, 2u);
  EXPECT_EQ(instances[1].level, 0u);
  EXPECT_EQ(instances[2].level, LITHE_UNDRAWN);
  EXPECT_EQ(instances[3].level, 2u);
  EXPECT_EQ(hand_.errors[wanted[0]], 0.5f);
  EXPECT_EQ(other.errors[wanted[1]], 1.0f);
  EXPECT_EQ(stats.undrawable, 1u);
  EXPECT_EQ(stats.limited, 3u);
  lithe_level fine, coarse;
  ASSERT_EQ(lithe_asset_level(asset_.get(), 2, &fine), LITHE_OK);
  ASSERT_EQ(lithe_asset_level(asset_.get(), 0, &coarse), LITHE_OK);
  EXPECT_EQ(stats.triangles, 2ull * fine.triangle_count + coarse.triangle_count);
  // Raised, never lowered.
  uint32_t high[2] = {9, 0};
  ASSERT_EQ(lithe_select(&crowd, &view, 1, high, nullptr), LITHE_OK);
  EXPECT_EQ(high[0], 9u);
}

TEST_F(Select, EveryViewIsServed) {
  Random random(21);
  for (uint32_t i = 0; i < 2000; ++i) {
    std::vector<lithe_view> views(1 + random.below(LITHE_MAX_VIEWS));
    uint32_t finest = 0;
    const lithe_instance instance = instanceAt(static_cast<float>(300 * random.unit()));
    for (lithe_view& view : views) {
      view = perspective(static_cast<float>(1 + 20 * random.unit()));
      view.position[0] = static_cast<float>(500 * random.unit());
      finest = std::max(finest, selected(view, instance));
    }
    lithe_instance seen = instance;
    ASSERT_EQ(select(views, &seen), LITHE_OK);
    ASSERT_EQ(seen.level, finest);
    ASSERT_EQ(seen.views, (1u << views.size()) - 1);
  }
}

TEST_F(Select, WhatIsOutsideAPlaneIsNotSeenByThatView) {
  lithe_view left = perspective(5), right = perspective(5);
  left.plane_count = right.plane_count = 2;
  left.planes[0][0] = -1, left.planes[1][1] = 1;  // x <= 0 and y >= 0
  right.planes[0][0] = 1, right.planes[1][1] = 1;
  lithe_instance instance = instanceAt(100);
  instance.radius = 2;
  const auto viewsAt = [&](float x, float y) {
    instance.center[0] = x;
    instance.center[1] = y;
    EXPECT_EQ(select({left, right}, &instance), LITHE_OK);
    return instance.views;
  };
  EXPECT_EQ(viewsAt(-2.1f, 0), 1);
  EXPECT_EQ(viewsAt(-1.9f, 0), 3);
  EXPECT_EQ(viewsAt(1.9f, -1.9f), 3);
  EXPECT_EQ(viewsAt(2.1f, 0), 2);
  // An unseen one keeps its level for when it is seen again, and counts nowhere else.
  const uint32_t level = instance.level;
  EXPECT_EQ(viewsAt(0, -2.1f), 0);
  EXPECT_EQ(instance.level, level);
  lithe_select_stats stats = {};
  ASSERT_EQ(select({left, right}, &instance, &stats), LITHE_OK);
  EXPECT_EQ(stats.unseen, 1u);
  EXPECT_EQ(stats.triangles + stats.undrawable + stats.limited, 0u);
}

TEST_F(Select, WhatIsTooSmallIsNotSeen) {
  lithe_view view = perspective(5), flat = perspective(5);
  view.least_px = flat.least_px = 4;
  flat.pixels_per_radian = 0;
  flat.pixels_per_unit = 2;
  lithe_instance instance = instanceAt(0);
  instance.radius = 1;
  const auto seenAt = [&](const lithe_view& by, float distance) {
    instance.center[2] = distance;
    EXPECT_EQ(select({by}, &instance), LITHE_OK);
    return instance.views == 1;
  };
  EXPECT_TRUE(seenAt(view, 249));  // 2 units across: 1000 pixels at distance 1
  EXPECT_FALSE(seenAt(view, 251));
  EXPECT_TRUE(seenAt(view, 0));
  EXPECT_TRUE(seenAt(flat, 1e6f));  // 4 pixels anywhere
  instance.radius = 0.99f;
  EXPECT_FALSE(seenAt(flat, 1));
}

TEST_F(Select, BoundsOfAnInstanceAreKept) {
  const uint32_t finest = static_cast<uint32_t>(hand_.levels.size()) - 1;
  for (uint32_t first = 0; first <= finest + 2; ++first)
    for (uint32_t end = 0; end <= finest + 3; ++end)
      for (const float distance : {0.0f, 150.0f, 1e6f}) {
        lithe_instance bounded = instanceAt(distance);
        const uint32_t free = selected(perspective(5), bounded);
        bounded.first_level = static_cast<uint8_t>(first);
        bounded.end_level = static_cast<uint8_t>(end);
        const uint32_t last = end == 0 ? finest : std::min(end - 1, finest);
        EXPECT_EQ(selected(perspective(5), bounded), std::min(std::max(free, first), last));
      }
}

// The instances as the beginning of the host's own structs.
TEST_F(Select, InstancesMayLieAnywhere) {
  struct Actor {
    lithe_instance instance;
    uint32_t own[3];
  };
  std::vector<Actor> actors;
  for (uint32_t i = 0; i < 50; ++i) actors.push_back({instanceAt(10.0f * static_cast<float>(i)), {i, i, i}});
  const lithe_asset* assets[] = {asset_.get()};
  const lithe_crowd crowd = {assets, &actors[0].instance, sizeof(Actor), 1, 50};
  const lithe_view view = perspective(5);
  ASSERT_EQ(lithe_select(&crowd, &view, 1, nullptr, nullptr), LITHE_OK);
  for (uint32_t i = 0; i < 50; ++i) {
    EXPECT_EQ(actors[i].instance.level, selected(view, instanceAt(10.0f * static_cast<float>(i))));
    EXPECT_TRUE(actors[i].own[0] == i && actors[i].own[1] == i && actors[i].own[2] == i);
  }
}

// Ranges of a crowd on threads of their own, with their own counts: the same choice, and the sums and maxima are the
// same.
TEST_F(Select, RangesOnThreadsAreTheWhole) {
  Random random(17);
  std::vector<lithe_instance> whole;
  for (uint32_t i = 0; i < 4000; ++i) whole.push_back(instanceAt(static_cast<float>(400 * random.unit())));
  std::vector<lithe_instance> split = whole;
  const lithe_asset* assets[] = {asset_.get()};
  const lithe_view view = perspective(5);
  const lithe_crowd all = {assets, whole.data(), 0, 1, 4000};
  uint32_t wanted = 0;
  lithe_select_stats stats = {};
  ASSERT_EQ(lithe_select(&all, &view, 1, &wanted, &stats), LITHE_OK);
  constexpr uint32_t kRanges = 4;
  uint32_t wanted_of[kRanges] = {};
  lithe_select_stats stats_of[kRanges] = {};
  lithe_result results[kRanges];
  std::vector<std::thread> threads;
  for (uint32_t r = 0; r < kRanges; ++r)
    threads.emplace_back([&, r] {
      const lithe_crowd range = {assets, split.data() + 1000 * r, 0, 1, 1000};
      results[r] = lithe_select(&range, &view, 1, &wanted_of[r], &stats_of[r]);
    });
  for (std::thread& thread : threads) thread.join();
  uint64_t triangles = 0;
  for (uint32_t r = 0; r < kRanges; ++r) {
    EXPECT_EQ(results[r], LITHE_OK);
    triangles += stats_of[r].triangles;
  }
  EXPECT_EQ(triangles, stats.triangles);
  EXPECT_EQ(*std::max_element(wanted_of, wanted_of + kRanges), wanted);
  for (size_t i = 0; i < whole.size(); ++i) EXPECT_EQ(split[i].level, whole[i].level);
}

// 1 until the coarser level's error is at the threshold, 0 where it is a quarter above, and a straight line between.
TEST_F(Select, MorphsFollowTheCoarserLevelsError) {
  const lithe_asset* assets[] = {asset_.get()};
  const lithe_view view = perspective(5);
  const uint32_t level = 5;  // errors of level 4: 2.5, that is 1250 / distance pixels
  ASSERT_EQ(hand_.errors[level - 1], 2.5f);
  const auto morphAt = [&](float distance, uint32_t at, float factor = 1) {
    lithe_instance instance = instanceAt(distance, at);
    const lithe_crowd crowd = {assets, &instance, 0, 1, 1};
    float morph = -1;
    EXPECT_EQ(lithe_morph_factors(&crowd, &view, 1, factor, 0.25f, &morph), LITHE_OK);
    return morph;
  };
  EXPECT_EQ(morphAt(1e5f, level), 1.0f);
  EXPECT_EQ(morphAt(251, level), 1.0f);
  EXPECT_NEAR(morphAt(250 / 1.125f, level), 0.5f, 1e-4f);
  EXPECT_EQ(morphAt(250 / 1.26f, level), 0.0f);
  EXPECT_EQ(morphAt(251, level, 1.25f), 1.0f);
  EXPECT_NEAR(morphAt(200 / 1.125f, level, 1.25f), 0.5f, 1e-4f);
  EXPECT_EQ(morphAt(1e5f, 0), 0.0f);
  EXPECT_EQ(morphAt(1e5f, LITHE_UNDRAWN), 0.0f);
  lithe_instance instance = instanceAt(1);
  const lithe_crowd crowd = {assets, &instance, 0, 1, 1};
  float morph;
  EXPECT_EQ(lithe_morph_factors(&crowd, &view, 1, 0.5f, 0.25f, &morph), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_morph_factors(&crowd, &view, 1, 1, 0, &morph), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_morph_factors(&crowd, &view, 1, 1, 0.25f, nullptr), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_morph_factors(nullptr, &view, 1, 1, 0.25f, &morph), LITHE_ERROR_INVALID_ARGUMENT);
  instance.asset = 1;
  EXPECT_EQ(lithe_morph_factors(&crowd, &view, 1, 1, 0.25f, &morph), LITHE_ERROR_INVALID_ARGUMENT);
}

TEST_F(Select, NumbersThatAreNoneGiveALevelAllTheSame) {
  for (const float odd : {NAN, INFINITY, -INFINITY, -1.0f, 0.0f, 3e38f}) {
    for (float lithe_instance::*member : {&lithe_instance::radius, &lithe_instance::scale, &lithe_instance::bias}) {
      lithe_instance instance = instanceAt(100);
      instance.*member = odd;
      EXPECT_LT(selected(perspective(5), instance), hand_.levels.size());
    }
    EXPECT_LT(selected(perspective(5), instanceAt(odd)), hand_.levels.size());
  }
}

TEST_F(Select, BadArgumentsAreRefused) {
  const lithe_asset* assets[] = {asset_.get(), nullptr};
  const lithe_view good = perspective(5);
  auto call = [&](auto change) {
    lithe_view view = good;
    change(view);
    lithe_instance instances[2] = {instanceAt(50, 7), instanceAt(50, 7)};
    const lithe_crowd crowd = {assets, instances, 0, 2, 2};
    const lithe_result result = lithe_select(&crowd, &view, 1, nullptr, nullptr);
    if (result != LITHE_OK) {
      EXPECT_EQ(instances[0].level, 7u);
    }
    return result;
  };
  EXPECT_EQ(call([](auto&) {}), LITHE_OK);
  EXPECT_EQ(call([](auto& v) { v.threshold_px = 0; }), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call([](auto& v) { v.threshold_px = NAN; }), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call([](auto& v) { v.near_distance = 0; }), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call([](auto& v) { v.hysteresis = 0.95f; }), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call([](auto& v) { v.hysteresis = -0.1f; }), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call([](auto& v) { v.pixels_per_radian = 0; }), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call([](auto& v) { v.pixels_per_radian = -1; }), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call([](auto& v) { v.least_px = -1; }), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call([](auto& v) { v.plane_count = LITHE_MAX_PLANES + 1; }), LITHE_ERROR_INVALID_ARGUMENT);

  lithe_instance instances[2] = {instanceAt(50, 7), instanceAt(50, 7)};
  auto select = [&](const lithe_crowd& crowd, const lithe_view* views, uint32_t view_count) {
    return lithe_select(&crowd, views, view_count, nullptr, nullptr);
  };
  EXPECT_EQ(lithe_select(nullptr, &good, 1, nullptr, nullptr), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(select({assets, instances, 0, 2, 2}, nullptr, 1), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(select({assets, instances, 0, 2, 2}, &good, 0), LITHE_ERROR_INVALID_ARGUMENT);
  const std::vector<lithe_view> many(LITHE_MAX_VIEWS + 1, good);
  EXPECT_EQ(select({assets, instances, 0, 2, 2}, many.data(), LITHE_MAX_VIEWS + 1), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(select({assets, nullptr, 0, 2, 2}, &good, 1), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(select({nullptr, instances, 0, 2, 2}, &good, 1), LITHE_ERROR_INVALID_ARGUMENT);
  for (const size_t stride : {size_t{1}, sizeof(lithe_instance) - 4, sizeof(lithe_instance) + 2})
    EXPECT_EQ(select({assets, instances, stride, 2, 2}, &good, 1), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(select({nullptr, nullptr, 0, 0, 0}, &good, 1), LITHE_OK);
  // The first instance that names no asset ends the call.
  for (const uint32_t stranger : {1u, 2u}) {
    instances[0] = instances[1] = instanceAt(50, 7);
    instances[1].asset = stranger;
    EXPECT_EQ(select({assets, instances, 0, 2, 2}, &good, 1), LITHE_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(instances[0].level, selected(good, instanceAt(50, 7)));
    EXPECT_EQ(instances[1].level, 7u);
  }
}

}  // namespace
}  // namespace lithe::test
