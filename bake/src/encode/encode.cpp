// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/encode.h"

#include <algorithm>
#include <map>

#include "base_encoder.h"
#include "file_writer.h"
#include "lithe/format/octahedral.h"
#include "split_encoder.h"

namespace lithe::bake {
namespace {

SplitSettings settingsOf(const EncodeInput& input) {
  const AttributeSet& attributes = input.mesh.attributes;
  SplitSettings settings;
  settings.placement_shift = input.placement_shift;
  settings.weight_one = input.mesh.weight_one;
  settings.normal_center = format::octahedralCenter(input.mesh.normal_bits);
  settings.uv_greatest = (1u << input.mesh.uv_bits) - 1;
  settings.has = {attributes.normal, attributes.tangent, attributes.uv_sets, attributes.color_sets};
  return settings;
}

class FileEncoder {
 public:
  explicit FileEncoder(const EncodeInput& input)
      : in_(input), cut_(input.hierarchy), settings_(settingsOf(input)), encoder_(cut_, settings_) {}

  std::vector<uint8_t> run(EncodeReport* report) {
    PageData base = encodeBase(cut_, settings_.has);
    endLevel(0, base);
    finishPage(base);
    for (uint32_t level = 1; level < in_.levels.size(); ++level) encodeLevel(level);
    if (page_splits_ > 0) finishSplitPage();
    uint64_t head_bytes = 0;
    std::vector<uint8_t> file = writeFile(in_, levels_, pages_, &head_bytes);
    if (report) fillReport(*report, head_bytes, file.size());
    return file;
  }

 private:
  bool isSplitBy(uint32_t node, uint32_t level) const {
    const uint32_t hierarchy_node = cut_.node_hierarchy[node];
    return hierarchy_node >= in_.hierarchy.vertex_count + in_.levels[level].collapses;
  }

  // Small levels share a page, large ones have several. A page that ends inside a level holds nothing but that level.
  void encodeLevel(uint32_t level) {
    uint32_t left = in_.levels[level - 1].collapses - in_.levels[level].collapses;
    if (page_splits_ + left > in_.page_splits && page_splits_ > 0) finishSplitPage();
    uint32_t pages_left = std::max(1u, (left + in_.page_splits / 2) / in_.page_splits);
    uint32_t page_left = left / pages_left;
    visitNodes(level, [&] {
      --left;
      const bool full = --page_left == 0 || encoder_.work() > format::kMaxPageWork / 2;
      if (!full || left == 0) return;
      finishSplitPage();
      pages_left = std::max(2u, pages_left) - 1;
      page_left = left / pages_left;
    });
    endLevel(level, encoder_.page());
    if (page_splits_ >= in_.shared_page_splits) finishSplitPage();
  }

  // In the order of the ids, children after all that were there before: one flag each.
  template <typename AfterSplit>
  void visitNodes(uint32_t level, const AfterSplit& after_split) {
    const uint32_t old_nodes = static_cast<uint32_t>(cut_.node_hierarchy.size());
    for (uint32_t node = 0; node < cut_.node_hierarchy.size(); ++node) {
      if (cut_.node_split[node]) continue;
      const bool split = isSplitBy(node, level);
      encoder_.flag(node < old_nodes, split);
      if (!split) continue;
      encoder_.split(node);
      ++page_splits_;
      after_split();
    }
  }

  void finishSplitPage() {
    finishPage(encoder_.finish());
    page_splits_ = 0;
  }

  void finishPage(const PageData& page) {
    PageEntry entry;
    // The coarsest level that needs the page: the first that had not ended before it.
    entry.level = levels_with_pages_;
    while (levels_with_pages_ < levels_.size())
      levels_[levels_with_pages_++].page_end = static_cast<uint32_t>(pages_.size()) + 1;
    entry.node_count = static_cast<uint32_t>(cut_.node_hierarchy.size());
    entry.wedge_count = static_cast<uint32_t>(cut_.wedge_node.size());
    entry.face_count = static_cast<uint32_t>(cut_.face_wedges.size());
    entry.values = static_cast<uint32_t>(page.valueCount());
    entry.max_fan = page.max_fan;
    PageBytes bytes;
    entry.bytes = writePage(page, &bytes);
    for (size_t s = 0; s < bytes.streams.size(); ++s)
      kinds_[streamKind(page.kind, static_cast<uint32_t>(s))] += bytes.streams[s];
    kinds_["low bits"] += bytes.low_bits;
    kinds_["page tables"] += bytes.overhead;
    pages_.push_back(std::move(entry));
  }

  void endLevel(uint32_t level, PageData& page) {
    page.hidden.push_back(hiddenFaces(cut_));
    LevelEntry entry;
    entry.node_count = static_cast<uint32_t>(cut_.node_hierarchy.size());
    entry.wedge_count = static_cast<uint32_t>(cut_.wedge_node.size());
    entry.face_count = static_cast<uint32_t>(cut_.face_wedges.size());
    entry.hidden_count = static_cast<uint32_t>(page.hidden.back().size());
    entry.error = in_.levels[level].error;
    entry.error_rms = in_.levels[level].error_rms;
    entry.joint_count = countJoints();
    levels_.push_back(entry);
  }

  uint32_t countJoints() const {
    std::vector<char> used(in_.model.joints.size(), 0);
    for (uint32_t n = 0; n < cut_.node_hierarchy.size(); ++n) {
      if (cut_.node_split[n]) continue;
      const QuantizedSkin& skin = in_.hierarchy.skin[cut_.node_hierarchy[n]];
      for (uint32_t i = 0; i < skin.count; ++i) used[skin.joint[i]] = 1;
    }
    return static_cast<uint32_t>(std::count(used.begin(), used.end(), 1));
  }

  void fillReport(EncodeReport& report, uint64_t head_bytes, uint64_t file_bytes) const {
    report = {};
    report.head_bytes = head_bytes;
    report.file_bytes = file_bytes;
    uint64_t end = head_bytes;
    uint32_t page = 0;
    for (const LevelEntry& level : levels_) {
      for (; page < level.page_end; ++page) end += pages_[page].bytes.size();
      report.levels.push_back({level.face_count - level.hidden_count, level.wedge_count, end});
    }
    report.kinds.push_back({"head", head_bytes});
    for (const auto& [name, bytes] : kinds_) report.kinds.push_back({name, bytes});
  }

  const EncodeInput& in_;
  Cut cut_;
  const SplitSettings settings_;
  SplitEncoder encoder_;
  uint32_t page_splits_ = 0;  ///< in the page being made
  std::vector<PageEntry> pages_;
  std::vector<LevelEntry> levels_;
  uint32_t levels_with_pages_ = 0;  ///< levels whose last page is written
  std::map<std::string, uint64_t> kinds_;
};

}  // namespace

const char* streamKind(format::PageKind page, uint32_t stream) {
  if (page == format::kBasePage) return "base";
  switch (stream) {
    case format::kSplits:
      return "splits";
    case format::kNormals:
      return "normals";
    case format::kTangents:
      return "tangents";
    case format::kColors:
      return "colours";
    case format::kSkinModesAll:
    case format::kSkinModesMost:
    case format::kSkinModesSome:
    case format::kSkinModesNone:
    case format::kSkinD:
    case format::kSkinE:
    case format::kSkinNew:
      return "skin";
    case format::kClassesBoth:
    case format::kClassesOne:
    case format::kClassesNone:
    case format::kClassPicks:
    case format::kClassChoices:
    case format::kMemberPicks:
    case format::kMemberChoices:
    case format::kThirdPicks:
    case format::kThirdChoices:
      return "wedges";
    case format::kExtraMasks:
    case format::kExtras:
      return "extra wedges";
    case format::kFlagsOld:
    case format::kFlagsNew:
      return "flags";
    default:
      return stream >= format::kUv0 ? "uvs" : "connectivity";
  }
}

std::vector<uint8_t> encodeFile(const EncodeInput& input, EncodeReport* report) {
  return FileEncoder(input).run(report);
}

}  // namespace lithe::bake
