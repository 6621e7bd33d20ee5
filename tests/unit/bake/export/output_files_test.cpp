// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Files that appear together: all of them, or nothing new.
#include "lithe/bake/output_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "lithe/bake/model.h"
#include "written_file.h"

namespace lithe::bake {
namespace {

using test::TemporaryFolder;

std::span<const uint8_t> bytesOf(std::string_view text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

std::string textOf(const std::filesystem::path& path) {
  const std::vector<uint8_t> bytes = test::bytesOf(path);
  return {bytes.begin(), bytes.end()};
}

std::vector<std::string> namesIn(const TemporaryFolder& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

TEST(OutputFiles, ReplaceWhatWasThere) {
  const TemporaryFolder folder;
  for (const char* text : {"first", "second"}) {
    const OutputFile files[] = {{folder / "a", bytesOf(text)}, {folder / "b", bytesOf("")}};
    writeTogether(files);
    EXPECT_EQ(textOf(folder / "a"), text);
    EXPECT_EQ(textOf(folder / "b"), "");
    EXPECT_EQ(namesIn(folder), (std::vector<std::string>{"a", "b"}));
  }
}

TEST(OutputFiles, WriteNothingWhenOneOfThemCannotBe) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "taken");
  const OutputFile files[] = {{folder / "a", bytesOf("a")}, {folder / "taken", bytesOf("b")}};
  EXPECT_THROW(writeTogether(files), Error);
  const std::string long_name(300, 'n');  // no file system takes it, and that shows only when the file is made
  const OutputFile unnameable[] = {{folder / "a", bytesOf("a")}, {folder / long_name, bytesOf("b")}};
  EXPECT_THROW(writeTogether(unnameable), Error);
  EXPECT_EQ(namesIn(folder), std::vector<std::string>{"taken"});
}

TEST(OutputFiles, PutTheOldOnesBackWhenALaterOneFails) {
  const TemporaryFolder folder;
  const OutputFile before[] = {{folder / "a", bytesOf("old")}};
  writeTogether(before);
  // The third cannot get its name: it shares its temporary file with the second, which has taken it away.
  const OutputFile files[] = {
      {folder / "a", bytesOf("new")}, {folder / "b", bytesOf("new")}, {folder / "b", bytesOf("new")}};
  EXPECT_THROW(writeTogether(files), Error);
  EXPECT_EQ(textOf(folder / "a"), "old");
  EXPECT_EQ(namesIn(folder), std::vector<std::string>{"a"});
}

TEST(OutputFiles, AreRefusedEarlyWhereTheyCannotBe) {
  const TemporaryFolder folder;
  EXPECT_NO_THROW(requireWritable(folder / "new"));
  EXPECT_NO_THROW(requireWritable("new"));
  const auto complaint = [](const std::filesystem::path& path) -> std::string {
    try {
      requireWritable(path);
    } catch (const Error& error) {
      return error.what();
    }
    return "nothing";
  };
  EXPECT_EQ(complaint(folder.path()),
            folder.path().string() + ": cannot be written: it is a folder; choose another output");
  EXPECT_NE(complaint(folder / "missing/new").find("does not exist"), std::string::npos);
  EXPECT_NE(complaint("").find("it names no file"), std::string::npos);
}

}  // namespace
}  // namespace lithe::bake
