// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "crowds.h"
#include "hand_made_asset.h"

namespace lithe::test {
namespace {

/// Assets of 4 to 10 levels, whose instances lie at random in front of a view.
class Budget : public testing::Test {
 protected:
  Budget() {
    for (const std::vector<uint32_t>& splits :
         {std::vector<uint32_t>{1, 2, 3, 4, 5, 6, 7, 8, 9}, {5, 5, 5}, {2, 9, 1, 1, 12}}) {
      AssetShape shape;
      shape.splits = splits;
      shape.hidden_of = 0;  // a finer level never has fewer triangles, as with baked ones
      hands_.emplace_back(shape, 4);
      handles_.push_back(hands_.back().open());
      assets_.push_back(handles_.back().get());
    }
  }

  std::vector<lithe_instance> randomInstances(Random& random, uint32_t count) const {
    std::vector<lithe_instance> instances;
    for (uint32_t i = 0; i < count; ++i) {
      lithe_instance instance = instanceAt(static_cast<float>(5 + 300 * random.unit()));
      instance.asset = random.below(static_cast<uint32_t>(assets_.size()));
      instance.bias = static_cast<float>(0.5 + random.unit());
      instance.scale = static_cast<float>(0.5 + random.unit());
      instances.push_back(instance);
    }
    return instances;
  }

  lithe_crowd of(std::vector<lithe_instance>& instances) {
    return {assets_.data(), instances.data(), 0, static_cast<uint32_t>(assets_.size()),
            static_cast<uint32_t>(instances.size())};
  }

  /// Chooses and returns the triangles.
  uint64_t within(std::vector<lithe_instance>& instances, const lithe_view& view, uint64_t triangles,
                  float* factor = nullptr, uint32_t* wanted = nullptr) {
    std::vector<uint64_t> scratch(lithe_budget_scratch(static_cast<uint32_t>(instances.size())) / 8 + 1);
    lithe_select_stats stats = {};
    const lithe_crowd crowd = of(instances);
    EXPECT_EQ(
        lithe_select_within(&crowd, &view, 1, triangles, wanted, &stats, scratch.data(), scratch.size() * 8, factor),
        LITHE_OK);
    EXPECT_EQ(stats.triangles, trianglesOf(instances));
    return stats.triangles;
  }
  uint64_t freely(std::vector<lithe_instance>& instances, const lithe_view& view) {
    lithe_select_stats stats = {};
    const lithe_crowd crowd = of(instances);
    EXPECT_EQ(lithe_select(&crowd, &view, 1, nullptr, &stats), LITHE_OK);
    return stats.triangles;
  }

  uint64_t trianglesAt(const lithe_instance& instance, uint32_t level) const {
    lithe_level described;
    EXPECT_EQ(lithe_asset_level(assets_[instance.asset], level, &described), LITHE_OK);
    return described.triangle_count;
  }
  uint64_t trianglesOf(const std::vector<lithe_instance>& instances) const {
    uint64_t sum = 0;
    for (const lithe_instance& instance : instances) sum += trianglesAt(instance, instance.level);
    return sum;
  }
  double errorAt(const lithe_view& view, const lithe_instance& instance, uint32_t level) const {
    return hands_[instance.asset].errors[level] * double(instance.scale) * instance.bias * view.pixels_per_radian /
           (double(instance.center[2]) - instance.radius);
  }
  double worstError(const lithe_view& view, const std::vector<lithe_instance>& instances) const {
    double worst = 0;
    for (const lithe_instance& instance : instances) worst = std::max(worst, errorAt(view, instance, instance.level));
    return worst;
  }
  uint32_t levelCount(const lithe_instance& instance) const {
    return static_cast<uint32_t>(hands_[instance.asset].levels.size());
  }

  std::vector<HandMade> hands_;
  std::vector<std::unique_ptr<lithe_asset, void (*)(lithe_asset*)>> handles_;
  std::vector<const lithe_asset*> assets_;
};

// All ways of giving four instances levels: none within the budget has a smaller largest error.
TEST_F(Budget, NoChoiceIsBetter) {
  Random random(31);
  for (uint32_t trial = 0; trial < 60; ++trial) {
    std::vector<lithe_instance> instances = randomInstances(random, 4);
    lithe_view view = perspective(0.01f);
    std::vector<lithe_instance> finest = instances;
    const uint64_t all = freely(finest, view), budget = 4 + static_cast<uint64_t>(random.unit() * double(all));
    double best = HUGE_VAL;
    std::vector<uint32_t> levels(4, 0);
    for (bool more = true; more;) {
      uint64_t triangles = 0;
      double worst = 0;
      for (uint32_t i = 0; i < 4; ++i) {
        triangles += trianglesAt(instances[i], levels[i]);
        worst = std::max(worst, errorAt(view, instances[i], levels[i]));
      }
      if (triangles <= budget) best = std::min(best, worst);
      uint32_t i = 0;
      while (i < 4 && ++levels[i] == levelCount(instances[i])) levels[i++] = 0;
      more = i < 4;
    }
    float factor = 0;
    const uint64_t spent = within(instances, view, budget, &factor);
    EXPECT_EQ(std::isinf(factor), best == HUGE_VAL);
    if (best == HUGE_VAL) {
      EXPECT_GT(spent, budget);  // even the coarsest levels have more
      for (const lithe_instance& instance : instances) EXPECT_EQ(instance.level, 0);
      continue;
    }
    EXPECT_LE(spent, budget);
    EXPECT_LE(worstError(view, instances), best * (1 + 1.0 / 128));
  }
}

TEST_F(Budget, ACrowdSpendsItsBudgetAndNeverMore) {
  Random random(32);
  for (uint32_t trial = 0; trial < 40; ++trial) {
    std::vector<lithe_instance> instances = randomInstances(random, 3000);
    const lithe_view view = perspective(1);
    std::vector<lithe_instance> coarsest = instances, fine = instances;
    const uint64_t most = freely(fine, view);
    for (lithe_instance& instance : coarsest) instance.level = 0;
    const uint64_t least = trianglesOf(coarsest);
    const uint64_t budget = least + static_cast<uint64_t>(random.unit() * double(most - least));
    float factor = 0;
    const uint64_t spent = within(instances, view, budget, &factor);
    EXPECT_LE(spent, budget);
    EXPECT_GE(double(spent), 0.995 * double(budget));
    EXPECT_GT(factor, 1.0f);
    // The factor is the thresholds' common one: chosen with it, nothing else comes out but where steps were alike.
    std::vector<lithe_instance> again = instances;
    for (lithe_instance& instance : again) instance.level = LITHE_UNDRAWN;
    const uint64_t by_threshold = freely(again, perspective(factor));
    EXPECT_NEAR(double(by_threshold), double(spent), 0.02 * double(budget));
  }
}

TEST_F(Budget, PlentyIsTheThresholdsChoice) {
  Random random(33);
  std::vector<lithe_instance> instances = randomInstances(random, 500), plain = instances;
  lithe_view view = perspective(2);
  view.hysteresis = 0.3f;
  for (uint32_t frame = 0; frame < 20; ++frame) {
    view.position[2] = -2.0f * static_cast<float>(frame % 7);
    const uint64_t triangles = freely(plain, view);
    float factor = 0;
    EXPECT_EQ(within(instances, view, frame % 2 ? triangles : UINT64_MAX, &factor), triangles);
    EXPECT_EQ(factor, 1.0f);
    for (size_t i = 0; i < plain.size(); ++i) EXPECT_EQ(instances[i].level, plain[i].level);
  }
}

TEST_F(Budget, AlikeInstancesGetTheRestInTheirOrder) {
  std::vector<lithe_instance> instances(10, instanceAt(50));
  for (lithe_instance& instance : instances) instance.asset = 1;
  const lithe_view view = perspective(0.01f);
  const uint64_t coarse = trianglesAt(instances[0], 0), fine = trianglesAt(instances[0], 1);
  EXPECT_EQ(within(instances, view, 10 * coarse + 3 * (fine - coarse) + 1), 10 * coarse + 3 * (fine - coarse));
  for (uint32_t i = 0; i < 10; ++i) EXPECT_EQ(instances[i].level, i < 3 ? 1 : 0);
}

// A camera that moves slowly: hysteresis holds under a budget too.
TEST_F(Budget, IsStable) {
  Random random(34);
  std::vector<lithe_instance> instances = randomInstances(random, 5000), fine = instances;
  lithe_view view = perspective(1);
  view.hysteresis = 0.2f;
  const uint64_t budget = freely(fine, view) / 2;
  within(instances, view, budget);
  uint32_t most = 0;
  for (uint32_t frame = 0; frame < 100; ++frame) {
    view.position[2] -= 0.05f;
    std::vector<lithe_instance> before = instances;
    EXPECT_LE(within(instances, view, budget), budget);
    uint32_t changed = 0;
    for (size_t i = 0; i < before.size(); ++i) changed += before[i].level != instances[i].level;
    most = std::max(most, changed);
  }
  EXPECT_LT(most, 50u);  // of 5,000
  EXPECT_GT(most, 0u);
}

TEST_F(Budget, OnlyWhatIsResidentAndAllowedIsGiven) {
  ASSERT_EQ(lithe_asset_evict(handles_[0].get(), 2), LITHE_OK);
  const HandMade other({}, 2);
  const auto empty = other.open(*mallocAllocator(), false);
  assets_.push_back(empty.get());
  std::vector<lithe_instance> instances(4, instanceAt(10));
  instances[1].asset = 1;
  instances[1].end_level = 2;
  instances[2].asset = 1;
  instances[2].first_level = 3;
  std::vector<lithe_instance> undrawable(1, instanceAt(10));
  undrawable[0].asset = 3;
  uint32_t wanted[4] = {};
  EXPECT_GT(within(instances, perspective(1), 0, nullptr, wanted), 0u);
  EXPECT_EQ(instances[2].level, 3);
  EXPECT_EQ(instances[0].level, 0);
  within(instances, perspective(0.001f), UINT64_MAX, nullptr, wanted);
  EXPECT_EQ(instances[0].level, 2);
  EXPECT_EQ(instances[1].level, 1);
  EXPECT_GT(wanted[0], 2u);
  lithe_select_stats stats = {};
  std::vector<uint64_t> scratch(lithe_budget_scratch(1) / 8 + 1);
  const lithe_crowd crowd = of(undrawable);
  const lithe_view view = perspective(1);
  ASSERT_EQ(lithe_select_within(&crowd, &view, 1, 100, wanted, &stats, scratch.data(), scratch.size() * 8, nullptr),
            LITHE_OK);
  EXPECT_EQ(undrawable[0].level, LITHE_UNDRAWN);
  EXPECT_EQ(stats.undrawable, 1u);
  EXPECT_GT(wanted[3], 0u);
}

TEST_F(Budget, WhatNoViewSeesCostsNothing) {
  std::vector<lithe_instance> instances(2, instanceAt(20));
  instances[1].center[2] = -20;
  lithe_view view = perspective(0.01f);
  view.plane_count = 1;
  view.planes[0][2] = 1;
  std::vector<uint64_t> scratch(lithe_budget_scratch(2) / 8 + 1);
  lithe_select_stats stats = {};
  const lithe_crowd crowd = of(instances);
  const uint64_t finest = trianglesAt(instances[0], levelCount(instances[0]) - 1);
  ASSERT_EQ(lithe_select_within(&crowd, &view, 1, finest, nullptr, &stats, scratch.data(), scratch.size() * 8, nullptr),
            LITHE_OK);
  EXPECT_EQ(stats.triangles, finest);
  EXPECT_EQ(stats.unseen, 1u);
  EXPECT_EQ(instances[1].views, 0);
}

TEST_F(Budget, NumbersThatAreNoneStayWithinItAllTheSame) {
  Random random(35);
  for (const float odd : {NAN, INFINITY, -INFINITY, -1.0f, 0.0f, 3e38f}) {
    std::vector<lithe_instance> instances = randomInstances(random, 40);
    for (uint32_t i = 0; i < 40; i += 3) instances[i].scale = odd;
    for (uint32_t i = 1; i < 40; i += 3) instances[i].center[i % 2 ? 0 : 2] = odd;
    std::vector<lithe_instance> coarsest = instances;
    for (lithe_instance& instance : coarsest) instance.level = 0;
    const uint64_t budget = trianglesOf(coarsest) * 3;
    EXPECT_LE(within(instances, perspective(1), budget), budget);
  }
}

TEST_F(Budget, BadArguments) {
  std::vector<lithe_instance> instances(3, instanceAt(20));
  const lithe_crowd crowd = of(instances);
  const lithe_view view = perspective(1);
  std::vector<uint64_t> scratch(lithe_budget_scratch(3) / 8 + 1);
  const size_t bytes = scratch.size() * 8;
  const auto call = [&](const lithe_crowd* c, const lithe_view* v, void* memory, size_t size) {
    return lithe_select_within(c, v, 1, 100, nullptr, nullptr, memory, size, nullptr);
  };
  EXPECT_EQ(call(&crowd, &view, scratch.data(), bytes), LITHE_OK);
  EXPECT_EQ(call(nullptr, &view, scratch.data(), bytes), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call(&crowd, nullptr, scratch.data(), bytes), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call(&crowd, &view, nullptr, bytes), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call(&crowd, &view, reinterpret_cast<char*>(scratch.data()) + 4, bytes - 4), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(call(&crowd, &view, scratch.data(), lithe_budget_scratch(3) - 1), LITHE_ERROR_BUFFER_TOO_SMALL);
  instances[1].asset = 77;
  EXPECT_EQ(call(&crowd, &view, scratch.data(), bytes), LITHE_ERROR_INVALID_ARGUMENT);
}

}  // namespace
}  // namespace lithe::test
