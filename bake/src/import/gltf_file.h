// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// A glTF file in memory: its document, the bytes of its buffers, and the way to complain about it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "gltf.h"
#include "lithe/bake/model.h"

namespace lithe::bake {

using Bytes = std::vector<uint8_t>;

/// The file's name, for the first words of every sentence.
struct FileName {
  std::string text;

  /// Throws Error "file: place: what". `place` may be empty.
  [[noreturn]] void fail(const std::string& place, const std::string& what) const;
};

/// The two halves of a file: its JSON, and the binary chunk of a GLB (empty for a .gltf).
struct GltfContainer {
  std::string json;
  Bytes binary;
};

struct GltfFile {
  FileName name;
  tinygltf::Model document;          ///< without buffers, images, textures, cameras and extras
  std::vector<Bytes> buffers;        ///< empty where the document states none to read
  std::vector<Bytes> decoded_views;  ///< per buffer view: its bytes if they were compressed, else empty

  /// The bytes of a buffer view. Throws Error if they are not within its buffer.
  std::span<const uint8_t> viewBytes(int64_t view, const std::string& place) const;
  /// How many vertices, triangles or keys may come of this file: references can make a small file expand without end.
  uint64_t elementLimit() const;
};

/// Splits a GLB into its chunks; anything else is taken as JSON. Throws Error for a damaged GLB.
GltfContainer splitContainer(const FileName& name, Bytes file);

/// Reads a file whole. Throws Error.
Bytes readWholeFile(const FileName& name, const std::filesystem::path& path);

/// Opens a file and everything it refers to, except images. Throws Error.
GltfFile readGltfFile(const std::filesystem::path& path);

}  // namespace lithe::bake
