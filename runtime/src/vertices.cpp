// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Writes vertices in the host's layout. A block of vertices is put together in local memory, attribute by attribute,
/// and then copied out in order: the destination may be write-combined memory that must be written once and never read.
#include "arguments.h"
#include "vertex_formats.h"
#include "vertex_layout.h"

namespace lithe::runtime {
namespace {

constexpr uint32_t kBlockBytes = 8192;

/// The vertices [first, first + count) and where one of their attributes goes.
struct Block {
  const lithe_asset& asset;
  uint32_t first, count;
  uint32_t set;
  uint32_t stride, influences;
  uint8_t* out;  ///< of the first vertex

  const Decoded& decoded() const { return asset.decoded; }
  const Info& info() const { return asset.head.info; }
  int32_t center() const { return static_cast<int32_t>(asset.format.normal_center); }
  const uint16_t* record(uint32_t wedge, uint32_t at) const {
    return decoded().wedge_attributes + size_t{wedge} * strideOf(asset) + at;
  }
  SkinRecord skin(uint32_t wedge) const {
    return skinOf(decoded(), decoded().wedge_node[wedge], asset.format.max_influences);
  }
};

using Writer = void (*)(const Block&);

template <typename Write>
void forEachVertex(const Block& block, Write write) {
  uint8_t* out = block.out;
  for (uint32_t i = 0; i < block.count; ++i, out += block.stride) write(block.first + i, out);
}

template <typename T, size_t kCount>
void put(uint8_t* out, const T (&values)[kCount]) {
  memcpy(out, values, sizeof values);
}

// ---- Position ------------------------------------------------------------------------------------------------------

void writePositionF32(const Block& block) {
  const Info& info = block.info();
  forEachVertex(block, [&](uint32_t wedge, uint8_t* out) {
    const uint16_t* grid = block.decoded().node_position + 3 * size_t{block.decoded().wedge_node[wedge]};
    const float xyz[3] = {bindCoordinate(info, 0, static_cast<float>(grid[0])),
                          bindCoordinate(info, 1, static_cast<float>(grid[1])),
                          bindCoordinate(info, 2, static_cast<float>(grid[2]))};
    put(out, xyz);
  });
}

void writePositionSnorm16(const Block& block) {
  const int32_t middle = 1 << (block.info().position_bits - 1);
  // -32768 would be read as -32767: of 16 position bits the lowest coordinate moves by one step.
  auto centered = [&](int32_t grid) { return static_cast<int16_t>(grid - middle < -32767 ? -32767 : grid - middle); };
  forEachVertex(block, [&](uint32_t wedge, uint8_t* out) {
    const uint16_t* grid = block.decoded().node_position + 3 * size_t{block.decoded().wedge_node[wedge]};
    const int16_t xyzw[4] = {centered(grid[0]), centered(grid[1]), centered(grid[2]), 32767};
    put(out, xyzw);
  });
}

// ---- Normal and tangent --------------------------------------------------------------------------------------------

int8_t toSnorm8(float x) { return static_cast<int8_t>(roundToInt(127 * x)); }

void writeNormalF32(const Block& block) {
  forEachVertex(block, [&](uint32_t wedge, uint8_t* out) {
    const uint16_t* p = block.record(wedge, block.asset.format.layout.normal);
    float xyz[3];
    octahedralUnit(p[0], p[1], block.center(), xyz);
    put(out, xyz);
  });
}

void writeNormalSnorm16(const Block& block) {
  forEachVertex(block, [&](uint32_t wedge, uint8_t* out) {
    const uint16_t* p = block.record(wedge, block.asset.format.layout.normal);
    const int16_t xy[2] = {octahedralSnorm16(p[0], block.center()), octahedralSnorm16(p[1], block.center())};
    put(out, xy);
  });
}

void writeNormalSnorm8(const Block& block) {
  forEachVertex(block, [&](uint32_t wedge, uint8_t* out) {
    const uint16_t* p = block.record(wedge, block.asset.format.layout.normal);
    float xyz[3];
    octahedralUnit(p[0], p[1], block.center(), xyz);
    const int8_t xyzw[4] = {toSnorm8(xyz[0]), toSnorm8(xyz[1]), toSnorm8(xyz[2]), 0};
    put(out, xyzw);
  });
}

void writeTangentF32(const Block& block) {
  forEachVertex(block, [&](uint32_t wedge, uint8_t* out) {
    const uint16_t* p = block.record(wedge, block.asset.format.layout.tangent);
    float xyzw[4];
    octahedralUnit(p[0], p[1], block.center(), xyzw);
    xyzw[3] = p[2] ? 1.0f : -1.0f;
    put(out, xyzw);
  });
}

void writeTangentSnorm16(const Block& block) {
  forEachVertex(block, [&](uint32_t wedge, uint8_t* out) {
    const uint16_t* p = block.record(wedge, block.asset.format.layout.tangent);
    const int16_t xy[2] = {octahedralSnorm16(p[0], block.center()), handedSnorm16(p[1], block.center(), p[2] != 0)};
    put(out, xy);
  });
}

void writeTangentSnorm8(const Block& block) {
  forEachVertex(block, [&](uint32_t wedge, uint8_t* out) {
    const uint16_t* p = block.record(wedge, block.asset.format.layout.tangent);
    float xyz[3];
    octahedralUnit(p[0], p[1], block.center(), xyz);
    const int8_t sign = p[2] ? 127 : -127;
    const int8_t xyzw[4] = {toSnorm8(xyz[0]), toSnorm8(xyz[1]), toSnorm8(xyz[2]), sign};
    put(out, xyzw);
  });
}

// ---- Uv and colour -------------------------------------------------------------------------------------------------

/// Calls write(wedge, out, u, v).
template <typename Write>
void forEachUv(const Block& block, Write write) {
  const uint32_t at = block.asset.format.layout.uv[block.set], sets = block.info().uv_sets;
  forEachVertex(block, [&](uint32_t wedge, uint8_t* out) {
    const UvGrid& grid = block.asset.uv_grids[block.decoded().wedge_part[wedge] * sets + block.set];
    const uint16_t* p = block.record(wedge, at);
    write(out, grid.offset[0] + grid.scale * p[0], grid.offset[1] + grid.scale * p[1]);
  });
}

void writeUvF32(const Block& block) {
  forEachUv(block, [](uint8_t* out, float u, float v) {
    const float uv[2] = {u, v};
    put(out, uv);
  });
}

void writeUvF16(const Block& block) {
  forEachUv(block, [](uint8_t* out, float u, float v) {
    const uint16_t uv[2] = {toHalf(u), toHalf(v)};
    put(out, uv);
  });
}

void writeUvUnorm16(const Block& block) {
  forEachUv(block, [](uint8_t* out, float u, float v) {
    const uint16_t uv[2] = {static_cast<uint16_t>(toUnorm16(u)), static_cast<uint16_t>(toUnorm16(v))};
    put(out, uv);
  });
}

void writeColorF32(const Block& block) {
  const uint32_t at = block.asset.format.layout.color[block.set];
  forEachVertex(block, [&](uint32_t wedge, uint8_t* out) {
    const uint16_t* p = block.record(wedge, at);
    const float rgba[4] = {p[0] / 255.0f, p[1] / 255.0f, p[2] / 255.0f, p[3] / 255.0f};
    put(out, rgba);
  });
}

void writeColorUnorm8(const Block& block) {
  const uint32_t at = block.asset.format.layout.color[block.set];
  forEachVertex(block, [&](uint32_t wedge, uint8_t* out) {
    const uint16_t* p = block.record(wedge, at);
    for (int c = 0; c < 4; ++c) out[c] = static_cast<uint8_t>(p[c]);
  });
}

// ---- Joints and weights --------------------------------------------------------------------------------------------

template <typename T>
void writeJoints(const Block& block) {
  forEachVertex(block, [&](uint32_t wedge, uint8_t* out) {
    const SkinRecord skin = block.skin(wedge);
    const uint32_t count = skin.count();
    T joints[LITHE_MAX_INFLUENCES] = {};
    for (uint32_t i = 0; i < count; ++i) joints[i] = static_cast<T>(skin.joint[i]);
    memcpy(out, joints, block.influences * sizeof(T));
  });
}

/// Weights that sum to the greatest value of T.
template <typename T>
void writeWeights(const Block& block) {
  constexpr uint32_t kTarget = static_cast<T>(~T{0});
  forEachVertex(block, [&](uint32_t wedge, uint8_t* out) {
    const SkinRecord skin = block.skin(wedge);
    const uint32_t count = skin.count();
    uint16_t scaled[LITHE_MAX_INFLUENCES];
    rescaleWeights(skin.weight, count, block.asset.format.weight_one, kTarget, scaled);
    T weights[LITHE_MAX_INFLUENCES] = {};
    for (uint32_t i = 0; i < count; ++i) weights[i] = static_cast<T>(scaled[i]);
    memcpy(out, weights, block.influences * sizeof(T));
  });
}

void writeWeightsUnorm8AsStored(const Block& block) {
  forEachVertex(block, [&](uint32_t wedge, uint8_t* out) {
    const SkinRecord skin = block.skin(wedge);
    for (uint32_t i = 0; i < block.influences; ++i)
      out[i] = i < skin.most ? static_cast<uint8_t>(skin.weight[i]) : uint8_t{0};
  });
}

void writeWeightsF32(const Block& block) {
  const float one = static_cast<float>(block.asset.format.weight_one);
  forEachVertex(block, [&](uint32_t wedge, uint8_t* out) {
    const SkinRecord skin = block.skin(wedge);
    const uint32_t count = skin.count();
    float weights[LITHE_MAX_INFLUENCES] = {};
    for (uint32_t i = 0; i < count; ++i) weights[i] = static_cast<float>(skin.weight[i]) / one;
    memcpy(out, weights, block.influences * sizeof(float));
  });
}

// ---- Putting vertices together -------------------------------------------------------------------------------------

Writer directionWriter(uint32_t format, Writer f32, Writer snorm16, Writer snorm8) {
  return format == LITHE_FORMAT_F32 ? f32 : format == LITHE_FORMAT_SNORM16 ? snorm16 : snorm8;
}

Writer weightWriter(const lithe_asset& asset, uint32_t format) {
  if (format == LITHE_FORMAT_F32) return writeWeightsF32;
  if (format == LITHE_FORMAT_UNORM16) return writeWeights<uint16_t>;
  return asset.head.info.weight_bits == 8 ? writeWeightsUnorm8AsStored : writeWeights<uint8_t>;
}

/// The plan allows only the formats that an attribute has.
Writer writerOf(const lithe_asset& asset, const AttributeUse& use) {
  const uint32_t format = use.format;
  switch (use.attribute) {
    case VertexAttribute::kPosition:
      return format == LITHE_FORMAT_F32 ? writePositionF32 : writePositionSnorm16;
    case VertexAttribute::kNormal:
      return directionWriter(format, writeNormalF32, writeNormalSnorm16, writeNormalSnorm8);
    case VertexAttribute::kTangent:
      return directionWriter(format, writeTangentF32, writeTangentSnorm16, writeTangentSnorm8);
    case VertexAttribute::kUv:
      return format == LITHE_FORMAT_F32 ? writeUvF32 : format == LITHE_FORMAT_F16 ? writeUvF16 : writeUvUnorm16;
    case VertexAttribute::kColor:
      return format == LITHE_FORMAT_F32 ? writeColorF32 : writeColorUnorm8;
    case VertexAttribute::kJoints:
      return format == LITHE_FORMAT_U8 ? writeJoints<uint8_t> : writeJoints<uint16_t>;
    case VertexAttribute::kWeights:
      break;
  }
  return weightWriter(asset, format);
}

/// Copies the covered bytes of a block out; all at once where nothing is left alone.
void copyOut(const LayoutPlan& plan, const uint8_t* block, uint32_t count, uint8_t* destination) {
  if (plan.span_count == 1 && plan.spans[0].bytes == plan.stride) {
    memcpy(destination, block, size_t{count} * plan.stride);
    return;
  }
  for (uint32_t i = 0; i < count; ++i, block += plan.stride, destination += plan.stride)
    for (uint32_t s = 0; s < plan.span_count; ++s)
      memcpy(destination + plan.spans[s].offset, block + plan.spans[s].offset, plan.spans[s].bytes);
}

void writeAll(const lithe_asset& asset, const LayoutPlan& plan, uint32_t first, uint32_t count, uint8_t* destination) {
  Writer writers[kMaxUses];
  for (uint32_t u = 0; u < plan.use_count; ++u) writers[u] = writerOf(asset, plan.uses[u]);
  uint8_t bytes[kBlockBytes];
  const uint32_t most = kBlockBytes / plan.stride;
  while (count > 0) {
    const uint32_t now = count < most ? count : most;
    for (uint32_t u = 0; u < plan.use_count; ++u)
      writers[u](Block{asset, first, now, plan.uses[u].set, plan.stride, plan.influences, bytes + plan.uses[u].offset});
    copyOut(plan, bytes, now, destination);
    destination += size_t{now} * plan.stride;
    first += now;
    count -= now;
  }
}

/// Uvs outside 0..1 have no unorm16, so all of them are looked at before anything is written.
bool uvsFit(const lithe_asset& asset, const LayoutPlan& plan, uint32_t first, uint32_t count) {
  bool fit = true;
  for (uint32_t u = 0; u < plan.use_count; ++u) {
    if (plan.uses[u].attribute != VertexAttribute::kUv || plan.uses[u].format != LITHE_FORMAT_UNORM16) continue;
    forEachUv(Block{asset, first, count, plan.uses[u].set, 0, 0, nullptr}, [&](uint8_t*, float x, float y) {
      const int32_t unorm[2] = {toUnorm16(x), toUnorm16(y)};
      fit = fit && unorm[0] >= 0 && unorm[0] <= 65535 && unorm[1] >= 0 && unorm[1] <= 65535;
    });
  }
  return fit;
}

}  // namespace
}  // namespace lithe::runtime

using namespace lithe::runtime;  // NOLINT: the C function below is the outside of this namespace

lithe_result lithe_asset_write_vertices(const lithe_asset* asset, const lithe_vertex_layout* layout, uint32_t first,
                                        uint32_t count, void* destination, size_t size) {
  LayoutPlan plan;
  if (!asset || !layout || (!destination && count) || !planLayout(*asset, *layout, &plan)) return invalidArgument();
  const uint64_t end = uint64_t{first} + count;
  if (end > asset->head.info.wedge_count) return invalidArgument();
  if (uint64_t{count} * plan.stride > size) return LITHE_ERROR_BUFFER_TOO_SMALL;
  if (end > asset->decoded.wedge_count) return LITHE_ERROR_NOT_RESIDENT;
  if (!uvsFit(*asset, plan, first, count)) return invalidArgument();
  writeAll(*asset, plan, first, count, static_cast<uint8_t*>(destination));
  return LITHE_OK;
}
