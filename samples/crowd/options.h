// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The crowd's command line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

struct Options {
  std::vector<std::filesystem::path> characters;  ///< .lithe files; clips come from the .glb of the same name beside
  uint32_t instances = 1000;
  float threshold_px = 2.0f;        ///< largest error on screen
  uint64_t triangles = 0;           ///< at most so many in the picture; 0: as many as the error asks for
  double bytes_per_second = 256e3;  ///< of the simulated link that pages come over
  int width = 1280, height = 720;
  uint32_t frames = 8;  ///< pictures along the camera path
  std::filesystem::path output = "demo";
  bool level_colors = false;
  bool both = false;  ///< a second picture of each, coloured by level
  bool window = false;
  bool shadows = true;
};

/// Ends the process for --help and for bad usage (exit code 2).
Options readOptions(int argc, char** argv);
