// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Where a file's bytes go in the words of a user: what positions, normals, skins and the rest of it take.
///
/// Streams that hold several things are taken apart by their attributes, the low bits by the values that they belong
/// to: of normals, tangents and weights a page's parameters say how many there are, of uvs the distance of the
/// children, of further wedges their masks and the parameters; what is left are positions' (with the padding of the
/// page's last byte).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "lithe/runtime.h"

namespace lithe::tool {

struct FileCosts {
  struct Kind {
    std::string group, name;
    uint64_t bytes = 0;  ///< low bits are rounded to bytes, at most one up or down for a kind
  };
  /// Always the same kinds in the same order, groups together; they add up to the file.
  std::vector<Kind> kinds;
  uint32_t vertices = 0;  ///< welded ones of the finest level: its nodes
  uint32_t wedges = 0;    ///< GPU vertices of the finest level

  uint64_t bytesOf(const std::string& group) const;
};

/// asset  opened from `file`, all pages supplied; `name` stands for it in sentences
/// @throws bake::Error when libdraco reads a page otherwise than the runtime
FileCosts fileCosts(const lithe_asset& asset, std::span<const uint8_t> file, const std::string& name);

}  // namespace lithe::tool
