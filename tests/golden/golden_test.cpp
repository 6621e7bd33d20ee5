// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Frozen files decode to the same bytes, whatever the reader has become since (README.md here says when they change).
#include "golden_files.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace lithe::test {
namespace {

FileBytes fileBytes(const std::string& name) {
  std::ifstream in(std::string(LITHE_SOURCE_DIR "/tests/golden/") + name, std::ios::binary);
  EXPECT_TRUE(in) << name << " is missing";
  return FileBytes(std::istreambuf_iterator<char>(in), {});
}

TEST(Golden, FilesDecodeToTheBytesTheyAlwaysDid) {
  std::string found;
  for (const GoldenFile& golden : goldenFiles())
    found += hashLines(golden.name, fileBytes(std::string(golden.name) + ".lithe"));
  const FileBytes listed = fileBytes("hashes.txt");
  EXPECT_EQ(found, std::string(listed.begin(), listed.end()));
}

/// The same input gives the same bytes as on the day the files were made.
TEST(Golden, FilesAreWrittenAsTheyWere) {
  for (const GoldenFile& golden : goldenFiles())
    EXPECT_EQ(encodeSmallFile(golden.shape), fileBytes(std::string(golden.name) + ".lithe")) << golden.name;
}

}  // namespace
}  // namespace lithe::test
