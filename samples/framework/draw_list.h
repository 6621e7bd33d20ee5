// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The instances of one view, from being pushed to being drawn: lithe chooses their levels and sorts them into
/// indirect draws. A frame makes one for the camera and one for the sun's shadows.
#pragma once

#include <span>
#include <vector>

#include "character.h"
#include "geometry.h"
#include "lithe/runtime.h"

namespace sample {

/// What the character shader knows of an instance. Layout of std430.
struct InstanceRecord {
  float position[3];
  float scale;
  float heading[2];    ///< cosine and sine of the turn about y
  uint32_t first_row;  ///< of its palette
  uint32_t seed;       ///< picks its colours
};

class DrawList {
 public:
  /// Takes all memory that `capacity` instances need.
  DrawList(std::span<const Character> characters, const Geometry& geometry, uint32_t capacity);

  void clear();
  /// level: of the frame before, LITHE_UNDRAWN at first
  void push(const lithe_instance& instance, const InstanceRecord& record);

  /// Chooses the levels; raises wanted (per character, may be nullptr) to what would be needed.
  void select(const lithe_view& view, uint32_t* wanted, lithe_select_stats* stats);
  /// The same for at most `triangles` triangles. Returns how many thresholds the largest error is then, 1 when all
  /// fits.
  float selectWithin(const lithe_view& view, uint64_t triangles, uint32_t* wanted, lithe_select_stats* stats);
  /// Sorts the instances into draws.
  void build();
  /// Sends instances, order and draws to the GPU.
  void upload();
  /// The one call that draws them all, with whatever program is in use.
  void draw() const;

  uint32_t size() const { return static_cast<uint32_t>(instances_.size()); }
  const lithe_instance& instance(uint32_t index) const { return instances_[index]; }
  std::span<const lithe_draw> draws() const { return {draws_.data(), draw_count_}; }
  std::span<const lithe_draw_key> keys() const { return {keys_.data(), draw_count_}; }

 private:
  lithe_crowd crowdOfAll();

  std::vector<const lithe_asset*> assets_;
  const Geometry* geometry_;
  std::vector<lithe_instance> instances_;
  std::vector<InstanceRecord> records_;
  std::vector<uint32_t> order_, counters_;
  std::vector<uint64_t> budget_scratch_;
  std::vector<lithe_draw> draws_;
  std::vector<lithe_draw_key> keys_;
  uint32_t draw_count_ = 0;
  Buffer record_buffer_, order_buffer_, draw_buffer_;
};

}  // namespace sample
