// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The frozen files of tests/golden: how each was made, and the lines of hashes.txt that say what it decodes to.
#pragma once

#include <cinttypes>
#include <cstdio>
#include <string>

#include "bounded_allocator.h"
#include "drive_asset.h"
#include "encoded_character.h"
#include "lithe_file.h"

namespace lithe::test {

struct GoldenFile {
  const char* name;
  FileShape shape;
};

inline FileShape bareShape() {
  FileShape shape = tinyShape();
  shape.character.attributes = {false, false, 0, 0};
  shape.character.position_bits = 16;
  shape.placement_shift = 31;
  shape.seed = 9;
  return shape;
}

/// Everything a file can have; a closed surface; no attribute at all.
inline std::vector<GoldenFile> goldenFiles() {
  return {{"rich", richShape()}, {"tiny", tinyShape()}, {"bare", bareShape()}};
}

/// One line a level: NAME LEVEL XXH64-OF-VERTICES XXH64-OF-INDICES; "NAME refused" where the file is not taken whole.
inline std::string hashLines(const std::string& name, const FileBytes& bytes) {
  BoundedAllocator memory;
  const Outcome outcome = driveAsset(bytes.data(), bytes.size(), memory.get());
  if (outcome.result != LITHE_OK) return name + " refused: check " + std::to_string(outcome.diagnosis.check) + "\n";
  std::string lines;
  for (size_t level = 0; level < outcome.levels.size(); ++level) {
    char hashes[64];
    std::snprintf(hashes, sizeof hashes, " %zu %016" PRIx64 " %016" PRIx64 "\n", level, outcome.levels[level].vertices,
                  outcome.levels[level].indices);
    lines += name + hashes;
  }
  return lines;
}

}  // namespace lithe::test
