// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "crowd.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "camera_path.h"

namespace {

constexpr float kSpacing = 2.0f;      ///< metres from one to the next
constexpr float kActorExtent = 1.8f;  ///< metres: every character's largest extent, whatever its file's unit

// The group that the camera visits. Its faces are looked at, so it is drawn better than it must be.
constexpr float kGroupBias = 3;
constexpr std::array<glm::vec3, 3> kGroup{{{0.0f, 0, 0.0f}, {-1.35f, 0, -0.25f}, {1.35f, 0, -0.5f}}};

/// Uniform in 0..1, the same on every machine.
float randomUnit(uint32_t seed, uint32_t stream) {
  uint32_t x = seed * 0x9e3779b9u + stream * 0x85ebca6bu + 0x1b873593u;
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return static_cast<float>((x ^ (x >> 16)) >> 8) / 16777216.0f;
}

/// Cells of a square grid from its centre outwards, more than needed because some stay free.
std::vector<glm::vec3> cellsOutwards(uint32_t count) {
  const int reach = static_cast<int>(std::sqrt(static_cast<float>(count) / 3.14f) * 1.3f) + 6;
  std::vector<glm::vec3> cells;
  for (int z = -reach; z <= reach; ++z) {
    for (int x = -reach; x <= reach; ++x) cells.emplace_back(x * kSpacing, 0.0f, z * kSpacing);
  }
  std::stable_sort(cells.begin(), cells.end(),
                   [](const auto& a, const auto& b) { return glm::dot(a, a) < glm::dot(b, b); });
  return cells;
}

bool isInGroup(const glm::vec3& position) {
  return std::any_of(kGroup.begin(), kGroup.end(),
                     [&](const auto& spot) { return glm::distance(spot, position) < 1.4f; });
}

/// Half of the crowd is the first character; the others share the rest.
uint32_t pickCharacter(uint32_t seed, uint32_t count) {
  const float pick = randomUnit(seed, 1);
  if (count == 1 || pick < 0.5f) return 0;
  return std::min(1 + static_cast<uint32_t>((pick - 0.5f) * 2 * static_cast<float>(count - 1)), count - 1);
}

/// The first clip three times as often as each other: in a file it is mostly the walk.
uint32_t pickClip(uint32_t seed, uint32_t count) {
  const uint32_t pick = static_cast<uint32_t>(randomUnit(seed, 2) * static_cast<float>(count + 2));
  return pick < count ? pick : 0;
}

/// The six planes of a projection; a point is inside where all are positive.
std::array<glm::vec4, 6> planesOf(const glm::mat4& projection) {
  const glm::mat4 rows = glm::transpose(projection);
  std::array<glm::vec4, 6> planes;
  for (int axis = 0; axis < 3; ++axis) {
    planes[2 * axis] = rows[3] + rows[axis];
    planes[2 * axis + 1] = rows[3] - rows[axis];
  }
  for (glm::vec4& plane : planes) plane /= glm::length(glm::vec3(plane));
  return planes;
}

bool meets(const std::array<glm::vec4, 6>& planes, const glm::vec3& center, float radius) {
  return std::all_of(planes.begin(), planes.end(),
                     [&](const glm::vec4& plane) { return glm::dot(plane, glm::vec4(center, 1)) > -radius; });
}

glm::vec3 turned(const glm::vec2& heading, const glm::vec3& v) {
  return {heading.x * v.x + heading.y * v.z, v.y, heading.x * v.z - heading.y * v.x};
}

}  // namespace

Crowd::Crowd(std::span<const sample::Character> characters, const sample::PoseBank& bank, uint32_t count)
    : bank_(&bank) {
  const uint32_t kinds = static_cast<uint32_t>(characters.size());
  for (uint32_t i = 0; i < std::min<uint32_t>({count, kinds, kGroup.size()}); ++i) place(characters, kGroup[i], i);
  for (const glm::vec3& cell : cellsOutwards(count)) {
    if (actors_.size() >= count) break;
    const uint32_t seed = static_cast<uint32_t>(actors_.size());
    const glm::vec3 jitter(randomUnit(seed, 3) - 0.5f, 0, randomUnit(seed, 4) - 0.5f);
    const glm::vec3 position = cell + jitter * 0.45f * kSpacing;
    if (!isInGroup(position) && !isInCamerasWay(position)) place(characters, position, pickCharacter(seed, kinds));
  }
  levels_.assign(actors_.size(), LITHE_UNDRAWN);
  no_levels_ = levels_;
  seen_.reserve(actors_.size());
  casters_.reserve(actors_.size());
}

void Crowd::place(std::span<const sample::Character> characters, const glm::vec3& position, uint32_t character) {
  const sample::Character& kind = characters[character];
  const uint32_t seed = static_cast<uint32_t>(actors_.size());
  const bool in_group = seed < std::min(characters.size(), kGroup.size());
  Actor actor;
  actor.character = character;
  actor.clip = in_group ? 0 : pickClip(seed, bank_->clipCount(character));
  actor.scale = kActorExtent / kind.largestExtent() * (in_group ? 1.0f : 0.9f + 0.2f * randomUnit(seed, 5));
  actor.bias = in_group ? kGroupBias : 1.0f;
  actor.position = position - glm::vec3(0, kind.info.box_min[1] * actor.scale, 0);
  // Most face where the camera comes from.
  const float turn = (in_group ? 0.5f : 2.4f) * (randomUnit(seed, 6) - 0.5f) * 2;
  actor.heading = {std::cos(turn), std::sin(turn)};
  actor.time_offset = randomUnit(seed, 7) * bank_->duration(character, actor.clip);
  actor.seed = seed;
  actors_.push_back(actor);
}

const sample::BankedPose& Crowd::poseOf(const Actor& actor, double seconds) const {
  const double duration = bank_->duration(actor.character, actor.clip);
  const double cycles = (seconds + actor.time_offset) / duration;
  const uint32_t phase = static_cast<uint32_t>((cycles - std::floor(cycles)) * sample::kPhases);
  return bank_->pose(actor.character, actor.clip, std::min(phase, sample::kPhases - 1));
}

void Crowd::pushInside(double seconds, const glm::mat4& view_projection, std::span<const uint8_t> levels,
                       sample::DrawList& list, std::vector<uint32_t>& pushed) {
  const std::array<glm::vec4, 6> planes = planesOf(view_projection);
  list.clear();
  pushed.clear();
  for (uint32_t i = 0; i < actors_.size(); ++i) {
    const Actor& actor = actors_[i];
    const sample::BankedPose& pose = poseOf(actor, seconds);
    const glm::vec3 center = actor.position + actor.scale * turned(actor.heading, pose.center);
    const float radius = actor.scale * pose.radius;
    if (!meets(planes, center, radius)) continue;
    list.push({{center.x, center.y, center.z}, radius, actor.scale, actor.bias, actor.character, levels[i], 0, 0, 0},
              {{actor.position.x, actor.position.y, actor.position.z},
               actor.scale,
               {actor.heading.x, actor.heading.y},
               pose.first_row,
               actor.seed});
    pushed.push_back(i);
  }
}

void Crowd::pushSeen(double seconds, const glm::mat4& view_projection, sample::DrawList& list) {
  pushInside(seconds, view_projection, levels_, list, seen_);
}

void Crowd::pushCasters(double seconds, const sample::SunView& view, const glm::vec3& sun, sample::DrawList& list) {
  pushInside(seconds, view.projection(sun), no_levels_, list, casters_);
}

void Crowd::keepLevels(const sample::DrawList& list) {
  for (uint32_t i = 0; i < seen_.size(); ++i) levels_[seen_[i]] = list.instance(i).level;
}
