// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Bytes from disk, and the chunks of a GLB (glTF 2.0, section 4).
#include <fstream>

#include "gltf_file.h"

namespace lithe::bake {

namespace {

constexpr uint32_t kGlbMagic = 0x46546c67;
constexpr uint32_t kJsonChunk = 0x4e4f534a;
constexpr uint32_t kBinaryChunk = 0x004e4942;
constexpr size_t kHeaderBytes = 12;
constexpr size_t kChunkHeaderBytes = 8;

uint32_t readU32(std::span<const uint8_t> bytes, size_t at) {
  return bytes[at] | uint32_t{bytes[at + 1]} << 8 | uint32_t{bytes[at + 2]} << 16 | uint32_t{bytes[at + 3]} << 24;
}

struct Chunk {
  uint32_t type = 0;
  std::span<const uint8_t> bytes;
};

/// The chunk at `at`, which is moved behind it.
Chunk nextChunk(const FileName& name, std::span<const uint8_t> glb, size_t& at) {
  if (glb.size() - at < kChunkHeaderBytes)
    name.fail("byte " + std::to_string(at), "the file is cut off; copy it again");
  const uint32_t length = readU32(glb, at), type = readU32(glb, at + 4);
  at += kChunkHeaderBytes;
  if (length > glb.size() - at) {
    name.fail("byte " + std::to_string(at), "a chunk of " + std::to_string(length) + " bytes is cut off after " +
                                                std::to_string(glb.size() - at) + "; copy the file again");
  }
  const Chunk chunk{type, glb.subspan(at, length)};
  at += length;
  return chunk;
}

/// The bytes of a GLB that its header announces.
std::span<const uint8_t> announcedBytes(const FileName& name, std::span<const uint8_t> file) {
  if (file.size() < kHeaderBytes) name.fail("", "the file is cut off within its header; copy it again");
  const uint32_t version = readU32(file, 4), length = readU32(file, 8);
  if (version != 2) name.fail("", "binary glTF version " + std::to_string(version) + " is not read; export glTF 2.0");
  if (length > file.size() || length < kHeaderBytes) {
    name.fail("", "the header announces " + std::to_string(length) + " bytes, the file has " +
                      std::to_string(file.size()) + "; copy it again");
  }
  return file.first(length);
}

GltfContainer splitGlb(const FileName& name, std::span<const uint8_t> file) {
  const std::span<const uint8_t> glb = announcedBytes(name, file);
  size_t at = kHeaderBytes;
  const Chunk json = nextChunk(name, glb, at);
  if (json.type != kJsonChunk) name.fail("", "the first chunk is not JSON; re-export the file");
  GltfContainer container{std::string(json.bytes.begin(), json.bytes.end()), {}};
  while (at < glb.size() && container.binary.empty()) {
    const Chunk chunk = nextChunk(name, glb, at);
    if (chunk.type == kBinaryChunk) container.binary.assign(chunk.bytes.begin(), chunk.bytes.end());
  }
  return container;
}

}  // namespace

void FileName::fail(const std::string& place, const std::string& what) const {
  std::string sentence = text + ": ";
  if (!place.empty()) sentence.append(place).append(": ");
  throw Error(sentence.append(what));
}

GltfContainer splitContainer(const FileName& name, Bytes file) {
  if (file.empty()) name.fail("", "the file is empty");
  GltfContainer container;
  if (file.size() >= 4 && readU32(file, 0) == kGlbMagic) {
    container = splitGlb(name, file);
  } else {
    container.json.assign(file.begin(), file.end());
  }
  // Some exporters fill up the JSON chunk with zeros instead of spaces.
  container.json.erase(container.json.find_last_not_of('\0') + 1);
  return container;
}

Bytes readWholeFile(const FileName& name, const std::filesystem::path& path) {
  std::error_code failure;
  const bool regular = std::filesystem::is_regular_file(path, failure);
  const uintmax_t size = regular ? std::filesystem::file_size(path, failure) : 0;
  if (!regular || failure) name.fail("", "there is no readable file '" + path.string() + "'; check the path");
  Bytes bytes(size);
  std::ifstream in(path, std::ios::binary);
  in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (!in) name.fail("", "'" + path.string() + "' cannot be read; check its permissions");
  return bytes;
}

}  // namespace lithe::bake
