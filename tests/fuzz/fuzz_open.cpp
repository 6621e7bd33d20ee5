// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Any bytes as a head, under a true checksum. Input: the head.
#include "bounded_allocator.h"
#include "drive_asset.h"
#include "repair_file.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace lithe::test;
  FileBytes head(data, data + size);
  uint64_t head_bytes = 0;
  const lithe_result peeked = lithe_peek(head.data(), head.size(), &head_bytes);
  LITHE_DEMAND(peeked != LITHE_OK || (head_bytes >= LITHE_PEEK_BYTES && head_bytes <= 16u << 20));
  repairHashes(head);
  BoundedAllocator memory(64u << 20);
  driveAsset(head.data(), head.size(), memory.get());
  LITHE_DEMAND(memory.held == 0);
  return 0;
}
