// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Any bytes as a whole file, pulled through the public API with everything written. Input: the file; its hashes and
/// its size are made true first.
#include "bounded_allocator.h"
#include "drive_asset.h"
#include "repair_file.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace lithe::test;
  FileBytes file(data, data + size);
  repairHashes(file);
  BoundedAllocator memory(64u << 20);
  driveAsset(file.data(), file.size(), memory.get());
  LITHE_DEMAND(memory.held == 0);
  return 0;
}
