// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// A small file damaged everywhere: cut, flipped, its numbers driven to their ends, its pages exchanged. What comes out
// is an error or a coarser level of the same character; driveAsset aborts on anything that could not be drawn.
#include "asset.h"
#include "refusals.h"

namespace lithe::test {
namespace {

using namespace format;  // NOLINT: the records' field names

/// Memory that a damaged small file may not ask for in vain: more is refused by the host.
constexpr size_t kMemory = 64u << 20;

/// Whatever is resident of a damaged file is what the sound one has at these levels.
void expectCoarser(const Outcome& outcome, const Outcome& sound) {
  ASSERT_LE(outcome.levels.size(), sound.levels.size());
  for (size_t level = 0; level < outcome.levels.size(); ++level)
    EXPECT_TRUE(outcome.levels[level] == sound.levels[level]) << "level " << level;
}

/// An opened sound file with its first pages supplied.
struct OpenFile {
  OpenFile(const FileBytes& bytes, uint32_t pages) : file(bytes) {
    const lithe_allocator allocator = memory.get();
    EXPECT_EQ(lithe_asset_open(&allocator, file.head.data(), file.head.size(), nullptr, &asset), LITHE_OK);
    lithe_asset_describe(asset, &info);
    for (uint32_t p = 0; p < pages; ++p) EXPECT_EQ(supply(p, file.pages[p]), LITHE_OK);
  }
  ~OpenFile() { lithe_asset_close(asset); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  lithe_result supply(uint32_t page, const FileBytes& from) {
    return lithe_asset_supply(asset, page, from.data(), from.size(), nullptr);
  }
  LevelHashes finest() const { return drawLevel(asset, info, lithe_asset_resident_level(asset)); }

  LitheFile file;
  BoundedAllocator memory;
  lithe_asset* asset = nullptr;
  lithe_asset_info info = {};
};

class WholeFile : public testing::Test {
 protected:
  const FileBytes& bytes = tinyFile();
  const Outcome sound = outcomeOf(bytes);
};

TEST_F(WholeFile, EveryPrefixIsAnErrorOrACoarserLevel) {
  ASSERT_EQ(sound.result, LITHE_OK);
  size_t levels = 0;
  for (size_t size = 0; size < bytes.size(); ++size) {
    const FileBytes prefix(bytes.begin(), bytes.begin() + static_cast<int64_t>(size));
    const Outcome outcome = outcomeOf(prefix);
    ASSERT_EQ(outcome.result, LITHE_ERROR_TRUNCATED) << size;
    ASSERT_GE(outcome.levels.size(), levels);
    ASSERT_LT(outcome.levels.size(), sound.levels.size());
    expectCoarser(outcome, sound);
    levels = outcome.levels.size();
  }
  EXPECT_GT(levels, 2u);
}

TEST_F(WholeFile, EveryBitOfTheHeadIsGuarded) {
  const size_t head_bytes = LitheFile(bytes).head.size();
  for (size_t at = 0; at < head_bytes; ++at)
    for (uint32_t bit = 0; bit < 8; ++bit) {
      FileBytes broken(bytes.begin(), bytes.begin() + static_cast<int64_t>(head_bytes));
      broken[at] ^= static_cast<uint8_t>(1u << bit);
      const Outcome outcome = outcomeOf(broken);
      ASSERT_GE(outcome.result, LITHE_ERROR_TRUNCATED) << at << " bit " << bit;
      ASSERT_LE(outcome.diagnosis.check, 5u);
      ASSERT_TRUE(outcome.levels.empty());
    }
}

TEST_F(WholeFile, EveryByteOfThePagesIsGuarded) {
  const uint32_t pages = static_cast<uint32_t>(LitheFile(bytes).pages.size());
  OpenFile open(bytes, 0);
  for (uint32_t page = 0; page < pages; ++page) {
    FileBytes broken = open.file.pages[page];
    for (uint8_t& byte : broken)
      for (const uint8_t pattern : {uint8_t{1}, uint8_t{0x80}, uint8_t{0xff}}) {
        byte ^= pattern;
        ASSERT_EQ(open.supply(page, broken), LITHE_ERROR_CORRUPT);
        byte ^= pattern;
      }
    ASSERT_EQ(open.supply(page, open.file.pages[page]), LITHE_OK);
  }
  EXPECT_TRUE(open.finest() == sound.levels.back());
}

// With hashes that hold, only the checks behind them are left between the bytes and the host.
TEST_F(WholeFile, FlippedHeadsUnderATrueChecksum) {
  const size_t head_bytes = LitheFile(bytes).head.size();
  uint32_t opened = 0, refused = 0;
  for (size_t at = 0; at < head_bytes; ++at) {
    // head_bytes must stay within the bytes for the checksum to be made.
    if (at >= header::kHeadBytesAt && at < header::kHeadBytesAt + 4) continue;
    for (const uint8_t pattern : {uint8_t{1}, uint8_t{0x10}, uint8_t{0x80}, uint8_t{0xff}}) {
      LitheFile file(bytes);
      file.head[at] ^= pattern;
      const Outcome outcome = outcomeOf(file.bytes(), kMemory);
      ++(outcome.result == LITHE_OK ? opened : refused);
    }
  }
  EXPECT_GT(opened, 0u);  // names, numbers of the scene
  EXPECT_GT(refused, opened);
}

TEST_F(WholeFile, FlippedPagesUnderTrueChecksums) {
  uint32_t refused = 0, tried = 0;
  const LitheFile whole(bytes);
  for (uint32_t page = 0; page < whole.pages.size(); ++page)
    for (size_t at = 0; at < whole.pages[page].size(); ++at)
      for (const uint8_t pattern : {uint8_t{1}, uint8_t{0x80}}) {
        LitheFile file(bytes);
        file.pages[page][at] ^= pattern;
        file.sealPages();
        ++tried;
        refused += outcomeOf(file.bytes(), kMemory).result != LITHE_OK;
      }
  EXPECT_GT(refused, tried / 2);
}

/// Every number of a file's tables that counts, places or sizes something.
struct Field {
  uint32_t chunk, at, bytes;
};
constexpr Field kFields[] = {{info::kId, info::kNodeCountAt, 4},      {info::kId, info::kWedgeCountAt, 4},
                             {info::kId, info::kFaceCountAt, 4},      {info::kId, info::kPositionBitsAt, 1},
                             {info::kId, info::kWeightBitsAt, 1},     {info::kId, info::kNormalBitsAt, 1},
                             {info::kId, info::kUvBitsAt, 1},         {info::kId, info::kMaxInfluencesAt, 1},
                             {info::kId, info::kUvSetsAt, 1},         {info::kId, info::kColorSetsAt, 1},
                             {info::kId, info::kPlacementShiftAt, 1}, {node::kId, node::kNameAt, 4},
                             {node::kId, node::kParentAt, 4},         {joint::kId, joint::kNodeAt, 4},
                             {material::kId, material::kNameAt, 4},   {part::kId, part::kNameAt, 4},
                             {part::kId, part::kMaterialAt, 4},       {part::kId, part::kRigidNodeAt, 4},
                             {level::kId, level::kPageEndAt, 4},      {level::kId, level::kNodeCountAt, 4},
                             {level::kId, level::kWedgeCountAt, 4},   {level::kId, level::kFaceCountAt, 4},
                             {level::kId, level::kHiddenCountAt, 4},  {level::kId, level::kJointCountAt, 4},
                             {page::kId, page::kSizeAt, 4},           {page::kId, page::kLevelAt, 4},
                             {page::kId, page::kNodeCountAt, 4},      {page::kId, page::kWedgeCountAt, 4},
                             {page::kId, page::kFaceCountAt, 4},      {page::kId, page::kValuesAt, 4},
                             {page::kId, page::kMaxFanAt, 4}};

constexpr uint32_t kEnds[] = {0, 1, 0x7fffffffu, 0x80000000u, 0xfffffffeu, 0xffffffffu, 1u << 26, 1u << 18};

void setField(uint8_t* at, uint32_t bytes, uint32_t value) {
  if (bytes == 1) *at = static_cast<uint8_t>(value);
  if (bytes == 4) storeU32(at, value);
}

TEST_F(WholeFile, EveryNumberOfTheTablesAtItsEnds) {
  for (const Field& field : kFields) {
    const uint32_t records = LitheFile(bytes).chunk(field.chunk).record_count;
    for (uint32_t record = 0; record < records; ++record)
      for (const uint32_t value : kEnds) {
        LitheFile file(bytes);
        setField(file.record(field.chunk, record) + field.at, field.bytes, value);
        outcomeOf(file.bytes(), kMemory);
      }
  }
}

TEST_F(WholeFile, EveryNumberOfTheDirectoryAtItsEnds) {
  for (uint32_t entry = 0; entry < LitheFile(bytes).chunks().size(); ++entry)
    for (uint32_t at = 0; at < directory::kBytes; at += 4)
      for (const uint32_t value : kEnds) {
        LitheFile file(bytes);
        uint8_t* number = file.head.data() + header::kBytes + entry * directory::kBytes + at;
        if (loadU32(number) == value) continue;
        storeU32(number, value);
        EXPECT_TRUE(outcomeOf(file.bytes(), kMemory).levels.empty() || value <= 1 || at == directory::kRecordCountAt);
      }
}

// ---- Memory --------------------------------------------------------------------------------------------------------

/// What opening a head may ask for: its copy, and the object with 8 bytes per page and 12 per uv grid.
size_t openBound(const LitheFile& file) {
  return file.head.size() + sizeof(lithe_asset) + 8 * (size_t{file.chunk(page::kId).record_count} + 1) +
         sizeof(runtime::UvGrid) * file.chunk(uv_grid::kId).record_count;
}

/// No call asks for more than opening's bound and what lithe_asset_memory states for the finest level.
void expectBounded(const LitheFile& file, size_t open_bound) {
  const FileBytes file_bytes = file.bytes();
  BoundedAllocator memory(kMemory);
  const lithe_allocator allocator = memory.get();
  lithe_asset* asset = nullptr;
  if (lithe_asset_open(&allocator, file_bytes.data(), file_bytes.size(), nullptr, &asset) != LITHE_OK) {
    // Only the copy of the bytes that are there comes before the checks.
    EXPECT_LE(memory.asked, file.head.size());
    EXPECT_LE(memory.calls, 1u);
    return;
  }
  EXPECT_LE(memory.asked, open_bound);
  lithe_asset_info info;
  lithe_asset_describe(asset, &info);
  Outcome outcome;
  supplyAll(asset, info, file_bytes.data(), file_bytes.size(), &outcome);
  EXPECT_LE(memory.asked, open_bound + lithe_asset_memory(asset, info.level_count - 1));
  lithe_asset_close(asset);
}

TEST_F(WholeFile, NoHeadAsksForMoreThanItsCountsState) {
  const size_t open_bound = openBound(LitheFile(bytes));
  expectBounded(LitheFile(bytes), open_bound);
  for (const Field& field : kFields)
    for (const uint32_t value : kEnds) {
      LitheFile file(bytes);
      setField(file.record(field.chunk, 0) + field.at, field.bytes, value);
      expectBounded(file, open_bound);
    }
}

TEST_F(WholeFile, TheStatedMemoryIsWhatIsHeld) {
  BoundedAllocator memory;
  const lithe_allocator allocator = memory.get();
  lithe_asset* asset = nullptr;
  ASSERT_EQ(lithe_asset_open(&allocator, bytes.data(), bytes.size(), nullptr, &asset), LITHE_OK);
  EXPECT_EQ(memory.held, openBound(LitheFile(bytes)));
  lithe_asset_info info;
  lithe_asset_describe(asset, &info);
  const size_t opened = memory.held;
  for (uint32_t level = 0; level < info.level_count; ++level) {
    lithe_request request;
    while (lithe_asset_next_request(asset, level, &request) == LITHE_OK)
      ASSERT_EQ(lithe_asset_supply(asset, request.page, bytes.data() + request.offset, request.size, nullptr),
                LITHE_OK);
    EXPECT_LE(memory.peak - opened, lithe_asset_memory(asset, level)) << "level " << level;
  }
  lithe_asset_close(asset);
}

// ---- Pages in the wrong place --------------------------------------------------------------------------------------

TEST_F(WholeFile, PagesOutOfOrderAreNotKept) {
  for (uint32_t next = 0; next < LitheFile(bytes).pages.size(); ++next) {
    OpenFile open(bytes, next);
    for (uint32_t page = next + 1; page < open.file.pages.size(); ++page)
      EXPECT_EQ(open.supply(page, open.file.pages[page]), LITHE_PENDING);
    for (uint32_t page = next; page < open.file.pages.size(); ++page)
      ASSERT_EQ(open.supply(page, open.file.pages[page]), LITHE_OK);
    EXPECT_TRUE(open.finest() == sound.levels.back());
  }
}

TEST_F(WholeFile, RepeatedPagesChangeNothing) {
  OpenFile open(bytes, static_cast<uint32_t>(LitheFile(bytes).pages.size()));
  for (uint32_t page = 0; page < open.file.pages.size(); ++page)
    EXPECT_EQ(open.supply(page, open.file.pages[page]), LITHE_OK);
  EXPECT_TRUE(open.finest() == sound.levels.back());
}

TEST_F(WholeFile, SwappedPagesAreRefused) {
  const uint32_t pages = static_cast<uint32_t>(LitheFile(bytes).pages.size());
  for (uint32_t next = 0; next < pages; ++next) {
    OpenFile open(bytes, next);
    for (uint32_t other = 0; other < pages; ++other) {
      if (other == next) continue;
      EXPECT_GE(open.supply(next, open.file.pages[other]), LITHE_ERROR_TRUNCATED);
    }
    ASSERT_EQ(open.supply(next, open.file.pages[next]), LITHE_OK);
  }
}

TEST_F(WholeFile, PagesOfAnotherFileAreRefused) {
  LitheFile other(otherTinyFile());
  for (uint32_t next = 0; next < LitheFile(bytes).pages.size(); ++next) {
    OpenFile open(bytes, next);
    FileBytes page = other.pages[std::min<size_t>(next, other.pages.size() - 1)];
    EXPECT_GE(open.supply(next, page), LITHE_ERROR_TRUNCATED);
    page.resize(open.file.pages[next].size());
    EXPECT_EQ(open.supply(next, page), LITHE_ERROR_CORRUPT);
    ASSERT_EQ(open.supply(next, open.file.pages[next]), LITHE_OK);
  }
}

// Under true hashes and tables: a page may fit by its counts alone, and then still has to make sense.
TEST_F(WholeFile, PagesOfAnotherFileUnderTrueChecksums) {
  LitheFile other(otherTinyFile());
  for (uint32_t page = 0; page < other.pages.size(); ++page)
    for (uint32_t place = 0; place < LitheFile(bytes).pages.size(); ++place) {
      LitheFile file(bytes);
      file.pages[place] = other.pages[page];
      storeU32(file.record(page::kId, place) + page::kValuesAt,
               loadU32(other.record(page::kId, page) + page::kValuesAt));
      file.sealPages();
      const Outcome outcome = outcomeOf(file.bytes(), kMemory);
      EXPECT_TRUE(outcome.result == LITHE_OK || outcome.diagnosis.check > 0);
    }
}

}  // namespace
}  // namespace lithe::test
