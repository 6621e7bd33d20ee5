// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// A camera that comes nearer or goes away: with geomorphs no point of the surface jumps on the screen.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "decoded_character.h"

namespace lithe::test {
namespace {

struct Point {
  double x, y, z;
};

class Morph : public DecodedCharacter {
 protected:
  Point positionOf(uint32_t wedge) const {
    const lithe_hierarchy h = asset.hierarchy();
    const uint16_t* p = h.node_position + 3 * size_t{h.wedge_node[wedge]};
    return {p[0] * double(h.grid_step), p[1] * double(h.grid_step), p[2] * double(h.grid_step)};
  }

  /// The vertex that stands for a vertex of the finest level.
  uint32_t vertexAt(uint32_t level, uint32_t vertex) const {
    const lithe_hierarchy h = asset.hierarchy();
    while (vertex >= asset.level(level).vertex_count) vertex = h.wedge_parent[vertex];
    return vertex;
  }

  /// Where a level shows the vertices of the finest one, `morph` of the way to the next coarser level.
  std::vector<Point> shown(uint32_t level, float morph) const {
    std::vector<uint32_t> sources(asset.level(level).vertex_count);
    for (uint32_t v = 0; v < sources.size(); ++v) sources[v] = v;
    if (level > 0) {
      EXPECT_EQ(lithe_asset_write_morph_sources(asset.get(), level, sources.data(), sources.size()), LITHE_OK);
    }
    std::vector<Point> points;
    for (uint32_t v = 0; v < asset.info().vertex_count; ++v) {
      const uint32_t vertex = vertexAt(level, v);
      const Point to = positionOf(vertex), from = positionOf(sources[vertex]);
      const double m = morph;
      points.push_back({to.x + m * (from.x - to.x), to.y + m * (from.y - to.y), to.z + m * (from.z - to.z)});
    }
    return points;
  }

  struct Walk {
    double largest_jump = 0;  ///< pixels, over all points and changes of the level
    uint32_t changes = 0;
  };

  /// From where the coarsest level does to where the finest is wanted, or back, by a 10,000th of the distance a frame.
  /// A jump is how far a change of the level moves a point while the camera stands still.
  Walk walk(bool nearer, bool morphs) const {
    lithe_view view = {};
    view.pixels_per_radian = 500;
    view.near_distance = 1e-6f;
    view.threshold_px = 1;
    view.hysteresis = 0.1f;
    lithe_instance instance = {};
    instance.scale = instance.bias = 1;
    instance.level = LITHE_UNDRAWN;
    const lithe_asset* assets[] = {asset.get()};
    const lithe_crowd crowd = {assets, &instance, 0, 1, 1};
    const auto shownNow = [&] {
      float morph = 0;
      EXPECT_EQ(lithe_morph_factors(&crowd, &view, 1, 1, 0.25f, &morph), LITHE_OK);
      EXPECT_TRUE(morph >= 0 && morph <= 1);
      return shown(instance.level, morphs ? morph : 0.0f);
    };
    const double farthest = 550.0 * asset.level(0).error, nearest = 350.0 * asset.level(levelCount() - 2).error;
    Walk result;
    for (double distance = nearer ? farthest : nearest; nearer ? distance > nearest : distance < farthest;
         distance *= nearer ? 1 - 1e-4 : 1 + 1e-4) {
      instance.center[2] = static_cast<float>(distance);
      const uint8_t last = instance.level;
      EXPECT_EQ(lithe_select(&crowd, &view, 1, nullptr, nullptr), LITHE_OK);
      if (last == instance.level || last == LITHE_UNDRAWN) continue;
      ++result.changes;
      const uint8_t level = instance.level;
      const std::vector<Point> after = shownNow();
      instance.level = last;
      const std::vector<Point> before = shownNow();
      instance.level = level;
      for (size_t i = 0; i < before.size(); ++i) {
        const double way = std::hypot(after[i].x - before[i].x, after[i].y - before[i].y, after[i].z - before[i].z);
        result.largest_jump = std::max(result.largest_jump, way * 500 / distance);
      }
    }
    EXPECT_GT(result.changes, 0u);
    return result;
  }
};

TEST_P(Morph, NothingJumpsOnTheWayNearerOrAway) {
  for (const bool nearer : {true, false}) {
    const double with = walk(nearer, true).largest_jump, without = walk(nearer, false).largest_jump;
    EXPECT_LT(with, 0.5) << "without geomorphs " << without;
    EXPECT_GT(without, 1.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Characters, Morph, testing::Values("baked_tube", "baked_open_tube"),
                         [](const auto& parameter) { return parameter.param; });

}  // namespace
}  // namespace lithe::test
