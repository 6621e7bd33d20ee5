// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "files.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <system_error>

#include "lithe/bake/model.h"

namespace lithe::tool {
namespace {

using FileHandle = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

FileHandle openFile(const std::filesystem::path& path, const char* mode) {
  return {std::fopen(path.c_str(), mode), [](std::FILE* file) { return std::fclose(file); }};
}

[[noreturn]] void failToWrite(const std::filesystem::path& path, const std::string& reason) {
  throw bake::Error(path.string() + ": cannot be written: " + reason + "; choose another output");
}

/// Removes its file unless told that the file has become what it should.
struct TemporaryFile {
  std::filesystem::path path;
  bool kept = false;

  ~TemporaryFile() {
    std::error_code ignored;
    if (!kept) std::filesystem::remove(path, ignored);
  }
};

/// In the same folder, since a rename across file systems is a copy; with the process id, since two tools may run at
/// once.
std::filesystem::path besides(const std::filesystem::path& path) {
  return path.parent_path() / ("." + path.filename().string() + "." + std::to_string(getpid()) + ".tmp");
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

void writeFile(const std::filesystem::path& path, std::span<const uint8_t> bytes) {
  requireWritable(path);
  TemporaryFile temporary{besides(path)};
  FileHandle file = openFile(temporary.path, "wb");
  if (!file) failToWrite(path, std::strerror(errno));
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
  const bool closed = std::fclose(file.release()) == 0;
  if (!written || !closed) failToWrite(path, std::strerror(errno));
  std::error_code error;
  std::filesystem::rename(temporary.path, path, error);
  if (error) failToWrite(path, error.message());
  temporary.kept = true;
}

void writeText(const std::filesystem::path& path, std::string_view text) {
  if (path == "-") {
    std::fwrite(text.data(), 1, text.size(), stdout);
    return;
  }
  writeFile(path, {reinterpret_cast<const uint8_t*>(text.data()), text.size()});
}

void requireWritable(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  if (path.filename().empty()) failToWrite(path, "it names no file");
  if (std::filesystem::is_directory(path, error)) failToWrite(path, "it is a folder");
  if (!std::filesystem::is_directory(folder, error))
    failToWrite(path, "the folder " + folder.string() + " does not exist");
  if (access(folder.c_str(), W_OK) != 0) failToWrite(path, std::strerror(errno));
}

}  // namespace lithe::tool
