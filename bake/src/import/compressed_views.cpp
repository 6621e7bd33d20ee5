// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "compressed_views.h"

#include <meshoptimizer.h>

#include "buffers.h"

namespace lithe::bake {

namespace {

constexpr uint8_t kVertexHeader = 0xa0;
/// Nothing that decodes is smaller than this part of the result: two header bits for sixteen bytes.
constexpr uint64_t kMaxVertexRatio = 64;
/// A triangle takes at least a byte, and is three indices.
constexpr uint64_t kMaxIndexRatio = 3;
constexpr uint64_t kRatioSlack = 4096;

struct CompressedView {
  std::string place;
  std::span<const uint8_t> bytes;
  uint64_t count = 0, stride = 0;
  std::string mode, filter;
};

const tinygltf::Value* compressionOf(const tinygltf::BufferView& view) {
  for (const char* extension : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    const auto found = view.extensions.find(extension);
    if (found != view.extensions.end()) return &found->second;
  }
  return nullptr;
}

uint64_t numberAt(const GltfFile& file, const tinygltf::Value& object, const char* key, const std::string& place) {
  if (!object.Has(key)) return 0;
  const tinygltf::Value& value = object.Get(key);
  const double number = value.IsNumber() ? value.GetNumberAsDouble() : -1.0;
  if (!(number >= 0.0) || number > 1e15) {
    file.name.fail(place, std::string("'") + key + "' of its compression is not a count; re-export the file");
  }
  return static_cast<uint64_t>(number);
}

std::string textAt(const tinygltf::Value& object, const char* key, const char* otherwise) {
  if (!object.Has(key) || !object.Get(key).IsString()) return otherwise;
  return object.Get(key).Get<std::string>();
}

CompressedView describe(const GltfFile& file, const tinygltf::Value& extension, size_t view) {
  CompressedView described;
  described.place = "buffer view " + std::to_string(view);
  described.bytes = bufferRange(file, static_cast<int64_t>(numberAt(file, extension, "buffer", described.place)),
                                numberAt(file, extension, "byteOffset", described.place),
                                numberAt(file, extension, "byteLength", described.place), described.place);
  described.count = numberAt(file, extension, "count", described.place);
  described.stride = numberAt(file, extension, "byteStride", described.place);
  described.mode = textAt(extension, "mode", "");
  described.filter = textAt(extension, "filter", "NONE");
  return described;
}

/// The decoders assert what they expect of sizes, and a few bytes must not make us allocate gigabytes.
void checkSizes(const GltfFile& file, const CompressedView& view) {
  const bool attributes = view.mode == "ATTRIBUTES";
  const bool stride_fits = attributes ? view.stride % 4 == 0 && view.stride >= 4 && view.stride <= 256
                                      : view.stride == 2 || view.stride == 4;
  if (!stride_fits || (view.mode == "TRIANGLES" && view.count % 3 != 0)) {
    file.name.fail(view.place, "the sizes of its compression are invalid; re-export the file");
  }
  const uint64_t units = attributes ? view.count * view.stride : view.count;
  const uint64_t ratio = attributes ? kMaxVertexRatio : kMaxIndexRatio;
  if (view.count > UINT32_MAX || units > ratio * view.bytes.size() + kRatioSlack) {
    file.name.fail(view.place, "it claims more elements than its " + std::to_string(view.bytes.size()) +
                                   " bytes can hold; re-export the file");
  }
}

bool decode(const CompressedView& view, Bytes& out) {
  const uint8_t* data = view.bytes.data();
  const size_t size = view.bytes.size();
  if (view.mode == "ATTRIBUTES")
    return meshopt_decodeVertexBuffer(out.data(), view.count, view.stride, data, size) == 0;
  if (view.mode == "TRIANGLES") return meshopt_decodeIndexBuffer(out.data(), view.count, view.stride, data, size) == 0;
  return meshopt_decodeIndexSequence(out.data(), view.count, view.stride, data, size) == 0;
}

void applyFilter(const GltfFile& file, const CompressedView& view, Bytes& out) {
  if (view.filter == "NONE") return;
  const bool attributes = view.mode == "ATTRIBUTES";
  if (view.filter == "OCTAHEDRAL" && attributes && (view.stride == 4 || view.stride == 8)) {
    meshopt_decodeFilterOct(out.data(), view.count, view.stride);
  } else if (view.filter == "QUATERNION" && attributes && view.stride == 8) {
    meshopt_decodeFilterQuat(out.data(), view.count, view.stride);
  } else if (view.filter == "EXPONENTIAL" && attributes) {
    meshopt_decodeFilterExp(out.data(), view.count, view.stride);
  } else {
    file.name.fail(view.place, "its compression filter '" + view.filter +
                                   "' is not known here; export with EXT_meshopt_compression or uncompressed");
  }
}

Bytes decodeView(const GltfFile& file, const CompressedView& view) {
  if (view.mode != "ATTRIBUTES" && view.mode != "TRIANGLES" && view.mode != "INDICES") {
    file.name.fail(view.place, "its compression mode '" + view.mode + "' is not known; export uncompressed");
  }
  checkSizes(file, view);
  if (view.mode == "ATTRIBUTES" && !view.bytes.empty() && (view.bytes[0] & 0xf0) == kVertexHeader &&
      view.bytes[0] != kVertexHeader) {
    file.name.fail(view.place, "it is compressed with version " + std::to_string(view.bytes[0] & 0x0f) +
                                   " of meshopt's vertex codec, only version 0 is read; export with "
                                   "EXT_meshopt_compression or uncompressed");
  }
  Bytes out(view.count * view.stride);
  if (!decode(view, out)) file.name.fail(view.place, "its compressed data is damaged; re-export the file");
  applyFilter(file, view, out);
  return out;
}

}  // namespace

std::vector<Bytes> decodeCompressedViews(const GltfFile& file) {
  std::vector<Bytes> decoded(file.document.bufferViews.size());
  for (size_t i = 0; i < decoded.size(); ++i) {
    const tinygltf::Value* extension = compressionOf(file.document.bufferViews[i]);
    if (extension != nullptr) decoded[i] = decodeView(file, describe(file, *extension, i));
  }
  return decoded;
}

}  // namespace lithe::bake
