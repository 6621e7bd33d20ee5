// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "hand_made_asset.h"

namespace lithe::test {
namespace {

lithe_result openBytes(const std::vector<uint8_t>& bytes, size_t size, lithe_diagnosis* diagnosis) {
  lithe_asset* asset = nullptr;
  const lithe_result result = lithe_asset_open(mallocAllocator(), bytes.data(), size, diagnosis, &asset);
  EXPECT_EQ(asset != nullptr, result == LITHE_OK);
  lithe_asset_close(asset);
  return result;
}

TEST(Peek, AsksForTheHeaderThenForTheHead) {
  const HandMade hand({});
  uint64_t bytes = 0;
  EXPECT_EQ(lithe_peek(nullptr, 0, &bytes), LITHE_PENDING);
  EXPECT_EQ(bytes, uint64_t{LITHE_PEEK_BYTES});
  EXPECT_EQ(lithe_peek(hand.head.data(), LITHE_PEEK_BYTES - 1, &bytes), LITHE_PENDING);
  EXPECT_EQ(lithe_peek(hand.head.data(), LITHE_PEEK_BYTES, &bytes), LITHE_OK);
  EXPECT_EQ(bytes, hand.head.size());
  EXPECT_EQ(lithe_peek(nullptr, 64, &bytes), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_peek(hand.head.data(), 64, nullptr), LITHE_ERROR_INVALID_ARGUMENT);
}

TEST(Peek, RefusesWhatOpenWould) {
  std::vector<uint8_t> bytes(64, 0);
  uint64_t head = 0;
  EXPECT_EQ(lithe_peek(bytes.data(), 64, &head), LITHE_ERROR_NOT_THIS_FORMAT);
  bytes = HandMade({}).head;
  bytes[8] = 200;
  EXPECT_EQ(lithe_peek(bytes.data(), 64, &head), LITHE_ERROR_VERSION_TOO_NEW);
  bytes[8] = 0;
  bytes[15] = 0x7f;
  EXPECT_EQ(lithe_peek(bytes.data(), 64, &head), LITHE_ERROR_CORRUPT);
}

TEST(Open, EveryPrefixIsTruncatedAndWhatFollowsTheHeadIsIgnored) {
  const HandMade hand({});
  lithe_diagnosis diagnosis;
  for (size_t size = 0; size < hand.head.size(); ++size) {
    const std::vector<uint8_t> prefix(hand.head.begin(), hand.head.begin() + static_cast<ptrdiff_t>(size));
    ASSERT_EQ(openBytes(prefix, size, &diagnosis), LITHE_ERROR_TRUNCATED) << size;
    ASSERT_EQ(diagnosis.check, 1u);
  }
  std::vector<uint8_t> more = hand.head;
  more.resize(more.size() + 100, 0xff);
  EXPECT_EQ(openBytes(more, more.size(), &diagnosis), LITHE_OK);
  EXPECT_EQ(diagnosis.check, 0u);
}

TEST(Open, EveryFlippedBitIsNoticed) {
  const HandMade hand({});
  std::vector<uint8_t> bytes = hand.head;
  for (size_t i = 0; i < bytes.size(); ++i) {
    const uint8_t bit = static_cast<uint8_t>(1 << i % 8);
    bytes[i] ^= bit;
    // A newer minor version is welcome, but its head has another checksum.
    ASSERT_GE(openBytes(bytes, bytes.size(), nullptr), LITHE_ERROR_TRUNCATED) << i;
    bytes[i] ^= bit;
  }
}

TEST(Open, TakesUnknownOptionalChunksAndLargerRecords) {
  HeadBuilder empty;
  const HandMade hand({});
  // The same chunks again, every record 8 bytes longer, and one chunk nobody knows.
  HeadBuilder builder;
  builder.declare(format::chunkId('W', 'H', 'A', 'T'), 24, format::directory::kOptional);
  builder.add(format::chunkId('W', 'H', 'A', 'T'), 24);
  for (const uint32_t id :
       {format::info::kId, format::node::kId, format::joint::kId, format::scale::kId, format::material::kId,
        format::part::kId, format::uv_grid::kId, format::level::kId, format::page::kId, format::names::kId}) {
    const ChunkPlace place = findChunk(hand.head, id);
    const uint32_t longer = place.record_bytes + (id == format::names::kId ? 0 : 8);
    for (uint32_t i = 0; i < place.record_count; ++i) {
      uint8_t* record = builder.add(id, longer);
      std::memset(record, 0xee, longer);
      std::memcpy(record, hand.head.data() + place.offset + i * place.record_bytes, place.record_bytes);
    }
  }
  const uint64_t page_bytes = format::loadU64(hand.head.data() + format::header::kFileBytesAt) - hand.head.size();
  const std::vector<uint8_t> bytes = builder.build(page_bytes);
  lithe_asset* asset = nullptr;
  ASSERT_EQ(lithe_asset_open(mallocAllocator(), bytes.data(), bytes.size(), nullptr, &asset), LITHE_OK);
  lithe_node node;
  EXPECT_EQ(lithe_asset_node(asset, 3, &node), LITHE_OK);
  EXPECT_STREQ(node.name, "joint 3");
  lithe_asset_close(asset);
}

TEST(Open, BadArguments) {
  const HandMade hand({});
  lithe_asset* asset = nullptr;
  const lithe_allocator* good = mallocAllocator();
  lithe_allocator no_alloc = *good, no_free = *good;
  no_alloc.alloc = nullptr;
  no_free.free = nullptr;
  const uint8_t* bytes = hand.head.data();
  const size_t size = hand.head.size();
  EXPECT_EQ(lithe_asset_open(nullptr, bytes, size, nullptr, &asset), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_asset_open(&no_alloc, bytes, size, nullptr, &asset), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_asset_open(&no_free, bytes, size, nullptr, &asset), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_asset_open(good, nullptr, size, nullptr, &asset), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_asset_open(good, bytes, size, nullptr, nullptr), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(asset, nullptr);
  lithe_asset_close(nullptr);
}

TEST(Open, EveryFailingAllocationIsReportedAndNothingLeaks) {
  const HandMade hand({});
  for (size_t fail_at = 0;; ++fail_at) {
    FailingAllocator memory;
    memory.fail_at = fail_at;
    const lithe_allocator allocator = memory.get();
    lithe_asset* asset = nullptr;
    const lithe_result result = lithe_asset_open(&allocator, hand.head.data(), hand.head.size(), nullptr, &asset);
    if (result == LITHE_OK) {
      EXPECT_EQ(fail_at, 2u);  // the head and the asset
      lithe_asset_close(asset);
      EXPECT_EQ(memory.bytes, 0u);
      break;
    }
    ASSERT_EQ(result, LITHE_ERROR_OUT_OF_MEMORY);
    ASSERT_EQ(asset, nullptr);
    ASSERT_EQ(memory.bytes, 0u);
  }
}

TEST(Describe, SaysWhatTheHeadSays) {
  const HandMade hand({});
  const auto asset = hand.open(*mallocAllocator(), false);
  lithe_asset_info info;
  lithe_asset_describe(asset.get(), &info);
  EXPECT_EQ(info.file_bytes, format::loadU64(hand.head.data() + format::header::kFileBytesAt));
  EXPECT_EQ(info.node_count, 7u);
  EXPECT_EQ(info.joint_count, 7u);
  EXPECT_EQ(info.part_count, 3u);
  EXPECT_EQ(info.material_count, 1u);
  EXPECT_EQ(info.level_count, 4u);
  EXPECT_EQ(info.page_count, 4u);
  EXPECT_EQ(info.vertex_count, hand.wedges.size());
  EXPECT_EQ(info.triangle_count, hand.levels[3].faces.size() - hand.levels[3].hidden.size());
  EXPECT_EQ(info.max_influences, 4u);
  EXPECT_EQ(info.has_normals, 1u);
  EXPECT_EQ(info.has_tangents, 1u);
  EXPECT_EQ(info.uv_sets, 2u);
  EXPECT_EQ(info.color_sets, 1u);
  EXPECT_EQ(info.box_min[0], -1.5f);
  EXPECT_EQ(info.box_max[1], 2.0f + 16383 * 0x1p-9f);
  EXPECT_EQ(info.rest_diagonal, 3.0f);
  EXPECT_EQ(info.posed_diagonal, 4.0f);
}

TEST(Tables, SayWhatTheHeadSays) {
  const HandMade hand({});
  const auto asset = hand.open(*mallocAllocator(), false);
  lithe_node node;
  ASSERT_EQ(lithe_asset_node(asset.get(), 0, &node), LITHE_OK);
  EXPECT_EQ(node.parent, LITHE_NO_INDEX);
  ASSERT_EQ(lithe_asset_node(asset.get(), 6, &node), LITHE_OK);
  EXPECT_STREQ(node.name, "joint 6");
  EXPECT_EQ(node.parent, 5u);
  EXPECT_EQ(node.translation[0], 6.0f);
  EXPECT_EQ(node.rotation[3], 1.0f);
  EXPECT_EQ(node.scale[2], 1.0f);

  lithe_part part;
  ASSERT_EQ(lithe_asset_part(asset.get(), 2, &part), LITHE_OK);
  EXPECT_STREQ(part.name, "part 2");
  EXPECT_STREQ(part.material, "cloth");
  EXPECT_EQ(part.material_index, 0u);
  EXPECT_EQ(part.rigid_node, LITHE_NO_INDEX);
  ASSERT_EQ(lithe_asset_part(asset.get(), 1, &part), LITHE_OK);
  EXPECT_STREQ(part.material, "");
  EXPECT_EQ(part.material_index, LITHE_NO_INDEX);

  lithe_joint joint;
  ASSERT_EQ(lithe_asset_joint(asset.get(), 2, &joint), LITHE_OK);
  EXPECT_EQ(joint.node, 2u);
  EXPECT_EQ(joint.inverse_bind[5], 1.0f);
  EXPECT_EQ(joint.inverse_bind[6], 0.0f);

  uint64_t offset = hand.head.size();
  for (uint32_t i = 0; i < 4; ++i) {
    lithe_page page;
    lithe_level level;
    ASSERT_EQ(lithe_asset_page(asset.get(), i, &page), LITHE_OK);
    ASSERT_EQ(lithe_asset_level(asset.get(), i, &level), LITHE_OK);
    EXPECT_EQ(page.offset, offset);
    EXPECT_EQ(page.size, 100 + i);
    EXPECT_EQ(page.level, i);
    offset += page.size;
    EXPECT_EQ(level.bytes_end, offset);
    EXPECT_EQ(level.page_end, i + 1);
    EXPECT_EQ(level.error, hand.errors[i]);
    EXPECT_EQ(level.error_rms, hand.errors[i] / 2);
    EXPECT_EQ(level.vertex_count, hand.levels[i].wedge_count);
    EXPECT_EQ(level.triangle_count, hand.levels[i].faces.size() - hand.levels[i].hidden.size());
    EXPECT_EQ(level.index_count, 3 * level.triangle_count);
    EXPECT_EQ(level.joint_count, 7u);
    lithe_level_extent extent;
    ASSERT_EQ(lithe_asset_level_extent(asset.get(), i, &extent), LITHE_OK);
    EXPECT_EQ(extent.node_count, hand.levels[i].node_count);
    EXPECT_EQ(extent.wedge_count, hand.levels[i].wedge_count);
    EXPECT_EQ(extent.face_count, hand.levels[i].faces.size());
  }
}

template <typename Record>
void expectRefused(lithe_result (*getter)(const lithe_asset*, uint32_t, Record*), const lithe_asset* asset,
                   uint32_t count) {
  Record record;
  EXPECT_EQ(getter(asset, count - 1, &record), LITHE_OK);
  EXPECT_EQ(getter(asset, count, &record), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(getter(asset, LITHE_NO_INDEX, &record), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(getter(nullptr, 0, &record), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(getter(asset, 0, nullptr), LITHE_ERROR_INVALID_ARGUMENT);
}

TEST(Tables, BadArguments) {
  const HandMade hand({});
  const auto asset = hand.open(*mallocAllocator(), false);
  expectRefused(lithe_asset_node, asset.get(), 7);
  expectRefused(lithe_asset_joint, asset.get(), 7);
  expectRefused(lithe_asset_part, asset.get(), 3);
  expectRefused(lithe_asset_level, asset.get(), 4);
  expectRefused(lithe_asset_page, asset.get(), 4);
  expectRefused(lithe_asset_level_extent, asset.get(), 4);
  expectRefused(lithe_asset_next_request, asset.get(), 4);
  lithe_asset_describe(nullptr, nullptr);
  lithe_asset_hierarchy(nullptr, nullptr);
  EXPECT_EQ(lithe_asset_memory(nullptr, 0), 0u);
  EXPECT_EQ(lithe_asset_memory(asset.get(), 4), 0u);
  EXPECT_EQ(lithe_asset_resident_level(nullptr), LITHE_NO_LEVEL);
  EXPECT_EQ(lithe_asset_evict(nullptr, 0), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_asset_evict(asset.get(), 4), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_asset_supply(nullptr, 0, nullptr, 0, nullptr), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_asset_supply(asset.get(), 4, nullptr, 0, nullptr), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_asset_supply(asset.get(), 0, nullptr, 100, nullptr), LITHE_ERROR_INVALID_ARGUMENT);
}

TEST(Hierarchy, ShowsTheArrays) {
  const HandMade hand({}, 6);
  const auto asset = hand.open();
  lithe_hierarchy h;
  lithe_asset_hierarchy(asset.get(), &h);
  ASSERT_EQ(h.node_count, hand.nodes.size());
  ASSERT_EQ(h.wedge_count, hand.wedges.size());
  ASSERT_EQ(h.face_count, hand.levels.back().faces.size());
  for (uint32_t n = 0; n < h.node_count; ++n) {
    ASSERT_EQ(h.node_position[3 * n + 1], hand.nodes[n].position[1]);
    ASSERT_EQ(h.node_parent[n], hand.nodes[n].parent);
    ASSERT_EQ(h.node_first_child[n], hand.nodes[n].first_child);
  }
  for (uint32_t w = 0; w < h.wedge_count; ++w) {
    ASSERT_EQ(h.wedge_node[w], hand.wedges[w].node);
    ASSERT_EQ(h.wedge_parent[w], hand.wedges[w].parent);
    ASSERT_EQ(h.wedge_part[w], hand.wedges[w].part);
  }
  EXPECT_EQ(h.grid_step, 0x1p-9f);
  EXPECT_EQ(h.grid_origin[2], 0.125f);
}

// After an eviction the arrays are what they were when the level was the finest: faces, leaves, and corner lists.
void expectTruncated(const HandMade& hand, const lithe_asset* asset, uint32_t level) {
  const HandLevel& l = hand.levels[level];
  const runtime::Decoded& d = asset->decoded;
  ASSERT_EQ(d.node_count, l.node_count);
  ASSERT_EQ(d.wedge_count, l.wedge_count);
  ASSERT_EQ(d.face_count, l.faces.size());
  std::vector<uint32_t> corners(l.node_count, 0);
  for (uint32_t f = 0; f < l.faces.size(); ++f)
    for (uint32_t k = 0; k < 3; ++k) {
      ASSERT_EQ(d.face_wedges[3 * f + k], l.faces[f][k]);
      ++corners[hand.wedges[l.faces[f][k]].node];
    }
  for (uint32_t n = 0; n < l.node_count; ++n) {
    const uint32_t child = hand.nodes[n].first_child;
    ASSERT_EQ(d.node_first_child[n], child < l.node_count ? child : LITHE_NO_INDEX);
    const runtime::NodeSkin& skin = hand.nodes[n].skin;
    const runtime::SkinRecord kept = runtime::skinOf(d, n, hand.widths().influences);
    ASSERT_EQ(kept.count(), skin.count);
    ASSERT_TRUE(std::equal(kept.joint, kept.joint + skin.count, skin.joint));
    ASSERT_TRUE(std::equal(kept.weight, kept.weight + skin.count, skin.weight));
    uint32_t listed = 0;
    for (uint32_t c = d.node_first_corner[n]; c != LITHE_NO_INDEX; c = d.corner_next[c], ++listed)
      ASSERT_EQ(d.wedge_node[d.face_wedges[c]], n);
    ASSERT_EQ(listed, corners[n]);
  }
  ASSERT_EQ(d.node_first_wedge[l.node_count], l.wedge_count);
}

TEST(Reserve, MakesRoomOnceAndEvictGivesItBack) {
  const HandMade hand({}, 4);
  FailingAllocator memory;
  const auto asset = hand.open(memory.get(), false);
  const size_t opened = memory.bytes;
  const auto held = [&](uint32_t level) {
    return opened + runtime::decodedBytes(runtime::countsOf(*asset, level), hand.widths());
  };
  ASSERT_EQ(lithe_asset_reserve(asset.get(), 3), LITHE_OK);
  EXPECT_EQ(memory.bytes, held(3));
  EXPECT_EQ(memory.peak, held(3));
  const size_t calls = memory.calls;
  ASSERT_EQ(lithe_asset_reserve(asset.get(), 1), LITHE_OK) << "there is room for it";
  EXPECT_EQ(memory.calls, calls);
  EXPECT_EQ(lithe_asset_resident_level(asset.get()), LITHE_NO_LEVEL);
  ASSERT_EQ(lithe_asset_evict(asset.get(), 1), LITHE_OK);
  EXPECT_EQ(memory.bytes, held(1));
}

TEST(Reserve, ReportsWhatItCannotHave) {
  const HandMade hand({}, 4);
  for (size_t failing = 0; failing < 4; ++failing) {
    FailingAllocator memory;
    auto asset = hand.open(memory.get(), false);
    memory.fail_at = memory.calls + failing;
    ASSERT_EQ(lithe_asset_reserve(asset.get(), 3), LITHE_ERROR_OUT_OF_MEMORY);
    ASSERT_EQ(lithe_asset_reserve(asset.get(), 3), LITHE_OK) << "and goes on where it failed";
    asset.reset();
    EXPECT_EQ(memory.bytes, 0u);
  }
  const auto asset = hand.open();
  EXPECT_EQ(lithe_asset_reserve(asset.get(), 4), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_asset_reserve(nullptr, 0), LITHE_ERROR_INVALID_ARGUMENT);
}

TEST(Evict, TakesTheArraysBackToTheLevelAndGivesMemoryBack) {
  for (uint64_t seed = 1; seed <= 10; ++seed) {
    const HandMade hand({}, seed);
    FailingAllocator memory;
    auto asset = hand.open(memory.get());
    const size_t opened = memory.bytes - runtime::decodedBytes(runtime::countsOf(*asset, 3), hand.widths());
    for (uint32_t level = 4; level-- > 0;) {
      ASSERT_EQ(lithe_asset_evict(asset.get(), level), LITHE_OK);
      EXPECT_EQ(lithe_asset_resident_level(asset.get()), level);
      expectTruncated(hand, asset.get(), level);
      EXPECT_EQ(memory.bytes - opened, runtime::decodedBytes(runtime::countsOf(*asset, level), hand.widths()));
    }
    asset.reset();
    EXPECT_EQ(memory.bytes, 0u);
  }
}

TEST(Evict, DropsTheLevelsEvenWhenTheAllocatorFails) {
  const HandMade hand({}, 3);
  for (size_t failing = 0; failing < 4; ++failing) {
    FailingAllocator memory;
    auto asset = hand.open(memory.get());
    memory.fail_at = memory.calls + failing;
    ASSERT_EQ(lithe_asset_evict(asset.get(), 1), LITHE_OK);
    EXPECT_GT(memory.calls, memory.fail_at);
    expectTruncated(hand, asset.get(), 1);
    ASSERT_EQ(lithe_asset_evict(asset.get(), 0), LITHE_OK);
    expectTruncated(hand, asset.get(), 0);
    asset.reset();
    EXPECT_EQ(memory.bytes, 0u);
  }
}

TEST(Evict, KeepsWhatIsNotFiner) {
  const HandMade hand({}, 3);
  const auto asset = hand.open();
  ASSERT_EQ(lithe_asset_evict(asset.get(), 1), LITHE_OK);
  ASSERT_EQ(lithe_asset_evict(asset.get(), 2), LITHE_OK);  // not resident: nothing to drop
  EXPECT_EQ(lithe_asset_resident_level(asset.get()), 1u);
  expectTruncated(hand, asset.get(), 1);
}

TEST(Requests, AskForThePagesInOrder) {
  AssetShape shape;
  shape.pages_per_level = 3;
  const HandMade hand(shape);
  const auto asset = hand.open(*mallocAllocator(), false);
  EXPECT_EQ(lithe_asset_resident_level(asset.get()), LITHE_NO_LEVEL);
  lithe_request request;
  for (uint32_t level = 0; level < 4; ++level) {
    ASSERT_EQ(lithe_asset_next_request(asset.get(), level, &request), LITHE_OK);
    EXPECT_EQ(request.page, 0u);
    EXPECT_EQ(request.offset, hand.head.size());
    EXPECT_EQ(request.size, 100u);
  }
  const auto full = hand.open();
  for (uint32_t level = 0; level < 4; ++level)
    EXPECT_EQ(lithe_asset_next_request(full.get(), level, &request), LITHE_COMPLETE);
  ASSERT_EQ(lithe_asset_evict(full.get(), 1), LITHE_OK);
  EXPECT_EQ(lithe_asset_next_request(full.get(), 1, &request), LITHE_COMPLETE);
  ASSERT_EQ(lithe_asset_next_request(full.get(), 3, &request), LITHE_OK);
  EXPECT_EQ(request.page, 4u);
}

TEST(Supply, OutOfTurn) {
  const HandMade hand({});
  const auto asset = hand.open(*mallocAllocator(), false);
  const std::vector<uint8_t> bytes(200, 1);
  lithe_diagnosis diagnosis = {9, 9};
  EXPECT_EQ(lithe_asset_supply(asset.get(), 1, bytes.data(), 101, &diagnosis), LITHE_PENDING);
  EXPECT_EQ(diagnosis.check, 0u);
  EXPECT_EQ(lithe_asset_supply(asset.get(), 0, bytes.data(), 99, &diagnosis), LITHE_ERROR_TRUNCATED);
  EXPECT_EQ(diagnosis.check, 60u);
  EXPECT_EQ(lithe_asset_supply(asset.get(), 0, bytes.data(), 100, &diagnosis), LITHE_ERROR_CORRUPT);
  EXPECT_EQ(diagnosis.check, 61u);
  EXPECT_EQ(diagnosis.offset, hand.head.size());
  const auto full = hand.open();
  EXPECT_EQ(lithe_asset_supply(full.get(), 0, bytes.data(), 1, &diagnosis), LITHE_OK);  // there already
}

TEST(Memory, GrowsWithTheLevelAndCoversTheArrays) {
  const HandMade hand({});
  const auto asset = hand.open();
  uint64_t coarser = 0;
  for (uint32_t level = 0; level < 4; ++level) {
    const uint64_t bytes = lithe_asset_memory(asset.get(), level);
    EXPECT_GT(bytes, coarser);
    EXPECT_GT(bytes, runtime::decodedBytes(runtime::countsOf(*asset, level), hand.widths()));
    coarser = bytes;
  }
}

}  // namespace
}  // namespace lithe::test
