// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "candidates.h"

#include <algorithm>
#include <cmath>

#include "lithe/bake/poses.h"

namespace lithe::bake {

namespace {

std::string clipNames(const Model& model) {
  std::string names;
  for (const Clip& clip : model.clips) names += (names.empty() ? "'" : ", '") + clip.name + "'";
  return names.empty() ? "the file has none" : "the file has " + names;
}

double seconds(const Clip& clip) { return std::max(0.0, clip.end - clip.begin); }

/// Samples of one clip at `rate`, first and last instant included.
uint32_t sampleCount(const Clip& clip, double rate) {
  return static_cast<uint32_t>(std::min(std::floor(seconds(clip) * rate + 0.5), double{kMaxCandidates})) + 1;
}

/// The highest rate up to kCandidateRate at which all clips together stay within kMaxCandidates, halving as long as
/// they do not; one sample per clip stays in any case.
double fittingRate(const Model& model, const std::vector<uint32_t>& clips) {
  for (double rate = kCandidateRate; rate > 1e-3; rate *= 0.5) {
    uint64_t total = 0;
    for (const uint32_t clip : clips) total += sampleCount(model.clips[clip], rate);
    if (total <= kMaxCandidates) return rate;
  }
  return 0.0;
}

std::vector<double> keyTimes(const Clip& clip) {
  std::vector<double> times;
  for (const Channel& channel : clip.channels) times.insert(times.end(), channel.times.begin(), channel.times.end());
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

/// Evenly spaced instants, and the keys where there are no more of them than instants: few keys are the poses an artist
/// set, many are a recording.
std::vector<double> candidateTimes(const Clip& clip, uint32_t samples) {
  if (samples == 1) return {0.5 * (clip.begin + clip.end)};
  std::vector<double> times;
  for (uint32_t i = 0; i < samples; ++i) times.push_back(clip.begin + seconds(clip) * i / (samples - 1));
  const std::vector<double> keys = keyTimes(clip);
  if (keys.size() <= samples) times.insert(times.end(), keys.begin(), keys.end());
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace

std::vector<uint32_t> findClips(const Model& model, const std::vector<std::string>& names) {
  std::vector<bool> wanted(model.clips.size(), names.empty());
  for (const std::string& name : names) {
    bool found = false;
    for (size_t i = 0; i < model.clips.size(); ++i) {
      if (model.clips[i].name != name) continue;
      wanted[i] = true;
      found = true;
    }
    if (!found) throw Error("there is no clip '" + name + "'; " + clipNames(model));
  }
  std::vector<uint32_t> clips;
  for (uint32_t i = 0; i < wanted.size(); ++i) {
    if (wanted[i]) clips.push_back(i);
  }
  return clips;
}

std::vector<Pose> clipCandidates(const Model& model, const std::vector<uint32_t>& clips) {
  const double rate = fittingRate(model, clips);
  std::vector<Pose> candidates;
  for (const uint32_t clip : clips) {
    for (const double time : candidateTimes(model.clips[clip], sampleCount(model.clips[clip], rate))) {
      candidates.push_back(clipPose(model, clip, time));
    }
  }
  return candidates;
}

}  // namespace lithe::bake
