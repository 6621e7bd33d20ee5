// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Any bytes as a page of a small sound file whose tables say its size, its hash and its integers. Input: the page's
/// index (one byte) | the integers that PAGE states (four bytes) | the page.
#include "bounded_allocator.h"
#include "drive_asset.h"
#include "encoded_character.h"
#include "lithe_file.h"

namespace {

using namespace lithe::test;

/// The file up to and with the page in question.
FileBytes fileWith(const uint8_t* data, size_t size) {
  static const FileBytes sound = encodeSmallFile(smallRichShape());
  LitheFile file(sound);
  const uint32_t page = data[0] % static_cast<uint32_t>(file.pages.size());
  file.pages[page].assign(data + 5, data + size);
  lithe::format::storeU32(file.record(lithe::format::page::kId, page) + lithe::format::page::kValuesAt,
                          lithe::format::loadU32(data + 1));
  file.sealPages();
  return file.bytes();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size < 6) return 0;
  const FileBytes file = fileWith(data, size);
  BoundedAllocator memory(64u << 20);
  driveAsset(file.data(), file.size(), memory.get());
  LITHE_DEMAND(memory.held == 0);
  return 0;
}
