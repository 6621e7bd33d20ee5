// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The head of a written file, byte by byte.
#include "file_writer.h"

#include <gtest/gtest.h>
#include <xxhash.h>

#include <map>

#include "lithe/format/bytes.h"
#include "lithe/format/file.h"
#include "small_mesh.h"

namespace lithe::bake {
namespace {

namespace format = lithe::format;
using format::loadF32;
using format::loadU16;
using format::loadU32;
using format::loadU64;

/// A character with something in every table: two parts, shared and empty names, a joint without vertices.
class FileWriter : public testing::Test {
 protected:
  void SetUp() override {
    mesh_ = test::tetrahedron();
    mesh_.attributes = {true, false, 2, 1};
    mesh_.wedge_normal.assign(4, {3, 4});
    for (auto& uv : mesh_.wedge_uv) uv.assign(4, {1, 2});
    mesh_.wedge_color[0].assign(4, {1, 2, 3, 4});
    mesh_.part_uv.resize(2);
    mesh_.part_uv[1][1] = {glm::dvec2(0.25, -0.5), 0.125};
    mesh_.grid = {glm::dvec3(-1.0, 2.0, 0.5), 0.25, 13};
    mesh_.weight_one = 511;
    mesh_.max_influences = 3;
    for (auto& skin : mesh_.skins) skin = test::skinOf({{0, 511}});
    mesh_.skins[3] = test::skinOf({{2, 300}, {0, 211}});
    model_.nodes = {{"hips", kNone, {}},
                    {"", 0, {glm::dvec3(1, 2, 3), glm::dquat(0.5, -0.5, 0.5, -0.5), glm::dvec3(2)}}};
    model_.joints = {{0, glm::dmat4(1.0)}, {1, glm::dmat4(1.0)}, {1, glm::dmat4(1.0)}};
    model_.joints[2].inverse_bind[3] = {7, 8, 9, 1};
    model_.materials = {"hips", "cloth"};
    model_.parts = {{"shirt", 1, kNone, 0, 0}, {"hat", kNone, 1, 0, 1}};
    model_.rest_diagonal = 12.5;
    hierarchy_ = buildHierarchy(mesh_, {}, 31);
    levels_ = {{1, 2, 3, 4, 0, 2, 0.5, 0.25}, {2, 4, 5, 6, 1, 3, 0.125, 0.0625}};
    pages_ = {{0, 2, 3, 4, 100, 7, {1, 2, 3}}, {1, 4, 5, 6, 200, 9, {4, 5, 6, 7, 8}}};
    write();
  }

  void write() {
    const EncodeInput input{model_, mesh_, hierarchy_, {}, 31, 15.0};
    file_ = writeFile(input, levels_, pages_, &head_bytes_);
    chunks_.clear();
    const uint8_t* p = file_.data();
    for (uint32_t i = 0; i < loadU32(p + format::header::kChunkCountAt); ++i) {
      const uint8_t* entry = p + format::header::kBytes + i * format::directory::kBytes;
      chunks_[loadU32(entry + format::directory::kIdAt)] = entry;
    }
  }

  const uint8_t* record(uint32_t id, uint32_t index) const {
    const uint8_t* entry = chunks_.at(id);
    return file_.data() + loadU32(entry + format::directory::kOffsetAt) +
           size_t{index} * loadU16(entry + format::directory::kRecordBytesAt);
  }
  uint32_t records(uint32_t id) const { return loadU32(chunks_.at(id) + format::directory::kRecordCountAt); }
  std::string name(uint32_t offset) const { return reinterpret_cast<const char*>(record(format::names::kId, offset)); }

  Model model_;
  Mesh mesh_;
  Hierarchy hierarchy_;
  std::vector<LevelEntry> levels_;
  std::vector<PageEntry> pages_;
  std::vector<uint8_t> file_;
  uint64_t head_bytes_ = 0;
  std::map<uint32_t, const uint8_t*> chunks_;
};

TEST_F(FileWriter, HeaderStatesTheFile) {
  const uint8_t* p = file_.data();
  EXPECT_TRUE(std::equal(std::begin(format::kMagic), std::end(format::kMagic), p));
  EXPECT_EQ(loadU16(p + format::header::kVersionMajorAt), format::kVersionMajor);
  EXPECT_EQ(loadU16(p + format::header::kVersionMinorAt), format::kVersionMinor);
  EXPECT_EQ(loadU32(p + format::header::kHeadBytesAt), head_bytes_);
  EXPECT_EQ(loadU64(p + format::header::kFileBytesAt), file_.size());
  EXPECT_EQ(file_.size(), head_bytes_ + 8);
  EXPECT_EQ(head_bytes_ % 8, 0u);
  for (uint32_t i = format::header::kReservedAt; i < format::header::kBytes; ++i) EXPECT_EQ(p[i], 0);
}

TEST_F(FileWriter, ChecksumIsThatOfTheHeadWithoutIt) {
  std::vector<uint8_t> head(file_.begin(), file_.begin() + static_cast<std::ptrdiff_t>(head_bytes_));
  format::storeU64(head.data() + format::header::kChecksumAt, 0);
  EXPECT_EQ(loadU64(file_.data() + format::header::kChecksumAt), XXH64(head.data(), head.size(), 0));
}

TEST_F(FileWriter, ChunksLieInOrderAlignedWithZerosBetweenThem) {
  EXPECT_EQ(chunks_.size(), 10u);
  size_t end = format::header::kBytes + 10 * format::directory::kBytes;
  for (uint32_t i = 0; i < 10; ++i) {
    const uint8_t* entry = file_.data() + format::header::kBytes + i * format::directory::kBytes;
    const uint32_t offset = loadU32(entry + format::directory::kOffsetAt);
    EXPECT_EQ(loadU16(entry + format::directory::kFlagsAt), 0u);
    EXPECT_EQ(offset % 8, 0u);
    ASSERT_GE(offset, end);
    EXPECT_LT(offset - end, 8u);
    for (; end < offset; ++end) EXPECT_EQ(file_[end], 0);
    end +=
        size_t{loadU16(entry + format::directory::kRecordBytesAt)} * loadU32(entry + format::directory::kRecordCountAt);
  }
  EXPECT_LE(end, head_bytes_);
  EXPECT_LT(head_bytes_ - end, 8u);
}

TEST_F(FileWriter, InfoIsTheMesh) {
  const uint8_t* p = record(format::info::kId, 0);
  EXPECT_EQ(records(format::info::kId), 1u);
  EXPECT_EQ(loadF32(p + format::info::kGridOriginAt + 4), 2.0f);
  EXPECT_EQ(loadF32(p + format::info::kGridStepAt), 0.25f);
  EXPECT_EQ(p[format::info::kPositionBitsAt], 13);
  EXPECT_EQ(p[format::info::kWeightBitsAt], 9);
  EXPECT_EQ(p[format::info::kNormalBitsAt], mesh_.normal_bits);
  EXPECT_EQ(p[format::info::kUvBitsAt], mesh_.uv_bits);
  EXPECT_EQ(p[format::info::kMaxInfluencesAt], 3);
  EXPECT_EQ(p[format::info::kUvSetsAt], 2);
  EXPECT_EQ(p[format::info::kColorSetsAt], 1);
  EXPECT_EQ(p[format::info::kAttributesAt], format::info::kHasNormals);
  EXPECT_EQ(p[format::info::kPlacementShiftAt], 31);
  EXPECT_EQ(loadU32(p + format::info::kNodeCountAt), 4u);
  EXPECT_EQ(loadU32(p + format::info::kWedgeCountAt), 5u);
  EXPECT_EQ(loadU32(p + format::info::kFaceCountAt), 6u);
  EXPECT_EQ(loadF32(p + format::info::kRestDiagonalAt), 12.5f);
  EXPECT_EQ(loadF32(p + format::info::kPosedDiagonalAt), 15.0f);
  for (uint32_t axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(loadU32(p + format::info::kGridMinAt + 4 * axis), 0u);
    EXPECT_EQ(loadU32(p + format::info::kGridMaxAt + 4 * axis), 8u);
  }
}

TEST_F(FileWriter, SceneNodesAndTheirNames) {
  ASSERT_EQ(records(format::node::kId), 2u);
  const uint8_t *hips = record(format::node::kId, 0), *child = record(format::node::kId, 1);
  EXPECT_EQ(name(loadU32(hips + format::node::kNameAt)), "hips");
  EXPECT_EQ(name(loadU32(child + format::node::kNameAt)), "");
  EXPECT_EQ(loadU16(hips + format::node::kParentAt), format::node::kNoParent);
  EXPECT_EQ(loadU16(child + format::node::kParentAt), 0u);
  EXPECT_EQ(loadF32(child + format::node::kTranslationAt + 8), 3.0f);
  const uint32_t form = loadU16(child + format::node::kFormAt);
  EXPECT_EQ(format::formLeftOut(form), 3u);
  const float x_y_z[] = {-0.5f, 0.5f, -0.5f};
  const uint64_t fields = loadU64(child + format::node::kRotationAt);
  for (uint32_t i = 0; i < 3; ++i) EXPECT_NEAR(format::rotationComponent(fields, i), x_y_z[i], 3.6e-7f) << i;
  EXPECT_EQ(records(format::scale::kId), 2u);
  const float twice[] = {2, 2, 2, 0, 0, 0};
  for (uint32_t i = 0; i < 6; ++i)
    EXPECT_EQ(loadF32(record(format::scale::kId, format::formScale(form)) + 4 * i), twice[i]) << i;
}

TEST_F(FileWriter, JointsHaveTheBoxOfWhatTheyInfluence) {
  ASSERT_EQ(records(format::joint::kId), 3u);
  // A grid of 13 bits has cells of 32 points.
  for (glm::ivec3& position : hierarchy_.position) position *= 100;
  write();
  const uint8_t boxes[3][6] = {{0, 0, 0, 25, 25, 25}, {255, 255, 255, 0, 0, 0}, {0, 0, 25, 0, 0, 25}};
  for (uint32_t j = 0; j < 3; ++j) {
    const uint8_t* p = record(format::joint::kId, j);
    EXPECT_EQ(loadU16(p + format::joint::kNodeAt), model_.joints[j].node);
    for (uint32_t i = 0; i < 6; ++i) EXPECT_EQ(p[format::joint::kBoxMinAt + i], boxes[j][i]) << j << i;
  }
  const uint8_t* shifted = record(format::joint::kId, 2);
  for (uint32_t i = 0; i < 3; ++i) {
    EXPECT_EQ(loadF32(shifted + format::joint::kTranslationAt + 4 * i), 7.0f + static_cast<float>(i));
    EXPECT_EQ(format::rotationComponent(loadU64(shifted + format::joint::kRotationAt), i), 0.0f);
  }
  EXPECT_EQ(loadU16(shifted + format::joint::kFormAt), loadU16(record(format::node::kId, 0) + format::node::kFormAt));
}

TEST_F(FileWriter, MaterialsPartsAndUvGrids) {
  ASSERT_EQ(records(format::material::kId), 2u);
  const uint32_t hips = loadU32(record(format::material::kId, 0));
  EXPECT_EQ(hips, loadU32(record(format::node::kId, 0) + format::node::kNameAt)) << "a name is stored once";
  EXPECT_EQ(name(loadU32(record(format::material::kId, 1))), "cloth");
  ASSERT_EQ(records(format::part::kId), 2u);
  const uint8_t *shirt = record(format::part::kId, 0), *hat = record(format::part::kId, 1);
  EXPECT_EQ(name(loadU32(shirt + format::part::kNameAt)), "shirt");
  EXPECT_EQ(loadU32(shirt + format::part::kMaterialAt), 1u);
  EXPECT_EQ(loadU32(shirt + format::part::kRigidNodeAt), format::kNoIndex);
  EXPECT_EQ(loadU32(hat + format::part::kMaterialAt), format::kNoIndex);
  EXPECT_EQ(loadU32(hat + format::part::kRigidNodeAt), 1u);
  ASSERT_EQ(records(format::uv_grid::kId), 4u);
  const uint8_t* last = record(format::uv_grid::kId, 3);
  EXPECT_EQ(loadF32(last + format::uv_grid::kOffsetAt), 0.25f);
  EXPECT_EQ(loadF32(last + format::uv_grid::kOffsetAt + 4), -0.5f);
  EXPECT_EQ(loadF32(last + format::uv_grid::kScaleAt), 0.125f);
}

TEST_F(FileWriter, LevelsAndPagesAreWhatTheyWereSaidToBe) {
  ASSERT_EQ(records(format::level::kId), 2u);
  const uint8_t* level = record(format::level::kId, 1);
  const uint32_t counts[] = {2, 4, 5, 6, 1};
  for (uint32_t i = 0; i < 5; ++i) EXPECT_EQ(loadU32(level + format::level::kPageEndAt + 4 * i), counts[i]) << i;
  EXPECT_EQ(loadF32(level + format::level::kErrorAt), 0.125f);
  EXPECT_EQ(loadF32(level + format::level::kErrorRmsAt), 0.0625f);
  EXPECT_EQ(loadU32(level + format::level::kJointCountAt), 3u);
  ASSERT_EQ(records(format::page::kId), 2u);
  uint64_t at = head_bytes_;
  for (uint32_t i = 0; i < 2; ++i) {
    const uint8_t* page = record(format::page::kId, i);
    const uint32_t size = loadU32(page + format::page::kSizeAt);
    ASSERT_EQ(size, pages_[i].bytes.size());
    EXPECT_TRUE(std::equal(pages_[i].bytes.begin(), pages_[i].bytes.end(), file_.data() + at));
    EXPECT_EQ(loadU64(page + format::page::kChecksumAt), XXH64(file_.data() + at, size, 0));
    EXPECT_EQ(loadU32(page + format::page::kLevelAt), pages_[i].level);
    EXPECT_EQ(loadU32(page + format::page::kNodeCountAt), pages_[i].node_count);
    EXPECT_EQ(loadU32(page + format::page::kWedgeCountAt), pages_[i].wedge_count);
    EXPECT_EQ(loadU32(page + format::page::kFaceCountAt), pages_[i].face_count);
    EXPECT_EQ(loadU32(page + format::page::kValuesAt), pages_[i].values);
    EXPECT_EQ(loadU32(page + format::page::kMaxFanAt), pages_[i].max_fan);
    at += size;
  }
  EXPECT_EQ(at, file_.size());
}

TEST_F(FileWriter, ANameEndsAtItsFirstZero) {
  model_.parts[0].name = std::string("a\0b", 3);
  write();
  EXPECT_EQ(name(loadU32(record(format::part::kId, 0) + format::part::kNameAt)), "a");
  EXPECT_EQ(file_[head_bytes_ - 1], 0);
}

TEST_F(FileWriter, RefusesWhatTheFormatCannotHold) {
  const auto sentence = [&] {
    try {
      write();
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  levels_.resize(65, levels_.back());
  EXPECT_EQ(sentence(), "the file format holds at most 64 levels, this character has 65");
  levels_.resize(2);
  model_.materials.resize(4097);
  EXPECT_EQ(sentence(), "the file format holds at most 4096 materials, this character has 4097");
  model_.materials.resize(1);
  pages_[1].max_fan = (1 << 18) + 1;
  EXPECT_EQ(sentence(), "the file format holds at most 262144 faces at one vertex, this character has 262145");
}

}  // namespace
}  // namespace lithe::bake
