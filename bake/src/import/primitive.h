// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// One glTF primitive: its attribute arrays and its triangles, however they are stored.
#pragma once

#include <array>
#include <map>
#include <optional>

#include "accessor.h"
#include "draco_mesh.h"

namespace lithe::bake {

using Triangle = std::array<uint32_t, 3>;

/// A primitive as one node shows it.
struct PrimitiveUse {
  uint32_t node = kNone, mesh = kNone, primitive = kNone;
  bool skinned = false;

  bool operator==(const PrimitiveUse&) const = default;
};

/// "mesh 2 'Body', primitive 0"
std::string primitivePlace(const GltfFile& file, const PrimitiveUse& use);
const tinygltf::Primitive& primitiveOf(const GltfFile& file, const PrimitiveUse& use);

/// The arrays of a primitive. All have `vertex_count` elements.
class PrimitiveArrays {
 public:
  PrimitiveArrays(const GltfFile& file, const PrimitiveUse& use);
  PrimitiveArrays(const PrimitiveArrays&) = delete;
  PrimitiveArrays& operator=(const PrimitiveArrays&) = delete;

  uint64_t vertexCount() const { return vertex_count_; }
  /// The attribute of that name, empty if the primitive lacks it. Throws Error if it is not of one of the types.
  std::optional<AccessorView> attribute(const std::string& name, std::initializer_list<int> types) const;
  /// Triangles as indices into the attributes, strips and fans resolved; strips lose the triangles without area that
  /// stitch them. Throws Error for an index out of range.
  std::vector<Triangle> triangles() const;

 private:
  AccessorView decodedAttribute(const DracoMesh::Attribute& data, int accessor) const;
  std::optional<AccessorView> indices() const;
  std::vector<uint32_t> corners() const;

  const GltfFile& file_;
  const tinygltf::Primitive& primitive_;
  std::string place_;
  DracoMesh draco_;
  uint64_t vertex_count_ = 0;
};

}  // namespace lithe::bake
