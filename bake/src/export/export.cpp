// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/export.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "appearance.h"
#include "clip_writer.h"
#include "gltf_builder.h"
#include "lithe/bake/import.h"
#include "lithe/bake/output_files.h"
#include "mesh_writer.h"
#include "skeleton_writer.h"
#include "uri.h"

namespace lithe::bake {

namespace {

constexpr uint32_t kGlbMagic = 0x46546c67, kGlbVersion = 2, kJsonChunk = 0x4e4f534a, kBinaryChunk = 0x004e4942;

void requireTriangles(std::span<const Model> models, const std::filesystem::path& path) {
  for (const Model& model : models) {
    if (!model.triangles.empty()) return;
  }
  throw Error(path.string() + ": not written, the model has no triangle: export a level that has some");
}

void requireSameSkeleton(std::span<const Model> models, const std::filesystem::path& path) {
  for (size_t i = 0; i < models.size(); ++i) {
    const bool same =
        models[i].nodes.size() == models[0].nodes.size() && models[i].joints.size() == models[0].joints.size();
    if (same) continue;
    throw Error(path.string() + ": not written, level " + std::to_string(i) +
                " has another skeleton than level 0: export levels of one character together");
  }
}

/// The document of models that share the first one's skeleton. @param as_levels  name and place the meshes as levels
GltfBuilder documentOf(std::span<const Model> models, const ExportOptions& options, bool as_levels) {
  const Model& first = models.front();
  GltfBuilder gltf;
  writeNodes(first, gltf);
  const std::vector<uint32_t> material_of =
      options.from.empty() ? writeNamedMaterials(first, gltf) : copyAppearance(first, options.from, gltf);
  const bool skinned = std::any_of(models.begin(), models.end(), hasSkinnedTriangle);
  const uint32_t skin = skinned ? writeSkin(first, gltf) : kNone;
  for (size_t level = 0; level < models.size(); ++level) {
    const MeshNaming naming{as_levels ? "_LOD" + std::to_string(level) : "", as_levels};
    writeMeshes(models[level], skin, material_of, naming, gltf);
  }
  writeClips(options.from.empty() ? first.clips : retargetedClips(importGltf(options.from), first), gltf);
  return gltf;
}

void appendU32(std::vector<uint8_t>& bytes, size_t value) {
  for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<uint8_t>(value >> (8 * i)));
}

void appendChunk(std::vector<uint8_t>& bytes, uint32_t type, std::span<const uint8_t> content, uint8_t padding) {
  const size_t length = (content.size() + 3) / 4 * 4;
  appendU32(bytes, length);
  appendU32(bytes, type);
  bytes.insert(bytes.end(), content.begin(), content.end());
  bytes.insert(bytes.end(), length - content.size(), padding);
}

std::vector<uint8_t> toBytes(const std::string& text) { return {text.begin(), text.end()}; }

/// Names may hold bytes that are no UTF-8; they are replaced rather than refused.
std::string textOf(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

std::vector<uint8_t> glbBytes(GltfBuilder& gltf, const std::filesystem::path& path) {
  gltf.closeBuffer("");
  std::vector<uint8_t> chunks;
  appendChunk(chunks, kJsonChunk, toBytes(textOf(gltf.json, -1)), ' ');
  appendChunk(chunks, kBinaryChunk, gltf.binary, 0);
  constexpr size_t kHeaderBytes = 12;
  if (chunks.size() + kHeaderBytes > std::numeric_limits<uint32_t>::max()) {
    throw Error(path.string() + ": not written, a .glb holds at most 4 GiB: export fewer levels or smaller textures");
  }
  std::vector<uint8_t> file;
  appendU32(file, kGlbMagic);
  appendU32(file, kGlbVersion);
  appendU32(file, chunks.size() + kHeaderBytes);
  file.insert(file.end(), chunks.begin(), chunks.end());
  return file;
}

void writeDocument(GltfBuilder gltf, const std::filesystem::path& path) {
  if (path.extension() != ".gltf") {
    const std::vector<uint8_t> bytes = glbBytes(gltf, path);
    const OutputFile glb{path, bytes};
    writeTogether({&glb, 1});
    return;
  }
  std::filesystem::path binary = path;
  binary.replace_extension(".bin");
  gltf.closeBuffer(percentEncoded(binary.filename().string()));
  const std::vector<uint8_t> text = toBytes(textOf(gltf.json, 1) + "\n");
  const std::array<OutputFile, 2> files{OutputFile{binary, gltf.binary}, OutputFile{path, text}};
  writeTogether(files);
}

}  // namespace

void writeGltf(const Model& model, const std::filesystem::path& path, const ExportOptions& options) {
  const std::span<const Model> models(&model, 1);
  requireTriangles(models, path);
  writeDocument(documentOf(models, options, false), path);
}

void writeGltfLevels(const std::vector<Model>& levels, const std::filesystem::path& path,
                     const ExportOptions& options) {
  requireTriangles(levels, path);
  requireSameSkeleton(levels, path);
  writeDocument(documentOf(levels, options, true), path);
}

}  // namespace lithe::bake
