// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Small glTF files for the import's tests, right or wrong as wanted.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lithe/bake/import.h"

namespace lithe::bake {

template <typename T>
constexpr int componentTypeOf() {
  if constexpr (std::is_same_v<T, int8_t>) return 5120;
  if constexpr (std::is_same_v<T, uint8_t>) return 5121;
  if constexpr (std::is_same_v<T, int16_t>) return 5122;
  if constexpr (std::is_same_v<T, uint16_t>) return 5123;
  if constexpr (std::is_same_v<T, uint32_t>) return 5125;
  return 5126;
}

inline size_t componentsOf(const std::string& type) {
  if (type == "SCALAR") return 1;
  if (type == "VEC2") return 2;
  if (type == "VEC3") return 3;
  return type == "VEC4" ? 4 : 16;
}

/// A document under construction (not the exporter's GltfBuilder, which is linked too): `json` is free to be changed,
/// `binary` is buffer 0.
struct GltfDraft {
  nlohmann::json json = {{"asset", {{"version", "2.0"}}}};
  std::vector<uint8_t> binary;

  /// Appends bytes at a multiple of four.
  int view(const void* data, size_t bytes, size_t stride = 0) {
    binary.resize((binary.size() + 3) / 4 * 4);
    nlohmann::json stated = {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes}};
    if (stride != 0) stated["byteStride"] = stride;
    const auto* begin = static_cast<const uint8_t*>(data);
    binary.insert(binary.end(), begin, begin + bytes);
    json["bufferViews"].push_back(stated);
    return static_cast<int>(json["bufferViews"].size()) - 1;
  }

  int add(const char* list, nlohmann::json item) {
    json[list].push_back(std::move(item));
    return static_cast<int>(json[list].size()) - 1;
  }

  template <typename T>
  int accessor(const std::string& type, const std::vector<T>& values, bool normalized = false) {
    nlohmann::json stated = {{"bufferView", view(values.data(), values.size() * sizeof(T))},
                             {"componentType", componentTypeOf<T>()},
                             {"count", values.size() / componentsOf(type)},
                             {"type", type}};
    if (normalized) stated["normalized"] = true;
    return add("accessors", stated);
  }

  std::string text() const {
    nlohmann::json whole = json;
    if (!whole.contains("buffers") && !binary.empty()) whole["buffers"] = {{{"byteLength", binary.size()}}};
    return whole.dump();
  }

  std::vector<uint8_t> glb() const {
    std::string document = text();
    document.resize((document.size() + 3) / 4 * 4, ' ');
    std::vector<uint8_t> chunk = binary;
    chunk.resize((chunk.size() + 3) / 4 * 4);
    std::vector<uint8_t> file;
    const auto u32 = [&](size_t value) {
      for (int i = 0; i < 4; ++i) file.push_back(static_cast<uint8_t>(value >> (8 * i)));
    };
    u32(0x46546c67), u32(2), u32(12 + 8 + document.size() + (chunk.empty() ? 0 : 8 + chunk.size()));
    u32(document.size()), u32(0x4e4f534a);
    file.insert(file.end(), document.begin(), document.end());
    if (!chunk.empty()) {
      u32(chunk.size()), u32(0x004e4942);
      file.insert(file.end(), chunk.begin(), chunk.end());
    }
    return file;
  }
};

/// A file of the running test in the temporary folder.
inline std::filesystem::path tempFile(const std::string& extension) {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  return std::filesystem::path(::testing::TempDir()) /
         (std::string("import_") + test->test_suite_name() + "_" + test->name() + extension);
}

inline std::filesystem::path writeBytes(const std::filesystem::path& path, const void* data, size_t size) {
  std::ofstream out(path, std::ios::binary);
  out.write(static_cast<const char*>(data), static_cast<std::streamsize>(size));
  return path;
}

inline Model importBytes(const std::vector<uint8_t>& file) {
  return importGltf(writeBytes(tempFile(".glb"), file.data(), file.size()));
}

inline Model importBuilt(const GltfDraft& builder) { return importBytes(builder.glb()); }

/// What importing throws, without the file's name; "nothing" if it does not.
inline std::string complaintAbout(const std::vector<uint8_t>& file) {
  try {
    importBytes(file);
  } catch (const Error& error) {
    const std::string what = error.what(), name = tempFile(".glb").string() + ": ";
    EXPECT_EQ(what.rfind(name, 0), 0u) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    return what.substr(std::min(name.size(), what.size()));
  }
  return "nothing";
}

inline bool warned(const Model& model, const std::string& fragment) {
  for (const std::string& warning : model.warnings) {
    if (warning.find(fragment) != std::string::npos) return true;
  }
  return false;
}

/// A ribbon of two triangles in the plane z = 0, x from 0 to 2, bound to the joints "a" at x = 0 and "b" at x = 1:
/// vertices 0 and 1 (x = 0) to a, 2 and 3 (x = 2) half to a and half to b. Node 2 shows it. Rest pose is bind pose.
struct Ribbon : GltfDraft {
  int position, joints, weights, indices, inverse_binds;

  Ribbon() {
    position = accessor<float>("VEC3", {0, 0, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0});
    joints = accessor<uint8_t>("VEC4", {0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0});
    weights = accessor<float>("VEC4", {1, 0, 0, 0, 1, 0, 0, 0, .5, .5, 0, 0, .5, .5, 0, 0});
    indices = accessor<uint16_t>("SCALAR", {0, 2, 1, 1, 2, 3});
    inverse_binds = accessor<float>(
        "MAT4", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1});
    add("meshes", {{"name", "ribbon"}, {"primitives", {{{"attributes", attributes()}, {"indices", indices}}}}});
    add("skins", {{"joints", {0, 1}}, {"inverseBindMatrices", inverse_binds}});
    add("nodes", {{"name", "a"}, {"children", {1}}});
    add("nodes", {{"name", "b"}, {"translation", {1, 0, 0}}});
    add("nodes", {{"name", "shows"}, {"mesh", 0}, {"skin", 0}});
    add("scenes", {{"nodes", {0, 2}}});
    json["scene"] = 0;
  }

  nlohmann::json attributes() const { return {{"POSITION", position}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}; }
  nlohmann::json& primitive() { return json["meshes"][0]["primitives"][0]; }
};

}  // namespace lithe::bake
