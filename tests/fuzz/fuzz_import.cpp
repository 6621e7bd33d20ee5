// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Any bytes as a glTF file. Input: the .glb or .gltf file. A damaged one is an Error with one sentence, and what is
/// taken is a model whose indices all lead somewhere.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "drive_asset.h"
#include "lithe/bake/import.h"

namespace {

using namespace lithe;

/// One file per process, gone when it ends.
struct Scratch {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("fuzz_import_" + std::to_string(getpid()) + ".glb");

  ~Scratch() {
    std::error_code failure;
    std::filesystem::remove(path, failure);
  }
};

void demandSound(const bake::Model& model) {
  for (size_t n = 0; n < model.nodes.size(); ++n)
    LITHE_DEMAND(model.nodes[n].parent == bake::kNone || model.nodes[n].parent < n);
  for (const auto& joint : model.joints) LITHE_DEMAND(joint.node < model.nodes.size());
  for (const auto& part : model.parts)
    LITHE_DEMAND(part.material == bake::kNone || part.material < model.materials.size());
  for (const auto& triangle : model.triangles)
    for (const uint32_t vertex : triangle) LITHE_DEMAND(vertex < model.positions.size());
  for (const uint32_t part : model.triangle_part) LITHE_DEMAND(part < model.parts.size());
  LITHE_DEMAND(model.triangle_part.size() == model.triangles.size());
  LITHE_DEMAND(model.normals.size() == model.positions.size());
  LITHE_DEMAND(model.skins.size() == model.positions.size());
  for (const bake::Skin& skin : model.skins)
    for (uint32_t i = 0; i < skin.count; ++i) LITHE_DEMAND(skin.joint[i] < model.joints.size() && skin.weight[i] > 0);
  for (const bake::Clip& clip : model.clips)
    for (const bake::Channel& channel : clip.channels) LITHE_DEMAND(channel.node < model.nodes.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  static const Scratch scratch;
  std::ofstream(scratch.path, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    demandSound(bake::importGltf(scratch.path));
  } catch (const bake::Error& error) {
    LITHE_DEMAND(std::string(error.what()).find('\n') == std::string::npos);
  }
  return 0;
}
