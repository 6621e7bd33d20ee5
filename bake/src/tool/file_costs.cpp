// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "file_costs.h"

#include <algorithm>
#include <array>

#include "cloud_bytes.h"
#include "lithe/bake/model.h"
#include "lithe/format/bytes.h"
#include "lithe/format/file.h"
#include "page_table.h"

namespace lithe::tool {
namespace {

using Bytes = std::span<const uint8_t>;

enum KindIndex : size_t {
  kFlags,
  kCuts,
  kLists,
  kClasses,
  kPicks,
  kFurther,
  kDifferences,
  kPlacement,
  kNormals,
  kTangents,
  kUvs,
  kColors,
  kJoints,
  kWeights,
  kSkinModes,
  kBase,
  kSkeleton,
  kFileTables,
  kPageTables,
  kKindCount
};

struct KindName {
  const char *group, *name;
};

constexpr KindName kNames[kKindCount] = {{"connectivity", "flags"},
                                         {"connectivity", "cuts"},
                                         {"connectivity", "lists"},
                                         {"connectivity", "wedge classes"},
                                         {"connectivity", "wedge picks"},
                                         {"connectivity", "extra wedges"},
                                         {"positions", "differences"},
                                         {"positions", "placement"},
                                         {"normals", "normals"},
                                         {"tangents", "tangents"},
                                         {"uvs", "uvs"},
                                         {"colours", "colours"},
                                         {"skin", "joints"},
                                         {"skin", "weights"},
                                         {"skin", "modes"},
                                         {"base page", "base page"},
                                         {"tables", "skeleton and names"},
                                         {"tables", "head"},
                                         {"tables", "page tables"}};

KindIndex kindOfSplitAttribute(size_t attribute) {
  switch (attribute) {
    case format::kSplitPosition:
    case format::kSplitPositionHeight:
      return kDifferences;
    default:
      return kPlacement;
  }
}

KindIndex kindOfStream(size_t stream) {
  switch (stream) {
    case format::kFlagsOld:
    case format::kFlagsNew:
      return kFlags;
    case format::kGeneral:
      return kLists;
    case format::kClassesBoth:
    case format::kClassesOne:
    case format::kClassesNone:
      return kClasses;
    case format::kClassPicks:
    case format::kClassChoices:
    case format::kMemberPicks:
    case format::kMemberChoices:
    case format::kThirdPicks:
    case format::kThirdChoices:
      return kPicks;
    case format::kNormals:
      return kNormals;
    case format::kTangents:
      return kTangents;
    case format::kColors:
      return kColors;
    case format::kSkinModesAll:
    case format::kSkinModesMost:
    case format::kSkinModesSome:
    case format::kSkinModesNone:
      return kSkinModes;
    case format::kSkinD:
    case format::kSkinE:
      return kWeights;
    case format::kSkinNew:
      return kJoints;
    case format::kExtraMasks:
    case format::kExtras:
      return kFurther;
    default:
      return stream >= format::kUv0 ? kUvs : kCuts;
  }
}

/// In the order of format::LowBits.
constexpr KindIndex kOfLowBits[format::kLowBitsKinds] = {kDifferences, kNormals, kTangents, kUvs, kWeights, kFurther};

bool isOfSkeleton(uint32_t chunk) {
  constexpr uint32_t kIds[] = {format::node::kId, format::joint::kId,   format::scale::kId, format::material::kId,
                               format::part::kId, format::uv_grid::kId, format::names::kId};
  return std::find(std::begin(kIds), std::end(kIds), chunk) != std::end(kIds);
}

class Counter {
 public:
  Counter(const lithe_asset& asset, Bytes file, std::string name) : file_(file), name_(std::move(name)) {
    lithe_asset_describe(&asset, &info_);
    lithe_asset_hierarchy(&asset, &hierarchy_);
    has_ = {info_.has_normals != 0, info_.has_tangents != 0, info_.uv_sets, info_.color_sets};
  }

  void countHead(const lithe_page& first_page) {
    uint64_t skeleton = 0;
    const uint32_t chunks = format::loadU32(file_.data() + format::header::kChunkCountAt);
    for (uint32_t i = 0; i < chunks; ++i) {
      const uint8_t* entry = file_.data() + format::header::kBytes + size_t{i} * format::directory::kBytes;
      if (!isOfSkeleton(format::loadU32(entry + format::directory::kIdAt))) continue;
      skeleton += uint64_t{format::loadU16(entry + format::directory::kRecordBytesAt)} *
                  format::loadU32(entry + format::directory::kRecordCountAt);
    }
    addBytes(kSkeleton, skeleton);
    addBytes(kFileTables, first_page.offset - skeleton);
  }

  void countPage(const lithe_page& page, uint32_t index) {
    const std::string place = name_ + ": page " + std::to_string(index);
    const PageTable table = readPageTable(file_.subspan(page.offset, page.size), place);
    if (table.kind == format::kBasePage) {
      addBytes(kBase, page.size);
      return;
    }
    addBytes(kPageTables, page.size - table.payloadBytes());
    countStreams(table, place);
    for (size_t k = 0; k < table.low_bits.size(); ++k) addBytes(kOfLowBits[k], table.low_bits[k].size());
  }

  FileCosts costs() const {
    FileCosts costs;
    for (size_t k = 0; k < kKindCount; ++k) costs.kinds.push_back({kNames[k].group, kNames[k].name, bytes_[k]});
    auto is_leaf = [&](uint32_t node) { return hierarchy_.node_first_child[node] == LITHE_NO_INDEX; };
    for (uint32_t n = 0; n < hierarchy_.node_count; ++n) costs.vertices += is_leaf(n);
    for (uint32_t w = 0; w < hierarchy_.wedge_count; ++w) costs.wedges += is_leaf(hierarchy_.wedge_node[w]);
    return costs;
  }

 private:
  void addBytes(KindIndex kind, uint64_t bytes) { bytes_[kind] += bytes; }

  void countStreams(const PageTable& table, const std::string& place) {
    for (size_t s = 0; s < table.streams.size(); ++s) {
      if (table.streams[s].records == 0) continue;
      format::StreamAttribute attributes[format::kMaxStreamAttributes];
      const uint32_t count = format::splitStreamAttributes(static_cast<uint32_t>(s), has_, attributes);
      const CloudBytes cloud =
          measureCloud(table.streams[s], {attributes, count}, place + ", stream " + std::to_string(s));
      for (size_t a = 0; a < cloud.attributes.size(); ++a)
        addBytes(s == format::kSplits ? kindOfSplitAttribute(a) : kindOfStream(s), cloud.attributes[a]);
    }
  }

  Bytes file_;
  std::string name_;
  lithe_asset_info info_{};
  lithe_hierarchy hierarchy_{};
  format::WedgeAttributes has_{};
  std::array<uint64_t, kKindCount> bytes_{};
};

}  // namespace

uint64_t FileCosts::bytesOf(const std::string& group) const {
  uint64_t bytes = 0;
  for (const Kind& kind : kinds)
    if (kind.group == group) bytes += kind.bytes;
  return bytes;
}

FileCosts fileCosts(const lithe_asset& asset, Bytes file, const std::string& name) {
  lithe_asset_info info;
  lithe_asset_describe(&asset, &info);
  Counter counter(asset, file, name);
  for (uint32_t i = 0; i < info.page_count; ++i) {
    lithe_page page;
    if (lithe_asset_page(&asset, i, &page) != LITHE_OK) throw bake::Error(name + ": has no page " + std::to_string(i));
    if (i == 0) counter.countHead(page);
    counter.countPage(page, i);
  }
  return counter.costs();
}

}  // namespace lithe::tool
