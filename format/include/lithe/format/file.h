// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The head of a .lithe file: header, directory and tables, as byte offsets. docs/format.md is the specification.
///
///     header (64) | directory (16 per chunk) | chunks, each 8-byte aligned | page 0 | page 1 | ...
///
/// All integers little-endian, floats IEEE 754 binary32. Bytes not named below are reserved: zero, and checked.
#pragma once

#include <stdint.h>

namespace lithe::format {

inline constexpr uint8_t kMagic[8] = {0x89, 'L', 'I', 'T', 'H', 'E', 0x1a, 0x0a};
inline constexpr uint16_t kVersionMajor = 0;  ///< a reader refuses files of another major version
inline constexpr uint16_t kVersionMinor = 1;  ///< a reader takes files of any minor version of its major version

/// Counts a file may state. A reader refuses more before it allocates anything.
namespace limits {
inline constexpr uint32_t kHeadBytes = 16u << 20;
inline constexpr uint32_t kChunks = 64;
inline constexpr uint32_t kSceneNodes = 65535;
inline constexpr uint32_t kJoints = 65535;
inline constexpr uint32_t kScales = 1u << 14;  ///< different ones, of nodes and joints together
inline constexpr uint32_t kParts = 4096;
inline constexpr uint32_t kMaterials = 4096;
inline constexpr uint32_t kLevels = 64;
inline constexpr uint32_t kPages = 65535;
inline constexpr uint32_t kPageBytes = 64u << 20;
inline constexpr uint32_t kNodes = 1u << 26;  ///< nodes of the hierarchy
inline constexpr uint32_t kWedges = 1u << 26;
inline constexpr uint32_t kFaces = 1u << 26;
inline constexpr uint32_t kBaseWedges = 1u << 17;  ///< of level 0
inline constexpr uint32_t kFan = 1u << 18;         ///< corners or wedges at one node
inline constexpr uint32_t kUvSets = 8;
inline constexpr uint32_t kColorSets = 2;
inline constexpr uint32_t kInfluences = 8;
}  // namespace limits

inline constexpr uint32_t kNoIndex = 0xffffffffu;

/// File header, at byte 0.
namespace header {
inline constexpr uint32_t kMagicAt = 0;          // 8 bytes
inline constexpr uint32_t kVersionMajorAt = 8;   // u16
inline constexpr uint32_t kVersionMinorAt = 10;  // u16
inline constexpr uint32_t kHeadBytesAt = 12;     // u32: everything before page 0
inline constexpr uint32_t kFileBytesAt = 16;     // u64
inline constexpr uint32_t kChecksumAt = 24;      // u64: XXH64, seed 0, of the head with these 8 bytes zero
inline constexpr uint32_t kChunkCountAt = 32;    // u32
inline constexpr uint32_t kReservedAt = 36;      // 28 bytes
inline constexpr uint32_t kBytes = 64;
}  // namespace header

/// Directory entry. Chunks lie in ascending order of offset, do not overlap, and each id occurs once.
namespace directory {
inline constexpr uint32_t kIdAt = 0;            // u32
inline constexpr uint32_t kFlagsAt = 4;         // u16: bit 0 = optional (an unknown optional chunk is skipped)
inline constexpr uint32_t kRecordBytesAt = 6;   // u16: a reader takes larger records than it knows and ignores the rest
inline constexpr uint32_t kOffsetAt = 8;        // u32: from the start of the file, multiple of 8
inline constexpr uint32_t kRecordCountAt = 12;  // u32
inline constexpr uint32_t kBytes = 16;
inline constexpr uint32_t kOptional = 1;
}  // namespace directory

constexpr uint32_t chunkId(char a, char b, char c, char d) {
  return static_cast<uint32_t>(a) | (static_cast<uint32_t>(b) << 8) | (static_cast<uint32_t>(c) << 16) |
         (static_cast<uint32_t>(d) << 24);
}

/// INFO: one record, the asset.
namespace info {
inline constexpr uint32_t kId = chunkId('I', 'N', 'F', 'O');
inline constexpr uint32_t kGridOriginAt = 0;       // f32 x 3
inline constexpr uint32_t kGridStepAt = 12;        // f32, > 0: bind space = origin + step * grid
inline constexpr uint32_t kPositionBitsAt = 16;    // u8: 8..16
inline constexpr uint32_t kWeightBitsAt = 17;      // u8: 4..16; the weights of a node sum to 2^bits - 1
inline constexpr uint32_t kNormalBitsAt = 18;      // u8: 4..15, octahedral, normals and tangents
inline constexpr uint32_t kUvBitsAt = 19;          // u8: 4..16
inline constexpr uint32_t kMaxInfluencesAt = 20;   // u8: 1..8
inline constexpr uint32_t kUvSetsAt = 21;          // u8: 0..8
inline constexpr uint32_t kColorSetsAt = 22;       // u8: 0..2
inline constexpr uint32_t kAttributesAt = 23;      // u8: bit 0 normals, bit 1 tangents
inline constexpr uint32_t kPlacementShiftAt = 24;  // u8: 0..31, see placement.h
inline constexpr uint32_t kReserved0At = 25;       // 3 bytes
inline constexpr uint32_t kNodeCountAt = 28;       // u32: nodes of the hierarchy
inline constexpr uint32_t kWedgeCountAt = 32;      // u32
inline constexpr uint32_t kFaceCountAt = 36;       // u32
inline constexpr uint32_t kRestDiagonalAt = 40;    // f32
inline constexpr uint32_t kPosedDiagonalAt = 44;   // f32
inline constexpr uint32_t kGridMinAt = 48;         // u32 x 3: box of all nodes, grid coordinates
inline constexpr uint32_t kGridMaxAt = 60;         // u32 x 3
inline constexpr uint32_t kBytes = 72;
inline constexpr uint32_t kHasNormals = 1, kHasTangents = 2;
}  // namespace info

/// The form of a node or joint: bits 0..13 its index into SCAL, bits 14..15 the component that its rotation leaves out.
inline constexpr uint32_t kFormScaleBits = 14;
inline constexpr uint32_t formScale(uint32_t form) { return form & ((1u << kFormScaleBits) - 1); }
inline constexpr uint32_t formLeftOut(uint32_t form) { return form >> kFormScaleBits; }

/// The three components of a rotation that are kept, x before y before z before w: fields of 21 bits from the lowest
/// on. The highest bit is zero.
inline constexpr uint32_t kRotationFieldBits = 21;
inline constexpr int32_t kRotationCenter = 1 << (kRotationFieldBits - 1);
constexpr float rotationComponent(uint64_t fields, uint32_t index) {
  const uint64_t field = fields >> (kRotationFieldBits * index) & ((1u << kRotationFieldBits) - 1);
  return static_cast<float>(3 * (static_cast<int32_t>(field) - kRotationCenter)) / 4194304.0f;  // exact: within 0.75
}

/// NODE: the scene graph, parents before children.
namespace node {
inline constexpr uint32_t kId = chunkId('N', 'O', 'D', 'E');
inline constexpr uint32_t kNameAt = 0;         // u32: offset in NAME
inline constexpr uint32_t kParentAt = 4;       // u16, kNoParent for a root, else smaller than the node's own index
inline constexpr uint32_t kFormAt = 6;         // u16: scale and left-out component
inline constexpr uint32_t kTranslationAt = 8;  // f32 x 3
inline constexpr uint32_t kRotationAt = 20;    // u64: the quaternion's components but the one left out
inline constexpr uint32_t kBytes = 28;
inline constexpr uint32_t kNoParent = 0xffff;
}  // namespace node

/// JOIN: the palette.
namespace joint {
inline constexpr uint32_t kId = chunkId('J', 'O', 'I', 'N');
inline constexpr uint32_t kNodeAt = 0;    // u16, index into NODE
inline constexpr uint32_t kFormAt = 2;    // u16: scale and left-out component
inline constexpr uint32_t kBoxMinAt = 4;  // u8 x 3: box of every node it influences, at any level, in cells of the grid
inline constexpr uint32_t kBoxMaxAt = 7;  // u8 x 3; an unused joint has min 255 and max 0
// Inverse bind matrix: rotation times scale, then the translation.
inline constexpr uint32_t kTranslationAt = 10;  // f32 x 3
inline constexpr uint32_t kRotationAt = 22;     // u64
inline constexpr uint32_t kBytes = 30;
/// The cells of joints' boxes: 256 along each axis of the grid.
constexpr uint32_t boxCellBits(uint32_t position_bits) { return position_bits - 8; }
}  // namespace joint

/// SCAL: the scales that nodes and joints share; what a rotation leaves of a matrix, upper triangular.
namespace scale {
inline constexpr uint32_t kId = chunkId('S', 'C', 'A', 'L');
inline constexpr uint32_t kDiagonalAt = 0;  // f32 x 3: xx, yy, zz
inline constexpr uint32_t kShearAt = 12;    // f32 x 3: xy, xz, yz; zero where a node uses it
inline constexpr uint32_t kBytes = 24;
}  // namespace scale

/// MATL: materials' names.
namespace material {
inline constexpr uint32_t kId = chunkId('M', 'A', 'T', 'L');
inline constexpr uint32_t kNameAt = 0;  // u32
inline constexpr uint32_t kBytes = 4;
}  // namespace material

/// PART: what a face belongs to.
namespace part {
inline constexpr uint32_t kId = chunkId('P', 'A', 'R', 'T');
inline constexpr uint32_t kNameAt = 0;       // u32
inline constexpr uint32_t kMaterialAt = 4;   // u32, index into MATL or kNoIndex
inline constexpr uint32_t kRigidNodeAt = 8;  // u32, index into NODE or kNoIndex
inline constexpr uint32_t kBytes = 12;
}  // namespace part

/// UVGR: part_count * uv_sets records, part by part. uv = offset + scale * integer.
namespace uv_grid {
inline constexpr uint32_t kId = chunkId('U', 'V', 'G', 'R');
inline constexpr uint32_t kOffsetAt = 0;  // f32 x 2
inline constexpr uint32_t kScaleAt = 8;   // f32
inline constexpr uint32_t kBytes = 12;
}  // namespace uv_grid

/// LEVL: the levels, coarse to fine. Counts and page_end grow strictly, except face_count (grows or stays).
namespace level {
inline constexpr uint32_t kId = chunkId('L', 'E', 'V', 'L');
inline constexpr uint32_t kPageEndAt = 0;       // u32: needs pages [0, page_end)
inline constexpr uint32_t kNodeCountAt = 4;     // u32: nodes created up to and with this level
inline constexpr uint32_t kWedgeCountAt = 8;    // u32
inline constexpr uint32_t kFaceCountAt = 12;    // u32: faces born, the hidden ones included
inline constexpr uint32_t kHiddenCountAt = 16;  // u32: faces of this cut that are not drawn (equal to another face)
inline constexpr uint32_t kErrorAt = 20;        // f32, >= 0, never grows from a level to the next
inline constexpr uint32_t kErrorRmsAt = 24;     // f32, >= 0
inline constexpr uint32_t kJointCountAt = 28;   // u32: joints that influence a node of this level's cut
inline constexpr uint32_t kBytes = 32;
}  // namespace level

/// PAGE: the pages, in file order; page 0 starts at head_bytes, each next one where the last ends.
namespace page {
inline constexpr uint32_t kId = chunkId('P', 'A', 'G', 'E');
inline constexpr uint32_t kSizeAt = 0;        // u32: bytes, > 0
inline constexpr uint32_t kLevelAt = 4;       // u32
inline constexpr uint32_t kChecksumAt = 8;    // u64: XXH64, seed 0
inline constexpr uint32_t kNodeCountAt = 16;  // u32: nodes, wedges and faces after this page
inline constexpr uint32_t kWedgeCountAt = 20;
inline constexpr uint32_t kFaceCountAt = 24;
inline constexpr uint32_t kValuesAt = 28;  // u32: integers in all of the page's streams: the reader's scratch memory
inline constexpr uint32_t kMaxFanAt = 32;  // u32: most corners or wedges at a node that the page splits
inline constexpr uint32_t kBytes = 36;
}  // namespace page

/// NAME: zero-terminated UTF-8 strings; record_bytes 1, the last byte is zero.
namespace names {
inline constexpr uint32_t kId = chunkId('N', 'A', 'M', 'E');
}  // namespace names

}  // namespace lithe::format
