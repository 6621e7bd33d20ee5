// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Writing a Model as plain skinned glTF 2.0, for every engine and viewer.
///
/// Written: the whole node tree with its names; one skin with every joint of the palette, in order (a node that the
/// palette has twice gets a child of the same name that does not move against it, for glTF allows a node once per
/// skin); the parts of one name as the primitives of one mesh; rigid parts as unskinned meshes of their node, in its
/// local space, turned round where that node mirrors, as glTF wants them; clips. Parts and vertices without triangles
/// are left out. Nodes keep their indices: node i of the file is nodes[i]. A path ending in `.gltf` gives JSON and a
/// `.bin` beside it, any other one binary file (.glb).
#pragma once

#include <filesystem>
#include <vector>

#include "lithe/bake/model.h"

namespace lithe::bake {

struct ExportOptions {
  /// The glTF the model was made from, or empty. Its clips replace the model's (channels follow the node of the same
  /// name, else of the same index); its materials, textures, samplers and images are taken over, images embedded where
  /// their files are there. A part's material is the one of the same name, where that does not decide the one of the
  /// same index. A texture that needs a uv set the model lacks is taken off its material.
  std::filesystem::path from;
};

/// Writes one model. The file appears, complete, under its name at the end; after a failure nothing new is there.
/// @throws Error if the file cannot be written, `from` cannot be read, or the model has no triangle or does not fit
/// into a
///         file of 4 GiB
void writeGltf(const Model& model, const std::filesystem::path& path, const ExportOptions& options);

/// Writes several models of one skeleton (levels of one character) into one file: mesh nodes side by side, named
/// `<mesh>_LOD<k>` with k the index into `levels`, all on one skin. Nodes, joints, materials and clips are those of
/// levels[0].
/// @throws Error as writeGltf, and if there is no level or one has other nodes or joints than the first
void writeGltfLevels(const std::vector<Model>& levels, const std::filesystem::path& path, const ExportOptions& options);

}  // namespace lithe::bake
