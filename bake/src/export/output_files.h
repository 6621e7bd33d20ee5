// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Files that appear when they are complete, or not at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace lithe::bake {

struct OutputFile {
  std::filesystem::path path;
  std::vector<uint8_t> bytes;
};

/// Writes every file beside its target, then gives all their names. When something fails, what was written is removed
/// again.
/// @throws Error naming the file and the reason
void writeTogether(std::span<const OutputFile> files);

}  // namespace lithe::bake
