// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Every reader check of docs/format.md that concerns the head: a sound file breaks exactly that rule, under a true
// checksum. The tests have the checks' numbers.
#include <limits>

#include "refusals.h"

namespace lithe::test {
namespace {

using namespace format;  // NOLINT: the records' field names

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// A sound file after a change of its head.
template <typename Change>
void expectRefusedAfter(lithe_result result, uint32_t check, const Change& change) {
  LitheFile file(richFile());
  change(file);
  expectHeadRefused(file, result, check);
}

template <typename Change>
void expectCorruptAfter(uint32_t check, const Change& change) {
  expectRefusedAfter(LITHE_ERROR_CORRUPT, check, change);
}

/// A sound file with one 32-bit number of a record exchanged.
void expectCorruptField(uint32_t check, uint32_t id, uint32_t record, uint32_t at, uint32_t value) {
  SCOPED_TRACE("record " + std::to_string(record) + " at " + std::to_string(at));
  expectCorruptAfter(check, [&](LitheFile& f) { storeU32(f.record(id, record) + at, value); });
}
void expectCorruptHalf(uint32_t check, uint32_t id, uint32_t record, uint32_t at, uint32_t value) {
  SCOPED_TRACE("record " + std::to_string(record) + " at " + std::to_string(at));
  expectCorruptAfter(check, [&](LitheFile& f) { storeU16(f.record(id, record) + at, static_cast<uint16_t>(value)); });
}
void expectCorruptNumber(uint32_t check, uint32_t id, uint32_t record, uint32_t at, float value) {
  SCOPED_TRACE("record " + std::to_string(record) + " at " + std::to_string(at));
  expectCorruptAfter(check, [&](LitheFile& f) { storeF32(f.record(id, record) + at, value); });
}
void expectCorruptByte(uint32_t check, uint32_t id, uint32_t at, uint8_t value) {
  SCOPED_TRACE("byte " + std::to_string(at) + " = " + std::to_string(value));
  expectCorruptAfter(check, [&](LitheFile& f) { f.record(id)[at] = value; });
}

uint32_t countOf(uint32_t id) { return LitheFile(richFile()).chunk(id).record_count; }
uint32_t fieldOf(uint32_t id, uint32_t record, uint32_t at) {
  return loadU32(LitheFile(richFile()).record(id, record) + at);
}

uint8_t* entryOf(LitheFile& file, uint32_t index) {
  return file.head.data() + header::kBytes + size_t{index} * directory::kBytes;
}

/// A head made of changed chunks.
template <typename Change>
LitheFile withChunks(const Change& change) {
  LitheFile file(richFile());
  std::vector<FileChunk> chunks = file.chunks();
  change(chunks);
  file.setChunks(chunks);
  return file;
}

FileChunk& chunkIn(std::vector<FileChunk>& chunks, uint32_t id) {
  for (FileChunk& chunk : chunks)
    if (chunk.id == id) return chunk;
  throw std::runtime_error("no such chunk");
}

constexpr uint32_t kChunkIds[] = {info::kId,    node::kId,  joint::kId, material::kId, part::kId,
                                  uv_grid::kId, level::kId, page::kId,  names::kId};

TEST(HeadCheck, TheFileItselfIsSound) {
  const Outcome outcome = outcomeOf(richFile());
  EXPECT_EQ(outcome.result, LITHE_OK);
  EXPECT_EQ(outcome.levels.size(), countOf(level::kId));
  EXPECT_GT(countOf(page::kId), 3u);
}

TEST(HeadCheck, N1_FewerBytesThanTheHead) {
  const FileBytes& bytes = richFile();
  const size_t head_bytes = LitheFile(bytes).head.size();
  for (const size_t size : {size_t{0}, size_t{1}, size_t{63}, size_t{64}, head_bytes - 1})
    expectHeadRefused(bytes.data(), size, LITHE_ERROR_TRUNCATED, 1);
}

TEST(HeadCheck, N2_Magic) {
  for (uint32_t i = 0; i < sizeof kMagic; ++i)
    expectRefusedAfter(LITHE_ERROR_NOT_THIS_FORMAT, 2, [&](LitheFile& f) { f.head[i] ^= 0x20; });
}

TEST(HeadCheck, N3_Version) {
  expectRefusedAfter(LITHE_ERROR_VERSION_TOO_NEW, 3,
                     [](LitheFile& f) { storeU16(f.head.data() + header::kVersionMajorAt, kVersionMajor + 1); });
  expectRefusedAfter(LITHE_ERROR_VERSION_TOO_NEW, 3,
                     [](LitheFile& f) { storeU16(f.head.data() + header::kVersionMajorAt, 0xffff); });
  if (kVersionMajor > 0) {
    expectRefusedAfter(LITHE_ERROR_NOT_THIS_FORMAT, 3,
                       [](LitheFile& f) { storeU16(f.head.data() + header::kVersionMajorAt, kVersionMajor - 1); });
  }
}

TEST(HeadCheck, N4_Sizes) {
  for (const uint32_t head_bytes : {0u, 56u, 65u, limits::kHeadBytes + 8, 0xfffffff8u}) {
    LitheFile file(richFile());
    storeU32(file.head.data() + header::kHeadBytesAt, head_bytes);
    expectHeadRefused(file.head.data(), file.head.size(), LITHE_ERROR_CORRUPT, 4);
  }
  for (const int64_t change : {int64_t{-1}, int64_t{1}, int64_t{1} << 40}) {
    expectCorruptAfter(4, [&](LitheFile& f) {
      uint8_t* at = f.head.data() + header::kFileBytesAt;
      storeU64(at, loadU64(at) + static_cast<uint64_t>(change));
    });
  }
}

TEST(HeadCheck, N5_Checksum) {
  const FileBytes& bytes = richFile();
  const uint32_t head_bytes = static_cast<uint32_t>(LitheFile(bytes).head.size());
  for (const uint32_t at : {header::kChecksumAt, header::kChecksumAt + 7, header::kChunkCountAt, head_bytes - 1}) {
    FileBytes broken = bytes;
    broken[at] ^= 1;
    expectHeadRefused(broken.data(), broken.size(), LITHE_ERROR_CORRUPT, 5);
  }
}

TEST(HeadCheck, N6_HeaderReserved) {
  for (uint32_t at = header::kReservedAt; at < header::kBytes; ++at)
    expectCorruptAfter(6, [&](LitheFile& f) { f.head[at] = 1; });
}

TEST(HeadCheck, N7_DirectoryDoesNotFit) {
  for (const uint32_t count : {limits::kChunks + 1, 0xffffffffu})
    expectCorruptAfter(7, [&](LitheFile& f) { storeU32(f.head.data() + header::kChunkCountAt, count); });
  expectCorruptAfter(7, [](LitheFile& f) {
    f.head.resize(header::kBytes + 8 * directory::kBytes);
    storeU32(f.head.data() + header::kHeadBytesAt, static_cast<uint32_t>(f.head.size()));
  });
}

TEST(HeadCheck, N8_Entry) {
  for (uint32_t i = 0; i < 9; ++i) {
    expectCorruptAfter(8, [&](LitheFile& f) { entryOf(f, i)[directory::kFlagsAt] = 2; });
    expectCorruptAfter(8, [&](LitheFile& f) { entryOf(f, i)[directory::kFlagsAt + 1] = 0x80; });
    expectCorruptAfter(8, [&](LitheFile& f) { storeU16(entryOf(f, i) + directory::kRecordBytesAt, 0); });
    expectCorruptAfter(8, [&](LitheFile& f) { entryOf(f, i)[directory::kOffsetAt] += 4; });
  }
}

TEST(HeadCheck, N9_ChunkPlace) {
  // Beyond the head, by its offset or by its records; over the directory; over each other; out of order.
  expectCorruptAfter(9, [](LitheFile& f) { storeU32(entryOf(f, 0) + directory::kOffsetAt, 0xfffffff8u); });
  expectCorruptAfter(9, [](LitheFile& f) { storeU32(entryOf(f, 8) + directory::kRecordCountAt, 0xffffffffu); });
  expectCorruptAfter(9, [](LitheFile& f) { storeU16(entryOf(f, 8) + directory::kRecordBytesAt, 0xffffu); });
  expectCorruptAfter(9, [](LitheFile& f) { storeU32(entryOf(f, 0) + directory::kOffsetAt, 64); });
  expectCorruptAfter(9, [](LitheFile& f) {
    storeU32(entryOf(f, 1) + directory::kOffsetAt, loadU32(entryOf(f, 0) + directory::kOffsetAt));
  });
  expectCorruptAfter(9, [](LitheFile& f) {
    for (uint32_t k = 0; k < directory::kBytes; ++k) std::swap(entryOf(f, 1)[k], entryOf(f, 2)[k]);
  });
}

TEST(HeadCheck, N9_BytesBetweenChunksAreZero) {
  uint32_t gaps = 0;
  LitheFile file(richFile());
  const uint32_t chunks = loadU32(file.head.data() + header::kChunkCountAt);
  uint32_t end = header::kBytes + chunks * directory::kBytes;
  for (uint32_t i = 0; i <= chunks; ++i) {
    const uint8_t* entry = i < chunks ? entryOf(file, i) : nullptr;
    const uint32_t begin = entry ? loadU32(entry + directory::kOffsetAt) : static_cast<uint32_t>(file.head.size());
    for (; end < begin; ++end, ++gaps) expectCorruptAfter(9, [&](LitheFile& f) { f.head[end] = 1; });
    if (entry) end += loadU16(entry + directory::kRecordBytesAt) * loadU32(entry + directory::kRecordCountAt);
  }
  EXPECT_GT(gaps, 0u);
}

TEST(HeadCheck, N10_ChunkIds) {
  expectHeadRefused(withChunks([](std::vector<FileChunk>& c) { c.push_back(chunkIn(c, material::kId)); }),
                    LITHE_ERROR_CORRUPT, 10);
  const FileChunk unknown = {chunkId('N', 'E', 'W', '1'), 0, 5, FileBytes(15, 7)};
  expectHeadRefused(withChunks([&](std::vector<FileChunk>& c) { c.push_back(unknown); }), LITHE_ERROR_CORRUPT, 10);
}

TEST(HeadCheck, N10_UnknownOptionalChunksAreSkipped) {
  const LitheFile file = withChunks([](std::vector<FileChunk>& c) {
    c.insert(c.begin() + 3, {chunkId('N', 'E', 'W', '1'), directory::kOptional, 5, FileBytes(15, 7)});
  });
  const Outcome outcome = outcomeOf(file.bytes());
  EXPECT_EQ(outcome.result, LITHE_OK);
  EXPECT_EQ(outcome.levels, outcomeOf(richFile()).levels);
}

TEST(HeadCheck, N11_MissingChunk) {
  for (const uint32_t id : kChunkIds) {
    expectHeadRefused(withChunks([&](std::vector<FileChunk>& c) {
                        chunkIn(c, id).flags = directory::kOptional;
                        chunkIn(c, id).id = chunkId('N', 'E', 'W', '1');
                      }),
                      LITHE_ERROR_CORRUPT, 11);
  }
}

TEST(HeadCheck, N11_RecordsTooSmall) {
  for (const uint32_t id : kChunkIds) {
    if (id == names::kId) continue;
    expectHeadRefused(withChunks([&](std::vector<FileChunk>& c) {
                        FileChunk& chunk = chunkIn(c, id);
                        const size_t count = chunk.bytes.size() / chunk.record_bytes;
                        chunk.bytes.resize(count * --chunk.record_bytes);
                      }),
                      LITHE_ERROR_CORRUPT, 11);
  }
}

TEST(HeadCheck, N11_NamesAreBytes) {
  expectHeadRefused(withChunks([](std::vector<FileChunk>& c) {
                      chunkIn(c, names::kId).record_bytes = 2;
                      chunkIn(c, names::kId).bytes.resize(chunkIn(c, names::kId).bytes.size() / 2 * 2);
                    }),
                    LITHE_ERROR_CORRUPT, 11);
}

TEST(HeadCheck, N11_TooFewRecords) {
  for (const uint32_t id : {info::kId, part::kId, level::kId, page::kId}) {
    expectHeadRefused(withChunks([&](std::vector<FileChunk>& c) { chunkIn(c, id).bytes.clear(); }), LITHE_ERROR_CORRUPT,
                      11);
  }
}

TEST(HeadCheck, N11_TooManyRecords) {
  const struct {
    uint32_t id, most;
  } kLimits[] = {{info::kId, 1},
                 {node::kId, limits::kSceneNodes},
                 {joint::kId, limits::kJoints},
                 {scale::kId, limits::kScales},
                 {material::kId, limits::kMaterials},
                 {part::kId, limits::kParts},
                 {uv_grid::kId, limits::kParts * limits::kUvSets},
                 {level::kId, limits::kLevels},
                 {page::kId, limits::kPages}};
  for (const auto& limit : kLimits) {
    expectHeadRefused(withChunks([&](std::vector<FileChunk>& c) {
                        FileChunk& chunk = chunkIn(c, limit.id);
                        chunk.bytes.resize((size_t{limit.most} + 1) * chunk.record_bytes);
                      }),
                      LITHE_ERROR_LIMIT, 11);
  }
}

TEST(HeadCheck, N11_LargerRecordsAreReadInPart) {
  const LitheFile file = withChunks([](std::vector<FileChunk>& chunks) {
    for (FileChunk& chunk : chunks) {
      if (chunk.id == names::kId) continue;
      FileBytes wider;
      for (size_t at = 0; at < chunk.bytes.size(); at += chunk.record_bytes) {
        const auto record = chunk.bytes.begin() + static_cast<int64_t>(at);
        wider.insert(wider.end(), record, record + chunk.record_bytes);
        wider.insert(wider.end(), 3, 0xaa);
      }
      chunk.bytes = wider;
      chunk.record_bytes += 3;
    }
  });
  const Outcome outcome = outcomeOf(file.bytes());
  EXPECT_EQ(outcome.result, LITHE_OK) << outcome.diagnosis.check;
  EXPECT_EQ(outcome.levels, outcomeOf(richFile()).levels);
}

TEST(HeadCheck, N12_Quantisation) {
  const struct {
    uint32_t at;
    uint8_t least, most;
  } kRanges[] = {{info::kPositionBitsAt, 8, 16},
                 {info::kWeightBitsAt, 4, 16},
                 {info::kNormalBitsAt, 4, 15},
                 {info::kUvBitsAt, 4, 16}};
  for (const auto& range : kRanges) {
    expectCorruptByte(12, info::kId, range.at, static_cast<uint8_t>(range.least - 1));
    expectCorruptByte(12, info::kId, range.at, static_cast<uint8_t>(range.most + 1));
    expectCorruptByte(12, info::kId, range.at, 0);
    expectCorruptByte(12, info::kId, range.at, 255);
  }
}

TEST(HeadCheck, N13_Attributes) {
  expectCorruptByte(13, info::kId, info::kMaxInfluencesAt, 0);
  expectCorruptByte(13, info::kId, info::kMaxInfluencesAt, limits::kInfluences + 1);
  expectCorruptByte(13, info::kId, info::kUvSetsAt, limits::kUvSets + 1);
  expectCorruptByte(13, info::kId, info::kColorSetsAt, limits::kColorSets + 1);
  for (uint32_t bit = 2; bit < 8; ++bit)
    expectCorruptByte(13, info::kId, info::kAttributesAt, static_cast<uint8_t>(1u << bit));
  expectCorruptByte(13, info::kId, info::kPlacementShiftAt, 32);
  for (uint32_t i = 0; i < 3; ++i) expectCorruptByte(13, info::kId, info::kReserved0At + i, 1);
}

TEST(HeadCheck, N14_InfoCounts) {
  const struct {
    uint32_t at, value;
  } kWrong[] = {{info::kNodeCountAt, 0},
                {info::kWedgeCountAt, 0},
                {info::kNodeCountAt, limits::kNodes + 1},
                {info::kWedgeCountAt, limits::kWedges + 1},
                {info::kFaceCountAt, limits::kFaces + 1},
                {info::kFaceCountAt, 0xffffffffu}};
  for (const auto& wrong : kWrong) {
    expectRefusedAfter(LITHE_ERROR_LIMIT, 14,
                       [&](LitheFile& f) { storeU32(f.record(info::kId) + wrong.at, wrong.value); });
  }
}

TEST(HeadCheck, N15_GridDiagonalsBox) {
  for (uint32_t c = 0; c < 3; ++c) {
    expectCorruptNumber(15, info::kId, 0, info::kGridOriginAt + 4 * c, kNan);
    expectCorruptNumber(15, info::kId, 0, info::kGridOriginAt + 4 * c, -kInfinity);
    expectCorruptField(15, info::kId, 0, info::kGridMinAt + 4 * c, 0xffffu);
    expectCorruptField(15, info::kId, 0, info::kGridMaxAt + 4 * c, 1u << 14);
    expectCorruptField(15, info::kId, 0, info::kGridMaxAt + 4 * c, 0xffffffffu);
  }
  for (const uint32_t at : {info::kGridStepAt, info::kRestDiagonalAt, info::kPosedDiagonalAt})
    for (const float value : {0.0f, -0.0f, -1.0f, kNan, kInfinity}) expectCorruptNumber(15, info::kId, 0, at, value);
}

TEST(HeadCheck, N16_Names) {
  expectHeadRefused(withChunks([](std::vector<FileChunk>& c) { chunkIn(c, names::kId).bytes.clear(); }),
                    LITHE_ERROR_CORRUPT, 16);
  expectHeadRefused(withChunks([](std::vector<FileChunk>& c) { chunkIn(c, names::kId).bytes.back() = 'x'; }),
                    LITHE_ERROR_CORRUPT, 16);
  expectHeadRefused(withChunks([](std::vector<FileChunk>& c) { chunkIn(c, names::kId).bytes.front() = 0xff; }),
                    LITHE_ERROR_CORRUPT, 16);
}

/// Components of 0.75 where two alone are too long, and the highest bit.
constexpr uint64_t kNoRotations[] = {0, 0x7fffffffffffffffu, uint64_t{1} << 63};

TEST(HeadCheck, N17_SceneNode) {
  const uint32_t last = countOf(node::kId) - 1;
  expectCorruptField(17, node::kId, last, node::kNameAt, countOf(names::kId));
  expectCorruptField(17, node::kId, 0, node::kNameAt, 0xffffffffu);
  expectCorruptHalf(17, node::kId, 0, node::kParentAt, 0);
  expectCorruptHalf(17, node::kId, last, node::kParentAt, last);
  expectCorruptHalf(17, node::kId, 1, node::kParentAt, last);
  expectCorruptHalf(17, node::kId, last, node::kFormAt, countOf(scale::kId));
  expectCorruptHalf(17, node::kId, 0, node::kFormAt, 0xffff);
  for (uint32_t i = 0; i < 3; ++i) {
    expectCorruptNumber(17, node::kId, last, node::kTranslationAt + 4 * i, kNan);
    expectCorruptNumber(17, node::kId, last, node::kTranslationAt + 4 * i, kInfinity);
  }
  for (uint32_t i = 0; i < 3; ++i) {
    expectCorruptNumber(17, scale::kId, 0, scale::kShearAt + 4 * i, 0.5f);
  }
  for (const uint64_t fields : kNoRotations)
    expectCorruptAfter(17, [&](LitheFile& f) { storeU64(f.record(node::kId, last) + node::kRotationAt, fields); });
}

TEST(HeadCheck, N18_Joint) {
  const uint32_t last = countOf(joint::kId) - 1;
  expectCorruptHalf(18, joint::kId, last, joint::kNodeAt, countOf(node::kId));
  expectCorruptHalf(18, joint::kId, 0, joint::kNodeAt, 0xffff);
  expectCorruptHalf(18, joint::kId, last, joint::kFormAt, countOf(scale::kId));
  for (uint32_t c = 0; c < 3; ++c) {
    expectCorruptAfter(18, [&](LitheFile& f) {
      f.record(joint::kId)[joint::kBoxMinAt + c] = 2;
      f.record(joint::kId)[joint::kBoxMaxAt + c] = 1;
    });
    expectCorruptNumber(18, joint::kId, last, joint::kTranslationAt + 4 * c, kNan);
    expectCorruptNumber(18, joint::kId, last, joint::kTranslationAt + 4 * c, kInfinity);
  }
  for (const uint64_t fields : kNoRotations)
    expectCorruptAfter(18, [&](LitheFile& f) { storeU64(f.record(joint::kId, last) + joint::kRotationAt, fields); });
}

TEST(HeadCheck, N19_Material) {
  expectCorruptField(19, material::kId, 0, material::kNameAt, countOf(names::kId));
  expectCorruptField(19, material::kId, 0, material::kNameAt, 0xffffffffu);
}

TEST(HeadCheck, N20_Part) {
  const uint32_t last = countOf(part::kId) - 1;
  expectCorruptField(20, part::kId, last, part::kNameAt, countOf(names::kId));
  expectCorruptField(20, part::kId, last, part::kMaterialAt, countOf(material::kId));
  expectCorruptField(20, part::kId, last, part::kRigidNodeAt, countOf(node::kId));
}

TEST(HeadCheck, N21_UvGrid) {
  for (const uint8_t sets : {uint8_t{0}, uint8_t{1}, uint8_t{8}})
    expectCorruptByte(21, info::kId, info::kUvSetsAt, sets);
  const uint32_t last = countOf(uv_grid::kId) - 1;
  for (uint32_t i = 0; i < 3; ++i) expectCorruptNumber(21, uv_grid::kId, last, uv_grid::kOffsetAt + 4 * i, kNan);
}

TEST(HeadCheck, N22_LevelCounts) {
  const uint32_t last = countOf(level::kId) - 1;
  expectCorruptField(22, level::kId, 0, level::kPageEndAt, 0);
  expectCorruptField(22, level::kId, 0, level::kPageEndAt, 2);
  expectCorruptField(22, level::kId, 1, level::kPageEndAt, 1);
  expectCorruptField(22, level::kId, last - 1, level::kPageEndAt, countOf(page::kId) + 1);
  expectCorruptField(22, level::kId, last, level::kPageEndAt, countOf(page::kId) - 1);
  expectCorruptField(22, level::kId, last, level::kPageEndAt, countOf(page::kId) + 1);
  for (const uint32_t at : {level::kNodeCountAt, level::kWedgeCountAt}) {
    expectCorruptField(22, level::kId, 1, at, fieldOf(level::kId, 0, at));
    expectCorruptField(22, level::kId, 0, at, 0);
    expectCorruptField(22, level::kId, last, at, fieldOf(level::kId, last, at) + 1);
  }
  expectCorruptField(22, level::kId, 1, level::kFaceCountAt, fieldOf(level::kId, 0, level::kFaceCountAt) - 1);
  expectCorruptField(22, level::kId, last, level::kFaceCountAt, fieldOf(level::kId, last, level::kFaceCountAt) + 1);
  for (const uint32_t at : {info::kNodeCountAt, info::kWedgeCountAt, info::kFaceCountAt})
    expectCorruptField(22, info::kId, 0, at, fieldOf(info::kId, 0, at) + 1);
}

TEST(HeadCheck, N23_LevelErrors) {
  const uint32_t last = countOf(level::kId) - 1;
  for (const float value : {-1.0f, kNan, kInfinity}) {
    expectCorruptNumber(23, level::kId, 0, level::kErrorAt, value);
    expectCorruptNumber(23, level::kId, last, level::kErrorRmsAt, value);
  }
  expectCorruptNumber(23, level::kId, 1, level::kErrorAt, 1.5f);
  expectCorruptField(23, level::kId, last, level::kHiddenCountAt, fieldOf(level::kId, last, level::kFaceCountAt) + 1);
  expectCorruptField(23, level::kId, 0, level::kJointCountAt, countOf(joint::kId) + 1);
}

TEST(HeadCheck, N23_HiddenFacesOfAllLevelsBeyondThirtyTwoBits) {
  const LitheFile file = withChunks([](std::vector<FileChunk>& chunks) {
    FileChunk& levels = chunkIn(chunks, level::kId);
    uint8_t* info_record = chunkIn(chunks, info::kId).bytes.data();
    const uint32_t nodes = loadU32(info_record + info::kNodeCountAt),
                   wedges = loadU32(info_record + info::kWedgeCountAt);
    const FileBytes first(levels.bytes.begin(), levels.bytes.begin() + levels.record_bytes);
    const uint32_t pages = static_cast<uint32_t>(chunkIn(chunks, page::kId).bytes.size() / page::kBytes);
    levels.bytes.clear();
    for (uint32_t l = 0; l < limits::kLevels; ++l) {
      levels.bytes.insert(levels.bytes.end(), first.begin(), first.end());
      uint8_t* p = levels.bytes.data() + size_t{l} * levels.record_bytes;
      storeU32(p + level::kPageEndAt, l == 0 ? 1 : pages);
      storeU32(p + level::kNodeCountAt, nodes - (limits::kLevels - 1 - l));
      storeU32(p + level::kWedgeCountAt, wedges - (limits::kLevels - 1 - l));
      storeU32(p + level::kFaceCountAt, limits::kFaces);
      storeU32(p + level::kHiddenCountAt, limits::kFaces);
    }
    storeU32(info_record + info::kFaceCountAt, limits::kFaces);
  });
  expectHeadRefused(file, LITHE_ERROR_CORRUPT, 23);
}

TEST(HeadCheck, N24_PageEntry) {
  const uint32_t last = countOf(page::kId) - 1;
  for (const uint32_t size : {0u, limits::kPageBytes + 1, 0xffffffffu}) {
    expectCorruptField(24, page::kId, 0, page::kSizeAt, size);
    expectCorruptField(24, page::kId, last, page::kSizeAt, size);
  }
  expectCorruptField(24, page::kId, 0, page::kLevelAt, 1);
  expectCorruptField(24, page::kId, 1, page::kLevelAt, 0);
  expectCorruptField(24, page::kId, last, page::kLevelAt, 0xffffffffu);
}

TEST(HeadCheck, N25_PageCounts) {
  const uint32_t last = countOf(page::kId) - 1;
  for (const uint32_t at : {page::kNodeCountAt, page::kWedgeCountAt, page::kFaceCountAt}) {
    expectCorruptField(25, page::kId, 0, at, fieldOf(page::kId, 0, at) - 1);
    expectCorruptField(25, page::kId, last, at, fieldOf(page::kId, last, at) + 2);
    expectCorruptField(25, page::kId, last - 1, at, fieldOf(page::kId, last, at) + 2);
    expectCorruptField(25, page::kId, last, at, 0);
  }
}

/// A page that ends inside a level may have any even number of splits between its neighbours', and no other.
TEST(HeadCheck, N25_PageInsideALevel) {
  LitheFile file(richFile());
  uint32_t inside = 0;
  for (uint32_t p = 1; p + 1 < countOf(page::kId); ++p)
    if (fieldOf(page::kId, p, page::kLevelAt) == fieldOf(page::kId, p + 1, page::kLevelAt)) inside = p;
  ASSERT_GT(inside, 0u);
  const uint32_t nodes = fieldOf(page::kId, inside, page::kNodeCountAt);
  expectCorruptField(25, page::kId, inside, page::kNodeCountAt, nodes + 1);
  expectCorruptField(25, page::kId, inside, page::kNodeCountAt, fieldOf(page::kId, inside - 1, page::kNodeCountAt) - 2);
  expectCorruptField(25, page::kId, inside, page::kWedgeCountAt,
                     fieldOf(page::kId, inside - 1, page::kWedgeCountAt) - 1);
  expectCorruptField(25, page::kId, inside, page::kFaceCountAt, fieldOf(page::kId, inside + 1, page::kFaceCountAt) + 1);
}

TEST(HeadCheck, N26_PageLimits) {
  const uint32_t last = countOf(page::kId) - 1;
  for (const uint32_t max_fan : {(1u << 18) + 1, 0xffffffffu}) {
    expectRefusedAfter(LITHE_ERROR_LIMIT, 26,
                       [&](LitheFile& f) { storeU32(f.record(page::kId, last) + page::kMaxFanAt, max_fan); });
  }
  for (uint32_t p = 0; p <= last; ++p) {
    expectCorruptField(26, page::kId, p, page::kValuesAt, 0xffffffffu);
  }
}

TEST(HeadCheck, N26_BasePageWithTooManyWedges) {
  expectRefusedAfter(LITHE_ERROR_LIMIT, 26, [](LitheFile& f) {
    auto add = [&](uint8_t* at) { storeU32(at, loadU32(at) + limits::kBaseWedges); };
    add(f.record(info::kId) + info::kWedgeCountAt);
    for (uint32_t l = 0; l < countOf(level::kId); ++l) add(f.record(level::kId, l) + level::kWedgeCountAt);
    for (uint32_t p = 0; p < countOf(page::kId); ++p) add(f.record(page::kId, p) + page::kWedgeCountAt);
  });
}

TEST(HeadCheck, N27_Scales) {
  for (uint32_t i = 0; i < 6; ++i) {
    expectCorruptNumber(27, scale::kId, 0, scale::kDiagonalAt + 4 * i, kNan);
    expectCorruptNumber(27, scale::kId, 0, scale::kDiagonalAt + 4 * i, -kInfinity);
  }
}

}  // namespace
}  // namespace lithe::test
