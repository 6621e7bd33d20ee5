// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "head.h"
#include "lithe/format/page.h"
#include "utf8.h"

namespace lithe::runtime {
namespace {

using namespace format;  // NOLINT: the records' field names

constexpr uint32_t kMaxMaxFan = 1u << 18;

Refusal corrupt(const Head& head, uint32_t check, const uint8_t* at) {
  return {LITHE_ERROR_CORRUPT, check, head.offsetOf(at)};
}
Refusal beyondLimit(const Head& head, uint32_t check, const uint8_t* at) {
  return {LITHE_ERROR_LIMIT, check, head.offsetOf(at)};
}

/// An exponent of all ones is an infinity or no number.
bool isFinite(const uint8_t* p) { return (loadU32(p) & 0x7f800000u) != 0x7f800000u; }

bool areFinite(const uint8_t* p, uint32_t count) {
  for (uint32_t i = 0; i < count; ++i)
    if (!isFinite(p + 4 * i)) return false;
  return true;
}

bool isPositive(const uint8_t* p) { return isFinite(p) && loadF32(p) > 0; }
bool isNotNegative(const uint8_t* p) { return isFinite(p) && loadF32(p) >= 0; }
bool isWithin(uint32_t value, uint32_t least, uint32_t most) { return value >= least && value <= most; }
bool isIndexOrNone(uint32_t value, uint32_t count) { return value < count || value == kNoIndex; }

// ---- INFO ----------------------------------------------------------------------------------------------------------

Info readInfo(const uint8_t* p) {
  Info info = {};
  for (uint32_t c = 0; c < 3; ++c) {
    info.grid_origin[c] = loadF32(p + info::kGridOriginAt + 4 * c);
    info.grid_min[c] = loadU32(p + info::kGridMinAt + 4 * c);
    info.grid_max[c] = loadU32(p + info::kGridMaxAt + 4 * c);
  }
  info.grid_step = loadF32(p + info::kGridStepAt);
  info.position_bits = p[info::kPositionBitsAt];
  info.weight_bits = p[info::kWeightBitsAt];
  info.normal_bits = p[info::kNormalBitsAt];
  info.uv_bits = p[info::kUvBitsAt];
  info.max_influences = p[info::kMaxInfluencesAt];
  info.uv_sets = p[info::kUvSetsAt];
  info.color_sets = p[info::kColorSetsAt];
  info.has_normals = (p[info::kAttributesAt] & info::kHasNormals) != 0;
  info.has_tangents = (p[info::kAttributesAt] & info::kHasTangents) != 0;
  info.placement_shift = p[info::kPlacementShiftAt];
  info.node_count = loadU32(p + info::kNodeCountAt);
  info.wedge_count = loadU32(p + info::kWedgeCountAt);
  info.face_count = loadU32(p + info::kFaceCountAt);
  info.rest_diagonal = loadF32(p + info::kRestDiagonalAt);
  info.posed_diagonal = loadF32(p + info::kPosedDiagonalAt);
  return info;
}

bool boxIsInGrid(const Info& info) {
  for (uint32_t c = 0; c < 3; ++c)
    if (info.grid_min[c] > info.grid_max[c] || info.grid_max[c] >> info.position_bits) return false;
  return true;
}

Refusal checkInfo(Head* head) {
  const uint8_t* p = head->info_record.bytes;
  const Info info = readInfo(p);
  if (!isWithin(info.position_bits, 8, 16) || !isWithin(info.weight_bits, 4, 16) ||
      !isWithin(info.normal_bits, 4, 15) || !isWithin(info.uv_bits, 4, 16))
    return corrupt(*head, kCheckQuantization, p + info::kPositionBitsAt);
  if (!isWithin(info.max_influences, 1, limits::kInfluences) || info.uv_sets > limits::kUvSets ||
      info.color_sets > limits::kColorSets || (p[info::kAttributesAt] & ~(info::kHasNormals | info::kHasTangents)) ||
      info.placement_shift > 31 || p[info::kReserved0At] || p[info::kReserved0At + 1] || p[info::kReserved0At + 2])
    return corrupt(*head, kCheckAttributes, p + info::kMaxInfluencesAt);
  if (!isWithin(info.node_count, 1, limits::kNodes) || !isWithin(info.wedge_count, 1, limits::kWedges) ||
      info.face_count > limits::kFaces)
    return beyondLimit(*head, kCheckInfoCounts, p + info::kNodeCountAt);
  if (!areFinite(p + info::kGridOriginAt, 3) || !isPositive(p + info::kGridStepAt) ||
      !isPositive(p + info::kRestDiagonalAt) || !isPositive(p + info::kPosedDiagonalAt) || !boxIsInGrid(info))
    return corrupt(*head, kCheckGrid, p + info::kGridOriginAt);
  head->info = info;
  return {};
}

// ---- Names and what bears them -------------------------------------------------------------------------------------

Refusal checkNames(const Head& head) {
  const Table& names = head.names;
  if (names.count == 0 || names.bytes[names.count - 1] != 0 || !isUtf8(names.bytes, names.count))
    return corrupt(head, kCheckNames, names.bytes);
  return {};
}

Refusal checkScales(const Head& head) {
  for (uint32_t i = 0; i < head.scales.count; ++i)
    if (!areFinite(head.scales.record(i), 6)) return corrupt(head, kCheckScales, head.scales.record(i));
  return {};
}

/// Three components of a unit quaternion: the sum of their squares is not above one.
bool isPartOfUnit(const uint8_t* p) {
  const uint64_t fields = loadU64(p);
  const float x = rotationComponent(fields, 0), y = rotationComponent(fields, 1), z = rotationComponent(fields, 2);
  return fields >> (3 * kRotationFieldBits) == 0 && x * x + y * y + z * z <= 1.0f;
}

bool isPure(const Head& head, uint32_t index) {
  const uint8_t* shear = head.scales.record(index) + scale::kShearAt;
  return loadF32(shear) == 0 && loadF32(shear + 4) == 0 && loadF32(shear + 8) == 0;
}

Refusal checkSceneNodes(const Head& head) {
  for (uint32_t i = 0; i < head.nodes.count; ++i) {
    const uint8_t* p = head.nodes.record(i);
    const uint32_t parent = loadU16(p + node::kParentAt), scale_index = formScale(loadU16(p + node::kFormAt));
    if (loadU32(p + node::kNameAt) >= head.names.count || (parent >= i && parent != node::kNoParent) ||
        scale_index >= head.scales.count || !isPure(head, scale_index) || !areFinite(p + node::kTranslationAt, 3) ||
        !isPartOfUnit(p + node::kRotationAt))
      return corrupt(head, kCheckSceneNode, p);
  }
  return {};
}

bool jointBoxIsSound(const uint8_t* p) {
  for (uint32_t c = 0; c < 3; ++c) {
    const uint32_t least = p[joint::kBoxMinAt + c], greatest = p[joint::kBoxMaxAt + c];
    if (least > greatest && !(least == 255 && greatest == 0)) return false;
  }
  return true;
}

Refusal checkJoints(const Head& head) {
  for (uint32_t i = 0; i < head.joints.count; ++i) {
    const uint8_t* p = head.joints.record(i);
    if (loadU16(p + joint::kNodeAt) >= head.nodes.count || !jointBoxIsSound(p) ||
        formScale(loadU16(p + joint::kFormAt)) >= head.scales.count || !areFinite(p + joint::kTranslationAt, 3) ||
        !isPartOfUnit(p + joint::kRotationAt))
      return corrupt(head, kCheckJoint, p);
  }
  return {};
}

Refusal checkMaterials(const Head& head) {
  for (uint32_t i = 0; i < head.materials.count; ++i)
    if (loadU32(head.materials.record(i) + material::kNameAt) >= head.names.count)
      return corrupt(head, kCheckMaterial, head.materials.record(i));
  return {};
}

Refusal checkParts(const Head& head) {
  for (uint32_t i = 0; i < head.parts.count; ++i) {
    const uint8_t* p = head.parts.record(i);
    if (loadU32(p + part::kNameAt) >= head.names.count ||
        !isIndexOrNone(loadU32(p + part::kMaterialAt), head.materials.count) ||
        !isIndexOrNone(loadU32(p + part::kRigidNodeAt), head.nodes.count))
      return corrupt(head, kCheckPart, p);
  }
  return {};
}

Refusal checkUvGrids(const Head& head) {
  if (head.uv_grids.count != head.parts.count * head.info.uv_sets)
    return corrupt(head, kCheckUvGrid, head.uv_grids.bytes);
  for (uint32_t i = 0; i < head.uv_grids.count; ++i)
    if (!areFinite(head.uv_grids.record(i), 3)) return corrupt(head, kCheckUvGrid, head.uv_grids.record(i));
  return {};
}

// ---- Levels --------------------------------------------------------------------------------------------------------

bool growsFrom(const LevelEntry& coarser, const LevelEntry& level) {
  return level.page_end >= coarser.page_end && level.node_count > coarser.node_count &&
         level.wedge_count > coarser.wedge_count && level.face_count >= coarser.face_count;
}

Refusal checkLevelCounts(const Head& head) {
  LevelEntry previous = {};
  for (uint32_t i = 0; i < head.levels.count; ++i) {
    const LevelEntry level = readLevelEntry(head.levels.record(i));
    // Page 0 is the base page and makes level 0 alone.
    if (!growsFrom(previous, level) || (i == 0) != (level.page_end == 1))
      return corrupt(head, kCheckLevelCounts, head.levels.record(i));
    previous = level;
  }
  if (previous.page_end != head.pages.count || previous.node_count != head.info.node_count ||
      previous.wedge_count != head.info.wedge_count || previous.face_count != head.info.face_count)
    return corrupt(head, kCheckLevelCounts, head.levels.record(head.levels.count - 1));
  return {};
}

Refusal checkLevelErrors(const Head& head) {
  float coarser_error = 0;
  uint64_t hidden = 0;
  for (uint32_t i = 0; i < head.levels.count; ++i) {
    const uint8_t* p = head.levels.record(i);
    const LevelEntry level = readLevelEntry(p);
    hidden += level.hidden_count;
    if (!isNotNegative(p + level::kErrorAt) || !isNotNegative(p + level::kErrorRmsAt) ||
        (i > 0 && level.error > coarser_error) || level.hidden_count > level.face_count ||
        level.joint_count > head.joints.count || hidden > limits::kFaces * uint64_t{limits::kLevels} - 1)
      return corrupt(head, kCheckLevelErrors, p);
    coarser_error = level.error;
  }
  return {};
}

// ---- Pages ---------------------------------------------------------------------------------------------------------

/// Each page's size, its level, and that all of them end with the file.
Refusal checkPageSizes(const Head& head) {
  uint64_t end = head.size;
  uint32_t level = 0;
  for (uint32_t i = 0; i < head.pages.count; ++i) {
    const PageEntry entry = readPageEntry(head.pages.record(i));
    while (i >= readLevelEntry(head.levels.record(level)).page_end) ++level;
    if (!isWithin(entry.size, 1, limits::kPageBytes) || entry.level != level)
      return corrupt(head, kCheckPageEntry, head.pages.record(i));
    end += entry.size;
  }
  if (end != head.file_bytes) return {LITHE_ERROR_CORRUPT, kCheckSizes, header::kFileBytesAt};
  return {};
}

bool follows(const PageEntry& previous, const PageEntry& entry) {
  return entry.node_count >= previous.node_count && entry.wedge_count >= previous.wedge_count &&
         entry.face_count >= previous.face_count && (entry.node_count - previous.node_count) % 2 == 0;
}

/// The finest level that ends in a page, or the one that the page is inside of.
uint32_t lastLevelOf(const Head& head, uint32_t page) {
  uint32_t level = readPageEntry(head.pages.record(page)).level;
  while (level + 1 < head.levels.count && readLevelEntry(head.levels.record(level + 1)).page_end == page + 1) ++level;
  return level;
}

bool meets(const LevelEntry& level, const PageEntry& entry) {
  return entry.node_count == level.node_count && entry.wedge_count == level.wedge_count &&
         entry.face_count == level.face_count;
}

Refusal checkPageCounts(const Head& head) {
  PageEntry previous = {};
  for (uint32_t i = 0; i < head.pages.count; ++i) {
    const PageEntry entry = readPageEntry(head.pages.record(i));
    const bool ends_level = readLevelEntry(head.levels.record(entry.level)).page_end == i + 1;
    const LevelEntry level = readLevelEntry(head.levels.record(lastLevelOf(head, i)));
    if ((i > 0 && !follows(previous, entry)) || (ends_level && !meets(level, entry)))
      return corrupt(head, kCheckPageCounts, head.pages.record(i));
    previous = entry;
  }
  return {};
}

/// The most integers that a page's streams can have between these counts: the bounds of section 3 of docs/format.md,
/// each times the components of its stream.
uint64_t mostValues(const Info& info, const PageEntry& before, const PageEntry& after) {
  const uint64_t nodes = after.node_count - before.node_count, wedges = after.wedge_count - before.wedge_count;
  if (after.level == 0)
    return (5 + 2 * uint64_t{info.max_influences}) * nodes + (1 + info.stride()) * wedges + 3ull * after.face_count;
  const uint64_t splits = nodes / 2;
  const uint64_t flags = 2ull * limits::kLevels * after.node_count, split_records = 7 * splits,
                 cuts = (kCutOpen - kCut3 + 1) * splits;
  const uint64_t lists = 4 * listedBound(splits, after.face_count), classes = 2ull * after.wedge_count;
  const uint64_t attributes = (2 * info.stride() + 1) * wedges, skins = (4 + 3 * kMaxSkinJoints) * splits;
  return flags + split_records + cuts + lists + classes + attributes + skins;
}

Refusal checkPageLimits(const Head& head) {
  PageEntry previous = {};
  for (uint32_t i = 0; i < head.pages.count; ++i) {
    const uint8_t* p = head.pages.record(i);
    const PageEntry entry = readPageEntry(p);
    if ((i == 0 && entry.wedge_count > limits::kBaseWedges) || entry.max_fan > kMaxMaxFan)
      return beyondLimit(head, kCheckPageLimits, p);
    if (entry.values > mostValues(head.info, previous, entry)) return corrupt(head, kCheckPageLimits, p);
    previous = entry;
  }
  return {};
}

}  // namespace

Refusal readTables(Head* head) {
  if (const Refusal refusal = checkInfo(head)) return refusal;
  constexpr Refusal (*kChecks[])(const Head&) = {checkNames,       checkScales,    checkSceneNodes, checkJoints,
                                                 checkMaterials,   checkParts,     checkUvGrids,    checkLevelCounts,
                                                 checkLevelErrors, checkPageSizes, checkPageCounts, checkPageLimits};
  for (const auto check : kChecks)
    if (const Refusal refusal = check(*head)) return refusal;
  return {};
}

}  // namespace lithe::runtime
