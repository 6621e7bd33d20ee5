// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Every character's vertices and indices on the GPU: one vertex buffer and one index buffer for all, so that one
/// indirect call draws everything. lithe writes into the mapped buffers; they only grow, so a draw in flight is never
/// disturbed.
#pragma once

#include <span>
#include <vector>

#include "character.h"
#include "gl_objects.h"
#include "lithe/runtime.h"

namespace sample {

/// Four influences are the default of the bake; a file may have up to eight.
inline constexpr uint32_t kMaxInfluences = LITHE_MAX_INFLUENCES;

/// One vertex of the shared vertex buffer. The second half of joints and weights is zero for four influences.
struct SkinVertex {
  float position[3];
  int16_t normal[2];  ///< octahedral
  uint16_t uv[2];     ///< halves; of the first set
  uint16_t joints[kMaxInfluences];
  uint8_t weights[kMaxInfluences];
};

class Geometry {
 public:
  /// Makes room for every level of every character; uploads nothing yet.
  explicit Geometry(std::span<const Character> characters);
  ~Geometry();
  Geometry(const Geometry&) = delete;
  Geometry& operator=(const Geometry&) = delete;

  /// Uploads the vertices and indices of the levels that became resident since the last call.
  void upload(std::span<const Character> characters);

  /// For lithe_build_draws, per character.
  const std::vector<lithe_placement>& placements() const { return placements_; }
  uint64_t bytesUploaded() const { return bytes_uploaded_; }

  /// Vertex attributes and index buffer for drawing.
  void bind() const;

 private:
  void uploadLevel(const Character& character, size_t index, uint32_t level);
  void uploadVertices(const Character& character, size_t index, uint32_t begin, uint32_t end);
  void uploadIndices(const Character& character, size_t index, uint32_t level);
  void orderForVertexCache(const Character& character, size_t level, std::span<const lithe_range> ranges,
                           std::vector<uint32_t>& indices);

  std::vector<lithe_placement> placements_;
  std::vector<std::vector<lithe_range>> ranges_;          ///< per character: [level * part_count + part]
  std::vector<std::vector<uint32_t>> level_first_index_;  ///< per character and level, in the shared index buffer
  std::vector<uint8_t> order_scratch_;
  Buffer vertices_, indices_;
  GLuint vertex_array_ = 0;
  uint64_t bytes_uploaded_ = 0;
};

}  // namespace sample
