// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "primitive.h"

#include <algorithm>

namespace lithe::bake {

namespace {

bool isStitch(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

std::vector<Triangle> listTriangles(const std::vector<uint32_t>& corners) {
  std::vector<Triangle> triangles;
  triangles.reserve(corners.size() / 3);
  for (size_t i = 0; i + 2 < corners.size(); i += 3) triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
  return triangles;
}

/// Every other triangle of a strip runs the other way round (glTF 2.0, section 3.7.2.1).
std::vector<Triangle> stripTriangles(const std::vector<uint32_t>& corners) {
  std::vector<Triangle> triangles;
  for (size_t i = 0; i + 2 < corners.size(); ++i) {
    const size_t odd = i & 1;
    const Triangle triangle{corners[i + odd], corners[i + 1 - odd], corners[i + 2]};
    if (!isStitch(triangle)) triangles.push_back(triangle);
  }
  return triangles;
}

std::vector<Triangle> fanTriangles(const std::vector<uint32_t>& corners) {
  std::vector<Triangle> triangles;
  for (size_t i = 1; i + 1 < corners.size(); ++i) triangles.push_back({corners[0], corners[i], corners[i + 1]});
  return triangles;
}

}  // namespace

std::string primitivePlace(const GltfFile& file, const PrimitiveUse& use) {
  const std::string& name = file.document.meshes[use.mesh].name;
  return "mesh " + std::to_string(use.mesh) + (name.empty() ? "" : " '" + name + "'") + ", primitive " +
         std::to_string(use.primitive);
}

const tinygltf::Primitive& primitiveOf(const GltfFile& file, const PrimitiveUse& use) {
  return file.document.meshes[use.mesh].primitives[use.primitive];
}

PrimitiveArrays::PrimitiveArrays(const GltfFile& file, const PrimitiveUse& use)
    : file_(file), primitive_(primitiveOf(file, use)), place_(primitivePlace(file, use)) {
  if (usesDraco(primitive_)) {
    draco_ = decodeDraco(file_, primitive_, place_);
    vertex_count_ = draco_.vertex_count;
  } else {
    vertex_count_ =
        AccessorView::open(file_, primitive_.attributes.at("POSITION"), {TINYGLTF_TYPE_VEC3}, place_ + ", POSITION")
            .count();
  }
}

std::optional<AccessorView> PrimitiveArrays::attribute(const std::string& name,
                                                       std::initializer_list<int> types) const {
  const auto stated = primitive_.attributes.find(name);
  if (stated == primitive_.attributes.end()) return std::nullopt;
  const std::string place = place_ + ", " + name;
  const auto decoded = draco_.attributes.find(name);
  const AccessorView view = decoded == draco_.attributes.end() ? AccessorView::open(file_, stated->second, types, place)
                                                               : decodedAttribute(decoded->second, stated->second);
  const bool fits = std::any_of(types.begin(), types.end(), [&](int type) {
    return tinygltf::GetNumComponentsInType(static_cast<uint32_t>(type)) == static_cast<int>(view.components());
  });
  if (!fits) file_.name.fail(place, "it has " + std::to_string(view.components()) + " components; re-export the file");
  if (view.count() != vertex_count_) {
    file_.name.fail(place, "it has " + std::to_string(view.count()) + " elements for " + std::to_string(vertex_count_) +
                               " vertices; re-export the file");
  }
  return view;
}

/// Only the accessor knows whether integers are normalised: Draco's own flag is not kept by every exporter.
AccessorView PrimitiveArrays::decodedAttribute(const DracoMesh::Attribute& data, int accessor) const {
  const auto& accessors = file_.document.accessors;
  const bool stated = accessor >= 0 && static_cast<size_t>(accessor) < accessors.size();
  const bool normalized = stated && accessors[static_cast<size_t>(accessor)].normalized;
  return AccessorView::ofBytes(data.bytes, vertex_count_, data.components, data.component_type, normalized);
}

/// Empty if every vertex is a corner in turn.
std::optional<AccessorView> PrimitiveArrays::indices() const {
  if (usesDraco(primitive_)) {
    return AccessorView::ofBytes(draco_.indices, draco_.triangle_count * 3, 1, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                                 false);
  }
  if (primitive_.indices < 0) return std::nullopt;
  const AccessorView view = AccessorView::open(file_, primitive_.indices, {TINYGLTF_TYPE_SCALAR}, place_ + ", indices");
  if (!view.isInteger()) file_.name.fail(place_, "its indices are not integers; re-export the file");
  return view;
}

std::vector<uint32_t> PrimitiveArrays::corners() const {
  const std::optional<AccessorView> stated = indices();
  const uint64_t count = stated ? stated->count() : vertex_count_;
  std::vector<uint32_t> corners;
  corners.reserve(count);
  for (uint64_t i = 0; i < count; ++i) {
    const uint32_t corner = stated ? stated->integer(i, 0) : static_cast<uint32_t>(i);
    if (corner >= vertex_count_) {
      file_.name.fail(place_, "index " + std::to_string(i) + " is " + std::to_string(corner) + ", there are " +
                                  std::to_string(vertex_count_) + " vertices; re-export the file");
    }
    corners.push_back(corner);
  }
  return corners;
}

std::vector<Triangle> PrimitiveArrays::triangles() const {
  const std::vector<uint32_t> all = corners();
  if (usesDraco(primitive_)) return listTriangles(all);  // whatever the mode was, Draco stores faces
  if (primitive_.mode == TINYGLTF_MODE_TRIANGLE_STRIP) return stripTriangles(all);
  if (primitive_.mode == TINYGLTF_MODE_TRIANGLE_FAN) return fanTriangles(all);
  return listTriangles(all);
}

}  // namespace lithe::bake
