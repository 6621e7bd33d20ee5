// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The tables of docs/format.md against the constants that the writer and the reader share: neither can drift alone.
#include "lithe/format/file.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <vector>

#include "spec_tables.h"

namespace lithe::format {
namespace {

using test::bytesOfType;
using test::numbersIn;
using test::spec;
using test::SpecRow;

struct Field {
  const char* name;
  uint32_t at;
};

/// Rows of (at, type, name, ...) are exactly these fields, each beginning where the one before ends, to the last byte.
void expectRecord(const std::vector<SpecRow>& rows, const std::vector<Field>& fields, uint32_t record_bytes) {
  ASSERT_EQ(rows.size(), fields.size());
  uint32_t end = 0;
  for (size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i][2], fields[i].name);
    EXPECT_EQ(rows[i][0], std::to_string(fields[i].at)) << fields[i].name;
    EXPECT_EQ(fields[i].at, end) << fields[i].name;
    // An empty type is that of the row above ("likewise").
    std::string type = rows[i][1];
    for (size_t above = i; type.empty() && above-- > 0;) type = rows[above][1];
    end += bytesOfType(type);
  }
  EXPECT_EQ(end, record_bytes);
}

/// Rows of one chunk of a table that begins with a column of chunks; that column is taken off.
std::vector<SpecRow> rowsOf(const std::vector<SpecRow>& table, const std::string& chunk) {
  std::vector<SpecRow> rows;
  std::string current;
  for (const SpecRow& row : table) {
    if (!row[0].empty()) current = row[0];
    if (current == chunk) rows.emplace_back(row.begin() + 1, row.end());
  }
  return rows;
}

/// What a heading says of a chunk between the parentheses after its id.
std::string statedOf(const std::string& heading, const std::string& chunk) {
  const size_t begin = heading.find(chunk + " (");
  if (begin == std::string::npos) return "";
  return heading.substr(begin, heading.find(')', begin) - begin);
}

TEST(FileSpecification, Version) {
  EXPECT_NE(spec()
                .line("Version ")
                .find("Version " + std::to_string(kVersionMajor) + "." + std::to_string(kVersionMinor) + "."),
            std::string::npos);
  const std::vector<SpecRow> rows = spec().table("Header");
  EXPECT_EQ(rows[1][3], std::to_string(kVersionMajor));
  EXPECT_EQ(rows[2][3], std::to_string(kVersionMinor));
}

TEST(FileSpecification, Magic) {
  std::string magic;
  for (uint8_t byte : kMagic) {
    char text[4];
    std::snprintf(text, sizeof text, "%02x ", static_cast<unsigned>(byte));
    magic += text;
  }
  magic.pop_back();
  EXPECT_EQ(spec().table("Header")[0][3], magic);
}

TEST(FileSpecification, Header) {
  expectRecord(spec().table("Header"),
               {{"magic", header::kMagicAt},
                {"version_major", header::kVersionMajorAt},
                {"version_minor", header::kVersionMinorAt},
                {"head_bytes", header::kHeadBytesAt},
                {"file_bytes", header::kFileBytesAt},
                {"checksum", header::kChecksumAt},
                {"chunk_count", header::kChunkCountAt},
                {"reserved", header::kReservedAt}},
               header::kBytes);
  EXPECT_EQ(numbersIn(spec().heading("Header")), std::vector<uint64_t>{header::kBytes});
}

TEST(FileSpecification, Directory) {
  expectRecord(spec().table("Directory entry"),
               {{"id", directory::kIdAt},
                {"flags", directory::kFlagsAt},
                {"record_bytes", directory::kRecordBytesAt},
                {"offset", directory::kOffsetAt},
                {"record_count", directory::kRecordCountAt}},
               directory::kBytes);
  EXPECT_EQ(numbersIn(spec().heading("Directory entry")), std::vector<uint64_t>{directory::kBytes});
}

TEST(FileSpecification, Info) {
  expectRecord(spec().table("INFO"),
               {{"grid_origin", info::kGridOriginAt},
                {"grid_step", info::kGridStepAt},
                {"position_bits", info::kPositionBitsAt},
                {"weight_bits", info::kWeightBitsAt},
                {"normal_bits", info::kNormalBitsAt},
                {"uv_bits", info::kUvBitsAt},
                {"max_influences", info::kMaxInfluencesAt},
                {"uv_sets", info::kUvSetsAt},
                {"color_sets", info::kColorSetsAt},
                {"attributes", info::kAttributesAt},
                {"placement_shift", info::kPlacementShiftAt},
                {"reserved", info::kReserved0At},
                {"node_count", info::kNodeCountAt},
                {"wedge_count", info::kWedgeCountAt},
                {"face_count", info::kFaceCountAt},
                {"rest_diagonal", info::kRestDiagonalAt},
                {"posed_diagonal", info::kPosedDiagonalAt},
                {"grid_min", info::kGridMinAt},
                {"grid_max", info::kGridMaxAt}},
               info::kBytes);
}

TEST(FileSpecification, SceneNode) {
  expectRecord(spec().table("NODE"),
               {{"name", node::kNameAt},
                {"parent", node::kParentAt},
                {"form", node::kFormAt},
                {"translation", node::kTranslationAt},
                {"rotation", node::kRotationAt}},
               node::kBytes);
}

TEST(FileSpecification, Joint) {
  expectRecord(spec().table("JOIN"),
               {{"node", joint::kNodeAt},
                {"form", joint::kFormAt},
                {"box_min", joint::kBoxMinAt},
                {"box_max", joint::kBoxMaxAt},
                {"translation", joint::kTranslationAt},
                {"rotation", joint::kRotationAt}},
               joint::kBytes);
}

TEST(FileSpecification, Scale) {
  expectRecord(spec().table("SCAL"), {{"diagonal", scale::kDiagonalAt}, {"shear", scale::kShearAt}}, scale::kBytes);
}

TEST(FileSpecification, MaterialPartAndUvGrid) {
  const std::vector<SpecRow> table = spec().table("MATL");
  expectRecord(rowsOf(table, "MATL"), {{"name", material::kNameAt}}, material::kBytes);
  expectRecord(rowsOf(table, "PART"),
               {{"name", part::kNameAt}, {"material", part::kMaterialAt}, {"rigid_node", part::kRigidNodeAt}},
               part::kBytes);
  expectRecord(rowsOf(table, "UVGR"), {{"offset", uv_grid::kOffsetAt}, {"scale", uv_grid::kScaleAt}}, uv_grid::kBytes);
}

TEST(FileSpecification, Level) {
  expectRecord(spec().table("LEVL"),
               {{"page_end", level::kPageEndAt},
                {"node_count", level::kNodeCountAt},
                {"wedge_count", level::kWedgeCountAt},
                {"face_count", level::kFaceCountAt},
                {"hidden_count", level::kHiddenCountAt},
                {"error", level::kErrorAt},
                {"error_rms", level::kErrorRmsAt},
                {"joint_count", level::kJointCountAt}},
               level::kBytes);
}

TEST(FileSpecification, Page) {
  expectRecord(spec().table("PAGE"),
               {{"size", page::kSizeAt},
                {"level", page::kLevelAt},
                {"checksum", page::kChecksumAt},
                {"node_count", page::kNodeCountAt},
                {"wedge_count", page::kWedgeCountAt},
                {"face_count", page::kFaceCountAt},
                {"values", page::kValuesAt},
                {"max_fan", page::kMaxFanAt}},
               page::kBytes);
}

TEST(FileSpecification, RecordSizesAndLimitsOfTheHeadings) {
  struct Stated {
    const char* heading;
    const char* chunk;
    std::vector<uint64_t> numbers;
  };
  const Stated all[] = {
      {"INFO", "INFO", {info::kBytes}},
      {"NODE", "NODE", {node::kBytes, limits::kSceneNodes}},
      {"JOIN", "JOIN", {joint::kBytes, limits::kJoints}},
      {"SCAL", "SCAL", {scale::kBytes, limits::kScales}},
      {"MATL", "MATL", {material::kBytes, limits::kMaterials}},
      {"MATL", "PART", {part::kBytes, 1, limits::kParts}},
      {"MATL", "UVGR", {uv_grid::kBytes}},
      {"LEVL", "LEVL", {level::kBytes, 1, limits::kLevels}},
      {"PAGE", "PAGE", {page::kBytes, 1, limits::kPages}},
  };
  for (const Stated& stated : all)
    EXPECT_EQ(numbersIn(statedOf(spec().heading(stated.heading), stated.chunk)), stated.numbers) << stated.chunk;
}

/// The note of a field, from the last column of its table.
std::string noteOf(const std::string& heading, const std::string& field) {
  for (const SpecRow& row : spec().table(heading))
    if (row[2] == field) return row[3];
  ADD_FAILURE() << heading << " has no " << field;
  return "";
}

TEST(FileSpecification, LimitsOfTheFields) {
  EXPECT_NE(noteOf("Header", "head_bytes").find("64 .. " + std::to_string(limits::kHeadBytes >> 20) + " MiB"),
            std::string::npos);
  EXPECT_EQ(numbersIn(noteOf("Header", "chunk_count")), std::vector<uint64_t>{limits::kChunks});
  EXPECT_EQ(numbersIn(noteOf("INFO", "max_influences")), (std::vector<uint64_t>{1, limits::kInfluences}));
  EXPECT_EQ(numbersIn(noteOf("INFO", "uv_sets")), (std::vector<uint64_t>{0, limits::kUvSets}));
  EXPECT_EQ(numbersIn(noteOf("INFO", "color_sets")), (std::vector<uint64_t>{0, limits::kColorSets}));
  EXPECT_EQ(numbersIn(noteOf("PAGE", "size")).at(1), limits::kPageBytes >> 20);
  const auto isPower = [](const std::string& note, uint64_t limit) {
    const std::vector<uint64_t> numbers = numbersIn(note);
    return numbers.size() >= 2 && numbers[0] == 2 && uint64_t{1} << numbers[1] == limit;
  };
  EXPECT_TRUE(isPower(noteOf("INFO", "node_count"), limits::kNodes));
  EXPECT_EQ(limits::kWedges, limits::kNodes);
  EXPECT_EQ(limits::kFaces, limits::kNodes);
  EXPECT_TRUE(isPower(noteOf("PAGE", "max_fan"), limits::kFan));
  const std::string base = spec().line("Page 0 is level 0's only page");
  EXPECT_TRUE(isPower(base.substr(base.find("at most")), limits::kBaseWedges));
}

TEST(FileSpecification, ChunkIdsAreTheirLettersLowestFirst) {
  EXPECT_EQ(info::kId, 0x4f464e49u);
  const uint32_t ids[] = {info::kId, node::kId,    joint::kId, scale::kId, material::kId,
                          part::kId, uv_grid::kId, level::kId, page::kId,  names::kId};
  const char* letters[] = {"INFO", "NODE", "JOIN", "SCAL", "MATL", "PART", "UVGR", "LEVL", "PAGE", "NAME"};
  for (size_t i = 0; i < std::size(ids); ++i) {
    const char* l = letters[i];
    EXPECT_EQ(ids[i], chunkId(l[0], l[1], l[2], l[3])) << l;
    for (size_t k = 0; k < i; ++k) EXPECT_NE(ids[i], ids[k]);
  }
}

}  // namespace
}  // namespace lithe::format
