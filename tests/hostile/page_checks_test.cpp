// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Every reader check of docs/format.md that concerns pages: a sound page breaks exactly that rule, under true
// checksums and true tables. The tests have the checks' numbers.
#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "page_editor.h"
#include "refusals.h"

namespace lithe::test {
namespace {

using namespace format;  // NOLINT: the streams' names

/// Beyond every range that a page has, whatever low bits follow it.
constexpr int32_t kFar = 1 << 16;

/// Attributes of the streams, as docs/format.md lists them.
enum BaseNodesAttribute : uint32_t { kNodePosition, kNodeWedges, kNodeInfluences };
enum InfluencesAttribute : uint32_t { kJoint, kWeight };

uint32_t pageCount(const LitheFile& file) { return static_cast<uint32_t>(file.pages.size()); }

/// A page of a sound file after a change of its streams.
template <typename Change>
void expectRefusedAfter(const FileBytes& bytes, uint32_t page, uint32_t check, const Change& change) {
  LitheFile file(bytes);
  PageEditor editor(file, page);
  change(editor);
  editor.apply();
  expectPageRefused(file, page, LITHE_ERROR_CORRUPT, check);
}

/// The first split page for which `has(editor)` is true; 0 when there is none.
template <typename Has>
uint32_t pageWhere(const FileBytes& bytes, const Has& has) {
  LitheFile file(bytes);
  for (uint32_t page = 1; page < pageCount(file); ++page) {
    PageEditor editor(file, page);
    if (has(editor)) return page;
  }
  return 0;
}

uint32_t pageWithStream(const FileBytes& bytes, uint32_t stream) {
  return pageWhere(bytes, [&](PageEditor& e) { return e.data.streams[stream].records() > 0; });
}

/// Changes the first value of a stream where there is one.
void expectRefusedWithFirst(uint32_t stream, uint32_t attribute, int32_t value, uint32_t check) {
  SCOPED_TRACE("stream " + std::to_string(stream) + " attribute " + std::to_string(attribute));
  const uint32_t page = pageWithStream(richFile(), stream);
  ASSERT_GT(page, 0u);
  expectRefusedAfter(richFile(), page, check, [&](PageEditor& e) { e.values(stream, attribute)[0] = value; });
}

void appendVarint(FileBytes& bytes, uint32_t value) {
  for (; value >= 0x80; value >>= 7) bytes.push_back(static_cast<uint8_t>(value | 0x80));
  bytes.push_back(static_cast<uint8_t>(value));
}

/// Where the stream table of a page begins.
constexpr size_t kTableAt = 1 + kParameterBytes;

// ---- Bytes ---------------------------------------------------------------------------------------------------------

TEST(PageCheck, N60_Size) {
  LitheFile file(richFile());
  for (uint32_t page = 0; page < pageCount(file); ++page) {
    for (const int32_t change : {-1, 1}) {
      LitheFile broken(richFile());
      broken.pages[page].resize(broken.pages[page].size() + static_cast<size_t>(change));
      expectPageRefused(broken, page, LITHE_ERROR_TRUNCATED, 60);
    }
    LitheFile empty(richFile());
    empty.pages[page].clear();
    expectPageRefused(empty, page, LITHE_ERROR_TRUNCATED, 60);
  }
}

TEST(PageCheck, N61_Checksum) {
  LitheFile file(richFile());
  for (uint32_t page = 0; page < pageCount(file); ++page) {
    LitheFile broken(richFile());
    broken.pages[page].back() ^= 1;
    expectPageRefused(broken, page, LITHE_ERROR_CORRUPT, 61);
  }
}

TEST(PageCheck, N62_Kind) {
  for (const uint32_t page : {0u, 1u}) {
    for (const uint8_t kind : {uint8_t{0}, uint8_t{1}, uint8_t{2}, uint8_t{255}}) {
      if (kind == (page == 0 ? kBasePage : kSplitPage)) continue;
      LitheFile file(richFile());
      file.pages[page][0] = kind;
      file.sealPages();
      expectPageRefused(file, page, LITHE_ERROR_CORRUPT, 62);
    }
    for (const size_t size : {size_t{1}, kTableAt - 1}) {
      LitheFile file(richFile());
      file.pages[page].resize(size);
      file.sealPages();
      expectPageRefused(file, page, LITHE_ERROR_CORRUPT, 62);
    }
  }
}

TEST(PageCheck, N63_Parameters) {
  for (uint32_t i = 0; i < kParameterBytes; ++i) {
    SCOPED_TRACE(i);
    const bool shift = i == kPositionBias || i == kNormalBias || i == kTangentBias || i >= kUvBias0;
    expectRefusedAfter(richFile(), 0, 63, [&](PageEditor& e) { e.data.parameters[i] = shift ? 16 : 1; });
    expectRefusedAfter(richFile(), 1, 63, [&](PageEditor& e) { e.data.parameters[i] = 255; });
  }
  const struct {
    uint32_t parameter;
    uint8_t most;
  } kRanges[] = {{kPositionMean, 32},   {kPositionBias, 31},     {kHeightBias, 31},        {kPlacement, 32},
                 {kNormalGradient, 32}, {kNormalGeometry, 32},   {kNormalBias, 31},        {kTangentGradient, 32},
                 {kTangentBias, 31},    {kSkinGradient, 32},     {kSkinBias, 31},          {kUvGradient0, 32},
                 {kUvBias0 + 1, 31},    {kExtraNormalShift, 15}, {kExtraTangentShift, 15}, {kExtraUvShift, 15}};
  for (const auto& range : kRanges) {
    SCOPED_TRACE(range.parameter);
    expectRefusedAfter(richFile(), 1, 63, [&](PageEditor& e) { e.data.parameters[range.parameter] = range.most + 1; });
  }
}

TEST(PageCheck, N63_ParametersOfMissingAttributes) {
  for (const uint32_t parameter : {uint32_t{kTangentGradient}, uint32_t{kTangentBias}, uint32_t{kExtraTangentShift},
                                   kUvGradient0 + 1, kUvBias0 + 1, kUvBias0 + 7}) {
    SCOPED_TRACE(parameter);
    expectRefusedAfter(torusFile(), 1, 63, [&](PageEditor& e) { e.data.parameters[parameter] = 1; });
  }
}

/// A page with its own stream table in the place of what follows the parameters.
void expectTableRefused(uint32_t page, const FileBytes& table) {
  LitheFile file(torusFile());
  file.pages[page].resize(kTableAt);
  file.pages[page].insert(file.pages[page].end(), table.begin(), table.end());
  file.sealPages();
  expectPageRefused(file, page, LITHE_ERROR_CORRUPT, 64);
}

TEST(PageCheck, N64_TableCutShort) {
  for (const uint32_t page : {0u, 1u}) {
    const FileBytes whole = LitheFile(torusFile()).pages[page];
    for (size_t size = kTableAt; size < kTableAt + 4; ++size)
      expectTableRefused(page, FileBytes(whole.begin() + kTableAt, whole.begin() + static_cast<int64_t>(size)));
  }
}

TEST(PageCheck, N64_MoreRecordsThanAllowed) {
  for (const uint32_t records : {1u << 20, 1u << 24, 0xffffffffu}) {
    FileBytes table;
    appendVarint(table, records);
    appendVarint(table, 16);
    table.resize(table.size() + 64);
    for (const uint32_t page : {0u, 1u}) expectTableRefused(page, table);
  }
}

TEST(PageCheck, N64_VarintsAreShortest) {
  expectTableRefused(1, FileBytes{0x80, 0x00, 0, 0, 0, 0});
  expectTableRefused(1, FileBytes{0xff, 0xff, 0xff, 0xff, 0x1f, 0});
  expectTableRefused(1, FileBytes{0xff, 0xff, 0xff, 0xff, 0xff, 0x01});
}

TEST(PageCheck, N64_StreamsOfMissingAttributes) {
  const uint32_t splits = PageEditor(*std::make_unique<LitheFile>(torusFile()), 1).data.streams[kSplits].records();
  ASSERT_GT(splits, 0u);
  for (const uint32_t stream : {uint32_t{kTangents}, uint32_t{kColors}, kUv0 + 1u, kUv0 + 7u}) {
    SCOPED_TRACE(stream);
    FileBytes table(stream, 0);  // the streams before it are empty
    table.insert(table.end(), {1, 8});
    table.resize(table.size() + 64);
    expectTableRefused(1, table);
  }
}

TEST(PageCheck, N64_OtherValuesThanStated) {
  for (const uint32_t page : {0u, 1u})
    for (const uint32_t change : {1u, 0xffffffffu}) {
      LitheFile file(richFile());
      uint8_t* values = file.record(page::kId, page) + page::kValuesAt;
      storeU32(values, loadU32(values) + change);
      expectPageRefused(file, page, LITHE_ERROR_CORRUPT, 64);
    }
}

TEST(PageCheck, N64_MoreBytesThanThereAre) {
  for (const uint32_t page : {0u, 1u}) {
    LitheFile file(richFile());
    // The first stream with records comes first in the table: its size is the varint after its records.
    VarintReader table{file.pages[page].data() + kTableAt};
    while (table.next() == 0) continue;
    const size_t at = static_cast<size_t>(table.at - file.pages[page].data());
    VarintReader size{table.at};
    size.next();
    const size_t bytes = static_cast<size_t>(size.at - table.at);
    FileBytes larger;
    appendVarint(larger, 1u << 28);
    const auto begin = file.pages[page].begin() + static_cast<int64_t>(at);
    file.pages[page].erase(begin, begin + static_cast<int64_t>(bytes));
    file.pages[page].insert(file.pages[page].begin() + static_cast<int64_t>(at), larger.begin(), larger.end());
    file.sealPages();
    expectPageRefused(file, page, LITHE_ERROR_CORRUPT, 64);
  }
}

/// A stream with records, and where its entry and its bytes lie in the page.
struct StreamPlace {
  size_t records_at, size_at, begin;
};

std::vector<StreamPlace> streamsIn(const FileBytes& page) {
  VarintReader table{page.data() + kTableAt};
  const auto here = [&] { return static_cast<size_t>(table.at - page.data()); };
  std::vector<StreamPlace> streams;
  size_t bytes = 0;
  for (uint32_t s = 0; s < (page[0] == kBasePage ? +kBaseStreamCount : +kSplitStreamCount); ++s) {
    const size_t records_at = here();
    if (table.next() == 0) continue;
    streams.push_back({records_at, here(), bytes});
    bytes += table.next();
  }
  for (uint32_t kind = 0; kind < kLowBitsKinds; ++kind) table.next();
  for (StreamPlace& stream : streams) stream.begin += here();
  return streams;
}

TEST(PageCheck, N65_Clouds) {
  for (const uint32_t page : {0u, 1u}) {
    const std::vector<StreamPlace> streams = streamsIn(LitheFile(richFile()).pages[page]);
    ASSERT_GT(streams.size(), 3u);
    for (const StreamPlace& stream : streams)
      // Prediction (none; 0xfe makes it Draco's differences), coding, scheme.
      for (const size_t byte : {0u, 1u, 2u})
        for (const uint8_t change : {uint8_t{2}, uint8_t{0x80}, uint8_t{0xfe}}) {
          SCOPED_TRACE(testing::Message() << "stream at " << stream.begin << " byte " << byte << " change " << +change);
          LitheFile file(richFile());
          file.pages[page][stream.begin + byte] ^= change;
          file.sealPages();
          expectPageRefused(file, page, LITHE_ERROR_CORRUPT, 65);
        }
  }
}

TEST(PageCheck, N65_AByteOfTheNextStream) {
  for (const uint32_t page : {0u, 1u}) {
    const std::vector<StreamPlace> streams = streamsIn(LitheFile(richFile()).pages[page]);
    uint32_t moved = 0;
    for (size_t s = 0; s + 1 < streams.size(); ++s) {
      LitheFile file(richFile());
      uint8_t &size = file.pages[page][streams[s].size_at], &next = file.pages[page][streams[s + 1].size_at];
      if ((size & 0x7f) == 0x7f || (next & 0x7f) < 2) continue;  // the varints stay as long as they are
      ++size;
      --next;
      ++moved;
      file.sealPages();
      expectPageRefused(file, page, LITHE_ERROR_CORRUPT, 65);
    }
    EXPECT_GT(moved, 1u);
  }
}

TEST(PageCheck, N65_OtherRecordsThanStated) {
  for (const int change : {-1, 1}) {
    LitheFile file(richFile());
    uint8_t& records = file.pages[0][streamsIn(file.pages[0])[kBaseInfluences].records_at];
    ASSERT_TRUE((records & 0x7f) > 0 && (records & 0x7f) < 0x7f);
    records = static_cast<uint8_t>(records + change);
    uint8_t* values = file.record(page::kId, 0) + page::kValuesAt;
    storeU32(values, loadU32(values) + static_cast<uint32_t>(2 * change));
    file.sealPages();
    expectPageRefused(file, 0, LITHE_ERROR_CORRUPT, 65);
  }
}

// ---- Base page -----------------------------------------------------------------------------------------------------

template <typename Change>
void expectBaseRefusedAfter(uint32_t check, const Change& change) {
  expectRefusedAfter(richFile(), 0, check, change);
}

TEST(PageCheck, N67_BaseNodes) {
  for (uint32_t c = 0; c < 3; ++c) {
    expectBaseRefusedAfter(67, [&](PageEditor& e) { e.values(kBaseNodes, kNodePosition)[c] = -1; });
    expectBaseRefusedAfter(67, [&](PageEditor& e) { e.values(kBaseNodes, kNodePosition)[c] = 1 << 14; });
  }
  expectBaseRefusedAfter(67, [](PageEditor& e) { e.values(kBaseNodes, kNodeWedges)[0] = kFar; });
  expectBaseRefusedAfter(67, [](PageEditor& e) { ++e.values(kBaseNodes, kNodeWedges)[0]; });
  expectBaseRefusedAfter(67, [](PageEditor& e) {
    std::vector<int32_t>& wedges = e.values(kBaseNodes, kNodeWedges);
    --*std::find_if(wedges.begin(), wedges.end(), [](int32_t w) { return w > 0; });
  });
  expectBaseRefusedAfter(67, [](PageEditor& e) { e.values(kBaseNodes, kNodeInfluences)[0] = 4; });
}

/// The first influence of the first base node that has at least `least` of them.
size_t influenceOf(PageEditor& e, int32_t least) {
  size_t at = 0;
  for (const int32_t more : e.values(kBaseNodes, kNodeInfluences)) {
    if (more + 1 >= least) return at;
    at += static_cast<size_t>(more) + 1;
  }
  throw std::runtime_error("the base has no such node");
}

TEST(PageCheck, N68_BaseSkins) {
  expectBaseRefusedAfter(68, [](PageEditor& e) { e.values(kBaseInfluences, kJoint)[0] = 5; });
  expectBaseRefusedAfter(68, [](PageEditor& e) { e.values(kBaseInfluences, kWeight)[influenceOf(e, 2)] = 0; });
  expectBaseRefusedAfter(68, [](PageEditor& e) { e.values(kBaseInfluences, kWeight)[influenceOf(e, 2)] = 255; });
  expectBaseRefusedAfter(68, [](PageEditor& e) { e.values(kBaseInfluences, kWeight)[influenceOf(e, 2)] = 256; });
  expectBaseRefusedAfter(68, [](PageEditor& e) { e.values(kBaseInfluences, kWeight)[influenceOf(e, 2)] = 1; });
  expectBaseRefusedAfter(68, [](PageEditor& e) { e.values(kBaseInfluences, kWeight)[influenceOf(e, 2) + 1] = 1; });
  expectBaseRefusedAfter(68, [](PageEditor& e) {
    std::vector<int32_t>& joints = e.values(kBaseInfluences, kJoint);
    joints[influenceOf(e, 2) + 1] = joints[influenceOf(e, 2)];
  });
}

TEST(PageCheck, N69_BaseWedges) {
  expectBaseRefusedAfter(69, [](PageEditor& e) { e.values(kBaseWedges, 0)[0] = 3; });
  LitheFile file(richFile());
  const PageEditor editor(file, 0);
  const auto& attributes = editor.data.streams[kBaseWedges].attributes;
  ASSERT_EQ(attributes.size(), 6u);  // part, normal, tangent, two uv sets, one colour set
  for (uint32_t a = 1; a < attributes.size(); ++a)
    for (uint32_t c = 0; c < attributes[a].spec.components; ++c)
      for (const int32_t value : {-1, kFar}) {
        SCOPED_TRACE(std::to_string(a) + " " + std::to_string(c));
        expectBaseRefusedAfter(69, [&](PageEditor& e) { e.values(kBaseWedges, a)[c] = value; });
      }
}

TEST(PageCheck, N69_SplitWedges) {
  for (const uint32_t stream :
       {uint32_t{kNormals}, uint32_t{kTangents}, uint32_t{kColors}, uint32_t{kExtras}, uint32_t{kUv0}, kUv0 + 1u})
    for (const int32_t value : {kFar, -kFar}) expectRefusedWithFirst(stream, 0, value, 69);
  expectRefusedWithFirst(kTangents, 1, 4, 69);
  expectRefusedWithFirst(kExtraMasks, 0, 1 << 12, 69);
}

TEST(PageCheck, N70_BaseFaces) {
  expectBaseRefusedAfter(70, [](PageEditor& e) { e.values(kBaseFaces)[0] = -1; });
  for (uint32_t k = 0; k < 3; ++k) expectBaseRefusedAfter(70, [&](PageEditor& e) { e.values(kBaseFaces)[k] = kFar; });
  expectBaseRefusedAfter(70, [](PageEditor& e) { e.values(kBaseFaces)[1] = 0; });
  expectBaseRefusedAfter(70, [](PageEditor& e) { e.values(kBaseFaces)[2] = 0; });
  expectBaseRefusedAfter(70, [](PageEditor& e) { e.values(kBaseFaces)[2] = e.values(kBaseFaces)[1]; });
}

TEST(PageCheck, N70_BaseFaceOfTwoParts) {
  expectBaseRefusedAfter(70, [](PageEditor& e) {
    const std::vector<int32_t>& part = e.values(kBaseWedges);
    std::vector<uint32_t> node_of;
    for (uint32_t n = 0; n < e.values(kBaseNodes, kNodeWedges).size(); ++n)
      node_of.insert(node_of.end(), static_cast<size_t>(e.values(kBaseNodes, kNodeWedges)[n]) + 1, n);
    std::vector<int32_t>& faces = e.values(kBaseFaces);
    const size_t first = static_cast<size_t>(faces[0]), second = static_cast<size_t>(faces[0] + faces[1]);
    for (size_t w = 0; w < part.size(); ++w) {
      if (part[w] == part[first] || node_of[w] == node_of[first] || node_of[w] == node_of[second]) continue;
      faces[2] = static_cast<int32_t>(w) - faces[0];
      return;
    }
    FAIL() << "the base has one part";
  });
}

// ---- Split pages ---------------------------------------------------------------------------------------------------

TEST(PageCheck, N71_Flags) {
  for (const uint32_t stream : {uint32_t{kFlagsOld}, uint32_t{kFlagsNew}}) expectRefusedWithFirst(stream, 0, 2, 71);
}

TEST(PageCheck, N71_MoreSplitsThanThePages) {
  // The last node that a level visits is the last one made: nothing is left to be split.
  const uint32_t page = pageCount(LitheFile(richFile())) - 1;
  expectRefusedAfter(richFile(), page, 71, [](PageEditor& e) {
    ASSERT_EQ(e.values(kFlagsNew).back(), 0);
    e.values(kFlagsNew).back() = 1;
  });
}

TEST(PageCheck, N72_Split) {
  expectRefusedWithFirst(kSplits, kSplitT8, 9, 72);
  for (uint32_t stream : {kSkinModesAll, kSkinModesMost, kSkinModesSome, kSkinModesNone})
    if (pageWithStream(richFile(), stream) > 0) expectRefusedWithFirst(stream, 0, 3, 72);
}

TEST(PageCheck, N73_Position) {
  const uint32_t page = pageWithStream(richFile(), kSplits);
  for (const int32_t value : {kFar, -kFar})
    for (const auto& [attribute, components] : {std::pair(kSplitPosition, 2), std::pair(kSplitPositionHeight, 1),
                                                std::pair(kSplitLattice, 2), std::pair(kSplitLatticeHeight, 1)})
      for (int c = 0; c < components; ++c) {
        SCOPED_TRACE(testing::Message() << "attribute " << attribute << " component " << c);
        expectRefusedAfter(richFile(), page, 73, [&, at = attribute](PageEditor& e) {
          e.values(kSplits, at)[static_cast<size_t>(c)] = value;
        });
      }
}

TEST(PageCheck, N74_Cuts) {
  std::set<uint32_t> streams;
  for (const FileBytes* bytes : {&torusFile(), &patchFile()})
    for (uint32_t stream = kCut3; stream <= kCutOpen; ++stream) {
      const uint32_t page = pageWithStream(*bytes, stream);
      if (page == 0) continue;
      SCOPED_TRACE(stream);
      streams.insert(stream);
      expectRefusedAfter(*bytes, page, 74, [&](PageEditor& e) { e.values(stream)[0] = kFar; });
    }
  EXPECT_TRUE(streams.count(kCutOpen));
  EXPECT_GT(streams.size(), 5u);
}

TEST(PageCheck, N74_FirstPairThatIsNotThere) {
  for (uint32_t edges = 3; edges <= 8; ++edges) {
    const uint32_t stream = cutStream(edges), page = pageWithStream(torusFile(), stream);
    if (page == 0) continue;
    SCOPED_TRACE(edges);
    expectRefusedAfter(torusFile(), page, 74,
                       [&](PageEditor& e) { e.values(stream)[0] = static_cast<int32_t>(1 + edges * (edges - 1) / 2); });
  }
}

/// One split's list in the stream `general`: where its parts lie.
struct List {
  size_t count_b, first_skip, face_count, faces;
  struct Face {
    size_t orientation, rank;
  };
  std::vector<Face> face;
};

std::vector<List> listsIn(const std::vector<int32_t>& general) {
  std::vector<List> lists;
  for (size_t at = 0; at < general.size();) {
    List list = {};
    list.count_b = at;
    list.first_skip = at + 1;
    list.face_count = at + 1 + static_cast<size_t>(general[at]);
    at = list.face_count + 1;
    for (int32_t f = 0; f < general[list.face_count]; ++f) {
      list.face.push_back({at, at + 1});
      at += general[at + 1] == 0 ? 4 : 2;
    }
    lists.push_back(list);
  }
  return lists;
}

/// Breaks the first list of a page for which `fits` is true.
template <typename Fits, typename Break>
void expectListRefused(uint32_t check, const Fits& fits, const Break& breakList) {
  auto find = [&](PageEditor& e) {
    for (const List& list : listsIn(e.values(kGeneral)))
      if (fits(e.values(kGeneral), list)) return list;
    return List{SIZE_MAX, 0, 0, 0, {}};
  };
  const uint32_t page = pageWhere(richFile(), [&](PageEditor& e) { return find(e).count_b != SIZE_MAX; });
  ASSERT_GT(page, 0u);
  expectRefusedAfter(richFile(), page, check, [&](PageEditor& e) { breakList(page, e.values(kGeneral), find(e)); });
}

TEST(PageCheck, N75_Lists) {
  auto any = [](const std::vector<int32_t>&, const List&) { return true; };
  auto hasB = [](const std::vector<int32_t>& general, const List& list) { return general[list.count_b] > 0; };
  auto hasFace = [](const std::vector<int32_t>&, const List& list) { return !list.face.empty(); };
  expectListRefused(75, any, [](uint32_t, auto& general, const List& l) { general[l.count_b] = kFar; });
  expectListRefused(75, hasB, [](uint32_t, auto& general, const List& l) { general[l.first_skip] = kFar; });
  expectListRefused(75, any, [](uint32_t, auto& general, const List& l) { general[l.face_count] = kFar; });
  expectListRefused(75, hasFace, [](uint32_t, auto& general, const List& l) { general[l.face[0].orientation] = 2; });
  expectListRefused(75, hasFace, [](uint32_t, auto& general, const List& l) { general[l.face[0].rank] = kFar; });
}

/// Names a face's third node by an id of two halves.
void nameThird(std::vector<int32_t>& general, const List& list, int32_t high, int32_t low) {
  const auto at = general.begin() + static_cast<int64_t>(list.face[0].rank);
  if (*at == 0) {
    at[1] = high;
    at[2] = low;
    return;
  }
  *at = 0;
  general.insert(at + 1, {high, low});
}

bool hasFace(const std::vector<int32_t>&, const List& list) { return !list.face.empty(); }

TEST(PageCheck, N75_HalvesOfAnId) {
  expectListRefused(75, hasFace, [](uint32_t, auto& general, const List& l) { nameThird(general, l, 1 << 16, 0); });
  expectListRefused(75, hasFace, [](uint32_t, auto& general, const List& l) { nameThird(general, l, 0, 1 << 16); });
}

TEST(PageCheck, N76_Classes) {
  for (const uint32_t stream : {uint32_t{kClassesBoth}, uint32_t{kClassesOne}, uint32_t{kClassesNone}}) {
    expectRefusedWithFirst(stream, 0, kClassListed + 1, 76);
    expectRefusedWithFirst(stream, 0, kFar, 76);
  }
  // Listed counts: none at all, and more than the page has room for.
  const int32_t kCounts[][2] = {{0, 0}, {kFar, 1}, {1, kFar}, {(1 << 19) - 1, (1 << 19) - 1}};
  for (const auto& counts : kCounts) {
    const uint32_t page = pageWithStream(richFile(), kClassesBoth);
    expectRefusedAfter(richFile(), page, 76, [&](PageEditor& e) {
      std::vector<int32_t>& classes = e.values(kClassesBoth);
      classes[0] = kClassListed;
      classes.insert(classes.begin() + 1, {counts[0], counts[1]});
    });
  }
}

TEST(PageCheck, N76_ChildWithoutWedges) {
  // Every wedge of the first split node goes to one child only.
  for (const ClassCounts counts : {ClassCounts{1, 0}, {0, 1}}) {
    expectRefusedAfter(torusFile(), 1, 76, [&](PageEditor& e) {
      for (const uint32_t stream : {uint32_t{kClassesBoth}, uint32_t{kClassesOne}, uint32_t{kClassesNone}})
        for (int32_t& wedge_class : e.values(stream)) wedge_class = static_cast<int32_t>(classCode(counts, true, true));
    });
  }
}

TEST(PageCheck, N77_Picks) {
  for (const uint32_t stream : {uint32_t{kClassPicks}, uint32_t{kClassChoices}, uint32_t{kMemberPicks},
                                uint32_t{kMemberChoices}, uint32_t{kThirdPicks}, uint32_t{kThirdChoices}})
    expectRefusedWithFirst(stream, 0, kFar, 77);
}

TEST(PageCheck, N77_FirstPlaceBeyondTheList) {
  // A class's first corner at a child goes to member 0 or 1.
  const uint32_t page = pageWithStream(richFile(), kMemberChoices);
  ASSERT_GT(page, 0u);
  expectRefusedAfter(richFile(), page, 77, [](PageEditor& e) { e.values(kMemberChoices)[0] = 2; });
}

TEST(PageCheck, N77_ClassWithoutAWedgeAtItsCornersChild) {
  // A class with corners at both children gets its wedges at one. Where its node's other child has none at all that is
  // said first.
  uint32_t refused = 0;
  for (uint32_t page = 1; page < pageCount(LitheFile(richFile())); ++page) {
    LitheFile sound(richFile());
    const size_t count = PageEditor(sound, page).values(kClassesBoth).size();
    for (size_t at = 0; at < count; ++at)
      for (const ClassCounts counts : {ClassCounts{2, 0}, {0, 2}}) {
        LitheFile file(richFile());
        PageEditor editor(file, page);
        int32_t& wedge_class = editor.values(kClassesBoth)[at];
        if (wedge_class != static_cast<int32_t>(classCode({1, 1}, true, true))) continue;
        wedge_class = static_cast<int32_t>(classCode(counts, true, true));
        editor.apply();
        const uint32_t check = outcomeOf(file.bytes()).diagnosis.check;
        EXPECT_TRUE(check == 77 || check == 76) << check;
        refused += check == 77;
      }
  }
  EXPECT_GT(refused, 0u);
}

// driveAsset demands that every face has one part: no pick may get past the check that it keeps its part.
TEST(PageCheck, N77_NoPickMixesParts) {
  uint32_t refused = 0;
  const uint32_t pages = pageCount(LitheFile(richFile()));
  for (const uint32_t stream :
       {uint32_t{kClassPicks}, uint32_t{kClassChoices}, uint32_t{kThirdPicks}, uint32_t{kThirdChoices}})
    for (uint32_t page = 1; page < pages; ++page) {
      LitheFile sound(richFile());
      const size_t count = PageEditor(sound, page).values(stream).size();
      for (size_t at = 0; at < count; ++at)
        for (int32_t value = 0; value < 4; ++value) {
          LitheFile file(richFile());
          PageEditor editor(file, page);
          editor.values(stream)[at] = value;
          editor.apply();
          refused += outcomeOf(file.bytes()).diagnosis.check == 77;
        }
    }
  EXPECT_GT(refused, 0u);
}

TEST(PageCheck, N78_ThirdNodeThatIsNotThere) {
  expectListRefused(78, hasFace, [](uint32_t, auto& general, const List& l) { nameThird(general, l, 0xffff, 0xffff); });
}

/// A node that the pages before this one have split.
uint32_t nodeSplitBefore(uint32_t page) {
  const LitheFile file(richFile());
  BoundedAllocator memory;
  const lithe_allocator allocator = memory.get();
  lithe_asset* asset = nullptr;
  EXPECT_EQ(lithe_asset_open(&allocator, file.head.data(), file.head.size(), nullptr, &asset), LITHE_OK);
  for (uint32_t p = 0; p < page; ++p)
    EXPECT_EQ(lithe_asset_supply(asset, p, file.pages[p].data(), file.pages[p].size(), nullptr), LITHE_OK);
  lithe_hierarchy h;
  lithe_asset_hierarchy(asset, &h);
  uint32_t node = 0;
  while (node < h.node_count && h.node_first_child[node] == LITHE_NO_INDEX) ++node;
  EXPECT_LT(node, h.node_count);
  lithe_asset_close(asset);
  return node;
}

TEST(PageCheck, N78_ThirdNodeThatWasSplit) {
  const uint32_t page = pageWhere(richFile(), [](PageEditor& e) {
    for (const List& list : listsIn(e.values(kGeneral)))
      if (!list.face.empty()) return true;
    return false;
  });
  // With the first page of splits nothing has been split before: its own first node has, by then.
  const uint32_t node = page > 1 ? nodeSplitBefore(page) : nodeSplitBefore(page + 1);
  expectListRefused(78, hasFace, [&](uint32_t, auto& general, const List& l) {
    nameThird(general, l, 0, static_cast<int32_t>(node));
  });
}

TEST(PageCheck, N79_ChildSkins) {
  expectRefusedWithFirst(kSkinNew, 0, static_cast<int32_t>(kMaxSkinJoints), 79);
  expectRefusedWithFirst(kSkinD, 0, kFar, 79);
  expectRefusedWithFirst(kSkinD, 0, -kFar, 79);
  expectRefusedWithFirst(kSkinE, 0, kFar, 79);
  expectRefusedWithFirst(kSkinE, 0, -kFar, 79);
}

TEST(PageCheck, N79_NewJointThatIsNotThere) {
  auto firstIsNew = [](PageEditor& e) { return !e.values(kSkinNew).empty() && e.values(kSkinNew)[0] > 0; };
  const uint32_t page = pageWhere(richFile(), firstIsNew);
  ASSERT_GT(page, 0u);
  expectRefusedAfter(richFile(), page, 79, [](PageEditor& e) { e.values(kSkinNew)[1] = 5; });
}

TEST(PageCheck, N79_NewJointTwice) {
  uint32_t tried = 0;
  for (uint32_t page = 1; page < pageCount(LitheFile(richFile())); ++page) {
    LitheFile unchanged(richFile());
    const std::vector<int32_t> news = PageEditor(unchanged, page).values(kSkinNew);
    for (size_t at = 0; at < news.size(); at += 1 + static_cast<size_t>(news[at])) {
      if (news[at] < 2) continue;
      SCOPED_TRACE(page);
      SCOPED_TRACE(at);
      ++tried;
      expectRefusedAfter(richFile(), page, 79, [&](PageEditor& e) { e.values(kSkinNew)[at + 2] = news[at + 1]; });
    }
  }
  EXPECT_GT(tried, 0u);
}

/// How many records of each stream of a split page a reader may meet at most where that is what the page has: one more
/// is refused by the table, and not as a leftover.
bool isFull(PageEditor& e, uint32_t stream) {
  if (stream == kSplits) return true;
  return stream >= kCut3 && stream <= kCutOpen && e.data.streams[stream].records() == e.data.streams[kSplits].records();
}

TEST(PageCheck, N80_RecordsLeftOver) {
  uint32_t tried = 0;
  for (uint32_t stream = 0; stream < kSplitStreamCount; ++stream) {
    SCOPED_TRACE(stream);
    const uint32_t page = pageWithStream(richFile(), stream);
    LitheFile file(richFile());
    PageEditor editor(file, page);
    if (page == 0 || isFull(editor, stream)) continue;
    ++tried;
    for (auto& attribute : editor.data.streams[stream].attributes)
      attribute.values.resize(attribute.values.size() + attribute.spec.components);
    editor.apply();
    expectPageRefused(file, page, LITHE_ERROR_CORRUPT, 80);
  }
  EXPECT_GT(tried, 15u);
}

TEST(PageCheck, N80_RecordsMissing) {
  // Zeros are read in the place of what is missing; nothing later may make good for it.
  for (uint32_t stream = 0; stream < kSplitStreamCount; ++stream) {
    SCOPED_TRACE(stream);
    const uint32_t page = pageWithStream(richFile(), stream);
    if (page == 0) continue;
    LitheFile file(richFile());
    PageEditor editor(file, page);
    for (auto& attribute : editor.data.streams[stream].attributes)
      attribute.values.resize(attribute.values.size() - attribute.spec.components);
    editor.apply();
    const Outcome outcome = outcomeOf(file.bytes());
    EXPECT_EQ(outcome.result, LITHE_ERROR_CORRUPT);
    EXPECT_GE(outcome.diagnosis.check, 67u);
  }
}

TEST(PageCheck, N80_LowBits) {
  for (uint32_t kind = 0; kind < kLowBitsKinds; ++kind) {
    SCOPED_TRACE(kind);
    expectRefusedAfter(richFile(), 1, 80, [&](PageEditor& e) { e.data.low_bits[kind].push_back(0); });
  }
}

// What is missing reads as zeros: another check may find the values wrong before the end does.
TEST(PageCheck, N80_TooFewLowBits) {
  uint32_t kinds_with_bits = 0;
  for (uint32_t kind = 0; kind < kLowBitsKinds; ++kind) {
    SCOPED_TRACE(kind);
    const uint32_t page = pageWhere(richFile(), [&](PageEditor& e) { return !e.data.low_bits[kind].empty(); });
    if (page == 0) continue;
    ++kinds_with_bits;
    LitheFile file(richFile());
    PageEditor editor(file, page);
    editor.data.low_bits[kind].pop_back();
    editor.apply();
    const Outcome outcome = outcomeOf(file.bytes());
    EXPECT_EQ(outcome.result, LITHE_ERROR_CORRUPT);
    EXPECT_GE(outcome.diagnosis.check, 67u);
  }
  EXPECT_GT(kinds_with_bits, 2u);
}

TEST(PageCheck, N80_BaseLeftOver) {
  for (uint32_t kind = 0; kind < kLowBitsKinds; ++kind)
    expectBaseRefusedAfter(80, [&](PageEditor& e) { e.data.low_bits[kind].push_back(0); });
}

TEST(PageCheck, N81_Fan) {
  for (uint32_t page = 1; page < pageCount(LitheFile(richFile())); ++page) {
    LitheFile file(richFile());
    storeU32(file.record(page::kId, page) + page::kMaxFanAt, 0);
    expectPageRefused(file, page, LITHE_ERROR_LIMIT, 81);
  }
}

TEST(PageCheck, N81_FanIsTheLargestOfThePage) {
  for (uint32_t page = 1; page < pageCount(LitheFile(richFile())); ++page) {
    LitheFile file(richFile());
    uint8_t* max_fan = file.record(page::kId, page) + page::kMaxFanAt;
    storeU32(max_fan, loadU32(max_fan) - 1);
    expectPageRefused(file, page, LITHE_ERROR_LIMIT, 81);
  }
}

/// Adds to a count of the last page, its level and the asset, or of all of them.
LitheFile withCount(uint32_t page_at, uint32_t level_at, uint32_t info_at, bool all) {
  LitheFile file(richFile());
  const uint32_t pages = file.chunk(page::kId).record_count, levels = file.chunk(level::kId).record_count;
  auto add = [](uint8_t* at) { storeU32(at, loadU32(at) + 1); };
  for (uint32_t p = all ? 0 : pages - 1; p < pages; ++p) add(file.record(page::kId, p) + page_at);
  for (uint32_t l = all ? 0 : levels - 1; l < levels; ++l) add(file.record(level::kId, l) + level_at);
  add(file.record(info::kId) + info_at);
  return file;
}

TEST(PageCheck, N82_Counts) {
  for (const bool all : {false, true}) {
    const uint32_t page = all ? 0 : pageCount(LitheFile(richFile())) - 1;
    expectPageRefused(withCount(page::kWedgeCountAt, level::kWedgeCountAt, info::kWedgeCountAt, all), page,
                      LITHE_ERROR_CORRUPT, 82);
    expectPageRefused(withCount(page::kFaceCountAt, level::kFaceCountAt, info::kFaceCountAt, all), page,
                      LITHE_ERROR_CORRUPT, 82);
  }
}

TEST(PageCheck, N83_HiddenFaces) {
  for (uint32_t page = 0; page < pageCount(LitheFile(richFile())); ++page) {
    LitheFile file(richFile());
    file.pages[page].push_back(0);
    file.sealPages();
    expectPageRefused(file, page, LITHE_ERROR_CORRUPT, 83);
  }
  LitheFile more(richFile());
  const uint32_t last = more.chunk(level::kId).record_count - 1;
  uint8_t* hidden = more.record(level::kId, last) + level::kHiddenCountAt;
  storeU32(hidden, loadU32(hidden) + 1);
  expectPageRefused(more, pageCount(more) - 1, LITHE_ERROR_CORRUPT, 83);
}

/// The file with these faces of its finest level hidden.
LitheFile withHidden(const std::vector<uint32_t>& faces) {
  LitheFile file(richFile());
  PageEditor editor(file, pageCount(file) - 1);
  editor.data.hidden.back() = faces;
  editor.apply();
  storeU32(file.record(level::kId, file.chunk(level::kId).record_count - 1) + level::kHiddenCountAt,
           static_cast<uint32_t>(faces.size()));
  return file;
}

TEST(PageCheck, N83_HiddenFacesAscendWithinTheLevel) {
  LitheFile sound(richFile());
  const uint32_t faces = loadU32(sound.record(info::kId) + info::kFaceCountAt), page = pageCount(sound) - 1;
  EXPECT_EQ(outcomeOf(withHidden({0, 1, faces - 1}).bytes()).result, LITHE_OK);
  for (const std::vector<uint32_t>& wrong :
       {std::vector<uint32_t>{0, 1, 1}, {faces}, {0, faces}, {0xffffffffu}, {5, 4}, {1, 0xffffffffu}})
    expectPageRefused(withHidden(wrong), page, LITHE_ERROR_CORRUPT, 83);
}

}  // namespace
}  // namespace lithe::test
