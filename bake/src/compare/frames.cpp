// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "frames.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

#include "lithe/bake/poses.h"

namespace lithe::bake {

namespace {

constexpr double kFullRate = 30.0;  // frames a second when all frames are asked for
constexpr uint32_t kMostFrames = 100000;

std::string namesOf(const std::vector<Clip>& clips) {
  std::string names;
  for (const Clip& clip : clips) names += (names.empty() ? "" : ", ") + clip.name;
  return names.empty() ? "none" : names;
}

uint32_t clipNamed(const std::vector<Clip>& clips, const std::string& name) {
  for (uint32_t i = 0; i < clips.size(); ++i) {
    if (clips[i].name == name) return i;
  }
  uint32_t index = 0;
  const char* end = name.data() + name.size();
  const auto parsed = std::from_chars(name.data(), end, index);
  if (parsed.ec == std::errc() && parsed.ptr == end && index < clips.size()) return index;
  throw Error("the original has no clip '" + name + "': choose one of " + namesOf(clips));
}

std::vector<uint32_t> chosenClips(const std::vector<Clip>& clips, const std::string& animation) {
  if (animation != "all") return {clipNamed(clips, animation)};
  std::vector<uint32_t> all(clips.size());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

double durationOf(const Clip& clip) { return clip.end - clip.begin; }

/// The middle of the step of kCandidateRate that `along` (0 to 1) lies in.
double betweenCandidates(const Clip& clip, double along) {
  const double steps = std::max(1.0, std::floor(durationOf(clip) * kCandidateRate + 0.5));
  return (std::min(std::floor(along * steps), steps - 1.0) + 0.5) / steps;
}

/// `frames` as evenly spread clips of the selection, one frame each.
std::vector<uint32_t> thinnedOut(const std::vector<uint32_t>& selection, uint32_t frames) {
  std::vector<uint32_t> kept(frames);
  for (uint64_t i = 0; i < frames; ++i) kept[i] = selection[i * selection.size() / frames];
  return kept;
}

/// Frames per selected clip: one each, then always where the longest time has no frame of its own (ties: the earlier
/// clip).
std::vector<uint32_t> framesPerClip(const std::vector<Clip>& clips, const std::vector<uint32_t>& selection,
                                    uint32_t frames) {
  constexpr double kInstant = 1e-9;  // lets clips without duration take part
  std::vector<uint32_t> counts(selection.size(), 1);
  for (size_t given = selection.size(); given < frames; ++given) {
    size_t neediest = 0;
    double longest = -1.0;
    for (size_t i = 0; i < selection.size(); ++i) {
      const double share = (durationOf(clips[selection[i]]) + kInstant) / counts[i];
      if (share > longest) {
        longest = share;
        neediest = i;
      }
    }
    ++counts[neediest];
  }
  return counts;
}

std::vector<ClipTime> everyFrame(const std::vector<Clip>& clips, const std::vector<uint32_t>& selection) {
  std::vector<ClipTime> frames;
  for (const uint32_t clip : selection) {
    const double steps = std::floor(durationOf(clips[clip]) * kFullRate + 1e-6);
    if (!(steps + static_cast<double>(frames.size()) < kMostFrames)) {
      throw Error("clip '" + clips[clip].name + "' is too long to compare every frame: name a number of frames");
    }
    for (uint32_t k = 0; k <= static_cast<uint32_t>(steps); ++k) {
      frames.push_back({clip, std::min(clips[clip].begin + k / kFullRate, clips[clip].end)});
    }
  }
  return frames;
}

/// A model without geometry whose palette is the world matrix of every node.
Model skeletonOf(const Model& model) {
  Model skeleton;
  skeleton.nodes = model.nodes;
  skeleton.clips = model.clips;
  for (uint32_t node = 0; node < model.nodes.size(); ++node) skeleton.joints.push_back({node, glm::dmat4(1.0)});
  return skeleton;
}

/// Sampled poses know joints only: the other nodes keep their rest transform below their parent.
std::vector<glm::dmat4> nodeWorldsOf(const Model& model, const Pose& pose) {
  std::vector<uint32_t> joint_of(model.nodes.size(), kNone);
  for (uint32_t joint = static_cast<uint32_t>(model.joints.size()); joint-- > 0;)
    joint_of[model.joints[joint].node] = joint;
  std::vector<glm::dmat4> worlds;
  worlds.reserve(model.nodes.size());
  for (uint32_t node = 0; node < model.nodes.size(); ++node) {
    const uint32_t parent = model.nodes[node].parent;
    if (joint_of[node] != kNone) {
      worlds.push_back(pose.palette[joint_of[node]] * glm::inverse(model.joints[joint_of[node]].inverse_bind));
    } else {
      const glm::dmat4 local = model.nodes[node].rest.matrix();
      worlds.push_back(parent == kNone ? local : worlds[parent] * local);
    }
  }
  return worlds;
}

std::vector<Instant> sampledInstants(const Model& original, uint32_t count, uint32_t first) {
  std::vector<Instant> instants;
  for (const Pose& pose : sampledPoses(original, count, first))
    instants.push_back({"", 0.0, nodeWorldsOf(original, pose)});
  return instants;
}

}  // namespace

std::vector<ClipTime> chooseFrames(const std::vector<Clip>& clips, const CompareOptions& options) {
  if (options.frames > kMostFrames) throw Error("more than 100,000 frames are asked for: take fewer");
  std::vector<uint32_t> selection = chosenClips(clips, options.animation);
  if (options.frames == 0) return everyFrame(clips, selection);
  if (selection.size() > options.frames) selection = thinnedOut(selection, options.frames);
  const std::vector<uint32_t> counts = framesPerClip(clips, selection, options.frames);
  std::vector<ClipTime> frames;
  for (size_t i = 0; i < selection.size(); ++i) {
    const Clip& clip = clips[selection[i]];
    const bool in_slices = counts[i] == 1 || options.phase != FramePhase::kEnds;
    for (uint32_t k = 0; k < counts[i]; ++k) {
      double along = in_slices ? (k + 0.5) / counts[i] : static_cast<double>(k) / (counts[i] - 1);
      if (options.phase == FramePhase::kBetween) along = betweenCandidates(clip, along);
      frames.push_back({selection[i], clip.begin + along * durationOf(clip)});
    }
  }
  return frames;
}

Instant restInstant(const Model& original) { return {"", 0.0, restPose(skeletonOf(original)).palette}; }

std::vector<Instant> chosenInstants(const Model& original, const CompareOptions& options) {
  if (options.animation == "none") return {restInstant(original)};
  const bool no_clips = options.animation == "all" && original.clips.empty();
  if (no_clips || options.animation == "sampled") {
    if (options.frames > kMostFrames) throw Error("more than 100,000 frames are asked for: take fewer");
    return sampledInstants(original, std::max(options.frames, 1u), options.first_pose);
  }
  const Model skeleton = skeletonOf(original);
  std::vector<Instant> instants;
  for (const ClipTime& frame : chooseFrames(original.clips, options)) {
    instants.push_back(
        {original.clips[frame.clip].name, frame.time, clipPose(skeleton, frame.clip, frame.time).palette});
  }
  return instants;
}

}  // namespace lithe::bake
