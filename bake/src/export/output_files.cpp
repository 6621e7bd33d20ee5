// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/output_files.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <system_error>
#include <vector>

#include "lithe/bake/model.h"

namespace lithe::bake {

namespace {

using std::filesystem::path;

[[noreturn]] void failToWrite(const path& target, const std::string& reason) {
  throw Error(target.string() + ": cannot be written: " + reason + "; choose another output");
}

/// In the same folder, since a rename across file systems is a copy; with the process id, since two tools may run at
/// once.
path besides(const path& target, const char* purpose) {
  return target.parent_path() / ("." + target.filename().string() + "." + std::to_string(getpid()) + purpose);
}

void writeBytes(const path& file_path, const path& target, std::span<const uint8_t> bytes) {
  std::FILE* file = std::fopen(file_path.string().c_str(), "wb");
  if (file == nullptr) failToWrite(target, std::strerror(errno));
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  const int write_error = errno;
  const bool closed = std::fclose(file) == 0;
  if (!written || !closed) failToWrite(target, std::strerror(written ? errno : write_error));
}

/// Puts files in place one by one, and the old ones back unless told that all went well.
class Replacement {
 public:
  Replacement() = default;
  Replacement(const Replacement&) = delete;
  Replacement& operator=(const Replacement&) = delete;
  ~Replacement() {
    std::error_code ignored;
    for (const path& file : written_) std::filesystem::remove(file, ignored);
    for (const Saved& saved : saved_) std::filesystem::rename(saved.copy, saved.target, ignored);
  }

  void write(const OutputFile& file) {
    written_.push_back(besides(file.path, ".tmp"));
    writeBytes(written_.back(), file.path, file.bytes);
  }

  /// Takes the target's old file out of the way, to come back if a later file fails.
  void save(const path& target) {
    std::error_code failure;
    if (!std::filesystem::is_regular_file(target, failure)) return;
    const path copy = besides(target, ".old");
    std::filesystem::rename(target, copy, failure);
    if (failure) failToWrite(target, failure.message());
    saved_.push_back({copy, target});
  }

  /// Gives file number `index` of those written its name.
  void place(size_t index, const path& target) {
    std::error_code failure;
    std::filesystem::rename(written_[index], target, failure);
    if (failure) failToWrite(target, failure.message());
    written_[index] = target;
  }

  void keep() {
    std::error_code ignored;
    for (const Saved& saved : saved_) std::filesystem::remove(saved.copy, ignored);
    saved_.clear();
    written_.clear();
  }

 private:
  struct Saved {
    path copy, target;
  };
  std::vector<path> written_;
  std::vector<Saved> saved_;
};

}  // namespace

void writeTogether(std::span<const OutputFile> files) {
  for (const OutputFile& file : files) requireWritable(file.path);
  Replacement replacement;
  for (const OutputFile& file : files) replacement.write(file);
  for (size_t i = 0; i < files.size(); ++i) {
    // Nothing can fail behind the last file, which is replaced in one step.
    if (i + 1 < files.size()) replacement.save(files[i].path);
    replacement.place(i, files[i].path);
  }
  replacement.keep();
}

void requireWritable(const path& target) {
  std::error_code error;
  const path folder = target.has_parent_path() ? target.parent_path() : ".";
  if (target.filename().empty()) failToWrite(target, "it names no file");
  if (std::filesystem::is_directory(target, error)) failToWrite(target, "it is a folder");
  if (!std::filesystem::is_directory(folder, error)) {
    failToWrite(target, "the folder " + folder.string() + " does not exist");
  }
  if (access(folder.c_str(), W_OK) != 0) failToWrite(target, std::strerror(errno));
}

}  // namespace lithe::bake
