// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// One frame of the crowd: let pages arrive, upload them, choose levels, draw, and say what it cost.
#pragma once

#include <memory>
#include <vector>

#include "animation.h"
#include "character.h"
#include "crowd.h"
#include "draw_list.h"
#include "frame_stats.h"
#include "geometry.h"
#include "materials.h"
#include "options.h"
#include "overlay.h"
#include "page_stream.h"
#include "pose_bank.h"
#include "stage.h"

class Viewer {
 public:
  /// Opens the characters, reads their first page, places the crowd. Needs a current context.
  explicit Viewer(const Options& options);

  /// Simulated time passes; pages that arrive are supplied and uploaded, and every level is chosen for this camera.
  /// wait   for the disk, so that the same calls give the same pictures
  void advance(double seconds, const sample::Camera& camera, bool wait);
  /// Draws what advance() chose, overlay included.
  void draw(const sample::Camera& camera, bool level_colors);

  const sample::Target& target() const { return target_; }
  const FrameStats& stats() const { return stats_; }

 private:
  void selectSeen(const sample::Camera& camera);
  void selectCasters(const sample::Camera& camera);
  void measure();
  void drawOverlay(bool level_colors);
  void drawLevelBars(float scale, bool level_colors);

  Options options_;
  std::vector<sample::Character> characters_;
  sample::PoseBank bank_;
  sample::Geometry geometry_;
  Crowd crowd_;
  sample::DrawList seen_, casters_;
  PageStream stream_;
  sample::Stage stage_;
  sample::Materials materials_;
  sample::Overlay overlay_;
  sample::Target target_;
  sample::SunView sun_view_;
  std::vector<uint32_t> wanted_;  ///< per character
  uint64_t first_bytes_ = 0;      ///< read before the first frame: heads and first pages
  double seconds_ = 0;
  FrameStats stats_;
};
