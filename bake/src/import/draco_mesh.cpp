// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "draco_mesh.h"

#include <draco/compression/decode.h>

#include <cstring>

namespace lithe::bake {

namespace {

constexpr const char* kExtension = "KHR_draco_mesh_compression";

[[noreturn]] void failDamaged(const GltfFile& file, const std::string& place, const std::string& reason) {
  file.name.fail(place, "its Draco data cannot be decoded (" + reason + "); re-export the file");
}

std::unique_ptr<draco::Mesh> decodeMesh(const GltfFile& file, std::span<const uint8_t> bytes,
                                        const std::string& place) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::Decoder decoder;
  try {
    auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok()) failDamaged(file, place, decoded.status().error_msg_string());
    return std::move(decoded).value();
  } catch (const std::bad_alloc&) {
    failDamaged(file, place, "it claims more vertices than memory holds");
  } catch (const std::length_error&) {
    failDamaged(file, place, "it claims more vertices than memory holds");
  }
}

/// 0 for the types that glTF lacks.
int componentType(draco::DataType type) {
  switch (type) {
    case draco::DT_INT8:
      return TINYGLTF_COMPONENT_TYPE_BYTE;
    case draco::DT_UINT8:
      return TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE;
    case draco::DT_INT16:
      return TINYGLTF_COMPONENT_TYPE_SHORT;
    case draco::DT_UINT16:
      return TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
    case draco::DT_INT32:
      return TINYGLTF_COMPONENT_TYPE_INT;
    case draco::DT_UINT32:
      return TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    case draco::DT_FLOAT32:
      return TINYGLTF_COMPONENT_TYPE_FLOAT;
    default:
      return 0;
  }
}

DracoMesh::Attribute readAttribute(const GltfFile& file, const draco::Mesh& mesh, uint32_t id,
                                   const std::string& place) {
  const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(id);
  if (attribute == nullptr) failDamaged(file, place, "there is no attribute " + std::to_string(id));
  DracoMesh::Attribute read;
  read.components = attribute->num_components();
  read.component_type = componentType(attribute->data_type());
  if (read.component_type == 0 || read.components == 0 || read.components > 4) {
    failDamaged(file, place, "attribute " + std::to_string(id) + " is of a type that glTF lacks");
  }
  const size_t element = read.components * static_cast<size_t>(draco::DataTypeLength(attribute->data_type()));
  read.bytes.resize(element * mesh.num_points());
  for (draco::PointIndex point(0); point < mesh.num_points(); ++point) {
    const draco::AttributeValueIndex value = attribute->mapped_index(point);
    if (value.value() >= attribute->size()) failDamaged(file, place, "a vertex lacks a value");
    std::memcpy(read.bytes.data() + element * point.value(), attribute->GetAddress(value), element);
  }
  return read;
}

Bytes readFaces(const draco::Mesh& mesh) {
  Bytes indices(size_t{mesh.num_faces()} * 3 * sizeof(uint32_t));
  uint8_t* out = indices.data();
  for (draco::FaceIndex face(0); face < mesh.num_faces(); ++face) {
    for (int corner = 0; corner < 3; ++corner, out += sizeof(uint32_t)) {
      const uint32_t index = mesh.face(face)[static_cast<size_t>(corner)].value();
      std::memcpy(out, &index, sizeof(index));
    }
  }
  return indices;
}

}  // namespace

bool usesDraco(const tinygltf::Primitive& primitive) { return primitive.extensions.count(kExtension) != 0; }

DracoMesh decodeDraco(const GltfFile& file, const tinygltf::Primitive& primitive, const std::string& place) {
  const tinygltf::Value& extension = primitive.extensions.at(kExtension);
  if (!extension.Has("bufferView") || !extension.Get("bufferView").IsNumber() || !extension.Has("attributes") ||
      !extension.Get("attributes").IsObject()) {
    failDamaged(file, place, "the extension lacks its buffer view or attributes");
  }
  const int view = extension.Get("bufferView").GetNumberAsInt();
  const std::unique_ptr<draco::Mesh> mesh = decodeMesh(file, file.viewBytes(view, place), place);
  DracoMesh decoded;
  const tinygltf::Value& attributes = extension.Get("attributes");
  for (const std::string& name : attributes.Keys()) {
    const tinygltf::Value& id = attributes.Get(name);
    if (!id.IsNumber()) failDamaged(file, place, "attribute " + name + " has no number");
    decoded.attributes[name] = readAttribute(file, *mesh, static_cast<uint32_t>(id.GetNumberAsInt()), place);
  }
  decoded.indices = readFaces(*mesh);
  decoded.vertex_count = mesh->num_points();
  decoded.triangle_count = mesh->num_faces();
  return decoded;
}

}  // namespace lithe::bake
