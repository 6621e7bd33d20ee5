// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "file_writer.h"

#include <xxhash.h>

#include <algorithm>
#include <map>

#include "lithe/format/bytes.h"
#include "lithe/format/file.h"
#include "lithe/format/page.h"
#include "skeleton_code.h"

namespace lithe::bake {
namespace {

using namespace format;  // NOLINT: the records' field names

/// A chunk being filled: records of a fixed size, zeroed.
struct Chunk {
  uint32_t id = 0;
  uint32_t record_bytes = 1;
  std::vector<uint8_t> bytes;

  uint8_t* add() {
    bytes.resize(bytes.size() + record_bytes);
    return bytes.data() + bytes.size() - record_bytes;
  }
};

Chunk chunk(uint32_t id, uint32_t record_bytes) { return {id, record_bytes, {}}; }

class NamePool {
 public:
  uint32_t add(const std::string& name) {
    const auto [at, added] = offsets_.try_emplace(name, static_cast<uint32_t>(chunk_.bytes.size()));
    // A zero byte would end the name early for a reader, so a name stops there.
    if (added)
      chunk_.bytes.insert(chunk_.bytes.end(), name.c_str(),
                          name.c_str() + std::char_traits<char>::length(name.c_str()) + 1);
    return at->second;
  }
  const Chunk& chunk() const { return chunk_; }

 private:
  std::map<std::string, uint32_t> offsets_;
  Chunk chunk_ = {names::kId, 1, {}};
};

template <typename V>
void storeVector(uint8_t* p, const V& v) {
  for (int i = 0; i < v.length(); ++i) storeF32(p + 4 * i, static_cast<float>(v[i]));
}

Chunk infoChunk(const EncodeInput& in, const std::vector<LevelEntry>& levels) {
  Chunk c = chunk(info::kId, info::kBytes);
  uint8_t* p = c.add();
  storeVector(p + info::kGridOriginAt, in.mesh.grid.origin);
  storeF32(p + info::kGridStepAt, static_cast<float>(in.mesh.grid.step));
  p[info::kPositionBitsAt] = static_cast<uint8_t>(in.mesh.grid.bits);
  p[info::kWeightBitsAt] = static_cast<uint8_t>(bitLength(in.mesh.weight_one));
  p[info::kNormalBitsAt] = static_cast<uint8_t>(in.mesh.normal_bits);
  p[info::kUvBitsAt] = static_cast<uint8_t>(in.mesh.uv_bits);
  p[info::kMaxInfluencesAt] = static_cast<uint8_t>(in.mesh.max_influences);
  p[info::kUvSetsAt] = static_cast<uint8_t>(in.mesh.attributes.uv_sets);
  p[info::kColorSetsAt] = static_cast<uint8_t>(in.mesh.attributes.color_sets);
  p[info::kAttributesAt] = static_cast<uint8_t>((in.mesh.attributes.normal ? info::kHasNormals : 0) |
                                                (in.mesh.attributes.tangent ? info::kHasTangents : 0));
  p[info::kPlacementShiftAt] = static_cast<uint8_t>(in.placement_shift);
  storeU32(p + info::kNodeCountAt, levels.back().node_count);
  storeU32(p + info::kWedgeCountAt, levels.back().wedge_count);
  storeU32(p + info::kFaceCountAt, levels.back().face_count);
  storeF32(p + info::kRestDiagonalAt, static_cast<float>(in.model.rest_diagonal));
  storeF32(p + info::kPosedDiagonalAt, static_cast<float>(in.posed_diagonal));
  glm::ivec3 least(INT32_MAX), greatest(0);
  for (const glm::ivec3& position : in.hierarchy.position) {
    least = glm::min(least, position);
    greatest = glm::max(greatest, position);
  }
  for (int i = 0; i < 3; ++i) {
    storeU32(p + info::kGridMinAt + 4 * i, static_cast<uint32_t>(least[i]));
    storeU32(p + info::kGridMaxAt + 4 * i, static_cast<uint32_t>(greatest[i]));
  }
  return c;
}

void storeForm(uint8_t* form_at, uint8_t* rotation_at, const StoredRotation& rotation, uint32_t scale_index) {
  storeU16(form_at, static_cast<uint16_t>(scale_index | rotation.left_out << kFormScaleBits));
  storeU64(rotation_at, rotationFields(rotation));
}

Chunk nodeChunk(const Model& model, NamePool& pool, ScalePool& scales) {
  Chunk c = chunk(node::kId, node::kBytes);
  for (const Node& n : model.nodes) {
    uint8_t* p = c.add();
    storeU32(p + node::kNameAt, pool.add(n.name));
    storeU16(p + node::kParentAt, static_cast<uint16_t>(n.parent == kNone ? node::kNoParent : n.parent));
    storeVector(p + node::kTranslationAt, n.rest.translation);
    storeForm(p + node::kFormAt, p + node::kRotationAt, storedRotation(n.rest.rotation), scales.add(n.rest.scale));
  }
  return c;
}

/// The grid box of every node that each joint influences.
std::vector<std::array<glm::ivec3, 2>> jointBoxes(const EncodeInput& in) {
  std::vector<std::array<glm::ivec3, 2>> boxes(in.model.joints.size(), {glm::ivec3(65535), glm::ivec3(0)});
  for (uint32_t n = 0; n < in.hierarchy.nodeCount(); ++n) {
    const QuantizedSkin& skin = in.hierarchy.skin[n];
    for (uint32_t i = 0; i < skin.count; ++i) {
      auto& box = boxes[skin.joint[i]];
      box[0] = glm::min(box[0], in.hierarchy.position[n]);
      box[1] = glm::max(box[1], in.hierarchy.position[n]);
    }
  }
  return boxes;
}

Chunk jointChunk(const EncodeInput& in, ScalePool& scales) {
  Chunk c = chunk(joint::kId, joint::kBytes);
  const auto boxes = jointBoxes(in);
  const uint32_t cell_bits = joint::boxCellBits(in.mesh.grid.bits);
  for (size_t j = 0; j < in.model.joints.size(); ++j) {
    uint8_t* p = c.add();
    storeU16(p + joint::kNodeAt, static_cast<uint16_t>(in.model.joints[j].node));
    for (int i = 0; i < 3; ++i) {
      p[joint::kBoxMinAt + i] = static_cast<uint8_t>(std::min(boxes[j][0][i] >> cell_bits, 255));
      p[joint::kBoxMaxAt + i] = static_cast<uint8_t>(boxes[j][1][i] >> cell_bits);
    }
    const glm::dmat4& inverse_bind = in.model.joints[j].inverse_bind;
    const RotationAndScale linear = rotationAndScale(glm::dmat3(inverse_bind));
    storeVector(p + joint::kTranslationAt, glm::dvec3(inverse_bind[3]));
    storeForm(p + joint::kFormAt, p + joint::kRotationAt, storedRotation(linear.rotation), scales.add(linear.scale));
  }
  return c;
}

Chunk scaleChunk(const ScalePool& scales) {
  Chunk c = chunk(scale::kId, scale::kBytes);
  for (const StoredScale& s : scales.all()) {
    uint8_t* p = c.add();
    for (uint32_t i = 0; i < 6; ++i) storeF32(p + 4 * i, s[i]);
  }
  return c;
}

Chunk materialChunk(const Model& model, NamePool& pool) {
  Chunk c = chunk(material::kId, material::kBytes);
  for (const std::string& name : model.materials) storeU32(c.add() + material::kNameAt, pool.add(name));
  return c;
}

Chunk partChunk(const Model& model, NamePool& pool) {
  Chunk c = chunk(part::kId, part::kBytes);
  for (const Part& source : model.parts) {
    uint8_t* p = c.add();
    storeU32(p + part::kNameAt, pool.add(source.name));
    storeU32(p + part::kMaterialAt, source.material);
    storeU32(p + part::kRigidNodeAt, source.rigid_node);
  }
  return c;
}

Chunk uvGridChunk(const Mesh& mesh) {
  Chunk c = chunk(uv_grid::kId, uv_grid::kBytes);
  for (const auto& grids : mesh.part_uv)
    for (uint32_t s = 0; s < mesh.attributes.uv_sets; ++s) {
      uint8_t* p = c.add();
      storeVector(p + uv_grid::kOffsetAt, grids[s].offset);
      storeF32(p + uv_grid::kScaleAt, static_cast<float>(grids[s].scale));
    }
  return c;
}

Chunk levelChunk(const std::vector<LevelEntry>& levels) {
  Chunk c = chunk(level::kId, level::kBytes);
  for (const LevelEntry& source : levels) {
    uint8_t* p = c.add();
    storeU32(p + level::kPageEndAt, source.page_end);
    storeU32(p + level::kNodeCountAt, source.node_count);
    storeU32(p + level::kWedgeCountAt, source.wedge_count);
    storeU32(p + level::kFaceCountAt, source.face_count);
    storeU32(p + level::kHiddenCountAt, source.hidden_count);
    storeF32(p + level::kErrorAt, static_cast<float>(source.error));
    storeF32(p + level::kErrorRmsAt, static_cast<float>(source.error_rms));
    storeU32(p + level::kJointCountAt, source.joint_count);
  }
  return c;
}

Chunk pageChunk(const std::vector<PageEntry>& pages) {
  Chunk c = chunk(page::kId, page::kBytes);
  for (const PageEntry& source : pages) {
    uint8_t* p = c.add();
    storeU32(p + page::kSizeAt, static_cast<uint32_t>(source.bytes.size()));
    storeU32(p + page::kLevelAt, source.level);
    storeU64(p + page::kChecksumAt, XXH64(source.bytes.data(), source.bytes.size(), 0));
    storeU32(p + page::kNodeCountAt, source.node_count);
    storeU32(p + page::kWedgeCountAt, source.wedge_count);
    storeU32(p + page::kFaceCountAt, source.face_count);
    storeU32(p + page::kValuesAt, source.values);
    storeU32(p + page::kMaxFanAt, source.max_fan);
  }
  return c;
}

uint32_t aligned(size_t size) { return static_cast<uint32_t>((size + 7) & ~size_t{7}); }

std::vector<uint8_t> assembleHead(const std::vector<Chunk>& chunks, uint64_t page_bytes) {
  uint32_t offset = aligned(header::kBytes + chunks.size() * directory::kBytes);
  std::vector<uint8_t> head(offset, 0);
  for (size_t i = 0; i < chunks.size(); ++i) {
    uint8_t* entry = head.data() + header::kBytes + i * directory::kBytes;
    storeU32(entry + directory::kIdAt, chunks[i].id);
    storeU32(entry + directory::kOffsetAt, offset);
    storeU16(entry + directory::kRecordBytesAt, static_cast<uint16_t>(chunks[i].record_bytes));
    storeU32(entry + directory::kRecordCountAt, static_cast<uint32_t>(chunks[i].bytes.size() / chunks[i].record_bytes));
    head.insert(head.end(), chunks[i].bytes.begin(), chunks[i].bytes.end());
    offset = aligned(head.size());
    head.resize(offset, 0);
  }
  std::copy(std::begin(kMagic), std::end(kMagic), head.data());
  storeU16(head.data() + header::kVersionMajorAt, kVersionMajor);
  storeU16(head.data() + header::kVersionMinorAt, kVersionMinor);
  storeU32(head.data() + header::kHeadBytesAt, static_cast<uint32_t>(head.size()));
  storeU64(head.data() + header::kFileBytesAt, head.size() + page_bytes);
  storeU32(head.data() + header::kChunkCountAt, static_cast<uint32_t>(chunks.size()));
  storeU64(head.data() + header::kChecksumAt, XXH64(head.data(), head.size(), 0));
  return head;
}

void checkLimits(const EncodeInput& in, const std::vector<LevelEntry>& levels, const std::vector<PageEntry>& pages) {
  auto check = [](const char* what, size_t count, size_t limit) {
    if (count > limit)
      throw Error("the file format holds at most " + std::to_string(limit) + " " + what + ", this character has " +
                  std::to_string(count));
  };
  check("scene nodes", in.model.nodes.size(), limits::kSceneNodes);
  check("joints", in.model.joints.size(), limits::kJoints);
  check("parts", in.model.parts.size(), limits::kParts);
  check("materials", in.model.materials.size(), limits::kMaterials);
  check("levels", levels.size(), limits::kLevels);
  check("pages", pages.size(), limits::kPages);
  check("hierarchy nodes", levels.back().node_count, limits::kNodes);
  check("vertices", levels.back().wedge_count, limits::kWedges);
  check("faces", levels.back().face_count, limits::kFaces);
  for (const PageEntry& entry : pages) {
    check("bytes in a page", entry.bytes.size(), limits::kPageBytes);
    check("faces at one vertex", entry.max_fan, limits::kFan);
  }
}

}  // namespace

std::vector<uint8_t> writeFile(const EncodeInput& in, const std::vector<LevelEntry>& levels,
                               const std::vector<PageEntry>& pages, uint64_t* head_bytes) {
  checkLimits(in, levels, pages);
  NamePool pool;
  pool.add("");
  ScalePool scales;
  std::vector<Chunk> chunks = {infoChunk(in, levels), nodeChunk(in.model, pool, scales), jointChunk(in, scales)};
  chunks.push_back(scaleChunk(scales));
  chunks.push_back(materialChunk(in.model, pool));
  chunks.push_back(partChunk(in.model, pool));
  chunks.push_back(uvGridChunk(in.mesh));
  chunks.push_back(levelChunk(levels));
  chunks.push_back(pageChunk(pages));
  chunks.push_back(pool.chunk());
  uint64_t page_bytes = 0;
  for (const PageEntry& entry : pages) page_bytes += entry.bytes.size();
  std::vector<uint8_t> file = assembleHead(chunks, page_bytes);
  *head_bytes = file.size();
  for (const PageEntry& entry : pages) file.insert(file.end(), entry.bytes.begin(), entry.bytes.end());
  return file;
}

}  // namespace lithe::bake
