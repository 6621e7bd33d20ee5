// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "pose_bank.h"

#include <algorithm>

namespace sample {

PoseBank::PoseBank(std::span<const Character> characters, std::span<const std::vector<Clip>> clips) {
  for (size_t i = 0; i < characters.size(); ++i) {
    entries_.emplace_back();
    for (const Clip& clip : clips[i]) addClip(characters[i], &clip);
    if (clips[i].empty()) addClip(characters[i], nullptr);
  }
  buffer_ = std::make_unique<Buffer>(rows_.size() * sizeof(float));
  buffer_->write(std::span<const float>(rows_));
}

void PoseBank::addClip(const Character& character, const Clip* clip) {
  const float duration = clip ? std::max(clip->duration(), 0.1f) : 1.0f;
  entries_.back().push_back({static_cast<uint32_t>(poses_.size()), duration});
  for (uint32_t phase = 0; phase < kPhases; ++phase) {
    const float seconds = (clip ? clip->begin : 0.0f) + duration * static_cast<float>(phase) / kPhases;
    poses_.push_back(addPose(character, clip, seconds));
  }
}

BankedPose PoseBank::addPose(const Character& character, const Clip* clip, float seconds) {
  const size_t first = rows_.size(), size = size_t{12} * character.joints.size();
  rows_.resize(first + size);
  posePalette(character, clip, seconds, &rows_[first]);
  float box[6];
  lithe_asset_posed_box(character.asset.get(), &rows_[first], box);
  const glm::vec3 low(box[0], box[1], box[2]), high(box[3], box[4], box[5]);
  return {static_cast<uint32_t>(first / 4), (low + high) * 0.5f, glm::length(high - low) * 0.5f};
}

}  // namespace sample
