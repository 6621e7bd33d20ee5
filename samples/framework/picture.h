// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Pictures in memory and as PNG files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace sample {

/// 8-bit RGB, rows from the top.
struct Picture {
  Picture(int width_px, int height_px) : width(width_px), height(height_px), rgb(size_t{3} * width_px * height_px) {}

  int width, height;
  std::vector<uint8_t> rgb;

  void flipRows();
};

/// Throws Error when the file is missing or no picture.
Picture readPng(const std::filesystem::path& path);

/// quality: 1 to 100
std::vector<uint8_t> encodeJpeg(const Picture& picture, int quality);

/// Throws Error when the file cannot be written.
void writePng(const Picture& picture, const std::filesystem::path& path);

}  // namespace sample
