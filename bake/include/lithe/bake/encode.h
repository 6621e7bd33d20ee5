// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Writes a hierarchy as the bytes of a .lithe file (docs/format.md).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lithe/bake/hierarchy.h"
#include "lithe/bake/mesh.h"
#include "lithe/bake/model.h"
#include "lithe/format/page.h"

namespace lithe::bake {

/// One level: the cut after the first `collapses` collapses of the sequence (0: the finest).
struct LevelPlan {
  uint32_t collapses = 0;
  double error = 0.0;  ///< largest posed distance to the original, bind-space units
  double error_rms = 0.0;
};

struct EncodeInput {
  const Model& model;
  const Mesh& mesh;
  const Hierarchy& hierarchy;
  std::vector<LevelPlan> levels;  ///< coarse to fine: `collapses` falls strictly, the last is 0
  uint32_t placement_shift = 4;
  double posed_diagonal = 0.0;
  uint32_t page_splits = 8192;         ///< splits per page, about: large levels have several pages
  uint32_t shared_page_splits = 2048;  ///< small levels share a page until it has this many splits
};

struct EncodedLevel {
  uint32_t triangles = 0;
  uint32_t vertices = 0;   ///< GPU vertices (wedges) of this level and all coarser ones
  uint64_t bytes_end = 0;  ///< the file's bytes up to the level's last page
};

/// Where the bytes went. Kinds add up to the file.
struct EncodeReport {
  std::vector<EncodedLevel> levels;
  struct Kind {
    std::string name;
    uint64_t bytes = 0;
  };
  std::vector<Kind> kinds;
  uint64_t head_bytes = 0;
  uint64_t file_bytes = 0;
};

/// What a stream of a page is counted as in EncodeReport::kinds: "base", "splits", "connectivity", "skin", "uvs", ...
const char* streamKind(format::PageKind page, uint32_t stream);

/// @param report  filled anew; may be null
/// Throws Error when the model is beyond the format's limits.
std::vector<uint8_t> encodeFile(const EncodeInput& input, EncodeReport* report);

}  // namespace lithe::bake
