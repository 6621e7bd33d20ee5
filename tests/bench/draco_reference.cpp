// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "draco_reference.h"

#include <draco/compression/decode.h>
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

#include "bench_character.h"
#include "lithe/format/octahedral.h"

namespace lithe::bench {
namespace {

using Type = draco::GeometryAttribute::Type;

constexpr int kPositionBits = 14;
constexpr int kNormalBits = 10;
constexpr int kUvBits = 12;

/// One attribute of the reference and where it lies in a vertex of LevelBuffers.
struct ReferenceAttribute {
  std::string name;
  Type type;
  int8_t components;
  draco::DataType data_type;
  uint32_t offset;
  uint32_t bytes;
};

/// The finest level in the layout that Draco is given.
struct FinestLevel {
  lithe_asset_info info{};
  float grid_origin[3] = {};
  float grid_step = 0;
  std::vector<ReferenceAttribute> attributes;
  std::unique_ptr<LevelBuffers> buffers;

  const uint8_t* vertex(uint32_t index) const {
    return buffers->vertices.data() + size_t{buffers->indices[index]} * buffers->layout.stride;
  }
};

/// Places attributes one after the other.
class LayoutBuilder {
 public:
  lithe_vertex_layout layout{};
  std::vector<ReferenceAttribute> attributes;

  lithe_attribute add(const std::string& name, Type type, uint32_t components, draco::DataType data_type,
                      lithe_format format) {
    const uint32_t bytes = components * static_cast<uint32_t>(draco::DataTypeLength(data_type));
    const uint32_t offset = layout.stride;
    attributes.push_back({name, type, static_cast<int8_t>(components), data_type, offset, bytes});
    layout.stride = (offset + bytes + 3) / 4 * 4;
    return {static_cast<uint16_t>(format), static_cast<uint16_t>(offset)};
  }
};

void addSkin(const lithe_asset_info& info, LayoutBuilder& builder) {
  lithe_vertex_layout& layout = builder.layout;
  const bool few_joints = info.joint_count <= 256;
  layout.joints =
      builder.add("joints", Type::GENERIC, layout.influences, few_joints ? draco::DT_UINT8 : draco::DT_UINT16,
                  few_joints ? LITHE_FORMAT_U8 : LITHE_FORMAT_U16);
  layout.weights = builder.add("weights", Type::GENERIC, layout.influences, draco::DT_UINT8, LITHE_FORMAT_UNORM8);
}

LayoutBuilder referenceLayout(const lithe_asset_info& info, bool with_skin) {
  LayoutBuilder builder;
  lithe_vertex_layout& layout = builder.layout;
  layout.struct_size = sizeof layout;
  layout.influences = info.max_influences <= 4 ? 4 : 8;
  layout.position = builder.add("position", Type::POSITION, 3, draco::DT_FLOAT32, LITHE_FORMAT_F32);
  if (info.has_normals) layout.normal = builder.add("normal", Type::NORMAL, 3, draco::DT_FLOAT32, LITHE_FORMAT_F32);
  if (info.has_tangents)
    layout.tangent = builder.add("tangent", Type::GENERIC, 3, draco::DT_INT16, LITHE_FORMAT_SNORM16);
  for (uint32_t s = 0; s < info.uv_sets; ++s)
    layout.uv[s] = builder.add("uv" + std::to_string(s), Type::TEX_COORD, 2, draco::DT_FLOAT32, LITHE_FORMAT_F32);
  for (uint32_t s = 0; s < info.color_sets; ++s)
    layout.color[s] = builder.add("color" + std::to_string(s), Type::COLOR, 4, draco::DT_UINT8, LITHE_FORMAT_UNORM8);
  if (with_skin) addSkin(info, builder);
  return builder;
}

/// Turns the runtime's snorm16 tangents back into grid coordinates and handedness, in place.
void unpackTangents(LevelBuffers& buffers) {
  const double center = format::octahedralCenter(kNormalBits);
  for (size_t at = buffers.layout.tangent.offset; at < buffers.vertices.size(); at += buffers.layout.stride) {
    int16_t snorm[3];
    std::memcpy(snorm, buffers.vertices.data() + at, sizeof snorm);
    const int16_t grid[3] = {static_cast<int16_t>(std::lround(center + snorm[0] * center / 32767)),
                             static_cast<int16_t>(std::lround(std::abs(snorm[1]) * 2 * center / 32767)),
                             static_cast<int16_t>(snorm[1] > 0)};
    std::memcpy(buffers.vertices.data() + at, grid, sizeof grid);
  }
}

FinestLevel readFinest(const lithe_asset& asset, bool with_skin) {
  FinestLevel finest;
  lithe_asset_describe(&asset, &finest.info);
  lithe_hierarchy hierarchy;
  lithe_asset_hierarchy(&asset, &hierarchy);
  std::copy_n(hierarchy.grid_origin, 3, finest.grid_origin);
  finest.grid_step = hierarchy.grid_step;
  LayoutBuilder builder = referenceLayout(finest.info, with_skin);
  finest.attributes = std::move(builder.attributes);
  finest.buffers = std::make_unique<LevelBuffers>(asset, builder.layout);
  finest.buffers->write(asset);
  if (finest.info.has_tangents) unpackTangents(*finest.buffers);
  return finest;
}

// ---- Encoding
// --------------------------------------------------------------------------------------------------------

/// The builder stores equal values and equal points once when it finishes.
std::unique_ptr<draco::Mesh> meshOfPart(const FinestLevel& finest, const lithe_range& range) {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(static_cast<int>(range.index_count / 3));
  for (const ReferenceAttribute& attribute : finest.attributes)
    builder.AddAttribute(attribute.type, attribute.components, attribute.data_type);
  for (uint32_t i = 0; i < range.index_count; i += 3) {
    const uint8_t* corner[3];
    for (uint32_t k = 0; k < 3; ++k) corner[k] = finest.vertex(range.first_index + i + k);
    for (size_t a = 0; a < finest.attributes.size(); ++a) {
      const uint32_t at = finest.attributes[a].offset;
      builder.SetAttributeValuesForFace(static_cast<int>(a), draco::FaceIndex(i / 3), corner[0] + at, corner[1] + at,
                                        corner[2] + at);
    }
  }
  std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
  if (!mesh) throw bake::Error("Draco cannot build a part's mesh");
  return mesh;
}

std::vector<uint8_t> encodeMesh(const FinestLevel& finest, const draco::Mesh& mesh) {
  draco::Encoder encoder;
  encoder.SetEncodingMethod(draco::MESH_EDGEBREAKER_ENCODING);
  encoder.SetSpeedOptions(0, 0);
  // The file's own grid for all parts: a box around each part would be a finer grid, and a larger reference.
  const float range = finest.grid_step * ((1 << kPositionBits) - 1);
  encoder.SetAttributeExplicitQuantization(Type::POSITION, kPositionBits, 3, finest.grid_origin, range);
  encoder.SetAttributeQuantization(Type::NORMAL, kNormalBits);
  encoder.SetAttributeQuantization(Type::TEX_COORD, kUvBits);
  draco::EncoderBuffer buffer;
  const draco::Status status = encoder.EncodeMeshToBuffer(mesh, &buffer);
  if (!status.ok()) throw bake::Error("Draco cannot encode a part: " + status.error_msg_string());
  const auto* bytes = reinterpret_cast<const uint8_t*>(buffer.data());
  return {bytes, bytes + buffer.size()};
}

std::unique_ptr<draco::Mesh> decodeMesh(const std::vector<uint8_t>& bytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) throw bake::Error("Draco cannot decode a part: " + decoded.status().error_msg_string());
  return std::move(decoded).value();
}

// ---- Is what comes back what went in?
// --------------------------------------------------------------------------------

/// A triangle's corners as numbers: its position on the grid alone, and with joints and weights.
struct CornerNumbers {
  uint64_t place = 0, all = 0;
};

uint64_t mix(uint64_t state, uint64_t value) {
  state = (state ^ value) * 0x9e3779b97f4a7c15u;
  return state ^ state >> 29;
}

/// Set of triangles as a number: neither the order of the triangles nor where their corners begin matters.
class TriangleSum {
 public:
  void add(const CornerNumbers (&corner)[3]) {
    if (corner[0].place == corner[1].place || corner[1].place == corner[2].place ||
        corner[2].place == corner[0].place) {
      ++flat_;
      return;
    }
    int first = 0;
    for (int k = 1; k < 3; ++k)
      if (corner[k].all < corner[first].all) first = k;
    uint64_t triangle = 1;
    for (int k = 0; k < 3; ++k) triangle = mix(triangle, corner[(first + k) % 3].all);
    sum_ += triangle;
    ++count_;
  }
  bool sameTriangles(const TriangleSum& other) const { return sum_ == other.sum_ && count_ == other.count_; }
  uint32_t count() const { return count_; }
  uint32_t flat() const { return flat_; }

 private:
  uint64_t sum_ = 0;
  uint32_t count_ = 0, flat_ = 0;
};

bool isOfSkin(const ReferenceAttribute& attribute) { return attribute.name == "joints" || attribute.name == "weights"; }

/// `read(attribute index, out)` copies one attribute's bytes.
template <typename Read>
CornerNumbers cornerNumbers(const FinestLevel& finest, const Read& read) {
  CornerNumbers numbers;
  float position[3];
  read(0, position);
  for (int c = 0; c < 3; ++c)
    numbers.place = mix(numbers.place,
                        static_cast<uint64_t>(std::llround((position[c] - finest.grid_origin[c]) / finest.grid_step)));
  numbers.all = numbers.place;
  for (size_t a = 0; a < finest.attributes.size(); ++a) {
    if (!isOfSkin(finest.attributes[a])) continue;
    uint8_t bytes[2 * LITHE_MAX_INFLUENCES];
    read(a, bytes);
    for (uint32_t i = 0; i < finest.attributes[a].bytes; ++i) numbers.all = mix(numbers.all, bytes[i]);
  }
  return numbers;
}

TriangleSum sumOfPart(const FinestLevel& finest, const lithe_range& range) {
  TriangleSum sum;
  for (uint32_t i = 0; i < range.index_count; i += 3) {
    CornerNumbers corner[3];
    for (uint32_t k = 0; k < 3; ++k) {
      const uint8_t* vertex = finest.vertex(range.first_index + i + k);
      corner[k] = cornerNumbers(finest, [&](size_t a, void* out) {
        std::memcpy(out, vertex + finest.attributes[a].offset, finest.attributes[a].bytes);
      });
    }
    sum.add(corner);
  }
  return sum;
}

TriangleSum sumOfMesh(const FinestLevel& finest, const draco::Mesh& mesh) {
  TriangleSum sum;
  for (draco::FaceIndex f(0); f < mesh.num_faces(); ++f) {
    CornerNumbers corner[3];
    for (int k = 0; k < 3; ++k)
      corner[k] = cornerNumbers(finest, [&](size_t a, void* out) {
        mesh.GetAttributeByUniqueId(static_cast<uint32_t>(a))->GetMappedValue(mesh.face(f)[k], out);
      });
    sum.add(corner);
  }
  return sum;
}

void encodePart(const FinestLevel& finest, const lithe_range& range, DracoReference& reference) {
  reference.parts.push_back(encodeMesh(finest, *meshOfPart(finest, range)));
  const TriangleSum source = sumOfPart(finest, range);
  if (!source.sameTriangles(sumOfMesh(finest, *decodeMesh(reference.parts.back()))))
    throw bake::Error("the Draco reference decodes to other triangles than the .lithe file");
  reference.triangles += source.count();
  reference.left_out += source.flat();
}

}  // namespace

uint64_t DracoReference::byteCount() const {
  uint64_t count = 0;
  for (const std::vector<uint8_t>& part : parts) count += part.size();
  return count;
}

DracoReference encodeReference(const lithe_asset& asset, bool with_skin) {
  const FinestLevel finest = readFinest(asset, with_skin);
  DracoReference reference;
  for (const ReferenceAttribute& attribute : finest.attributes) reference.names.push_back(attribute.name);
  for (const lithe_range& range : finest.buffers->ranges)
    if (range.index_count > 0) encodePart(finest, range, reference);
  return reference;
}

uint64_t decodeReference(const DracoReference& reference) {
  uint64_t points = 0;
  for (const std::vector<uint8_t>& part : reference.parts) points += decodeMesh(part)->num_points();
  return points;
}

}  // namespace lithe::bench
