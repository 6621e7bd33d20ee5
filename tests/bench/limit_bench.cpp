// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// How close one hierarchy for all poses comes to simplifying every frame on its own, which no animated character can
// afford: each judged frame, frozen, is simplified to the same count by quadrics of its own (metric `rest`: Garland and
// Heckbert 1997, weighted by area, vertices placed freely).
//
//     bench_limit [NAME|FILE ...]
//
// Without names: the built-in characters and the shared ones. Prints markdown.
#include <cmath>
#include <cstdio>

#include "bench_character.h"
#include "lithe/bake/cut.h"
#include "lithe/bake/nearest.h"
#include "simplified.h"

namespace lithe::bench {
namespace {

constexpr double kShares[] = {0.5, 0.2, 0.1, 0.05, 0.02};
constexpr double kReach[] = {1.1, 1.0, 0.9, 0.9, 0.9};  // what the project asks of the geometric means
constexpr uint32_t kFrames = 4;
constexpr uint32_t kSamples = 20000;
constexpr uint32_t kUnseenPoses = 4096;  // the first of the sampled poses that no bake takes

/// Instants spread over the clips, off the candidates that a bake chooses from; without clips, sampled poses that no
/// bake takes.
std::vector<bake::Pose> judgedPoses(const bake::Model& model) {
  if (model.clips.empty()) return bake::sampledPoses(model, kFrames, kUnseenPoses);
  std::vector<bake::Pose> poses;
  for (uint32_t i = 0; i < kFrames; ++i) {
    const auto clip = static_cast<uint32_t>(i * model.clips.size() / kFrames);
    const bake::Clip& of = model.clips[clip];
    const double share = (i + 0.5) / kFrames, between = 0.5 / bake::kCandidateRate;
    const double time = of.begin + share * (of.end - of.begin);
    poses.push_back(
        bake::clipPose(model, clip, std::floor(time * bake::kCandidateRate) / bake::kCandidateRate + between));
  }
  return poses;
}

/// The character as it stands in a pose, on one joint that does not move.
bake::Model frozen(const bake::Model& model, const std::vector<glm::dvec3>& positions) {
  bake::Model frame = model;
  frame.nodes = {{"root", bake::kNone, {}}};
  frame.joints = {{0, glm::dmat4(1.0)}};
  frame.clips.clear();
  for (bake::Part& part : frame.parts) part.rigid_node = bake::kNone;
  for (size_t i = 0; i < positions.size(); ++i) {
    frame.positions[i] = glm::vec3(positions[i]);
    frame.skins[i] = {};
    frame.skins[i].count = 1;
    frame.skins[i].weight[0] = 1.0f;
  }
  return frame;
}

/// The larger of both directions, in 1e-4 of the rest diagonal.
double distanceBetween(const bake::Model& model, const std::vector<glm::dvec3>& original, const bake::Model& cut,
                       const std::vector<glm::dvec3>& posed) {
  const bake::TriangleTree original_tree(original, model.triangles), cut_tree(posed, cut.triangles);
  const double forth = bake::surfaceDistance(original, model.triangles, cut_tree, kSamples, 1).rms;
  const double back = bake::surfaceDistance(posed, cut.triangles, original_tree, kSamples, 2).rms;
  return 1e4 * std::max(forth, back) / model.rest_diagonal;
}

struct Rms {
  double lithe = 0.0, limit = 0.0;  // means over the frames
};

std::vector<Rms> measure(const bake::Model& model) {
  const bake::BakeOptions options;
  bake::BakeOptions frame_options;
  frame_options.metric = "rest";
  frame_options.position_bits = 16;
  frame_options.precision = 31;
  const Simplified all = simplified(model, bake::choosePoses(model, options.poses), options);
  std::vector<bake::Model> cuts;
  for (const double share : kShares)
    cuts.push_back(bake::cutToModel(model, all.mesh, all.sequence, all.triangles(share)));
  std::vector<Rms> rms(std::size(kShares));
  for (const bake::Pose& pose : judgedPoses(model)) {
    const std::vector<glm::dvec3> original = bake::skinPositions(model, pose);
    const bake::Model frame = frozen(model, original);
    const Simplified alone = simplified(frame, {bake::restPose(frame)}, frame_options);
    for (size_t i = 0; i < std::size(kShares); ++i) {
      const bake::Model& cut = cuts[i];
      const bake::Model best = bake::cutToModel(frame, alone.mesh, alone.sequence, all.triangles(kShares[i]));
      const std::vector<glm::dvec3> at(best.positions.begin(), best.positions.end());
      rms[i].lithe += distanceBetween(model, original, cut, bake::skinPositions(cut, pose)) / kFrames;
      rms[i].limit += distanceBetween(model, original, best, at) / kFrames;
    }
  }
  return rms;
}

void printLimits(const std::vector<std::string>& names, bool) {
  std::printf("| character |");
  for (const double share : kShares) std::printf(" %g %%: lithe | limit | ratio |", 100.0 * share);
  std::printf("\n|---|");
  for (size_t i = 0; i < std::size(kShares); ++i) std::printf("---:|---:|---:|");
  std::printf("\n");
  double logs[std::size(kShares)] = {};
  for (const std::string& name : names) {
    const Source source = loadCharacter(name);
    const std::vector<Rms> rms = measure(source.model);
    std::printf("| %s |", source.name.c_str());
    for (size_t i = 0; i < std::size(kShares); ++i) {
      const double ratio = rms[i].lithe / rms[i].limit;
      logs[i] += std::log(ratio) / static_cast<double>(names.size());
      std::printf(" %.3f | %.3f | %.2f |", rms[i].lithe, rms[i].limit, ratio);
    }
    std::printf("\n");
    std::fflush(stdout);
  }
  std::printf("| **geometric mean** |");
  for (const double log : logs) std::printf(" | | **%.2f** |", std::exp(log));
  std::printf("\n| to reach |");
  for (const double reach : kReach) std::printf(" | | %g |", reach);
  std::printf("\n");
}

}  // namespace
}  // namespace lithe::bench

int main(int argc, char** argv) {
  return lithe::bench::runOverCharacters(argc, argv, "bench_limit [NAME|FILE ...]", lithe::bench::printLimits);
}
