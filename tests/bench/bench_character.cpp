// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "bench_character.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "lithe/bake/generate.h"
#include "lithe/bake/import.h"
#include "malloc_allocator.h"

namespace lithe::bench {
namespace {

namespace fs = std::filesystem;

void require(lithe_result result, const std::string& what) {
  if (result != LITHE_OK) throw bake::Error(what + " fails: " + lithe_result_name(result));
}

bool isBuiltIn(const std::string& name) {
  const std::vector<std::string> names = bake::generatorNames();
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Many exporters call every file scene.gltf: then its folder has the telling name.
std::string characterName(const fs::path& path) {
  return path.stem() == "scene" && path.has_parent_path() ? path.parent_path().filename().string()
                                                          : path.stem().string();
}

/// assetgen's files are corner cases of a few triangles, no characters; column.glb is the built-in one.
bool isCharacterFile(const fs::path& path) {
  const fs::path extension = path.extension();
  return (extension == ".glb" || extension == ".gltf") &&
         std::find(path.begin(), path.end(), "assetgen") == path.end() && !isBuiltIn(path.stem().string());
}

std::vector<std::string> sharedCharacters() {
  const fs::path folder = fs::path(LITHE_SHARED_DIR) / "models";
  std::vector<std::string> paths;
  std::error_code missing;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, missing))
    if (isCharacterFile(entry.path())) paths.push_back(entry.path().lexically_normal().string());
  if (paths.empty()) std::fprintf(stderr, "no shared characters here: only the built-in ones are measured\n");
  std::sort(paths.begin(), paths.end());
  return paths;
}

}  // namespace

std::vector<std::string> defaultCharacters() {
  std::vector<std::string> characters = bake::generatorNames();
  for (std::string& path : sharedCharacters()) characters.push_back(std::move(path));
  return characters;
}

int runOverCharacters(int argc, char** argv, const std::string& usage,
                      void (*bench)(const std::vector<std::string>& names, bool json)) try {
  std::vector<std::string> names;
  bool json = false;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--json" && usage.find("[--json]") != std::string::npos) {
      json = true;
    } else if (argument.starts_with('-')) {
      std::fprintf(stderr, "unknown option %s: use %s\n", argument.c_str(), usage.c_str());
      return 2;
    } else {
      names.push_back(argument);
    }
  }
  bench(names.empty() ? defaultCharacters() : names, json);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}

Source loadCharacter(const std::string& name_or_path) {
  if (isBuiltIn(name_or_path)) return {name_or_path, bake::generate(name_or_path)};
  return {characterName(name_or_path), bake::importGltf(name_or_path)};
}

Character bakeCharacter(const std::string& name_or_path) {
  const Source source = loadCharacter(name_or_path);
  std::fprintf(stderr, "baking %s\n", source.name.c_str());
  Character character{source.name, {}, {}};
  character.bytes = bake::bake(source.model, {}, &character.report);
  return character;
}

AssetHandle openAsset(const std::vector<uint8_t>& bytes, const lithe_allocator* allocator) {
  lithe_asset* asset = nullptr;
  require(
      lithe_asset_open(allocator ? allocator : test::mallocAllocator(), bytes.data(), bytes.size(), nullptr, &asset),
      "opening");
  return AssetHandle(asset);
}

void supplyAll(lithe_asset& asset, const std::vector<uint8_t>& bytes) {
  lithe_asset_info info;
  lithe_asset_describe(&asset, &info);
  lithe_request next;
  lithe_result result;
  while ((result = lithe_asset_next_request(&asset, info.level_count - 1, &next)) == LITHE_OK)
    require(lithe_asset_supply(&asset, next.page, bytes.data() + next.offset, next.size, nullptr),
            "supplying page " + std::to_string(next.page));
  if (result != LITHE_COMPLETE) require(result, "asking for the next page");
}

LevelBuffers::LevelBuffers(const lithe_asset& asset, const lithe_vertex_layout& vertex_layout) : layout(vertex_layout) {
  lithe_asset_info info;
  lithe_asset_describe(&asset, &info);
  vertices.resize(size_t{info.vertex_count} * layout.stride);
  indices.resize(size_t{info.triangle_count} * 3);
  ranges.resize(info.part_count);
}

void LevelBuffers::write(const lithe_asset& asset) {
  const uint32_t count = static_cast<uint32_t>(vertices.size() / layout.stride);
  require(lithe_asset_write_vertices(&asset, &layout, 0, count, vertices.data(), vertices.size()), "writing vertices");
  require(lithe_asset_write_indices(&asset, lithe_asset_resident_level(&asset), LITHE_INDEX_U32, indices.data(),
                                    indices.size() * sizeof(uint32_t), ranges.data()),
          "writing indices");
}

uint32_t usedVertices(const LevelBuffers& buffers) {
  std::vector<bool> used(buffers.vertices.size() / buffers.layout.stride);
  for (uint32_t index : buffers.indices) used[index] = true;
  return static_cast<uint32_t>(std::count(used.begin(), used.end(), true));
}

}  // namespace lithe::bench
