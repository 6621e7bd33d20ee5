// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Pulls everything out of a file through the public API, whatever the file: what a host with all features would do.
/// Aborts when the runtime hands out something that a host could not draw: hostile bytes may cost levels, never that.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "lithe/runtime.h"
#include "widest_layout.h"
#include "xxh64.h"

namespace lithe::test {

#define LITHE_DEMAND(condition)                                            \
  do {                                                                     \
    if (!(condition)) {                                                    \
      std::fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition); \
      std::abort();                                                        \
    }                                                                      \
  } while (false)

/// The buffers of one level, hashed.
struct LevelHashes {
  uint64_t vertices = 0, indices = 0;

  bool operator==(const LevelHashes& other) const { return vertices == other.vertices && indices == other.indices; }
};

/// What came of a file: the first error, and every level that can be drawn all the same.
struct Outcome {
  lithe_result result = LITHE_OK;  ///< of opening, else of the first page that was refused
  lithe_diagnosis diagnosis = {0, 0};
  std::vector<LevelHashes> levels;
};

template <typename T>
uint64_t hashOf(const std::vector<T>& values) {
  return runtime::xxh64(values.data(), values.size() * sizeof(T));
}

inline std::vector<uint8_t> verticesOf(const lithe_asset* asset, const lithe_vertex_layout& layout, uint32_t count) {
  std::vector<uint8_t> bytes(size_t{count} * layout.stride);
  LITHE_DEMAND(lithe_asset_write_vertices(asset, &layout, 0, count, bytes.data(), bytes.size()) == LITHE_OK);
  return bytes;
}

inline std::vector<uint32_t> indicesOf(const lithe_asset* asset, uint32_t level, uint32_t part_count,
                                       std::vector<lithe_range>* ranges) {
  lithe_level entry;
  LITHE_DEMAND(lithe_asset_level(asset, level, &entry) == LITHE_OK);
  std::vector<uint32_t> indices(entry.index_count);
  ranges->resize(part_count);
  LITHE_DEMAND(lithe_asset_write_indices(asset, level, LITHE_INDEX_U32, indices.data(), indices.size() * 4,
                                         ranges->data()) == LITHE_OK);
  for (const uint32_t index : indices) LITHE_DEMAND(index < entry.vertex_count);
  uint32_t end = 0;
  for (const lithe_range& range : *ranges) {
    LITHE_DEMAND(range.first_index == end && range.index_count % 3 == 0);
    end += range.index_count;
  }
  LITHE_DEMAND(end == entry.index_count);
  return indices;
}

/// One level's buffers in the widest layout; the default layout and the morph sources are written too.
inline LevelHashes drawLevel(const lithe_asset* asset, const lithe_asset_info& info, uint32_t level) {
  lithe_level entry;
  LITHE_DEMAND(lithe_asset_level(asset, level, &entry) == LITHE_OK);
  LevelHashes hashes;
  hashes.vertices = hashOf(verticesOf(asset, widestLayout(info), entry.vertex_count));
  verticesOf(asset, lithe_vertex_layout_default(asset), entry.vertex_count);
  std::vector<lithe_range> ranges;
  hashes.indices = hashOf(indicesOf(asset, level, info.part_count, &ranges));
  if (level > 0) {
    lithe_level coarser;
    LITHE_DEMAND(lithe_asset_level(asset, level - 1, &coarser) == LITHE_OK);
    std::vector<uint32_t> sources(entry.vertex_count);
    LITHE_DEMAND(lithe_asset_write_morph_sources(asset, level, sources.data(), sources.size()) == LITHE_OK);
    for (const uint32_t source : sources) LITHE_DEMAND(source < coarser.vertex_count);
  }
  return hashes;
}

/// Everything that an asset says without a page.
inline void describeAll(const lithe_asset* asset, const lithe_asset_info& info) {
  for (uint32_t i = 0; i < info.node_count; ++i) {
    lithe_node node;
    LITHE_DEMAND(lithe_asset_node(asset, i, &node) == LITHE_OK);
    LITHE_DEMAND(node.parent == LITHE_NO_INDEX || node.parent < i);
    LITHE_DEMAND(std::strlen(node.name) < 1u << 24);
  }
  for (uint32_t i = 0; i < info.joint_count; ++i) {
    lithe_joint joint;
    LITHE_DEMAND(lithe_asset_joint(asset, i, &joint) == LITHE_OK && joint.node < info.node_count);
  }
  for (uint32_t i = 0; i < info.part_count; ++i) {
    lithe_part part;
    LITHE_DEMAND(lithe_asset_part(asset, i, &part) == LITHE_OK);
    LITHE_DEMAND(part.rigid_node == LITHE_NO_INDEX || part.rigid_node < info.node_count);
  }
  uint64_t end = 0;
  for (uint32_t i = 0; i < info.page_count; ++i) {
    lithe_page page;
    LITHE_DEMAND(lithe_asset_page(asset, i, &page) == LITHE_OK && page.level < info.level_count);
    LITHE_DEMAND(i == 0 || page.offset == end);
    end = page.offset + page.size;
  }
  LITHE_DEMAND(end == info.file_bytes);
  for (uint32_t i = 0; i < info.level_count; ++i) LITHE_DEMAND(lithe_asset_memory(asset, i) > 0);
}

/// Chooses levels for a near and a far instance, by threshold and within a budget, and builds their draws.
inline void selectAndDraw(const lithe_asset* asset, const lithe_asset_info& info, uint32_t resident) {
  lithe_view view = {};
  view.pixels_per_radian = 1000;
  view.near_distance = 0.1f;
  view.threshold_px = 1;
  view.hysteresis = 0.2f;
  lithe_instance instances[2] = {};
  for (lithe_instance& instance : instances) {
    instance.radius = instance.scale = instance.bias = 1;
    instance.level = LITHE_UNDRAWN;
  }
  instances[0].center[2] = 2;
  instances[1].center[2] = 1e5f;
  const lithe_crowd crowd = {&asset, instances, 0, 1, 2};
  uint32_t wanted = 0;
  lithe_select_stats stats = {}, within = {};
  LITHE_DEMAND(lithe_select(&crowd, &view, 1, &wanted, &stats) == LITHE_OK);
  LITHE_DEMAND(wanted < info.level_count);
  std::vector<uint64_t> scratch(lithe_budget_scratch(2) / 8 + 1);
  float factor = 0;
  LITHE_DEMAND(lithe_select_within(&crowd, &view, 1, stats.triangles, nullptr, &within, scratch.data(),
                                   scratch.size() * 8, &factor) == LITHE_OK);
  LITHE_DEMAND(within.triangles <= stats.triangles && factor >= 1);
  for (const lithe_instance& instance : instances)
    LITHE_DEMAND(resident == LITHE_NO_LEVEL ? instance.level == LITHE_UNDRAWN : instance.level <= resident);
  if (resident == LITHE_NO_LEVEL) return;
  std::vector<lithe_range> ranges, of_level;
  for (uint32_t level = 0; level <= resident; ++level) {
    indicesOf(asset, level, info.part_count, &of_level);
    ranges.insert(ranges.end(), of_level.begin(), of_level.end());
  }
  const lithe_placement placement = {0, info.part_count, resident + 1, ranges.data()};
  const uint32_t bound = lithe_draws_bound(&placement, 1);
  std::vector<lithe_draw> draws(bound);
  std::vector<lithe_draw_key> keys(bound);
  std::vector<uint32_t> counters(bound);
  uint32_t order[2], draw_count = 0;
  LITHE_DEMAND(lithe_build_draws(&crowd, &placement, 1, order, draws.data(), keys.data(), &draw_count,
                                 counters.data()) == LITHE_OK);
  LITHE_DEMAND(draw_count <= bound);
}

/// What the arrays of the hierarchy promise.
inline void walkHierarchy(const lithe_asset* asset, const lithe_asset_info& info) {
  lithe_hierarchy h;
  lithe_asset_hierarchy(asset, &h);
  for (uint32_t n = 0; n < h.node_count; ++n) {
    LITHE_DEMAND(h.node_parent[n] == LITHE_NO_INDEX || h.node_parent[n] < n);
    LITHE_DEMAND(h.node_first_child[n] == LITHE_NO_INDEX ||
                 (h.node_first_child[n] > n && h.node_first_child[n] + 1 < h.node_count));
  }
  for (uint32_t w = 0; w < h.wedge_count; ++w) {
    LITHE_DEMAND(h.wedge_node[w] < h.node_count && h.wedge_part[w] < info.part_count);
    LITHE_DEMAND(h.wedge_parent[w] == LITHE_NO_INDEX || h.wedge_parent[w] < w);
  }
  for (uint32_t f = 0; f < h.face_count; ++f) {
    const uint32_t* wedges = h.face_wedges + 3 * size_t{f};
    uint32_t nodes[3];
    for (uint32_t k = 0; k < 3; ++k) {
      LITHE_DEMAND(wedges[k] < h.wedge_count);
      nodes[k] = h.wedge_node[wedges[k]];
      LITHE_DEMAND(h.node_first_child[nodes[k]] == LITHE_NO_INDEX);
      LITHE_DEMAND(h.wedge_part[wedges[k]] == h.wedge_part[wedges[0]]);
    }
    LITHE_DEMAND(nodes[0] != nodes[1] && nodes[1] != nodes[2] && nodes[2] != nodes[0]);
  }
}

/// Supplies the pages of `bytes` in order until one is refused or missing.
inline void supplyAll(lithe_asset* asset, const lithe_asset_info& info, const uint8_t* bytes, size_t size,
                      Outcome* outcome) {
  lithe_request request;
  while (lithe_asset_next_request(asset, info.level_count - 1, &request) == LITHE_OK) {
    const size_t begin = request.offset < size ? static_cast<size_t>(request.offset) : size;
    const size_t there = size - begin < request.size ? size - begin : request.size;
    const uint32_t before = lithe_asset_resident_level(asset);
    outcome->result = lithe_asset_supply(asset, request.page, bytes + begin, there, &outcome->diagnosis);
    if (outcome->result == LITHE_OK) continue;
    LITHE_DEMAND(outcome->result >= LITHE_ERROR_TRUNCATED);
    LITHE_DEMAND((outcome->diagnosis.check == 0) == (outcome->result == LITHE_ERROR_OUT_OF_MEMORY));
    LITHE_DEMAND(lithe_asset_resident_level(asset) == before);
    return;
  }
}

/// Opens the file, takes what pages it can, and draws every resident level.
inline Outcome driveAsset(const uint8_t* bytes, size_t size, const lithe_allocator& allocator) {
  Outcome outcome;
  lithe_asset* asset = nullptr;
  outcome.result = lithe_asset_open(&allocator, bytes, size, &outcome.diagnosis, &asset);
  LITHE_DEMAND((outcome.result == LITHE_OK) == (asset != nullptr));
  LITHE_DEMAND((outcome.diagnosis.check == 0) ==
               (outcome.result == LITHE_OK || outcome.result == LITHE_ERROR_OUT_OF_MEMORY));
  if (!asset) return outcome;
  lithe_asset_info info;
  lithe_asset_describe(asset, &info);
  describeAll(asset, info);
  supplyAll(asset, info, bytes, size, &outcome);
  walkHierarchy(asset, info);
  const uint32_t resident = lithe_asset_resident_level(asset);
  for (uint32_t level = 0; resident != LITHE_NO_LEVEL && level <= resident; ++level)
    outcome.levels.push_back(drawLevel(asset, info, level));
  selectAndDraw(asset, info, resident);
  std::vector<float> palette(size_t{12} * info.joint_count, 0.5f);
  float box[6];
  lithe_asset_posed_box(asset, palette.data(), box);
  if (resident != LITHE_NO_LEVEL && resident > 0) {
    LITHE_DEMAND(lithe_asset_evict(asset, resident / 2) == LITHE_OK);
    const uint32_t left = lithe_asset_resident_level(asset);
    LITHE_DEMAND(left >= resident / 2 && left <= resident);
    for (uint32_t level = 0; level <= left; ++level)
      LITHE_DEMAND(drawLevel(asset, info, level) == outcome.levels[level]);
  }
  lithe_asset_close(asset);
  return outcome;
}

}  // namespace lithe::test
