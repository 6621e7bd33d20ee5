// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// A .lithe file on disk and the asset that was opened from its head. Pages are read by whoever streams them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "lithe/runtime.h"

namespace sample {

struct CloseAsset {
  void operator()(lithe_asset* asset) const { lithe_asset_close(asset); }
};

struct Character {
  std::string name;            ///< the file's stem
  std::filesystem::path path;  ///< of the .lithe
  uint64_t head_bytes = 0;     ///< read to open it
  std::unique_ptr<lithe_asset, CloseAsset> asset;
  lithe_asset_info info{};
  // What lithe says of it, by index. Names point into the asset.
  std::vector<lithe_node> nodes;
  std::vector<lithe_joint> joints;
  std::vector<lithe_part> parts;
  std::vector<lithe_level> levels;

  /// Bind-space extents.
  float largestExtent() const;
};

/// Reads the head and nothing else. Throws Error.
Character openCharacter(const std::filesystem::path& path);

/// [offset, offset + size) of a file. Throws Error when it is shorter. May be called from any thread.
std::vector<uint8_t> readBytes(const std::filesystem::path& path, uint64_t offset, size_t size);

/// Reads and supplies the pages that a level still lacks, one after the other. Throws Error.
void loadLevel(Character& character, uint32_t level);

}  // namespace sample
