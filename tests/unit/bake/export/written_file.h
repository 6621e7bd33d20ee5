// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Looking into files that a test wrote, without the library's own reader.
#pragma once

#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace lithe::bake::test {

/// A folder of its own that goes away with the object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    static int count = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("lithe_export_" + std::to_string(getpid()) + "_" + std::to_string(count++));
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::filesystem::path& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

inline std::vector<uint8_t> bytesOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

inline uint32_t wordAt(const std::vector<uint8_t>& bytes, size_t offset) {
  uint32_t word = 0;
  std::memcpy(&word, bytes.data() + offset, sizeof word);
  return word;
}

/// The JSON chunk of a GLB whose header and lengths agree.
inline nlohmann::json jsonOf(const std::filesystem::path& path) {
  const std::vector<uint8_t> bytes = bytesOf(path);
  if (bytes.size() < 20 || wordAt(bytes, 0) != 0x46546c67 || wordAt(bytes, 8) != bytes.size()) return {};
  return nlohmann::json::parse(bytes.begin() + 20, bytes.begin() + 20 + wordAt(bytes, 12));
}

/// The binary chunk of a GLB, cut to the length that the buffer states.
inline std::vector<uint8_t> binaryOf(const std::filesystem::path& path) {
  const std::vector<uint8_t> bytes = bytesOf(path);
  const size_t chunk = 20 + wordAt(bytes, 12);
  const size_t length = jsonOf(path)["buffers"][0]["byteLength"];
  if (wordAt(bytes, chunk) < length || wordAt(bytes, chunk) > length + 3) return {};
  return {bytes.begin() + static_cast<std::ptrdiff_t>(chunk) + 8,
          bytes.begin() + static_cast<std::ptrdiff_t>(chunk + 8 + length)};
}

/// The values of a float accessor.
inline std::vector<float> floatsOf(const std::filesystem::path& path, size_t accessor) {
  const nlohmann::json json = jsonOf(path);
  const std::vector<uint8_t> binary = binaryOf(path);
  const nlohmann::json& view = json["bufferViews"][json["accessors"][accessor]["bufferView"].get<size_t>()];
  std::vector<float> values(view["byteLength"].get<size_t>() / sizeof(float));
  std::memcpy(values.data(), binary.data() + view["byteOffset"].get<size_t>(), values.size() * sizeof(float));
  return values;
}

}  // namespace lithe::bake::test
