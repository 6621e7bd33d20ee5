// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "levels.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

#include "lithe/bake/cut.h"
#include "lithe/bake/nearest.h"

namespace lithe::bake {
namespace {

/// Poses in which levels are measured, and points per direction beside the vertices.
constexpr uint32_t kMeasuredPoses = 4;
constexpr uint32_t kMeasuredSamples = 4000;

template <typename Work>
void parallel(size_t count, uint32_t threads, const Work& work) {
  std::atomic<size_t> next{0};
  auto loop = [&] {
    for (size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::thread> pool;
  const uint32_t wanted = threads ? threads : std::max(1u, std::thread::hardware_concurrency());
  for (uint32_t t = 1; t < wanted && t < count; ++t) pool.emplace_back(loop);
  loop();
  for (std::thread& thread : pool) thread.join();
}

std::vector<Pose> spreadPoses(const std::vector<Pose>& poses) {
  std::vector<Pose> chosen;
  const size_t count = std::min<size_t>(kMeasuredPoses, poses.size());
  for (size_t i = 0; i < count; ++i) chosen.push_back(poses[i * poses.size() / count]);
  return chosen;
}

}  // namespace

std::vector<LevelPlan> planLevels(const CollapseSequence& sequence, const Mesh& mesh,
                                  const std::vector<double>& shares) {
  std::vector<uint32_t> collapses = {0};
  std::vector<double> descending = shares;
  std::sort(descending.rbegin(), descending.rend());
  for (double share : descending) {
    const double target = std::max(1.0, std::round(share * mesh.triangleCount()));
    const uint32_t count = collapsesToReach(sequence, mesh, static_cast<uint32_t>(target));
    if (count >= collapses.back() + kMinLevelCollapses) collapses.push_back(count);
  }
  // The sequence's end is the base, whatever the distance to the last level.
  const uint32_t end = static_cast<uint32_t>(sequence.collapses.size());
  if (collapses.back() != end) {
    if (collapses.size() > 1 && end < collapses.back() + kMinLevelCollapses) collapses.pop_back();
    collapses.push_back(end);
  }
  std::vector<LevelPlan> levels;
  for (size_t i = collapses.size(); i-- > 0;) levels.push_back({collapses[i], 0.0, 0.0});
  return levels;
}

void measureLevels(const Model& model, const Mesh& mesh, const CollapseSequence& sequence,
                   const std::vector<Pose>& all_poses, uint32_t threads, std::vector<LevelPlan>& levels,
                   const std::function<void(double)>& progress) {
  const std::vector<Pose> poses = spreadPoses(all_poses);
  std::vector<Model> cuts(levels.size());
  parallel(levels.size(), threads, [&](size_t level) {
    const uint32_t collapses = levels[level].collapses;
    const uint32_t triangles = collapses == 0 ? mesh.triangleCount() : sequence.collapses[collapses - 1].triangles;
    cuts[level] = cutToModel(model, mesh, sequence, triangles);
  });
  for (const Pose& pose : poses) {
    const std::vector<glm::dvec3> original = skinPositions(model, pose);
    const TriangleTree original_tree(original, model.triangles);
    parallel(levels.size(), threads, [&](size_t level) {
      const Model& cut = cuts[level];
      if (cut.triangles.empty()) {
        levels[level].error = std::max(levels[level].error, posedDiagonal(model, {pose}));
        levels[level].error_rms = levels[level].error;
        return;
      }
      const std::vector<glm::dvec3> posed = skinPositions(cut, pose);
      const SurfaceDistance forth =
          surfaceDistance(original, model.triangles, TriangleTree(posed, cut.triangles), kMeasuredSamples, level);
      const SurfaceDistance back = surfaceDistance(posed, cut.triangles, original_tree, kMeasuredSamples, level);
      levels[level].error = std::max({levels[level].error, forth.max, back.max});
      levels[level].error_rms = std::max({levels[level].error_rms, forth.rms, back.rms});
    });
    if (progress) progress(static_cast<double>(&pose - poses.data() + 1) / static_cast<double>(poses.size()));
  }
  for (size_t level = levels.size() - 1; level-- > 0;) {
    levels[level].error = std::max(levels[level].error, levels[level + 1].error);
    levels[level].error_rms = std::max(levels[level].error_rms, levels[level + 1].error_rms);
  }
}

}  // namespace lithe::bake
