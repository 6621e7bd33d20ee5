// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "gltf_file.h"

#include "buffers.h"
#include "compressed_views.h"
#include "document.h"

namespace lithe::bake {

namespace {

/// A file may show one mesh many times, but no character needs more than this for what it stores.
constexpr uint64_t kFreeElements = uint64_t{1} << 20;
constexpr uint64_t kElementsPerByte = 4;

}  // namespace

std::span<const uint8_t> GltfFile::viewBytes(int64_t view, const std::string& place) const {
  if (view < 0 || view >= static_cast<int64_t>(document.bufferViews.size())) {
    name.fail(place, "there is no buffer view " + std::to_string(view) + "; re-export the file");
  }
  const size_t index = static_cast<size_t>(view);
  if (!decoded_views[index].empty()) return decoded_views[index];
  const tinygltf::BufferView& stated = document.bufferViews[index];
  return bufferRange(*this, stated.buffer, stated.byteOffset, stated.byteLength, "buffer view " + std::to_string(view));
}

uint64_t GltfFile::elementLimit() const {
  uint64_t bytes = 0;
  for (const Bytes& buffer : buffers) bytes += buffer.size();
  return kFreeElements + kElementsPerByte * bytes;
}

GltfFile readGltfFile(const std::filesystem::path& path) {
  GltfFile file;
  file.name.text = path.string();
  GltfContainer container = splitContainer(file.name, readWholeFile(file.name, path));
  const nlohmann::json json = parseJson(file.name, container.json);
  file.buffers = readBuffers(file.name, json, path.parent_path(), std::move(container.binary));
  file.document = parseDocument(file.name, json);
  file.decoded_views = decodeCompressedViews(file);
  return file;
}

}  // namespace lithe::bake
