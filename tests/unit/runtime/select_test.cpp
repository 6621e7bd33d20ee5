// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "hand_made_asset.h"

namespace lithe::test {
namespace {

/// Ten levels with errors 4.5, 4, ... 0.
AssetShape manyLevels() {
  AssetShape shape;
  shape.splits = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  return shape;
}

lithe_view perspective(float threshold_px) {
  lithe_view view = {};
  view.pixels_per_radian = 500;
  view.near_distance = 0.1f;
  view.threshold_px = threshold_px;
  return view;
}

lithe_instance instanceAt(float distance, uint32_t level = LITHE_NO_LEVEL) {
  lithe_instance instance = {};
  instance.center[2] = distance;
  instance.scale = 1;
  instance.bias = 1;
  instance.level = level;
  return instance;
}

class Select : public testing::Test {
 protected:
  Select() : hand_(manyLevels(), 4), asset_(hand_.open()) {}

  uint32_t selected(const lithe_view& view, lithe_instance instance) {
    const lithe_asset* assets[] = {asset_.get()};
    EXPECT_EQ(lithe_select(&view, assets, 1, &instance, 1, nullptr, nullptr), LITHE_OK);
    return instance.level;
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
    const lithe_asset* assets[] = {asset_.get()};
    uint32_t changes = 0, last = LITHE_NO_LEVEL;
    for (uint32_t frame = 0; frame < 100; ++frame) {
      instance.center[2] = frame % 2 ? 149.0f : 151.0f;
      ASSERT_EQ(lithe_select(&view, assets, 1, &instance, 1, nullptr, nullptr), LITHE_OK);
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
  ASSERT_EQ(lithe_select(&view, assets, 2, instances.data(), 4, wanted, &stats), LITHE_OK);
  EXPECT_EQ(instances[0].level, 2u);
  EXPECT_EQ(instances[1].level, 0u);
  EXPECT_EQ(instances[2].level, LITHE_NO_LEVEL);
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
  ASSERT_EQ(lithe_select(&view, assets, 2, instances.data(), 4, high, nullptr), LITHE_OK);
  EXPECT_EQ(high[0], 9u);
}

TEST_F(Select, BadArgumentsChangeNothing) {
  const lithe_asset* assets[] = {asset_.get(), nullptr};
  const lithe_view good = perspective(5);
  auto call = [&](auto change, uint32_t second_asset = 0) {
    lithe_view view = good;
    change(view);
    lithe_instance instances[2] = {instanceAt(50, 7), instanceAt(50, 7)};
    instances[1].asset = second_asset;
    const lithe_result result = lithe_select(&view, assets, 2, instances, 2, nullptr, nullptr);
    if (result != LITHE_OK) {
      EXPECT_EQ(instances[0].level, 7u);
    }
    return result;
  };
  EXPECT_EQ(call([](auto&) {}), LITHE_OK);
  EXPECT_EQ(call([](auto&) {}, 1), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call([](auto&) {}, 2), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call([](auto& v) { v.threshold_px = 0; }), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call([](auto& v) { v.threshold_px = NAN; }), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call([](auto& v) { v.near_distance = 0; }), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call([](auto& v) { v.hysteresis = 0.95f; }), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call([](auto& v) { v.hysteresis = -0.1f; }), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call([](auto& v) { v.pixels_per_radian = 0; }), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call([](auto& v) { v.pixels_per_radian = -1; }), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_select(nullptr, assets, 2, nullptr, 0, nullptr, nullptr), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_select(&good, assets, 2, nullptr, 1, nullptr, nullptr), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_select(&good, nullptr, 1, nullptr, 0, nullptr, nullptr), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_select(&good, nullptr, 0, nullptr, 0, nullptr, nullptr), LITHE_OK);
}

}  // namespace
}  // namespace lithe::test
