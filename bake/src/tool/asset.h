// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// A .lithe file opened by the real reader: what every engine would get, with sentences for what was refused.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lithe/runtime.h"

namespace lithe::tool {

/// Owns the bytes and the runtime's object. Movable.
class Asset {
 public:
  /// Opens a file and supplies no page yet.
  /// @throws bake::Error naming the file, the failed check of docs/format.md and the byte it concerns
  static Asset open(const std::filesystem::path& path);

  /// The same for bytes in memory; `name` stands for the file in sentences.
  static Asset openBytes(std::vector<uint8_t> bytes, std::string name);

  /// Supplies the pages that `level` needs. Levels below it become drawable too.
  /// @throws bake::Error when a page is damaged or missing
  void load(uint32_t level);
  void loadAll() { load(info_.level_count - 1); }

  const lithe_asset* get() const { return asset_.get(); }
  const lithe_asset_info& info() const { return info_; }
  const std::string& name() const { return name_; }
  uint64_t headBytes() const { return head_bytes_; }
  std::span<const uint8_t> bytes() const { return bytes_; }

  // Indices must be in range; info() says how many there are.
  lithe_level level(uint32_t index) const;
  lithe_page page(uint32_t index) const;
  lithe_part part(uint32_t index) const;
  lithe_node node(uint32_t index) const;
  lithe_joint joint(uint32_t index) const;

 private:
  struct Close {
    void operator()(lithe_asset* asset) const { lithe_asset_close(asset); }
  };

  [[noreturn]] void refuse(lithe_result result, const lithe_diagnosis& diagnosis, const std::string& place) const;

  std::string name_;
  std::vector<uint8_t> bytes_;
  uint64_t head_bytes_ = 0;
  std::unique_ptr<lithe_asset, Close> asset_;
  lithe_asset_info info_{};
};

}  // namespace lithe::tool
