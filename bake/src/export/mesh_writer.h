// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The meshes of an exported file and the nodes that show them.
#pragma once

#include <string>

#include "gltf_builder.h"
#include "lithe/bake/model.h"

namespace lithe::bake {

struct MeshNaming {
  std::string suffix;  ///< appended to the names of meshes and of the nodes made for them
  bool own_rigid_nodes =
      false;  ///< rigid meshes get a child node of their own, so that several models fit on one skeleton
};

/// Writes the model's parts that have triangles. @param skin  kNone where no part is skinned
/// @param material_of  per Model::materials entry: the index of its material in the file
void writeMeshes(const Model& model, uint32_t skin, const std::vector<uint32_t>& material_of, const MeshNaming& naming,
                 GltfBuilder& gltf);

/// Whether a skinned part has a triangle.
bool hasSkinnedTriangle(const Model& model);

}  // namespace lithe::bake
