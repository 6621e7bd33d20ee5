// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The node tree and the skin of an exported file.
#pragma once

#include "gltf_builder.h"
#include "lithe/bake/model.h"

namespace lithe::bake {

/// Writes the nodes (node i of the file is nodes[i]) and the scene that shows them.
void writeNodes(const Model& model, GltfBuilder& gltf);

/// Writes a skin with all joints of the palette, in order. Returns its index.
uint32_t writeSkin(const Model& model, GltfBuilder& gltf);

/// A node that carries a mesh; `entry` is a glTF node without children.
void appendSceneNode(Json entry, GltfBuilder& gltf);
uint32_t appendChildNode(Json entry, uint32_t parent, GltfBuilder& gltf);

}  // namespace lithe::bake
