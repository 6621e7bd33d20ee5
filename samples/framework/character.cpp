// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "character.h"

#include <algorithm>
#include <fstream>
#include <new>

#include "error.h"

namespace sample {
namespace {

/// lithe frees with the size alone, so every block is taken with the alignment it is given back with.
constexpr std::align_val_t kAlignment{64};

void* takeMemory(void*, size_t size, size_t) { return ::operator new(size, kAlignment, std::nothrow); }

void freeMemory(void*, void* memory, size_t) { ::operator delete(memory, kAlignment); }

constexpr lithe_allocator kAllocator{nullptr, takeMemory, freeMemory};

template <class Record, class Ask>
std::vector<Record> readTable(const lithe_asset* asset, uint32_t count, Ask ask) {
  std::vector<Record> table(count);
  for (uint32_t i = 0; i < count; ++i) check(ask(asset, i, &table[i]), "a table of the asset");
  return table;
}

void readTables(Character& character) {
  const lithe_asset* asset = character.asset.get();
  lithe_asset_describe(asset, &character.info);
  character.nodes = readTable<lithe_node>(asset, character.info.node_count, lithe_asset_node);
  character.joints = readTable<lithe_joint>(asset, character.info.joint_count, lithe_asset_joint);
  character.parts = readTable<lithe_part>(asset, character.info.part_count, lithe_asset_part);
  character.levels = readTable<lithe_level>(asset, character.info.level_count, lithe_asset_level);
}

std::string refusal(const Character& character, const lithe_diagnosis& diagnosis) {
  return character.path.string() + ", check " + std::to_string(diagnosis.check) + " at byte " +
         std::to_string(diagnosis.offset);
}

}  // namespace

float Character::largestExtent() const {
  float extent = 0;
  for (int axis = 0; axis < 3; ++axis) extent = std::max(extent, info.box_max[axis] - info.box_min[axis]);
  return extent;
}

std::vector<uint8_t> readBytes(const std::filesystem::path& path, uint64_t offset, size_t size) {
  std::vector<uint8_t> bytes(size);
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Error(path.string() + ": cannot be opened");
  file.seekg(static_cast<std::streamoff>(offset));
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (!file) throw Error(path.string() + ": ends before byte " + std::to_string(offset + size));
  return bytes;
}

Character openCharacter(const std::filesystem::path& path) {
  Character character;
  character.name = path.stem().string();
  character.path = path;
  const std::vector<uint8_t> peek = readBytes(path, 0, LITHE_PEEK_BYTES);
  check(lithe_peek(peek.data(), peek.size(), &character.head_bytes), path.string());
  const std::vector<uint8_t> head = readBytes(path, 0, character.head_bytes);
  lithe_diagnosis diagnosis{};
  lithe_asset* asset = nullptr;
  const lithe_result result = lithe_asset_open(&kAllocator, head.data(), head.size(), &diagnosis, &asset);
  check(result, refusal(character, diagnosis));
  character.asset.reset(asset);
  readTables(character);
  return character;
}

void loadLevel(Character& character, uint32_t level) {
  lithe_asset* asset = character.asset.get();
  lithe_request request{};
  while (lithe_asset_next_request(asset, level, &request) == LITHE_OK) {
    const std::vector<uint8_t> bytes = readBytes(character.path, request.offset, request.size);
    lithe_diagnosis diagnosis{};
    const lithe_result result = lithe_asset_supply(asset, request.page, bytes.data(), bytes.size(), &diagnosis);
    check(result, refusal(character, diagnosis));
  }
}

}  // namespace sample
