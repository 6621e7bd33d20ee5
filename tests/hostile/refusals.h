// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Small sound files, and what a test of a reader check expects of a broken one.
#pragma once

#include <gtest/gtest.h>

#include "bounded_allocator.h"
#include "drive_asset.h"
#include "encoded_character.h"
#include "lithe_file.h"

namespace lithe::test {

inline const FileBytes& richFile() {
  static const FileBytes bytes = encodeSmallFile(richShape());
  return bytes;
}

/// Closed rings only, no attributes but normals and uvs.
inline const FileBytes& torusFile() {
  static const FileBytes bytes = encodeSmallFile({});
  return bytes;
}

/// Open rings too.
inline const FileBytes& patchFile() {
  static const FileBytes bytes = encodeSmallFile(patchShape());
  return bytes;
}

inline const FileBytes& tinyFile() {
  static const FileBytes bytes = encodeSmallFile(tinyShape());
  return bytes;
}

/// A file like tinyFile() with another mesh.
inline const FileBytes& otherTinyFile() {
  FileShape shape = tinyShape();
  shape.seed = 6;
  static const FileBytes bytes = encodeSmallFile(shape);
  return bytes;
}

/// Opening refuses the head by this check, gives no asset and leaks nothing.
inline void expectHeadRefused(const uint8_t* bytes, size_t size, lithe_result result, uint32_t check) {
  BoundedAllocator memory;
  const lithe_allocator allocator = memory.get();
  lithe_asset* asset = nullptr;
  lithe_diagnosis diagnosis = {};
  EXPECT_STREQ(lithe_result_name(lithe_asset_open(&allocator, bytes, size, &diagnosis, &asset)),
               lithe_result_name(result));
  EXPECT_EQ(diagnosis.check, check);
  EXPECT_LE(diagnosis.offset, size);
  EXPECT_EQ(asset, nullptr);
  lithe_asset_close(asset);
  EXPECT_EQ(memory.held, 0u);
}

inline void expectHeadRefused(const LitheFile& file, lithe_result result, uint32_t check) {
  const FileBytes bytes = file.bytes();
  expectHeadRefused(bytes.data(), bytes.size(), result, check);
}

/// The pages before `page` are taken, it is refused by this check, and the levels before it are still what they were.
inline void expectPageRefused(const LitheFile& file, uint32_t page, lithe_result result, uint32_t check) {
  const FileBytes head = file.sealedHead();
  BoundedAllocator memory;
  const lithe_allocator allocator = memory.get();
  lithe_asset* asset = nullptr;
  lithe_diagnosis diagnosis = {};
  ASSERT_EQ(lithe_asset_open(&allocator, head.data(), head.size(), &diagnosis, &asset), LITHE_OK)
      << "check " << diagnosis.check;
  lithe_asset_info info;
  lithe_asset_describe(asset, &info);
  uint64_t offset = head.size();
  for (uint32_t p = 0; p < page; ++p) {
    ASSERT_EQ(lithe_asset_supply(asset, p, file.pages[p].data(), file.pages[p].size(), nullptr), LITHE_OK);
    offset += file.pages[p].size();
  }
  const uint32_t resident = lithe_asset_resident_level(asset);
  LevelHashes before, after;
  if (page > 0) before = drawLevel(asset, info, resident);
  EXPECT_STREQ(
      lithe_result_name(lithe_asset_supply(asset, page, file.pages[page].data(), file.pages[page].size(), &diagnosis)),
      lithe_result_name(result));
  EXPECT_EQ(diagnosis.check, check);
  EXPECT_GE(diagnosis.offset, offset);
  EXPECT_LE(diagnosis.offset, offset + file.pages[page].size());
  EXPECT_EQ(lithe_asset_resident_level(asset), resident);
  walkHierarchy(asset, info);
  if (page > 0) after = drawLevel(asset, info, resident);
  EXPECT_TRUE(before == after);
  lithe_asset_close(asset);
  EXPECT_EQ(memory.held, 0u);
}

/// What a sound file decodes to.
inline Outcome outcomeOf(const FileBytes& bytes, size_t limit = SIZE_MAX) {
  BoundedAllocator memory(limit);
  const Outcome outcome = driveAsset(bytes.data(), bytes.size(), memory.get());
  EXPECT_EQ(memory.held, 0u);
  return outcome;
}

}  // namespace lithe::test
