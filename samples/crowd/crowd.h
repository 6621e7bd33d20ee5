// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Who stands where, doing what: a disc of characters around a group that the camera visits.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "draw_list.h"
#include "pose_bank.h"
#include "stage.h"

/// One character of the crowd.
struct Actor {
  uint32_t character = 0, clip = 0;
  glm::vec3 position{0};
  float scale = 1;          ///< world units per bind-space unit
  glm::vec2 heading{1, 0};  ///< cosine and sine of the turn about y
  float bias = 1;           ///< more than 1: deserves less error than the others
  float time_offset = 0;    ///< seconds into the clip at time 0
  uint32_t seed = 0;
};

class Crowd {
 public:
  Crowd(std::span<const sample::Character> characters, const sample::PoseBank& bank, uint32_t count);

  /// Pushes everybody whose bounding sphere meets the picture; remembers their levels from frame to frame.
  void pushSeen(double seconds, const glm::mat4& view_projection, sample::DrawList& list);
  /// Pushes everybody whose bounding sphere meets the sun's view.
  void pushCasters(double seconds, const sample::SunView& view, const glm::vec3& sun, sample::DrawList& list);
  /// After the list's levels were chosen: keeps them for the next frame's hysteresis.
  void keepLevels(const sample::DrawList& list);

  std::span<const Actor> actors() const { return actors_; }

 private:
  void place(std::span<const sample::Character> characters, const glm::vec3& position, uint32_t character);
  const sample::BankedPose& poseOf(const Actor& actor, double seconds) const;
  /// pushed receives who it was, in the list's order.
  void pushInside(double seconds, const glm::mat4& view_projection, std::span<const uint8_t> levels,
                  sample::DrawList& list, std::vector<uint32_t>& pushed);

  const sample::PoseBank* bank_;
  std::vector<Actor> actors_;
  std::vector<uint8_t> levels_, no_levels_;  ///< per actor
  std::vector<uint32_t> seen_, casters_;     ///< actors last pushed, in the list's order
};
