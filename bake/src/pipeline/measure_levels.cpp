// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>
#include <utility>

#include "level_surface.h"
#include "levels.h"
#include "lithe/bake/parallel.h"

namespace lithe::bake {
namespace {

/// Points per pose and direction, beside the vertices.
constexpr uint32_t kMeasuredSamples = 2000;
/// Vertices that one thread looks up in a row.
constexpr size_t kRun = 4096;

/// The first ones, since poses of clips and sampled ones begin with the strongest, and some spread over the others,
/// since a pose file has any order.
std::vector<Pose> measuredPoses(const std::vector<Pose>& poses) {
  constexpr size_t kFirst = 4, kSpread = 4;
  std::vector<Pose> chosen(poses.begin(), poses.begin() + static_cast<std::ptrdiff_t>(std::min(kFirst, poses.size())));
  const size_t others = poses.size() - chosen.size(), count = std::min(kSpread, others);
  for (size_t i = 0; i < count; ++i) chosen.push_back(poses[kFirst + i * others / count]);
  return chosen;
}

/// A surface in one pose after the other. Its tree is built once and moved along: building costs more than searching.
class MovingSurface {
 public:
  explicit MovingSurface(const Model& shape) : shape_(shape) {}

  void moveTo(const Pose& pose) {
    positions_ = skinPositions(shape_, pose);
    if (tree_)
      tree_->move(positions_, shape_.triangles);
    else if (!shape_.triangles.empty())
      tree_.emplace(positions_, shape_.triangles);
  }

  const std::vector<glm::dvec3>& positions() const { return positions_; }
  const std::vector<Triangle>& triangles() const { return shape_.triangles; }
  const TriangleTree& tree() const { return *tree_; }

 private:
  const Model& shape_;
  std::vector<glm::dvec3> positions_;
  std::optional<TriangleTree> tree_;
};

struct MeasuredLevel {
  explicit MeasuredLevel(LevelSurface of_level) : level(std::move(of_level)), surface(level.shape) {}
  MeasuredLevel(const MeasuredLevel&) = delete;  // the surface refers to the level beside it

  LevelSurface level;
  MovingSurface surface;
};

/// What ties the original to the mesh that was welded from it.
struct Correspondence {
  std::vector<uint32_t> mesh_vertex;  ///< per vertex of the original
  TrianglesAt triangles_at;           ///< per vertex of the mesh: the original's triangles there
};

/// @param finest  in the same pose as the original
Correspondence correspondence(const MovingSurface& original, const MeasuredLevel& finest, uint32_t mesh_vertices,
                              uint32_t threads) {
  const size_t count = original.positions().size();
  Correspondence result;
  result.mesh_vertex.resize(count);
  forEachIndex(static_cast<uint32_t>((count + kRun - 1) / kRun), threads, [&](size_t run) {
    uint32_t hint = kNone;
    for (size_t vertex = run * kRun; vertex < std::min(count, (run + 1) * kRun); ++vertex) {
      const NearestPoint nearest = finest.surface.tree().nearest(original.positions()[vertex], hint);
      hint = nearest.triangle;
      const int corner = largestShare(nearest.barycentric);
      result.mesh_vertex[vertex] = finest.level.vertex_near[finest.surface.triangles()[hint][corner]];
    }
  });
  result.triangles_at = TrianglesAt(original.triangles(), result.mesh_vertex, mesh_vertices);
  return result;
}

/// Raises `plan`'s errors to what is found in the pose that both surfaces are in.
void measureInPose(const MovingSurface& original, const MeasuredLevel& measured, const Correspondence& ties,
                   uint64_t seed, LevelPlan& plan) {
  const LevelSurface& level = measured.level;
  const MovingSurface& surface = measured.surface;
  const TrianglesNear on_level = [&](uint32_t vertex) -> std::span<const uint32_t> {
    const uint32_t node = level.node_of[ties.mesh_vertex[vertex]];
    if (node == kNone) return {};
    return level.triangles_at[node];
  };
  const TrianglesNear on_original = [&](uint32_t node) { return ties.triangles_at[level.vertex_near[node]]; };
  const SurfaceDistance forth =
      sampledDistance(original.positions(), original.triangles(), surface.tree(), kMeasuredSamples, seed, on_level);
  const SurfaceDistance back =
      sampledDistance(surface.positions(), surface.triangles(), original.tree(), kMeasuredSamples, seed, on_original);
  plan.error = std::max({plan.error, forth.max, back.max});
  plan.error_rms = std::max({plan.error_rms, forth.rms, back.rms});
  plan.error = farthestVertex(original.positions(), original.triangles(), surface.tree(), plan.error, on_level);
  plan.error = farthestVertex(surface.positions(), surface.triangles(), original.tree(), plan.error, on_original);
}

/// Selection relies on it that a coarser level never states less than a finer one.
void carryUp(std::vector<LevelPlan>& levels) {
  for (size_t level = levels.size() - 1; level-- > 0;) {
    levels[level].error = std::max(levels[level].error, levels[level + 1].error);
    levels[level].error_rms = std::max(levels[level].error_rms, levels[level + 1].error_rms);
  }
}

}  // namespace

void measureLevels(const Model& model, const Mesh& mesh, const CollapseSequence& sequence,
                   const std::vector<Pose>& all_poses, uint32_t threads, std::vector<LevelPlan>& levels,
                   const std::function<void(double)>& progress) {
  const std::vector<Pose> poses = measuredPoses(all_poses);
  std::vector<std::optional<MeasuredLevel>> measured(levels.size());
  forEachIndex(static_cast<uint32_t>(levels.size()), threads,
               [&](size_t i) { measured[i].emplace(levelSurface(mesh, sequence, levels[i].collapses)); });
  MovingSurface original(model);
  Correspondence ties;
  for (size_t pose = 0; pose < poses.size(); ++pose) {
    // One more job than levels: the original's.
    forEachIndex(static_cast<uint32_t>(levels.size() + 1), threads, [&](size_t i) {
      MovingSurface& surface = i == 0 ? original : measured[levels.size() - i]->surface;
      surface.moveTo(poses[pose]);
    });
    if (pose == 0) ties = correspondence(original, *measured.back(), mesh.vertexCount(), threads);
    forEachIndex(static_cast<uint32_t>(levels.size()), threads, [&](size_t done) {
      const size_t i = levels.size() - 1 - done;  // the finest, which takes longest, first
      if (measured[i]->level.shape.triangles.empty())
        levels[i].error = levels[i].error_rms = std::max(levels[i].error, posedDiagonal(model, {poses[pose]}));
      else
        measureInPose(original, *measured[i], ties, i, levels[i]);
    });
    carryUp(levels);
    if (progress) progress(static_cast<double>(pose + 1) / static_cast<double>(poses.size()));
  }
}

}  // namespace lithe::bake
