// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Any integers as the streams of a page, behind Draco and the tables: splits applied to a small sound cut, or a base
/// made of nothing. What is accepted must be a mesh, and what is refused must leave the cut as it was.
/// Input: tests/support/split_input.h.
#include <algorithm>
#include <memory>

#include "asset.h"
#include "drive_asset.h"
#include "encoded_character.h"
#include "lithe_file.h"
#include "malloc_allocator.h"
#include "page_base.h"
#include "skin_order.h"
#include "split_decoder.h"
#include "split_input.h"

namespace {

using namespace lithe;
using test::SplitInput;

constexpr uint32_t kPrefixes = 3;  ///< pages that are resident before the splits

/// A sound asset with its first pages resident, and room for one page more.
struct Cut {
  explicit Cut(uint32_t pages) {
    const test::LitheFile file(test::encodeSmallFile(test::richShape()));
    LITHE_DEMAND(lithe_asset_open(test::mallocAllocator(), file.head.data(), file.head.size(), nullptr, &asset) ==
                 LITHE_OK);
    lithe_asset_describe(asset, &info);
    for (uint32_t p = 0; p < pages; ++p)
      LITHE_DEMAND(lithe_asset_supply(asset, p, file.pages[p].data(), file.pages[p].size(), nullptr) == LITHE_OK);
    runtime::Decoded& d = asset->decoded;
    LITHE_DEMAND(runtime::reserveDecoded(asset->allocator,
                                         {d.node_count + 64, d.wedge_count + 256, d.face_count + 256, 0},
                                         runtime::widthsOf(*asset), &d));
    const runtime::PageEntry next = runtime::pageEntry(*asset, pages);
    const uint32_t level = pages == 0 ? 0 : runtime::pageEntry(*asset, pages - 1).level;
    level_first_node = next.level ? asset->levels[next.level - 1].entry.node_count : 0;
    cursor = level == next.level ? asset->visit_cursor : 0;
    faces.assign(d.face_wedges, d.face_wedges + 3 * d.face_count);
    children.assign(d.node_first_child, d.node_first_child + d.node_count);
  }
  ~Cut() { lithe_asset_close(asset); }
  Cut(const Cut&) = delete;
  Cut& operator=(const Cut&) = delete;

  void demandUnchanged() const {
    const runtime::Decoded& d = asset->decoded;
    LITHE_DEMAND(std::equal(faces.begin(), faces.end(), d.face_wedges));
    LITHE_DEMAND(std::equal(children.begin(), children.end(), d.node_first_child));
  }

  lithe_asset* asset = nullptr;
  lithe_asset_info info = {};
  uint32_t level_first_node = 0, cursor = 0;  ///< as the page that comes next in the file has them
  std::vector<uint32_t> faces, children;
};

runtime::PagePlan readPlan(SplitInput& in, const Cut& cut, bool base) {
  const runtime::Decoded& d = cut.asset->decoded;
  runtime::PagePlan plan = {};
  const uint32_t splits = in.byte() % 32 + 1u;
  plan.node_count = d.node_count + (base ? splits : 2 * splits);
  plan.wedge_count = d.wedge_count + in.byte();
  plan.face_count = d.face_count + in.byte();
  plan.level = base ? 0 : 1;
  plan.level_first_node = cut.level_first_node;
  plan.max_fan = in.byte();
  const runtime::LevelEnd last = {plan.node_count, plan.wedge_count, plan.face_count, 0};
  const uint8_t ends = in.byte();
  if (ends & 1) plan.ends[plan.ended_levels++] = last;
  if (ends & 1 && ends & 2 && splits > 1) {
    plan.ends[0] = {d.node_count + 2, std::min(d.wedge_count + (ends >> 4), last.wedge_count),
                    std::min(d.face_count + (ends >> 2 & 3), last.face_count), 0};
    plan.ends[plan.ended_levels++] = last;
  }
  return plan;
}

/// The streams' integers, and what a page says beside them.
struct Payload {
  uint8_t parameters[format::kParameterBytes] = {};
  std::vector<std::unique_ptr<int32_t[]>> values;
  std::vector<uint8_t> low_bits;
  runtime::PageStreams streams = {};
};

void readPayload(SplitInput& in, format::WedgeAttributes has, bool base, Payload* out) {
  if (!base)
    for (uint8_t& parameter : out->parameters) parameter = in.byte() % 16;  // within the range of each
  out->streams.parameters = out->parameters;
  const uint32_t count = base ? uint32_t{format::kBaseStreamCount} : uint32_t{format::kSplitStreamCount};
  for (uint32_t s = 0; s < count; ++s) {
    format::StreamAttribute specs[format::kMaxStreamAttributes];
    const uint32_t attributes =
        base ? format::baseStreamAttributes(s, has, specs) : format::splitStreamAttributes(s, has, specs);
    if (attributes == 0) continue;
    const uint32_t records = out->streams.records[s] = in.byte();
    for (uint32_t a = 0; a < attributes; ++a) {
      const uint32_t size = records * specs[a].components;
      out->values.push_back(std::make_unique<int32_t[]>(size));
      int32_t* values = out->values.back().get();
      for (uint32_t i = 0; i < size; ++i) values[i] = in.value(specs[a].is_unsigned);
      out->streams.values[s][a] = {values, values + size, false};
    }
  }
  out->low_bits.assign(in.at, in.end);
  for (runtime::BitReader& low : out->streams.low_bits)
    low = {out->low_bits.data(), 0, 8 * uint64_t{out->low_bits.size()}, false};
}

uint32_t applySplits(const lithe_asset& asset, const runtime::PagePlan& plan, uint32_t cursor,
                     runtime::PageStreams* streams, runtime::Decoded* decoded) {
  const size_t fan = plan.max_fan;
  std::vector<uint32_t> corner(fan), next(fan), previous(fan), wedge(fan), sorted(2 * fan);
  std::vector<uint32_t> other_wedge[2] = {std::vector<uint32_t>(fan), std::vector<uint32_t>(fan)};
  std::vector<format::Int3> other_at[2] = {std::vector<format::Int3>(fan), std::vector<format::Int3>(fan)};
  std::vector<runtime::WedgeClass> classes(fan);
  std::vector<uint8_t> at_b(fan);
  runtime::FanScratch scratch;
  scratch.capacity = plan.max_fan;
  scratch.corner = corner.data();
  scratch.next = next.data();
  scratch.previous = previous.data();
  scratch.wedge = wedge.data();
  for (uint32_t step = 0; step < 2; ++step) {
    scratch.other_wedge[step] = other_wedge[step].data();
    scratch.other_at[step] = other_at[step].data();
  }
  scratch.classes = classes.data();
  scratch.sorted = sorted.data();
  scratch.at_b = at_b.data();
  return runtime::SplitDecoder(asset.format, plan, streams, scratch, decoded).run(&cursor);
}

uint32_t applyBase(const lithe_asset& asset, const runtime::PagePlan& plan, runtime::PageStreams* streams,
                   runtime::Decoded* decoded) {
  const uint32_t check = runtime::decodeBase(asset.format, plan, streams, decoded);
  if (check) return check;
  decoded->node_count = plan.node_count;
  decoded->wedge_count = plan.wedge_count;
  decoded->face_count = plan.face_count;
  return 0;
}

void demandSkins(const lithe_asset& asset) {
  for (uint32_t n = 0; n < asset.decoded.node_count; ++n) {
    const runtime::SkinRecord kept = runtime::skinOf(asset.decoded, n, asset.format.max_influences);
    runtime::NodeSkin skin = {kept.count(), {}, {}};
    uint32_t sum = 0;
    LITHE_DEMAND(skin.count >= 1 && skin.count <= asset.format.max_influences);
    for (uint32_t i = 0; i < skin.count; ++i) {
      skin.joint[i] = kept.joint[i];
      skin.weight[i] = kept.weight[i];
      LITHE_DEMAND(skin.joint[i] < asset.format.joint_count && skin.weight[i] > 0);
      sum += skin.weight[i];
    }
    LITHE_DEMAND(sum == asset.format.weight_one && runtime::skinIsOrdered(skin));
  }
}

void demandAttributes(const lithe_asset& asset) {
  int64_t greatest[runtime::kMaxStride];
  runtime::attributeLimits(asset.format, greatest);
  const uint32_t stride = runtime::strideOf(asset);
  for (size_t w = 0; w < asset.decoded.wedge_count; ++w)
    for (uint32_t v = 0; v < stride; ++v) LITHE_DEMAND(asset.decoded.wedge_attributes[w * stride + v] <= greatest[v]);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  static Cut empty(0), cuts[kPrefixes] = {Cut(1), Cut(4), Cut(5)};
  SplitInput in{data, data + size};
  const uint32_t choice = in.byte() % (kPrefixes + 1);
  const bool base = choice == kPrefixes;
  Cut& cut = base ? empty : cuts[choice];
  runtime::Decoded& d = cut.asset->decoded;
  const uint32_t nodes = d.node_count, wedges = d.wedge_count, faces = d.face_count;
  const runtime::PagePlan plan = readPlan(in, cut, base);
  Payload payload;
  readPayload(in, cut.asset->format.has, base, &payload);
  const uint32_t check = base ? applyBase(*cut.asset, plan, &payload.streams, &d)
                              : applySplits(*cut.asset, plan, cut.cursor, &payload.streams, &d);
  if (check == 0) {
    test::walkHierarchy(cut.asset, cut.info);
    demandSkins(*cut.asset);
    demandAttributes(*cut.asset);
  }
  runtime::truncateDecoded(&d, nodes, wedges, faces);
  cut.demandUnchanged();
  return 0;
}
