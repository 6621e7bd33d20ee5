// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// What a frame cost and showed: the overlay, the printed line and crowd.json all say it from here.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "character.h"
#include "draw_list.h"

struct LevelCount {
  uint32_t instances = 0;
  uint64_t triangles = 0;
};

struct FrameStats {
  double seconds = 0;  ///< along the camera path
  uint32_t instances = 0, seen = 0;
  uint32_t limited = 0;           ///< would like a level that has not arrived
  uint64_t triangles = 0;         ///< drawn to the picture
  uint64_t finest_triangles = 0;  ///< what the same instances would be at their finest level
  uint64_t shadow_triangles = 0;
  uint32_t draws = 0;
  std::vector<LevelCount> levels;  ///< by level, all characters together
  std::vector<uint32_t> resident;  ///< per character: levels resident
  uint64_t resident_bytes = 0;     ///< held by lithe
  uint64_t gpu_bytes = 0;          ///< vertices and indices uploaded
  uint64_t streamed_bytes = 0, file_bytes = 0;
  double largest_error_px = 0;  ///< that the levels were chosen for: the threshold, or what the budget makes of it
  double select_ms = 0, draws_ms = 0;
};

/// Counts what a built list will draw.
void countDraws(const sample::DrawList& list, std::span<const sample::Character> characters, FrameStats& stats);

/// Several lines for people.
std::vector<std::string> textLines(const FrameStats& stats);
/// "1,234,567"
std::string grouped(uint64_t value);

nlohmann::ordered_json toJson(const FrameStats& stats);
