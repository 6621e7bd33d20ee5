// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "output_files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "lithe/bake/model.h"

namespace lithe::bake {

namespace {

/// Removes its files unless told that all went well.
struct Undo {
  std::vector<std::filesystem::path> paths;

  Undo() = default;
  Undo(const Undo&) = delete;
  Undo& operator=(const Undo&) = delete;
  ~Undo() {
    std::error_code ignored;
    for (const std::filesystem::path& path : paths) std::filesystem::remove(path, ignored);
  }
};

[[noreturn]] void failToWrite(const std::filesystem::path& path, const std::string& reason) {
  throw Error(path.string() + ": cannot be written (" + reason + "): check the folder and the space left");
}

void writeBytes(const std::filesystem::path& path, const std::filesystem::path& target,
                std::span<const uint8_t> bytes) {
  std::FILE* file = std::fopen(path.string().c_str(), "wb");
  if (file == nullptr) failToWrite(target, std::strerror(errno));
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  const int reason = errno;
  const bool closed = std::fclose(file) == 0;
  if (!written || !closed) failToWrite(target, std::strerror(written ? errno : reason));
}

}  // namespace

void writeTogether(std::span<const OutputFile> files) {
  Undo undo;
  std::vector<std::filesystem::path> temporaries;
  for (const OutputFile& file : files) {
    temporaries.push_back(file.path.string() + ".part");
    undo.paths.push_back(temporaries.back());
    writeBytes(temporaries.back(), file.path, file.bytes);
  }
  for (size_t i = 0; i < files.size(); ++i) {
    std::error_code failure;
    std::filesystem::rename(temporaries[i], files[i].path, failure);
    if (failure) failToWrite(files[i].path, failure.message());
    undo.paths.push_back(files[i].path);
  }
  undo.paths.clear();
}

}  // namespace lithe::bake
