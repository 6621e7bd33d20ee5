// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The whole bake: an imported character in, the bytes of a .lithe file out.
///
///     poses -> weld -> simplify -> levels -> measure -> encode
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "lithe/bake/encode.h"
#include "lithe/bake/model.h"
#include "lithe/bake/poses.h"

namespace lithe::bake {

struct BakeOptions {
  std::string metric = "articulated";  ///< see lithe/bake/simplify.h
  PoseOptions poses;
  uint32_t max_influences = 4;  ///< [1..8]
  /// Attributes to carry: "normal", "tangent", "uv0" .. "uv7", "color0", "color1"; uv and colour sets are leading ones,
  /// so uv1 brings uv0. Empty: normals, tangents, uv0 and the first colour set, each where the model has it and it is
  /// not the same everywhere.
  std::vector<std::string> attributes;
  uint32_t position_bits = 14;  ///< [8..16]
  uint32_t normal_bits = 10;    ///< [4..15] tangents too
  uint32_t uv_bits = 12;        ///< [4..16]
  uint32_t weight_bits = 0;     ///< [4..16], or 0: as many of 8 to 12 as the character's blends need
  uint32_t precision = 4;       ///< placement_shift of format/placement.h [0..31]: more is finer and larger
  /// Triangles of the levels as shares of the finest, in any order; 1 is always there. Levels that would differ by
  /// fewer than kMinLevelCollapses collapses are left out. The smallest share is where the simplification ends.
  std::vector<double> levels = {0.7, 0.5, 0.3, 0.2, 0.14, 0.1, 0.07, 0.05, 0.03, 0.02, 0.014, 0.01, 0.007, 0.005};
  bool refit = true;     ///< move the nodes of each level closer to the original's posed surface
  uint32_t threads = 0;  ///< 0: as many as the machine has; the result does not depend on it
  /// Called now and then from the calling thread with the stage's name and its progress 0..1.
  std::function<void(const char* stage, double progress)> progress;
};

inline constexpr uint32_t kMinLevelCollapses = 160;

struct BakedLevel {
  double share = 0.0;  ///< of the finest level's triangles
  uint32_t triangles = 0;
  uint32_t vertices = 0;  ///< GPU vertices of this and all coarser levels
  uint64_t bytes_end = 0;
  double error = 0.0;  ///< largest posed distance measured, bind-space units
  double error_rms = 0.0;
};

struct BakeReport {
  std::vector<std::string> warnings;
  uint32_t poses = 0;
  uint32_t weight_bits = 0;  ///< as used
  uint32_t source_triangles = 0, source_vertices = 0;
  double rest_diagonal = 0.0, posed_diagonal = 0.0;
  std::vector<BakedLevel> levels;         ///< coarse to fine
  std::vector<EncodeReport::Kind> kinds;  ///< bytes by kind; they add up to the file
  uint64_t head_bytes = 0, file_bytes = 0;
  struct Stage {
    std::string name;
    double seconds = 0.0;
  };
  std::vector<Stage> stages;
};

/// Bakes a model. Same model and options, same bytes.
/// @param report  filled anew; may be null
/// @throws Error for options out of their ranges and for what the stages throw
std::vector<uint8_t> bake(const Model& model, const BakeOptions& options, BakeReport* report);

}  // namespace lithe::bake
