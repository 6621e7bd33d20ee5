// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The host's memory runs out at every call that asks for some: an error, nothing leaked, and an asset that still works.
#include "refusals.h"

namespace lithe::test {
namespace {

/// How many times memory is asked for while a file is opened and supplied.
size_t callsToSupply(const FileBytes& bytes) {
  BoundedAllocator memory;
  EXPECT_EQ(driveAsset(bytes.data(), bytes.size(), memory.get()).result, LITHE_OK);
  return memory.calls;
}

TEST(Allocation, OpenFailsAtEveryCall) {
  const FileBytes& bytes = richFile();
  for (size_t fail_at = 0;; ++fail_at) {
    BoundedAllocator memory;
    memory.fail_at = fail_at;
    const lithe_allocator allocator = memory.get();
    lithe_asset* asset = nullptr;
    lithe_diagnosis diagnosis = {7, 7};
    const lithe_result result = lithe_asset_open(&allocator, bytes.data(), bytes.size(), &diagnosis, &asset);
    EXPECT_EQ(diagnosis.check, 0u);
    if (result == LITHE_OK) {
      EXPECT_EQ(fail_at, 2u);  // the head's copy and the object
      lithe_asset_close(asset);
      EXPECT_EQ(memory.held, 0u);
      return;
    }
    EXPECT_EQ(result, LITHE_ERROR_OUT_OF_MEMORY);
    EXPECT_EQ(asset, nullptr);
    EXPECT_EQ(memory.held, 0u);
  }
}

/// The asset without its pages; null where it cannot be opened.
lithe_asset* openWith(BoundedAllocator& memory, const FileBytes& bytes) {
  const lithe_allocator allocator = memory.get();
  lithe_asset* asset = nullptr;
  EXPECT_EQ(lithe_asset_open(&allocator, bytes.data(), bytes.size(), nullptr, &asset), LITHE_OK);
  return asset;
}

void expectLevels(const lithe_asset* asset, const lithe_asset_info& info, const Outcome& sound) {
  for (uint32_t level = 0; level < info.level_count; ++level)
    EXPECT_TRUE(drawLevel(asset, info, level) == sound.levels[level]);
}

/// Supplies every page; at a failure the same page is supplied again. Returns how often that was.
uint32_t supplyWithRetries(lithe_asset* asset, const FileBytes& bytes, const lithe_asset_info& info,
                           const Outcome& sound) {
  uint32_t failures = 0;
  lithe_request request;
  while (lithe_asset_next_request(asset, info.level_count - 1, &request) == LITHE_OK) {
    lithe_diagnosis diagnosis = {};
    const lithe_result result =
        lithe_asset_supply(asset, request.page, bytes.data() + request.offset, request.size, &diagnosis);
    if (result == LITHE_OK) continue;
    EXPECT_EQ(result, LITHE_ERROR_OUT_OF_MEMORY);
    EXPECT_EQ(diagnosis.check, 0u);
    EXPECT_LE(++failures, 1u);
    if (failures > 1) return failures;
    walkHierarchy(asset, info);
    const uint32_t resident = lithe_asset_resident_level(asset);
    for (uint32_t level = 0; resident != LITHE_NO_LEVEL && level <= resident; ++level)
      EXPECT_TRUE(drawLevel(asset, info, level) == sound.levels[level]);
  }
  return failures;
}

TEST(Allocation, SupplyFailsAtEveryCallAndGoesOn) {
  const FileBytes& bytes = richFile();
  const Outcome sound = outcomeOf(bytes);
  const size_t calls = callsToSupply(bytes);
  ASSERT_GT(calls, 10u);
  uint32_t failed = 0;
  for (size_t fail_at = 2; fail_at < calls; ++fail_at) {
    BoundedAllocator memory;
    memory.fail_at = fail_at;
    lithe_asset* asset = openWith(memory, bytes);
    ASSERT_NE(asset, nullptr);
    lithe_asset_info info;
    lithe_asset_describe(asset, &info);
    failed += supplyWithRetries(asset, bytes, info, sound);
    EXPECT_EQ(lithe_asset_resident_level(asset), info.level_count - 1);
    expectLevels(asset, info, sound);
    lithe_asset_close(asset);
    EXPECT_EQ(memory.held, 0u);
  }
  EXPECT_GT(failed, 10u);
}

// Eviction asks for smaller blocks; without them the levels go all the same, and come back.
TEST(Allocation, EvictFailsAtEveryCallAndDropsTheLevelsAllTheSame) {
  const FileBytes& bytes = richFile();
  const Outcome sound = outcomeOf(bytes);
  uint32_t failed = 0;
  for (size_t at = 0; at < 5; ++at) {
    BoundedAllocator memory;
    lithe_asset* asset = openWith(memory, bytes);
    ASSERT_NE(asset, nullptr);
    lithe_asset_info info;
    lithe_asset_describe(asset, &info);
    supplyWithRetries(asset, bytes, info, sound);
    const size_t before = memory.calls;
    memory.fail_at = before + at;
    EXPECT_EQ(lithe_asset_evict(asset, 0), LITHE_OK);
    failed += memory.calls > memory.fail_at;
    EXPECT_EQ(lithe_asset_resident_level(asset), 0u);
    walkHierarchy(asset, info);
    EXPECT_TRUE(drawLevel(asset, info, 0) == sound.levels[0]);
    memory.fail_at = SIZE_MAX;
    EXPECT_EQ(supplyWithRetries(asset, bytes, info, sound), 0u);
    expectLevels(asset, info, sound);
    lithe_asset_close(asset);
    EXPECT_EQ(memory.held, 0u);
  }
  EXPECT_GE(failed, 3u);
}

// A host that gives nothing more after some point, not just once.
TEST(Allocation, EveryLimitOfMemoryGivesAnErrorOrTheWholeFile) {
  const FileBytes& bytes = torusFile();
  const Outcome sound = outcomeOf(bytes);
  BoundedAllocator unlimited;
  driveAsset(bytes.data(), bytes.size(), unlimited.get());
  size_t levels = 0;
  for (size_t limit = 0; limit <= unlimited.peak; limit += 509) {
    BoundedAllocator memory(limit);
    const Outcome outcome = driveAsset(bytes.data(), bytes.size(), memory.get());
    EXPECT_EQ(outcome.result, LITHE_ERROR_OUT_OF_MEMORY);
    EXPECT_GE(outcome.levels.size(), levels);
    levels = outcome.levels.size();
    for (size_t level = 0; level < levels; ++level) EXPECT_TRUE(outcome.levels[level] == sound.levels[level]);
    EXPECT_EQ(memory.held, 0u);
    EXPECT_LE(memory.peak, limit);
  }
  EXPECT_EQ(outcomeOf(bytes, unlimited.peak).result, LITHE_OK);
}

}  // namespace
}  // namespace lithe::test
