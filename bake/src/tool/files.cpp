// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <system_error>

#include "lithe/bake/model.h"
#include "lithe/bake/output_files.h"

namespace lithe::tool {
namespace {

using FileHandle = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

FileHandle openFile(const std::filesystem::path& path, const char* mode) {
  return {std::fopen(path.c_str(), mode), [](std::FILE* file) { return std::fclose(file); }};
}

}  // namespace

std::vector<uint8_t> readFile(const std::filesystem::path& path) {
  const auto fail = [&](const std::string& reason) {
    throw bake::Error(path.string() + ": cannot be read: " + reason + "; check the path");
  };
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) fail("it is a folder");
  const FileHandle file = openFile(path, "rb");
  if (!file) fail(std::strerror(errno));
  std::vector<uint8_t> bytes;
  uint8_t block[1 << 16];
  while (const size_t count = std::fread(block, 1, sizeof block, file.get())) {
    bytes.insert(bytes.end(), block, block + count);
  }
  if (std::ferror(file.get())) fail(std::strerror(errno));
  return bytes;
}

std::span<const uint8_t> bytesOf(std::string_view text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

void writeText(const std::filesystem::path& path, std::string_view text) {
  if (path == "-") {
    std::fwrite(text.data(), 1, text.size(), stdout);
    return;
  }
  const bake::OutputFile file{path, bytesOf(text)};
  bake::writeTogether({&file, 1});
}

}  // namespace lithe::tool
