// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The characters that the benches measure: baked with default options, opened by the real reader.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "lithe/bake/bake.h"
#include "lithe/runtime.h"

namespace lithe::bench {

/// The built-in characters, then the shared glTF files in the order of their paths. Says on stderr when there are none.
std::vector<std::string> defaultCharacters();

/// A bench's main: calls bench(names, json) with the characters that the arguments name, or the default ones. --json is
/// an option where the usage says so. Returns the exit code.
int runOverCharacters(int argc, char** argv, const std::string& usage,
                      void (*bench)(const std::vector<std::string>& names, bool json));

struct Source {
  std::string name;  ///< a built-in name, or the file's without its extension
  bake::Model model;
};

/// A built-in character, by its name, or a glTF file, by its path. @throws bake::Error for what generate() and
/// importGltf() throw
Source loadCharacter(const std::string& name_or_path);

struct Character {
  std::string name;            ///< a built-in name, or the file's without its extension
  std::vector<uint8_t> bytes;  ///< of the .lithe file
  bake::BakeReport report;
};

/// Bakes a built-in character, by its name, or a glTF file, by its path, with default options.
/// @throws bake::Error for what generate(), importGltf() and bake() throw
Character bakeCharacter(const std::string& name_or_path);

struct CloseAsset {
  void operator()(lithe_asset* asset) const { lithe_asset_close(asset); }
};
using AssetHandle = std::unique_ptr<lithe_asset, CloseAsset>;

/// Opens a file without supplying a page. allocator: malloc where there is none; it must outlive the asset.
/// @throws bake::Error naming the result
AssetHandle openAsset(const std::vector<uint8_t>& bytes, const lithe_allocator* allocator = nullptr);

/// Supplies every page, coarse to fine. @throws bake::Error naming the page
void supplyAll(lithe_asset& asset, const std::vector<uint8_t>& bytes);

/// What an engine uploads to draw the finest level: vertices in the runtime's default layout or any other, 32-bit
/// indices, and where each part's lie.
struct LevelBuffers {
  lithe_vertex_layout layout{};
  std::vector<uint8_t> vertices;  ///< of all levels, layout.stride bytes each
  std::vector<uint32_t> indices;
  std::vector<lithe_range> ranges;  ///< per part

  /// Buffers of the right sizes; nothing is written yet.
  LevelBuffers(const lithe_asset& asset, const lithe_vertex_layout& vertex_layout);
  /// Every page must have been supplied. @throws bake::Error naming the result
  void write(const lithe_asset& asset);
};

/// GPU vertices that the indices mention: those of the finest level alone.
uint32_t usedVertices(const LevelBuffers& buffers);

}  // namespace lithe::bench
