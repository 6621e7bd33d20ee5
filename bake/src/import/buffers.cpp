// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "buffers.h"

#include "uri.h"

namespace lithe::bake {

namespace {

using Json = nlohmann::json;

/// tinygltf knows a fixed list of media types; the bytes are the same whatever they are called.
Bytes decodeDataUri(const FileName& name, const std::string& uri, const std::string& place) {
  const size_t comma = uri.find(',');
  if (comma == std::string::npos || uri.substr(0, comma).find(";base64") == std::string::npos) {
    name.fail(place, "its data URI is not base64; re-export the file");
  }
  Bytes bytes;
  std::string media_type;
  const std::string plain = "data:application/octet-stream;base64," + uri.substr(comma + 1);
  tinygltf::DecodeDataURI(&bytes, media_type, plain, 0, false);
  return bytes;
}

Bytes readExternal(const FileName& name, const std::string& uri, const std::filesystem::path& folder,
                   const std::string& place) {
  if (uri.find("://") != std::string::npos) {
    name.fail(place, "'" + uri + "' is on a network; download it and refer to the copy");
  }
  const std::filesystem::path path = folder / std::filesystem::path(percentDecoded(uri));
  std::error_code failure;
  if (!std::filesystem::is_regular_file(path, failure)) {
    name.fail(place, "its file '" + percentDecoded(uri) + "' is missing; put it beside the .gltf");
  }
  return readWholeFile(name, path);
}

/// Cuts a buffer to its stated length, as padding is not part of it.
void cutToLength(const FileName& name, const Json& buffer, Bytes& bytes, const std::string& place) {
  if (!buffer.contains("byteLength") || !buffer["byteLength"].is_number_unsigned()) {
    name.fail(place, "its byteLength is missing; re-export the file");
  }
  const uint64_t length = buffer["byteLength"].get<uint64_t>();
  if (bytes.size() < length) {
    name.fail(place, "it should have " + std::to_string(length) + " bytes and has " + std::to_string(bytes.size()) +
                         "; copy or export the file again");
  }
  bytes.resize(length);
}

/// The bytes of one buffer. `binary` is the GLB's chunk for the buffer that may use it, null for others.
Bytes readBuffer(const FileName& name, const Json& buffer, const std::filesystem::path& folder, Bytes* binary,
                 const std::string& place) {
  Bytes bytes;
  if (buffer.contains("uri")) {
    if (!buffer["uri"].is_string()) name.fail(place, "its uri is not a string; re-export the file");
    const std::string uri = buffer["uri"].get<std::string>();
    bytes = uri.rfind("data:", 0) == 0 ? decodeDataUri(name, uri, place) : readExternal(name, uri, folder, place);
  } else if (binary != nullptr && !binary->empty()) {
    bytes = std::move(*binary);
  } else {
    return bytes;  // a fallback for readers without decompression
  }
  cutToLength(name, buffer, bytes, place);
  return bytes;
}

}  // namespace

std::vector<Bytes> readBuffers(const FileName& name, const Json& json, const std::filesystem::path& folder,
                               Bytes binary) {
  std::vector<Bytes> buffers;
  if (!json.contains("buffers")) return buffers;
  const Json& stated = json["buffers"];
  if (!stated.is_array()) name.fail("", "'buffers' is not an array; re-export the file");
  for (size_t i = 0; i < stated.size(); ++i) {
    const std::string place = "buffer " + std::to_string(i);
    if (!stated[i].is_object()) name.fail(place, "it is not an object; re-export the file");
    buffers.push_back(readBuffer(name, stated[i], folder, i == 0 ? &binary : nullptr, place));
  }
  return buffers;
}

std::span<const uint8_t> bufferRange(const GltfFile& file, int64_t buffer, uint64_t offset, uint64_t length,
                                     const std::string& place) {
  if (buffer < 0 || buffer >= static_cast<int64_t>(file.buffers.size())) {
    file.name.fail(place, "there is no buffer " + std::to_string(buffer) + "; re-export the file");
  }
  const Bytes& bytes = file.buffers[static_cast<size_t>(buffer)];
  if (offset > bytes.size() || length > bytes.size() - offset) {
    file.name.fail(place, "it reaches beyond the " + std::to_string(bytes.size()) + " bytes of buffer " +
                              std::to_string(buffer) + "; re-export the file");
  }
  return std::span<const uint8_t>(bytes).subspan(offset, length);
}

}  // namespace lithe::bake
