// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "viewer.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "error.h"

namespace {

constexpr int kSamples = 4;               ///< of the multisampled picture
constexpr float kShadowThreshold_px = 2;  ///< a shadow's error, in texels: shadows forgive more than surfaces
constexpr float kHysteresis = 0.2f;

constexpr glm::vec4 kPanel{0.04f, 0.05f, 0.07f, 0.6f}, kText{1, 1, 1, 0.95f};

std::vector<sample::Character> openAll(const Options& options) {
  std::vector<sample::Character> characters;
  for (const std::filesystem::path& path : options.characters) characters.push_back(sample::openCharacter(path));
  return characters;
}

std::vector<std::vector<sample::Clip>> readAllClips(std::span<const sample::Character> characters) {
  std::vector<std::vector<sample::Clip>> clips;
  for (const sample::Character& character : characters) {
    const std::filesystem::path gltf = std::filesystem::path(character.path).replace_extension(".glb");
    clips.emplace_back();
    if (std::filesystem::exists(gltf)) clips.back() = sample::readClips(character, gltf);
  }
  return clips;
}

class Timer {
 public:
  double milliseconds() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Shadows matter where the camera looks: a cube around the ground it sees, larger the higher it stands.
sample::SunView sunViewFor(const sample::Camera& camera) {
  const glm::vec3 ahead = glm::normalize(camera.target - camera.position);
  const float reach = std::clamp(glm::distance(camera.target, camera.position), 4.0f, 30.0f);
  glm::vec3 center = camera.position + ahead * reach;
  center.y = 0;
  return {center, std::clamp(1.6f * reach, 9.0f, 38.0f)};
}

}  // namespace

Viewer::Viewer(const Options& options)
    : options_(options),
      characters_(openAll(options)),
      bank_(characters_, readAllClips(characters_)),
      geometry_(characters_),
      crowd_(characters_, bank_, options.instances),
      seen_(characters_, geometry_, options.instances),
      casters_(characters_, geometry_, options.instances),
      stream_(characters_, options.bytes_per_second),
      materials_(characters_),
      target_(options.width, options.height, kSamples),
      wanted_(characters_.size(), 0) {
  for (sample::Character& character : characters_) {
    sample::loadLevel(character, 0);
    first_bytes_ += character.levels[0].bytes_end;
    stats_.file_bytes += character.info.file_bytes;
  }
  sample::Stage::Look look;
  look.fog_density = 0.008f;
  stage_.setLook(look);
  stage_.setPalettes(bank_);
}

void Viewer::advance(double seconds, const sample::Camera& camera, bool wait) {
  seconds_ += seconds;
  stream_.advance(seconds, wanted_, wait);
  geometry_.upload(characters_);
  const uint64_t file_bytes = stats_.file_bytes;
  stats_ = {};
  stats_.file_bytes = file_bytes;
  selectSeen(camera);
  measure();
}

void Viewer::selectSeen(const sample::Camera& camera) {
  const float aspect = static_cast<float>(target_.width()) / static_cast<float>(target_.height());
  crowd_.pushSeen(seconds_, camera.viewProjection(aspect), seen_);
  lithe_view view{};
  view.position[0] = camera.position.x;
  view.position[1] = camera.position.y;
  view.position[2] = camera.position.z;
  view.pixels_per_radian = camera.pixelsPerRadian(target_.height());
  view.near_distance = 0.1f;
  view.threshold_px = options_.threshold_px;
  view.hysteresis = kHysteresis;
  lithe_select_stats select_stats{};
  std::fill(wanted_.begin(), wanted_.end(), 0);
  const Timer select_timer;
  stats_.largest_error_px = options_.threshold_px;
  if (options_.triangles > 0)
    stats_.largest_error_px *= seen_.selectWithin(view, options_.triangles, wanted_.data(), &select_stats);
  else
    seen_.select(view, wanted_.data(), &select_stats);
  stats_.select_ms = select_timer.milliseconds();
  const Timer build_timer;
  seen_.build();
  stats_.draws_ms = build_timer.milliseconds();
  stats_.limited = select_stats.limited;
  crowd_.keepLevels(seen_);
}

/// The sun's view is orthographic: one texel is the same size everywhere.
void Viewer::selectCasters(const sample::Camera& camera) {
  sun_view_ = sunViewFor(camera);
  casters_.clear();
  if (options_.shadows) crowd_.pushCasters(seconds_, sun_view_, stage_.look().sun, casters_);
  lithe_view view{};
  view.pixels_per_unit = static_cast<float>(stage_.shadowSize()) / (2 * sun_view_.half_extent);
  view.near_distance = 0.1f;
  view.threshold_px = kShadowThreshold_px;
  lithe_select_stats select_stats{};
  casters_.select(view, nullptr, &select_stats);
  casters_.build();
  stats_.shadow_triangles = select_stats.triangles;
}

void Viewer::measure() {
  stats_.seconds = seconds_;
  stats_.instances = static_cast<uint32_t>(crowd_.actors().size());
  stats_.streamed_bytes = first_bytes_ + stream_.bytesStreamed();
  stats_.gpu_bytes = geometry_.bytesUploaded();
  for (const sample::Character& character : characters_) {
    const uint32_t resident = lithe_asset_resident_level(character.asset.get());
    stats_.resident.push_back(resident + 1);
    stats_.resident_bytes += lithe_asset_memory(character.asset.get(), resident);
  }
  countDraws(seen_, characters_, stats_);
}

void Viewer::draw(const sample::Camera& camera, bool level_colors) {
  selectCasters(camera);
  casters_.upload();
  seen_.upload();
  stage_.drawShadows(sun_view_, casters_);
  target_.bind();
  stage_.drawScene(camera, target_.width(), target_.height(), seen_, materials_.forDraws(seen_, level_colors));
  target_.resolve();
  drawOverlay(level_colors);
}

void Viewer::drawOverlay(bool level_colors) {
  const float scale = std::max(1.0f, std::round(static_cast<float>(target_.height()) / 360.0f));
  const std::vector<std::string> lines = textLines(stats_);
  float widest = 0;
  for (const std::string& line : lines) widest = std::max(widest, sample::Overlay::textWidth(line, scale));
  const float line_height = 12 * scale, margin = 6 * scale;
  overlay_.box(margin, margin, widest + 2 * margin, static_cast<float>(lines.size()) * line_height + 1.5f * margin,
               kPanel);
  float y = 2 * margin;
  for (const std::string& line : lines) {
    overlay_.text(2 * margin, y, line, scale, kText);
    y += line_height;
  }
  drawLevelBars(scale, level_colors);
  overlay_.draw(target_.width(), target_.height());
}

/// Along the foot of the picture, per level: how many instances, and the colour that --lod-colors gives them.
void Viewer::drawLevelBars(float scale, bool level_colors) {
  uint32_t level_count = 1;
  for (const sample::Character& character : characters_)
    level_count = std::max(level_count, character.info.level_count);
  const float margin = 6 * scale, height = 15 * scale, top = static_cast<float>(target_.height()) - margin - height;
  const float width = (static_cast<float>(target_.width()) - 2 * margin) / static_cast<float>(level_count);
  overlay_.text(margin, top - 11 * scale, "instances per level, coarse to fine", scale, kText);
  overlay_.box(margin, top, width * static_cast<float>(level_count), height, kPanel);
  for (uint32_t level = 0; level < level_count; ++level) {
    const uint32_t count = level < stats_.levels.size() ? stats_.levels[level].instances : 0;
    const float x = margin + width * static_cast<float>(level),
                share = std::min(1.0f, 2.5f * static_cast<float>(count) / static_cast<float>(stats_.seen + 1));
    const glm::vec3 shown = glm::pow(sample::levelColor(level, level_count), glm::vec3(1 / 2.2f));
    overlay_.box(x, top, width * share, height,
                 level_colors ? glm::vec4(shown, 0.9f) : glm::vec4(0.45f, 0.55f, 0.65f, 0.55f));
    overlay_.text(x + 3 * scale, top + 4 * scale, std::to_string(level) + ": " + grouped(count), scale, kText);
  }
}
