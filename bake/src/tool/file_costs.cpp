// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "file_costs.h"

#include <algorithm>
#include <array>
#include <cstdlib>

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
    case format::kSplitMode:
      return kCuts;
    case format::kSplitSkin:
      return kSkinModes;
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

  /// Pages in order: a page of splits has its children behind those of the pages before it.
  void countPage(const lithe_page& page, uint32_t index) {
    const std::string place = name_ + ": page " + std::to_string(index);
    const PageTable table = readPageTable(file_.subspan(page.offset, page.size), place);
    if (table.kind == format::kBasePage) {
      addBytes(kBase, page.size);
      next_node_ = baseCount(hierarchy_.node_parent, hierarchy_.node_count);
      next_wedge_ = baseCount(hierarchy_.wedge_parent, hierarchy_.wedge_count);
      return;
    }
    addBytes(kPageTables, page.size - table.payloadBytes());
    countLowBits(table, countStreams(table, place));
  }

  FileCosts costs() const {
    FileCosts costs;
    uint64_t bits = 0, bytes = 0;
    for (size_t k = 0; k < kKindCount; ++k) {
      bits += bits_[k];
      costs.kinds.push_back({kNames[k].group, kNames[k].name, (bits + 4) / 8 - bytes});
      bytes += costs.kinds.back().bytes;
    }
    auto is_leaf = [&](uint32_t node) { return hierarchy_.node_first_child[node] == LITHE_NO_INDEX; };
    for (uint32_t n = 0; n < hierarchy_.node_count; ++n) costs.vertices += is_leaf(n);
    for (uint32_t w = 0; w < hierarchy_.wedge_count; ++w) costs.wedges += is_leaf(hierarchy_.wedge_node[w]);
    return costs;
  }

 private:
  void addBits(KindIndex kind, uint64_t bits) { bits_[kind] += bits; }
  void addBytes(KindIndex kind, uint64_t bytes) { addBits(kind, 8 * bytes); }

  static uint32_t baseCount(const uint32_t* parents, uint32_t count) {
    return static_cast<uint32_t>(
        std::find_if(parents, parents + count, [](uint32_t parent) { return parent != LITHE_NO_INDEX; }) - parents);
  }

  /// Returns the masks of the page's further wedges.
  std::vector<int32_t> countStreams(const PageTable& table, const std::string& place) {
    std::vector<int32_t> masks;
    for (size_t s = 0; s < table.streams.size(); ++s) {
      if (table.streams[s].records == 0) continue;
      format::StreamAttribute attributes[format::kMaxStreamAttributes];
      const uint32_t count = format::splitStreamAttributes(static_cast<uint32_t>(s), has_, attributes);
      CloudBytes cloud = measureCloud(table.streams[s], {attributes, count}, place + ", stream " + std::to_string(s));
      for (size_t a = 0; a < cloud.attributes.size(); ++a)
        addBytes(s == format::kSplits ? kindOfSplitAttribute(a) : kindOfStream(s), cloud.attributes[a].bytes);
      if (s == format::kExtraMasks) masks = std::move(cloud.attributes[0].values);
    }
    return masks;
  }

  void countLowBits(const PageTable& table, const std::vector<int32_t>& masks) {
    uint64_t left = 8 * table.low_bits.size();
    auto take = [&](KindIndex kind, uint64_t bits) {
      if (bits > left) throw bake::Error(name_ + ": states other low bits than its parameters; bake it again");
      addBits(kind, bits);
      left -= bits;
    };
    auto fixed = [&](size_t stream, size_t components, size_t shift) {
      return uint64_t{table.streams[stream].records} * components * table.parameters[shift];
    };
    take(kNormals, fixed(format::kNormals, 2, format::kNormalShift));
    take(kTangents, fixed(format::kTangents, 2, format::kTangentShift));
    take(kWeights, fixed(format::kSkinD, 1, format::kSkinShift));
    take(kFurther, furtherLowBits(masks));
    take(kUvs, uvLowBits(table));
    addBits(kDifferences, left);
  }

  uint64_t furtherLowBits(const std::vector<int32_t>& masks) const {
    const uint32_t stride = (has_.normals ? 2u : 0u) + (has_.tangents ? 3u : 0u) + 2 * has_.uv_sets;
    uint64_t bits = 0;
    for (int32_t stored : masks) {
      const uint32_t mask = static_cast<uint32_t>(stored < 0 ? -2 * stored - 1 : 2 * stored);
      for (uint32_t i = 0; i < stride; ++i) {
        const format::ExtraField field = format::extraField(has_, i);
        if (mask >> field.group & 1) bits += field.low;
      }
    }
    return bits;
  }

  /// Walks over the page's splits, whose children are the next nodes and wedges.
  uint64_t uvLowBits(const PageTable& table) {
    uint64_t bits = 0;
    for (uint32_t splits = table.streams[format::kSplits].records; splits > 0; --splits, next_node_ += 2) {
      const uint32_t classes = takeClassesAtBoth(), extent = differenceOfChildren();
      for (uint32_t set = 0; set < has_.uv_sets; ++set)
        bits += uint64_t{2} * classes *
                static_cast<uint32_t>(format::lowBits(extent, table.parameters[format::kUvBias0 + set]));
    }
    return bits;
  }

  uint32_t differenceOfChildren() const {
    const uint16_t* a = hierarchy_.node_position + size_t{3} * next_node_;
    int32_t largest = 0;
    for (size_t c = 0; c < 3; ++c) largest = std::max(largest, std::abs(a[c] - a[c + 3]));
    return static_cast<uint32_t>(largest);
  }

  /// The parent's wedges with wedges at both of the next two nodes. A child's wedges come in the order of their
  /// parents.
  uint32_t takeClassesAtBoth() {
    const std::vector<uint32_t> at_a = takeParentsOfWedgesAt(next_node_), at_b = takeParentsOfWedgesAt(next_node_ + 1);
    std::vector<uint32_t> both;
    std::set_intersection(at_a.begin(), at_a.end(), at_b.begin(), at_b.end(), std::back_inserter(both));
    return static_cast<uint32_t>(both.size());
  }

  std::vector<uint32_t> takeParentsOfWedgesAt(uint32_t node) {
    std::vector<uint32_t> parents;
    for (; next_wedge_ < hierarchy_.wedge_count && hierarchy_.wedge_node[next_wedge_] == node; ++next_wedge_) {
      const uint32_t parent = hierarchy_.wedge_parent[next_wedge_];
      if (parents.empty() || parents.back() != parent) parents.push_back(parent);
    }
    return parents;
  }

  Bytes file_;
  std::string name_;
  lithe_asset_info info_{};
  lithe_hierarchy hierarchy_{};
  format::WedgeAttributes has_{};
  std::array<uint64_t, kKindCount> bits_{};
  uint32_t next_node_ = 0, next_wedge_ = 0;
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
