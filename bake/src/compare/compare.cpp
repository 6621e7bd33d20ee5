// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/compare.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "frames.h"
#include "lithe/bake/parallel.h"
#include "posed_surface.h"
#include "seams.h"
#include "silhouette.h"
#include "surface_error.h"

namespace lithe::bake {

namespace {

constexpr uint32_t kMostSamples = 10'000'000;

/// Everything that is the same in all frames.
struct Comparison {
  MeasuredSurface original, simplified;
  const std::vector<Joint>& original_joints;
  const std::vector<Joint>& simplified_joints;
  std::vector<uint32_t> original_nodes, simplified_nodes;  ///< per joint: the original's node it follows
  SeamProbe seams;
  double rest_diagonal = 0.0;
  uint32_t samples = 0;
  uint64_t seed = 0;
  bool has_uv = false;
  double beyond = std::numeric_limits<double>::infinity();
};

std::vector<uint32_t> ownNodes(const Model& model) {
  std::vector<uint32_t> nodes;
  for (const Joint& joint : model.joints) nodes.push_back(joint.node);
  return nodes;
}

PosedSurface posedOriginal(const Comparison& c, const Instant& instant) {
  return poseSurface(c.original, paletteAt(instant, c.original_joints, c.original_nodes));
}

PosedSurface posedSimplified(const Comparison& c, const Instant& instant) {
  return poseSurface(c.simplified, paletteAt(instant, c.simplified_joints, c.simplified_nodes));
}

Comparison prepare(const Model& original, const Model& simplified, const CompareOptions& options) {
  Comparison c{surfaceOf(original, options.include_rigid, "original"),
               surfaceOf(simplified, options.include_rigid, "simplified"),
               original.joints,
               simplified.joints,
               ownNodes(original),
               matchJoints(original, simplified),
               {}};
  c.samples = options.samples;
  c.seed = options.seed;
  if (options.beyond) c.beyond = *options.beyond;
  c.has_uv = !c.original.uvs.empty() && !c.simplified.uvs.empty();
  const Instant rest = restInstant(original);
  const PosedSurface original_rest = posedOriginal(c, rest);
  c.seams = makeSeamProbe(c.original, original_rest.positions, posedSimplified(c, rest).positions);
  c.rest_diagonal = original.rest_diagonal > 0.0 ? original.rest_diagonal : diagonalOf(original_rest.positions);
  if (!(c.rest_diagonal > 0.0)) throw Error("the original model has no extent: give a model with a surface");
  return c;
}

/// @param number  of the frame: every frame draws its own samples
FrameReport measureFrame(const Comparison& c, const Instant& instant, uint64_t number) {
  const SearchableSurface original(c.original, posedOriginal(c, instant));
  const SearchableSurface simplified(c.simplified, posedSimplified(c, instant));
  const uint64_t seed = (c.seed << 32) + 2 * number;
  const Sampling forth{c.samples, seed, c.has_uv, c.beyond, true};
  const Sampling back{c.samples, seed + 1, c.has_uv, c.beyond, false};
  const double unit = 1.0 / c.rest_diagonal;
  FrameReport frame;
  frame.clip = instant.clip;
  frame.time = instant.time;
  frame.original_to_simplified = scaled(surfaceError(original, simplified, forth), unit, 1.0);
  frame.simplified_to_original = scaled(surfaceError(simplified, original, back), unit, 1.0);
  frame.symmetric = largerOf(frame.original_to_simplified, frame.simplified_to_original);
  frame.silhouette = silhouetteDifference(original.posed.positions, c.original.triangles, simplified.posed.positions,
                                          c.simplified.triangles);
  frame.seam = measureSeams(c.seams, original.posed.positions, simplified.posed.positions);
  frame.seam.gap *= unit;
  frame.seam.opened *= unit;
  return frame;
}

void summarizeFrames(CompareReport& report) {
  for (const FrameReport& frame : report.frames) {
    accumulate(report.mean, frame.symmetric);
    report.worst = largerOf(report.worst, frame.symmetric);
    report.mean_silhouette += frame.silhouette;
    report.worst_silhouette = std::max(report.worst_silhouette, frame.silhouette);
    report.seam.gap = std::max(report.seam.gap, frame.seam.gap);
    report.seam.opened = std::max(report.seam.opened, frame.seam.opened);
  }
  const double share = 1.0 / static_cast<double>(report.frames.size());
  report.mean = scaled(report.mean, share, share);
  report.mean_silhouette *= share;
}

double weightSumError(const MeasuredSurface& surface) {
  double largest = 0.0;
  for (const Skin& skin : surface.skins) {
    double sum = 0.0;
    for (uint32_t k = 0; k < skin.count; ++k) sum += skin.weight[k];
    largest = std::max(largest, std::abs(1.0 - sum));
  }
  return largest;
}

}  // namespace

CompareReport compare(const Model& original, const Model& simplified, const CompareOptions& options) {
  if (options.samples < 1 || options.samples > kMostSamples) {
    throw Error("cannot compare with " + std::to_string(options.samples) + " samples: use 1 to 10,000,000");
  }
  const Comparison comparison = prepare(original, simplified, options);
  const std::vector<Instant> instants = chosenInstants(original, options);
  CompareReport report;
  report.original_triangles = static_cast<uint32_t>(comparison.original.triangles.size());
  report.original_vertices = static_cast<uint32_t>(comparison.original.positions.size());
  report.simplified_triangles = static_cast<uint32_t>(comparison.simplified.triangles.size());
  report.simplified_vertices = static_cast<uint32_t>(comparison.simplified.positions.size());
  report.rest_diagonal = comparison.rest_diagonal;
  report.has_uv = comparison.has_uv;
  report.samples = options.samples;
  report.beyond = options.beyond;
  report.weight_sum_error = weightSumError(comparison.simplified);
  report.frames.resize(instants.size());
  forEachIndex(static_cast<uint32_t>(instants.size()), options.threads,
               [&](uint32_t i) { report.frames[i] = measureFrame(comparison, instants[i], i); });
  summarizeFrames(report);
  return report;
}

}  // namespace lithe::bake
