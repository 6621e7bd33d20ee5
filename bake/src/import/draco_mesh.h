// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// KHR_draco_mesh_compression: primitives whose attributes and triangles are one compressed mesh.
#pragma once

#include <map>

#include "accessor.h"

namespace lithe::bake {

/// The decoded attributes of one primitive, as arrays like those of accessors.
struct DracoMesh {
  struct Attribute {
    Bytes bytes;  ///< one element per vertex, tightly packed
    uint32_t components = 0;
    int component_type = 0;  ///< TINYGLTF_COMPONENT_TYPE_*
  };
  std::map<std::string, Attribute> attributes;  ///< by glTF name
  Bytes indices;                                ///< three 32-bit integers per triangle
  uint64_t vertex_count = 0, triangle_count = 0;
};

/// Whether the primitive is compressed.
bool usesDraco(const tinygltf::Primitive& primitive);

/// Decodes a primitive for which usesDraco() holds. Throws Error if its data is damaged.
DracoMesh decodeDraco(const GltfFile& file, const tinygltf::Primitive& primitive, const std::string& place);

}  // namespace lithe::bake
