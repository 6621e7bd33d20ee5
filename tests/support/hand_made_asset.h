// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Assets whose decoded arrays are filled by hand: a random forest of splits with random skins and attributes, and
/// beside it, for every level, what a reader should see of it. No page is decoded.
#pragma once

#include <array>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "asset.h"
#include "head_builder.h"
#include "malloc_allocator.h"
#include "random.h"

namespace lithe::test {

struct AssetShape {
  std::vector<uint32_t> splits = {5, 9, 20};  ///< per level after the base
  uint32_t base_nodes = 6;
  uint32_t position_bits = 14, weight_bits = 8, normal_bits = 10, uv_bits = 12;
  uint32_t max_influences = 4;
  uint32_t joints = 7, parts = 3, uv_sets = 2, color_sets = 1;
  bool normals = true, tangents = true;
  uint32_t pages_per_level = 1;  ///< of every level after the base
  uint32_t hidden_of = 8;        ///< one face of so many is hidden at each level; 0: none
  float uv_offset = 0.25f, uv_scale = 0x1p-13f;
};

/// One decoded wedge, node and face, as the arrays hold them.
struct HandNode {
  std::array<int32_t, 3> position;
  uint32_t parent, first_child;
  runtime::NodeSkin skin;
};
struct HandWedge {
  uint32_t node, parent;
  uint16_t part;
  std::vector<uint16_t> attributes;
};
using HandFace = std::array<uint32_t, 3>;

/// What one level looks like.
struct HandLevel {
  uint32_t node_count = 0, wedge_count = 0;
  std::vector<HandFace> faces;   ///< all born so far, corners in this level's cut
  std::vector<uint32_t> hidden;  ///< ascending
};

class HandMade {
 public:
  explicit HandMade(const AssetShape& shape, uint64_t seed = 1) : shape_(shape), random_(seed) {
    growBase();
    for (const uint32_t splits : shape.splits) growLevel(splits);
    buildHead();
  }

  /// Opens the head and, unless told otherwise, makes every level resident.
  std::unique_ptr<lithe_asset, void (*)(lithe_asset*)> open(const lithe_allocator& allocator = *mallocAllocator(),
                                                            bool resident = true) const {
    lithe_asset* asset = nullptr;
    const lithe_result result = lithe_asset_open(&allocator, head.data(), head.size(), nullptr, &asset);
    if (result == LITHE_OK && resident && !fill(asset)) {
      lithe_asset_close(asset);
      asset = nullptr;
    }
    return {asset, lithe_asset_close};
  }

  uint32_t stride() const {
    return (shape_.normals ? 2 : 0) + (shape_.tangents ? 3 : 0) + 2 * shape_.uv_sets + 4 * shape_.color_sets;
  }
  runtime::RecordWidths widths() const { return {stride(), shape_.max_influences}; }
  const AssetShape& shape() const { return shape_; }
  const runtime::NodeSkin& skinOf(uint32_t wedge) const { return nodes[wedges[wedge].node].skin; }

  std::vector<HandNode> nodes;
  std::vector<HandWedge> wedges;
  std::vector<HandLevel> levels;
  std::vector<uint8_t> head;
  std::vector<float> errors;

 private:
  runtime::NodeSkin randomSkin() {
    runtime::NodeSkin skin = {};
    uint32_t left = (1u << shape_.weight_bits) - 1;
    skin.count = static_cast<uint32_t>(1 + random_.below(std::min(shape_.max_influences, shape_.joints)));
    const uint32_t first = random_.below(shape_.joints);
    for (uint32_t i = 0; i < skin.count; ++i) {
      skin.joint[i] = static_cast<uint16_t>((first + i) % shape_.joints);
      const uint32_t kept = skin.count - 1 - i;  // at least one for each that follows
      const uint32_t weight = kept ? 1 + random_.below(left - kept) : left;
      skin.weight[i] = static_cast<uint16_t>(weight);
      left -= weight;
    }
    return skin;
  }

  uint32_t addNode(uint32_t parent) {
    const int32_t top = (1 << shape_.position_bits) - 1;
    HandNode node{{random_.between(0, top), random_.between(0, top), random_.between(0, top)},
                  parent,
                  format::kNoIndex,
                  randomSkin()};
    nodes.push_back(node);
    return static_cast<uint32_t>(nodes.size() - 1);
  }

  uint32_t addWedge(uint32_t node, uint32_t parent, uint16_t part) {
    HandWedge wedge{node, parent, part, {}};
    const int32_t direction = (1 << shape_.normal_bits) - 2, uv = (1 << shape_.uv_bits) - 1;
    auto add = [&](int32_t most) { wedge.attributes.push_back(static_cast<uint16_t>(random_.between(0, most))); };
    if (shape_.normals) add(direction), add(direction);
    if (shape_.tangents) add(direction), add(direction), add(1);
    for (uint32_t i = 0; i < 2 * shape_.uv_sets; ++i) add(uv);
    for (uint32_t i = 0; i < 4 * shape_.color_sets; ++i) add(255);
    wedges.push_back(wedge);
    return static_cast<uint32_t>(wedges.size() - 1);
  }

  // Every base node has one wedge in every part, so that a face of any part can have a corner anywhere.
  void growBase() {
    for (uint32_t n = 0; n < shape_.base_nodes; ++n) {
      addNode(format::kNoIndex);
      for (uint32_t p = 0; p < shape_.parts; ++p) addWedge(n, format::kNoIndex, static_cast<uint16_t>(p));
    }
    HandLevel base;
    for (uint32_t f = 0; f < 3 * shape_.base_nodes; ++f) {
      const uint32_t part = random_.below(shape_.parts), n = random_.below(shape_.base_nodes);
      HandFace face;
      for (uint32_t k = 0; k < 3; ++k) face[k] = (n + k) % shape_.base_nodes * shape_.parts + part;
      base.faces.push_back(face);
    }
    finishLevel(base);
  }

  void growLevel(uint32_t splits) {
    HandLevel level = levels.back();
    for (uint32_t s = 0; s < splits; ++s) {
      uint32_t node = random_.below(static_cast<uint32_t>(nodes.size()));
      while (nodes[node].first_child != format::kNoIndex) node = random_.below(static_cast<uint32_t>(nodes.size()));
      split(node, level);
    }
    finishLevel(level);
  }

  void split(uint32_t node, HandLevel& level) {
    const uint32_t child = addNode(node);
    addNode(node);
    nodes[node].first_child = child;
    std::vector<uint32_t> of_node;
    for (uint32_t w = 0; w < wedges.size(); ++w)
      if (wedges[w].node == node) of_node.push_back(w);
    std::vector<std::array<uint32_t, 2>> children(wedges.size() + 2 * of_node.size());
    for (uint32_t side = 0; side < 2; ++side)
      for (const uint32_t w : of_node) children[w][side] = addWedge(child + side, w, wedges[w].part);
    for (HandFace& face : level.faces)
      for (uint32_t& corner : face)
        if (wedges[corner].node == node) corner = children[corner][random_.below(2)];
    const uint32_t across = randomLeafBeside(node);
    for (const uint32_t w : of_node)
      for (uint32_t x = 0; x < wedges.size(); ++x)
        if (wedges[x].node == across && wedges[x].part == wedges[w].part && random_.below(2))
          level.faces.push_back({children[w][0], x, children[w][1]});
  }

  uint32_t randomLeafBeside(uint32_t node) {
    for (;;) {
      const uint32_t n = random_.below(static_cast<uint32_t>(nodes.size()));
      if (nodes[n].first_child == format::kNoIndex && nodes[n].parent != node) return n;
    }
  }

  void finishLevel(HandLevel level) {
    level.node_count = static_cast<uint32_t>(nodes.size());
    level.wedge_count = static_cast<uint32_t>(wedges.size());
    level.hidden.clear();
    for (uint32_t f = 0; shape_.hidden_of > 0 && f < level.faces.size(); ++f)
      if (random_.below(shape_.hidden_of) == 0) level.hidden.push_back(f);
    levels.push_back(level);
  }

  // ---- The head ----------------------------------------------------------------------------------------------------

  void buildHead() {
    HeadBuilder builder;
    addInfo(builder);
    addSkeleton(builder);
    addParts(builder);
    addLevels(builder);
    head = builder.build(page_bytes_);
  }

  void addInfo(HeadBuilder& builder) {
    using namespace format;
    uint8_t* p = builder.add(info::kId, info::kBytes);
    storeF32(p + info::kGridOriginAt, -1.5f);
    storeF32(p + info::kGridOriginAt + 4, 2.0f);
    storeF32(p + info::kGridOriginAt + 8, 0.125f);
    storeF32(p + info::kGridStepAt, 0x1p-9f);
    p[info::kPositionBitsAt] = static_cast<uint8_t>(shape_.position_bits);
    p[info::kWeightBitsAt] = static_cast<uint8_t>(shape_.weight_bits);
    p[info::kNormalBitsAt] = static_cast<uint8_t>(shape_.normal_bits);
    p[info::kUvBitsAt] = static_cast<uint8_t>(shape_.uv_bits);
    p[info::kMaxInfluencesAt] = static_cast<uint8_t>(shape_.max_influences);
    p[info::kUvSetsAt] = static_cast<uint8_t>(shape_.uv_sets);
    p[info::kColorSetsAt] = static_cast<uint8_t>(shape_.color_sets);
    p[info::kAttributesAt] =
        static_cast<uint8_t>((shape_.normals ? info::kHasNormals : 0) | (shape_.tangents ? info::kHasTangents : 0));
    storeU32(p + info::kNodeCountAt, levels.back().node_count);
    storeU32(p + info::kWedgeCountAt, levels.back().wedge_count);
    storeU32(p + info::kFaceCountAt, static_cast<uint32_t>(levels.back().faces.size()));
    storeF32(p + info::kRestDiagonalAt, 3.0f);
    storeF32(p + info::kPosedDiagonalAt, 4.0f);
    for (uint32_t c = 0; c < 3; ++c) storeU32(p + info::kGridMaxAt + 4 * c, (1u << shape_.position_bits) - 1);
  }

  static constexpr uint16_t kWLeftOut = 3u << format::kFormScaleBits;  // the first scale
  static constexpr uint64_t kCenter = format::kRotationCenter;
  static constexpr uint64_t kNoRotation =
      kCenter | kCenter << format::kRotationFieldBits | kCenter << (2 * format::kRotationFieldBits);

  void addSkeleton(HeadBuilder& builder) {
    using namespace format;
    for (uint32_t j = 0; j < shape_.joints; ++j) {
      const uint32_t name = builder.name("joint " + std::to_string(j));
      uint8_t* n = builder.add(node::kId, node::kBytes);
      storeU32(n + node::kNameAt, name);
      storeU16(n + node::kParentAt, static_cast<uint16_t>(j ? j - 1 : node::kNoParent));
      storeU16(n + node::kFormAt, kWLeftOut);
      storeU64(n + node::kRotationAt, kNoRotation);
      storeF32(n + node::kTranslationAt, static_cast<float>(j));
      addJoint(builder, j);
    }
    uint8_t* one = builder.add(scale::kId, scale::kBytes);
    for (uint32_t c = 0; c < 3; ++c) storeF32(one + scale::kDiagonalAt + 4 * c, 1.0f);
  }

  void addJoint(HeadBuilder& builder, uint32_t j) {
    using namespace format;
    uint8_t* p = builder.add(joint::kId, joint::kBytes);
    storeU16(p + joint::kNodeAt, static_cast<uint16_t>(j));
    storeU16(p + joint::kFormAt, kWLeftOut);
    storeU64(p + joint::kRotationAt, kNoRotation);
    for (uint32_t c = 0; c < 3; ++c) {
      int32_t least = 65535, greatest = 0;
      for (const HandNode& n : nodes)
        for (uint32_t i = 0; i < n.skin.count; ++i)
          if (n.skin.joint[i] == j) {
            least = std::min(least, n.position[c]);
            greatest = std::max(greatest, n.position[c]);
          }
      const uint32_t cell_bits = joint::boxCellBits(shape_.position_bits);
      p[joint::kBoxMinAt + c] = static_cast<uint8_t>(std::min(least >> cell_bits, 255));
      p[joint::kBoxMaxAt + c] = static_cast<uint8_t>(greatest >> cell_bits);
    }
  }

  void addParts(HeadBuilder& builder) {
    using namespace format;
    storeU32(builder.add(material::kId, material::kBytes), builder.name("cloth"));
    builder.declare(uv_grid::kId, uv_grid::kBytes);
    for (uint32_t i = 0; i < shape_.parts; ++i) {
      const uint32_t name = builder.name("part " + std::to_string(i));
      uint8_t* p = builder.add(part::kId, part::kBytes);
      storeU32(p + part::kNameAt, name);
      storeU32(p + part::kMaterialAt, i % 2 ? kNoIndex : 0);
      storeU32(p + part::kRigidNodeAt, kNoIndex);
      for (uint32_t s = 0; s < shape_.uv_sets; ++s) {
        uint8_t* grid = builder.add(uv_grid::kId, uv_grid::kBytes);
        storeF32(grid + uv_grid::kOffsetAt, shape_.uv_offset + 0.01f * static_cast<float>(i));
        storeF32(grid + uv_grid::kOffsetAt + 4, shape_.uv_offset);
        storeF32(grid + uv_grid::kScaleAt, shape_.uv_scale);
      }
    }
  }

  void addLevels(HeadBuilder& builder) {
    using namespace format;
    uint32_t page_end = 0;
    for (uint32_t l = 0; l < levels.size(); ++l) {
      const HandLevel& level = levels[l];
      const uint32_t pages = l ? shape_.pages_per_level : 1;
      for (uint32_t i = 1; i <= pages; ++i) addPage(builder, l, i == pages);
      page_end += pages;
      errors.push_back(static_cast<float>(levels.size() - 1 - l) * 0.5f);
      uint8_t* p = builder.add(level::kId, level::kBytes);
      storeU32(p + level::kPageEndAt, page_end);
      storeU32(p + level::kNodeCountAt, level.node_count);
      storeU32(p + level::kWedgeCountAt, level.wedge_count);
      storeU32(p + level::kFaceCountAt, static_cast<uint32_t>(level.faces.size()));
      storeU32(p + level::kHiddenCountAt, static_cast<uint32_t>(level.hidden.size()));
      storeF32(p + level::kErrorAt, errors.back());
      storeF32(p + level::kErrorRmsAt, errors.back() / 2);
      storeU32(p + level::kJointCountAt, shape_.joints);
    }
  }

  // The pages of a level but its last add nothing: enough for tables that nobody decodes.
  void addPage(HeadBuilder& builder, uint32_t level, bool last) {
    using namespace format;
    const HandLevel& counts = levels[last ? level : level - 1];
    uint8_t* p = builder.add(page::kId, page::kBytes);
    const uint32_t size = 100 + level;
    storeU32(p + page::kSizeAt, size);
    storeU32(p + page::kLevelAt, level);
    storeU32(p + page::kNodeCountAt, counts.node_count);
    storeU32(p + page::kWedgeCountAt, counts.wedge_count);
    storeU32(p + page::kFaceCountAt, static_cast<uint32_t>(counts.faces.size()));
    storeU32(p + page::kValuesAt, counts.node_count);
    storeU32(p + page::kMaxFanAt, 16);
    page_bytes_ += size;
  }

  // ---- The arrays --------------------------------------------------------------------------------------------------

  bool fill(lithe_asset* asset) const {
    const uint32_t last = static_cast<uint32_t>(levels.size() - 1);
    runtime::Decoded& d = asset->decoded;
    if (!runtime::reserveDecoded(asset->allocator, runtime::countsOf(*asset, last), widths(), &d)) return false;
    uint32_t wedge = 0;
    for (uint32_t n = 0; n < nodes.size(); ++n) {
      for (uint32_t c = 0; c < 3; ++c) d.node_position[3 * n + c] = static_cast<uint16_t>(nodes[n].position[c]);
      d.node_parent[n] = nodes[n].parent;
      d.node_first_child[n] = nodes[n].first_child;
      runtime::storeSkin(nodes[n].skin, n, widths().influences, &d);
      d.node_first_wedge[n] = wedge;
      while (wedge < wedges.size() && wedges[wedge].node == n) ++wedge;
      d.node_first_wedge[n + 1] = wedge;
    }
    for (uint32_t w = 0; w < wedges.size(); ++w) {
      d.wedge_node[w] = wedges[w].node;
      d.wedge_parent[w] = wedges[w].parent;
      d.wedge_part[w] = wedges[w].part;
      if (stride()) std::memcpy(d.wedge_attributes + w * stride(), wedges[w].attributes.data(), 2 * stride());
    }
    const std::vector<HandFace>& faces = levels.back().faces;
    for (uint32_t f = 0; f < faces.size(); ++f) std::memcpy(d.face_wedges + 3 * f, faces[f].data(), 12);
    for (uint32_t l = 0; l < levels.size(); ++l) {
      for (const uint32_t face : levels[l].hidden) d.hidden_faces[d.hidden_count++] = face;
      d.hidden_end[l] = d.hidden_count;
    }
    runtime::truncateDecoded(&d, levels.back().node_count, levels.back().wedge_count,
                             static_cast<uint32_t>(faces.size()));
    asset->pages_resident = asset->page_count;
    asset->resident_level = last;
    return true;
  }

  AssetShape shape_;
  Random random_;
  uint64_t page_bytes_ = 0;
};

}  // namespace lithe::test
