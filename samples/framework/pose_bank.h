// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Every clip of every character at a fixed number of phases, as palettes in one buffer. A thousand instances then
/// cost the CPU no animation at all: each names the palette of its clip and phase.
#pragma once

#include <span>
#include <vector>

#include "animation.h"
#include "gl_objects.h"

namespace sample {

inline constexpr uint32_t kPhases = 48;  ///< per clip

/// One palette of the bank and where the character lies in it, before the instance's own placement.
struct BankedPose {
  uint32_t first_row = 0;  ///< vec4 rows, 3 per joint
  glm::vec3 center{0};     ///< bounding sphere
  float radius = 0;
};

class PoseBank {
 public:
  /// clips is per character; a character without clips gets its rest pose as the only one.
  PoseBank(std::span<const Character> characters, std::span<const std::vector<Clip>> clips);

  uint32_t clipCount(uint32_t character) const { return static_cast<uint32_t>(entries_[character].size()); }
  float duration(uint32_t character, uint32_t clip) const { return entries_[character][clip].duration; }
  /// phase < kPhases
  const BankedPose& pose(uint32_t character, uint32_t clip, uint32_t phase) const {
    return poses_[entries_[character][clip].first_pose + phase];
  }
  const Buffer& buffer() const { return *buffer_; }
  /// The palette itself, 12 floats per joint.
  const float* palette(const BankedPose& pose) const { return &rows_[size_t{4} * pose.first_row]; }

 private:
  struct Entry {
    uint32_t first_pose = 0;
    float duration = 1;
  };

  void addClip(const Character& character, const Clip* clip);
  BankedPose addPose(const Character& character, const Clip* clip, float seconds);

  std::vector<std::vector<Entry>> entries_;  ///< per character and clip
  std::vector<BankedPose> poses_;
  std::vector<float> rows_;
  std::unique_ptr<Buffer> buffer_;
};

}  // namespace sample
