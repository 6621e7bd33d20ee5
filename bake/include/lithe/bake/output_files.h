// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Files that appear under their names when they are complete, or not at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace lithe::bake {

struct OutputFile {
  std::filesystem::path path;
  std::span<const uint8_t> bytes;  ///< the caller's; only read
};

/// Writes every file beside its target, then gives them their names, replacing files that have them. When something
/// fails, all targets are as they were and nothing is left beside them. A single target is replaced in one step; of
/// several, a process that is killed in the middle may leave the first ones replaced. Safe to call from several threads
/// or processes for different targets.
/// @throws Error naming the file and the reason
void writeTogether(std::span<const OutputFile> files);

/// Checks early, before minutes of work, that `path` can become a file: its folder exists, can be written to, and
/// `path` is not a folder itself.
/// @throws Error naming the file and the reason
void requireWritable(const std::filesystem::path& path);

}  // namespace lithe::bake
