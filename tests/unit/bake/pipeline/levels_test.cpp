// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "levels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lithe/bake/cut.h"
#include "lithe/bake/nearest.h"
#include "lithe/bake/simplify.h"
#include "lithe/bake/weld.h"
#include "shapes.h"

namespace lithe::bake {
namespace {

// ---- The plan ----

/// A mesh of `triangles` of which every collapse takes two.
struct Plan {
  Mesh mesh;
  CollapseSequence sequence;

  Plan(uint32_t triangles, uint32_t collapses) {
    mesh.triangles.resize(triangles);
    sequence.collapses.resize(collapses);
    for (uint32_t i = 0; i < collapses; ++i) sequence.collapses[i].triangles = triangles - 2 * (i + 1);
  }

  std::vector<uint32_t> levels(const std::vector<double>& shares) const {
    std::vector<uint32_t> collapses;
    for (const LevelPlan& level : planLevels(sequence, mesh, shares)) {
      collapses.push_back(level.collapses);
      EXPECT_EQ(level.error, 0.0);
    }
    return collapses;
  }
};

using Counts = std::vector<uint32_t>;

TEST(PlanLevels, SharesInAnyOrderGiveLevelsFromCoarseToFine) {
  const Plan plan(2000, 950);
  EXPECT_EQ(plan.levels({0.5, 0.7, 0.05}), (Counts{950, 500, 300, 0}));
  EXPECT_EQ(plan.levels({0.05, 0.7, 0.5}), (Counts{950, 500, 300, 0}));
}

TEST(PlanLevels, TheFinestIsAlwaysThereOnce) {
  const Plan plan(2000, 950);
  EXPECT_EQ(plan.levels({}), (Counts{950, 0}));
  EXPECT_EQ(plan.levels({1.0, 1.0}), (Counts{950, 0}));
  EXPECT_EQ(Plan(100, 0).levels({0.5}), Counts{0});
}

TEST(PlanLevels, LevelsTooCloseToTheLastAreLeftOut) {
  const Plan plan(2000, 950);
  EXPECT_EQ(plan.levels({0.9}), (Counts{950, 0})) << "100 collapses are fewer than " << kMinLevelCollapses;
  EXPECT_EQ(plan.levels({0.84}), (Counts{950, 160, 0}));
  EXPECT_EQ(plan.levels({0.5, 0.4}), (Counts{950, 500, 0}));
}

TEST(PlanLevels, TheBaseIsTheSequencesEndWhateverTheDistance) {
  // 900 is closer to the end than a level may be: the end takes its place.
  EXPECT_EQ(Plan(2000, 950).levels({0.5, 0.1}), (Counts{950, 500, 0}));
  EXPECT_EQ(Plan(40, 10).levels({0.5}), (Counts{10, 0}));
}

// ---- The measure ----

struct Measured {
  Model model = test::tube(12, 40);
  std::vector<Pose> poses;
  Mesh mesh;
  CollapseSequence sequence;
  std::vector<LevelPlan> levels;

  Measured() {
    std::vector<std::string> warnings;
    poses = {restPose(model), clipPose(model, 0, 0.5), clipPose(model, 0, 1.0)};
    mesh = weld(model, poses, {}, warnings);
    SimplifyOptions options;
    options.min_triangles = 20;
    sequence = simplify(mesh, model.joints, poses, options);
    const auto count = static_cast<uint32_t>(sequence.collapses.size());
    levels = {{count}, {count * 9 / 10}, {count / 2}, {count / 5}, {0}};
    measureLevels(model, mesh, sequence, poses, 2, levels, {});
  }
};

const Measured& measured() {
  static const Measured result;
  return result;
}

TEST(MeasureLevels, ErrorsNeverGrowWithTheLevel) {
  const auto& levels = measured().levels;
  for (size_t i = 1; i < levels.size(); ++i) {
    EXPECT_LE(levels[i].error, levels[i - 1].error) << i;
    EXPECT_LE(levels[i].error_rms, levels[i - 1].error_rms) << i;
  }
  for (const LevelPlan& level : levels) EXPECT_LE(level.error_rms, level.error);
  EXPECT_GT(levels[0].error, 10 * levels.back().error);
}

TEST(MeasureLevels, TheFinestLevelIsOffByTheQuantisationOnly) {
  // Half a grid step per axis, and weights of 1/255 where the elbow moves vertices by up to 2 * sqrt(2).
  const Measured& m = measured();
  EXPECT_GT(m.levels.back().error, 0.0);
  EXPECT_LT(m.levels.back().error, 0.9 * m.mesh.grid.step + 2.9 / 255);
}

double farthestVertex(const std::vector<glm::dvec3>& from, const std::vector<Triangle>& from_triangles,
                      const std::vector<glm::dvec3>& to, const std::vector<Triangle>& to_triangles) {
  const TriangleTree tree(to, to_triangles);
  double largest = 0.0;
  for (const Triangle& triangle : from_triangles)
    for (uint32_t vertex : triangle) largest = std::max(largest, tree.nearest(from[vertex]).distance2);
  return std::sqrt(largest);
}

// Beside its own samples the measure takes all vertices: no vertex of either surface is farther away than stated.
TEST(MeasureLevels, TheErrorCoversEveryVertexInEveryPose) {
  const Measured& m = measured();
  for (const LevelPlan& level : m.levels) {
    const uint32_t triangles =
        level.collapses ? m.sequence.collapses[level.collapses - 1].triangles : m.mesh.triangleCount();
    const Model cut = cutToModel(m.model, m.mesh, m.sequence, triangles);
    double largest = 0.0;
    for (const Pose& pose : m.poses) {
      const auto original = skinPositions(m.model, pose), posed = skinPositions(cut, pose);
      largest = std::max(largest, farthestVertex(original, m.model.triangles, posed, cut.triangles));
      largest = std::max(largest, farthestVertex(posed, cut.triangles, original, m.model.triangles));
    }
    EXPECT_LE(largest, level.error);
    EXPECT_GT(largest, 0.3 * level.error) << "stated without need";
  }
}

// What the measure skips, moves along and guesses must not show: the same from a tree of its own for every surface.
TEST(MeasureLevels, TheErrorIsThatOfTheWholeSearch) {
  const Measured& m = measured();
  double least = 0.0, least_rms = 0.0;
  for (size_t i = m.levels.size(); i-- > 0;) {
    const uint32_t collapses = m.levels[i].collapses;
    const uint32_t triangles = collapses ? m.sequence.collapses[collapses - 1].triangles : m.mesh.triangleCount();
    const Model cut = cutToModel(m.model, m.mesh, m.sequence, triangles);
    for (const Pose& pose : m.poses) {
      const auto original = skinPositions(m.model, pose), posed = skinPositions(cut, pose);
      const SurfaceDistance forth = surfaceDistance(original, m.model.triangles, posed, cut.triangles, 2000, i);
      const SurfaceDistance back = surfaceDistance(posed, cut.triangles, original, m.model.triangles, 2000, i);
      least = std::max({least, forth.max, back.max});
      least_rms = std::max({least_rms, forth.rms, back.rms});
    }
    EXPECT_DOUBLE_EQ(m.levels[i].error, least) << i;
    EXPECT_DOUBLE_EQ(m.levels[i].error_rms, least_rms) << i;
  }
}

TEST(MeasureLevels, LooksAtTheFirstPosesAndAtOthersSpreadOverTheRest) {
  const Measured& m = measured();
  const auto coarsest = [&](const std::vector<Pose>& poses) {
    std::vector<LevelPlan> levels = {{m.levels[0].collapses, 0.0, 0.0}, {0, 0.0, 0.0}};
    measureLevels(m.model, m.mesh, m.sequence, poses, 1, levels, {});
    return levels[0].error;
  };
  const Pose rest = m.poses[0], bent = m.poses[2];
  std::vector<Pose> poses(20, rest);
  const double still = coarsest(poses);
  for (const size_t seen : {0, 3, 4, 8, 12, 16}) {
    poses.assign(20, rest);
    poses[seen] = bent;
    EXPECT_GT(coarsest(poses), still) << seen;
  }
}

TEST(MeasureLevels, SameOnAnyNumberOfThreads) {
  const Measured& m = measured();
  std::vector<LevelPlan> alone = m.levels;
  for (LevelPlan& level : alone) level.error = level.error_rms = 0.0;
  double last = 0.0;
  measureLevels(m.model, m.mesh, m.sequence, m.poses, 1, alone, [&last](double progress) {
    EXPECT_GE(progress, last);
    last = progress;
  });
  EXPECT_EQ(last, 1.0);
  for (size_t i = 0; i < alone.size(); ++i) {
    EXPECT_EQ(alone[i].error, m.levels[i].error);
    EXPECT_EQ(alone[i].error_rms, m.levels[i].error_rms);
  }
}

TEST(MeasureLevels, ALevelOfNothingIsOffByTheWholeCharacter) {
  const Measured& m = measured();
  SimplifyOptions options;
  options.min_triangles = 0;
  const CollapseSequence all = simplify(m.mesh, m.model.joints, m.poses, options);
  ASSERT_EQ(all.collapses.back().triangles, 0u);
  std::vector<LevelPlan> levels = {{static_cast<uint32_t>(all.collapses.size())}, {0}};
  measureLevels(m.model, m.mesh, all, {m.poses[0]}, 1, levels, {});
  EXPECT_EQ(levels[0].error, posedDiagonal(m.model, {m.poses[0]}));
}

}  // namespace
}  // namespace lithe::bake
