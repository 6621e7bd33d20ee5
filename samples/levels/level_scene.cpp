// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "level_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "error.h"
#include "skinning.h"

namespace {

constexpr int kSamples = 4;
constexpr uint32_t kMeasuredLevel = 4;             ///< fine enough to frame a picture by
constexpr float kFov = 0.42f;                      ///< radians: a long lens
constexpr float kCheckerCells = 48;                ///< of the uvs' unit square
constexpr float kMargin = 1.06f;                   ///< free room around the character
constexpr float kLabelScale = 2, kLabelLine = 22;  ///< pixels per dot and per line

std::vector<sample::Character> loaded(sample::Character character) {
  sample::loadLevel(character, character.info.level_count - 1);
  std::vector<sample::Character> characters;
  characters.push_back(std::move(character));
  return characters;
}

/// The one clip that is shown, or none.
std::vector<std::vector<sample::Clip>> chooseClip(const sample::Character& character, const std::filesystem::path& gltf,
                                                  const std::string& name) {
  std::vector<sample::Clip> clips;
  if (std::filesystem::exists(gltf)) clips = sample::readClips(character, gltf);
  if (name.empty()) {
    clips.resize(std::min<size_t>(clips.size(), 1));
    return {clips};
  }
  const auto found =
      std::find_if(clips.begin(), clips.end(), [&](const sample::Clip& clip) { return clip.name == name; });
  if (found == clips.end()) throw sample::Error(gltf.string() + ": there is no clip named " + name);
  return {{*found}};
}

uint32_t phaseAt(float fraction) {
  return std::min(static_cast<uint32_t>(fraction * sample::kPhases), sample::kPhases - 1);
}

std::vector<glm::vec3> corners(const glm::vec3& low, const glm::vec3& high) {
  std::vector<glm::vec3> points;
  for (int i = 0; i < 8; ++i)
    points.emplace_back(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
  return points;
}

/// Many edges must be faint, or nothing but edges is seen.
glm::vec4 wireColor(uint32_t triangles) {
  return {0.02f, 0.03f, 0.05f, std::clamp(40.0f / std::sqrt(static_cast<float>(triangles + 1)), 0.07f, 0.75f)};
}

}  // namespace

LevelScene::LevelScene(sample::Character character, const std::filesystem::path& gltf, const PoseChoice& choice)
    : characters_(loaded(std::move(character))),
      bank_(characters_, chooseClip(characters_.front(), gltf, choice.clip)),
      geometry_(characters_),
      list_(characters_, geometry_, 1),
      materials_(characters_),
      phase_(phaseAt(choice.fraction)),
      elevation_(glm::radians(choice.elevation)),
      heading_(std::cos(glm::radians(choice.turn)), std::sin(glm::radians(choice.turn))) {
  geometry_.upload(characters_);
  stage_.setPalettes(bank_);
  measure();
}

/// lithe_asset_posed_box is safe but roomy; a picture is framed by where the vertices are.
void LevelScene::measure() {
  const float* palette = bank_.palette(bank_.pose(0, 0, phase_));
  low_ = glm::vec3(std::numeric_limits<float>::max());
  high_ = -low_;
  const uint32_t level = std::min(character().info.level_count - 1, kMeasuredLevel);
  for (const glm::vec3& posed : sample::posedPositions(character(), level, palette)) {
    const glm::vec3 turned(heading_.x * posed.x + heading_.y * posed.z, posed.y,
                           heading_.x * posed.z - heading_.y * posed.x);
    low_ = glm::min(low_, turned);
    high_ = glm::max(high_, turned);
  }
  lift_ = -low_.y;
  low_.y += lift_;
  high_.y += lift_;
}

void LevelScene::placeInstance(uint32_t level) {
  const glm::vec3 center = (low_ + high_) * 0.5f;
  list_.clear();
  list_.push(
      {{center.x, center.y, center.z}, glm::length(high_ - low_) * 0.5f, 1, 1, 0, static_cast<uint8_t>(level), 0, 0, 1},
      {{0, lift_, 0}, 1.0f, {heading_.x, heading_.y}, bank_.pose(0, 0, phase_).first_row, 0});
  list_.build();
  list_.upload();
}

/// As close as all corners of the box stay in the picture, or so far that a unit gets the asked pixels.
sample::Camera LevelScene::frame(const Shot& shot) const {
  const glm::vec3 center = (low_ + high_) * 0.5f;
  const glm::vec3 back(0, std::sin(elevation_), std::cos(elevation_)), right(1, 0, 0), up = glm::cross(back, right);
  const float tangent = std::tan(kFov / 2), aspect = static_cast<float>(shot.width) / static_cast<float>(shot.height);
  const float label_share = kLabelLine * static_cast<float>(shot.labels.size()) / static_cast<float>(shot.height);
  float distance = 0;
  for (const glm::vec3& corner : corners(low_, high_)) {
    const glm::vec3 from = corner - center;
    const float across =
        std::max(std::abs(glm::dot(from, right)) / aspect, std::abs(glm::dot(from, up)) / (1 - label_share));
    distance = std::max(distance, kMargin * across / tangent + glm::dot(from, back));
  }
  if (shot.pixels_per_unit > 0) distance = static_cast<float>(shot.height) / (2 * tangent * shot.pixels_per_unit);
  // The labels take the foot of the picture: what is looked at moves up by half of their share.
  const glm::vec3 target = center - up * (label_share * tangent * distance);
  return {target + back * distance, target, kFov};
}

void LevelScene::drawLabels(const Shot& shot) {
  float y = static_cast<float>(shot.height) - kLabelLine * static_cast<float>(shot.labels.size());
  for (const std::string& label : shot.labels) {
    const float width = sample::Overlay::textWidth(label, kLabelScale);
    overlay_.text((static_cast<float>(shot.width) - width) / 2, y, label, kLabelScale, {0.1f, 0.1f, 0.12f, 1});
    y += kLabelLine;
  }
  overlay_.draw(shot.width, shot.height);
}

sample::Picture LevelScene::draw(const Shot& shot) {
  const sample::Target target(shot.width, shot.height, kSamples);
  const sample::Camera camera = frame(shot);
  sample::Stage::Look look;
  look.studio = true;
  look.ground_lines = 0;
  look.ground = shot.ground;
  if (shot.checker) look.checker_cells = kCheckerCells;
  stage_.setLook(look);
  placeInstance(shot.level);
  stage_.drawShadows({(low_ + high_) * 0.5f, glm::length(high_ - low_) * 0.8f}, list_);
  target.bind();
  stage_.drawScene(camera, shot.width, shot.height, list_, materials_.forDraws(list_, false));
  if (shot.wires) stage_.drawWires(list_, wireColor(character().levels[shot.level].triangle_count));
  target.resolve();
  drawLabels(shot);
  return target.read();
}
