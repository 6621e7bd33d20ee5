// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The materials of an exported file: named ones, or those of the file the model came from with all that they refer to.
#pragma once

#include <filesystem>

#include "gltf_builder.h"
#include "lithe/bake/model.h"

namespace lithe::bake {

/// Writes one material per Model::materials entry, with nothing but its name. Returns their indices in the file.
std::vector<uint32_t> writeNamedMaterials(const Model& model, GltfBuilder& gltf);

/// Copies materials, textures, samplers and images of the glTF file `from`, and adds what the model has beyond its
/// materials. Returns, per Model::materials entry, the index of its material in the file. Throws Error if `from` cannot
/// be read.
std::vector<uint32_t> copyAppearance(const Model& model, const std::filesystem::path& from, GltfBuilder& gltf);

}  // namespace lithe::bake
