// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The head of a file: its checks, and its tables as views into the bytes.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "lithe/format/bytes.h"
#include "lithe/format/file.h"
#include "lithe/runtime.h"

namespace lithe::runtime {

/// Reader checks of docs/format.md that concern the head.
enum HeadCheck : uint32_t {
  kCheckComplete = 1,
  kCheckMagic = 2,
  kCheckVersion = 3,
  kCheckSizes = 4,
  kCheckHeadChecksum = 5,
  kCheckHeaderReserved = 6,
  kCheckDirectory = 7,
  kCheckEntry = 8,
  kCheckChunkPlace = 9,
  kCheckChunkId = 10,
  kCheckChunkRecords = 11,
  kCheckQuantization = 12,
  kCheckAttributes = 13,
  kCheckInfoCounts = 14,
  kCheckGrid = 15,
  kCheckNames = 16,
  kCheckSceneNode = 17,
  kCheckJoint = 18,
  kCheckMaterial = 19,
  kCheckPart = 20,
  kCheckUvGrid = 21,
  kCheckLevelCounts = 22,
  kCheckLevelErrors = 23,
  kCheckPageEntry = 24,
  kCheckPageCounts = 25,
  kCheckPageLimits = 26,
  kCheckScales = 27,
};

/// The check that failed; false when none did.
struct Refusal {
  lithe_result result = LITHE_OK;
  uint32_t check = 0;
  uint64_t offset = 0;

  explicit operator bool() const { return check != 0; }
};

/// A chunk's records, in the bytes of the head.
struct Table {
  const uint8_t* bytes = nullptr;
  uint32_t record_bytes = 0;
  uint32_t count = 0;

  const uint8_t* record(uint32_t index) const { return bytes + size_t{index} * record_bytes; }
};

/// INFO, read.
struct Info {
  float grid_origin[3], grid_step;
  uint32_t position_bits, weight_bits, normal_bits, uv_bits;
  uint32_t max_influences, uv_sets, color_sets;
  bool has_normals, has_tangents;
  uint32_t placement_shift;
  uint32_t node_count, wedge_count, face_count;
  float rest_diagonal, posed_diagonal;
  uint32_t grid_min[3], grid_max[3];

  uint32_t stride() const {  ///< 16-bit values in a wedge's record
    return (has_normals ? 2 : 0) + (has_tangents ? 3 : 0) + 2 * uv_sets + 4 * color_sets;
  }
};

struct Head {
  const uint8_t* bytes = nullptr;
  uint32_t size = 0;  ///< head_bytes
  uint64_t file_bytes = 0;
  Table info_record, nodes, joints, scales, materials, parts, uv_grids, levels, pages, names;
  Info info = {};

  uint64_t offsetOf(const uint8_t* at) const { return static_cast<uint64_t>(at - bytes); }
};

/// One record of PAGE, read.
struct PageEntry {
  uint32_t size, level;
  uint64_t checksum;
  uint32_t node_count, wedge_count, face_count, values, max_fan;
};

inline PageEntry readPageEntry(const uint8_t* record) {
  using namespace format;
  return {loadU32(record + page::kSizeAt),       loadU32(record + page::kLevelAt),
          loadU64(record + page::kChecksumAt),   loadU32(record + page::kNodeCountAt),
          loadU32(record + page::kWedgeCountAt), loadU32(record + page::kFaceCountAt),
          loadU32(record + page::kValuesAt),     loadU32(record + page::kMaxFanAt)};
}

/// One record of LEVL, read.
struct LevelEntry {
  uint32_t page_end, node_count, wedge_count, face_count, hidden_count, joint_count;
  float error, error_rms;
};

inline LevelEntry readLevelEntry(const uint8_t* record) {
  using namespace format;
  return {loadU32(record + level::kPageEndAt),     loadU32(record + level::kNodeCountAt),
          loadU32(record + level::kWedgeCountAt),  loadU32(record + level::kFaceCountAt),
          loadU32(record + level::kHiddenCountAt), loadU32(record + level::kJointCountAt),
          loadF32(record + level::kErrorAt),       loadF32(record + level::kErrorRmsAt)};
}

/// Checks 1 to 4, as far as the header alone can tell. bytes must hold the header (format::header::kBytes).
Refusal checkHeader(const uint8_t* bytes);

/// Finds and checks the chunks of a complete head whose header and checksum are sound: checks 6 to 11.
Refusal readDirectory(const uint8_t* bytes, Head* head);

/// Checks what the tables say: 12 to 27, and the rest of 4. Reads head->info.
Refusal readTables(Head* head);

}  // namespace lithe::runtime
