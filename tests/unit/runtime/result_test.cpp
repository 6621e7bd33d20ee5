// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "lithe/runtime.h"

namespace {

/// The lines of a file of the project that begin with a prefix, spaces in front left out.
std::vector<std::string> linesWith(const std::string& path, const std::string& prefix) {
  std::ifstream file(LITHE_SOURCE_DIR "/" + path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    line.erase(0, std::min(line.size(), line.find_first_not_of(' ')));
    if (line.compare(0, prefix.size(), prefix) == 0) lines.push_back(line);
  }
  return lines;
}

TEST(ResultName, IsTheNameInTheHeaderAndUniqueForEveryCode) {
  std::set<std::string> names;
  for (const std::string& line : linesWith("runtime/include/lithe/runtime.h", "LITHE_")) {
    char name[64];
    int value = 0;
    if (std::sscanf(line.c_str(), "%63[A-Z_] = %d", name, &value) != 2) continue;
    const std::string text = name;
    if (text.compare(0, 12, "LITHE_FORMAT") == 0 || text.compare(0, 11, "LITHE_INDEX") == 0) continue;
    EXPECT_EQ(text, lithe_result_name(static_cast<lithe_result>(value)));
    names.insert(text);
  }
  EXPECT_EQ(names.size(), 12u);
}

TEST(ResultName, IsUnknownForOtherValues) { EXPECT_STREQ(lithe_result_name(static_cast<lithe_result>(15)), "unknown"); }

TEST(Version, IsTheProjects) {
  const std::vector<std::string> lines = linesWith("CMakeLists.txt", "project(lithe VERSION ");
  ASSERT_EQ(lines.size(), 1u);
  unsigned major = 0, minor = 0, patch = 0;
  ASSERT_EQ(std::sscanf(lines[0].c_str(), "project(lithe VERSION %u.%u.%u", &major, &minor, &patch), 3);
  EXPECT_EQ(lithe_version(), major * 10000 + minor * 100 + patch);
}

}  // namespace
