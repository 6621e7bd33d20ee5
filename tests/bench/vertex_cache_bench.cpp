// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// How well a GPU's vertex cache works on the indices that the runtime writes, level by level, as they are and after
// lithe_order_indices, beside the same triangles in meshoptimizer's order.
//
//     bench_vertex_cache [NAME|FILE.glb ...] [--json]
//
// Without names: the built-in characters and the shared ones. ACMR (vertices transformed per triangle) and ATVR (per
// vertex that is used) are of a FIFO of 16 entries, overfetch is bytes fetched per byte of the vertices that are used;
// all by meshoptimizer's own analysis. A part's triangles stay in the part's range. Prints markdown, or JSON.
#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "bench_character.h"
#include "timing.h"

namespace lithe::bench {
namespace {

constexpr unsigned kCacheSize = 16;

struct Order {
  double acmr = 0, atvr = 0, overfetch = 0;
};

struct Level {
  uint32_t triangles = 0;
  Order written, ordered, optimized;
  double seconds = 0;  ///< of lithe_order_indices
  double ratio() const { return ordered.acmr / optimized.acmr; }
};

struct Measured {
  std::string name;
  std::vector<Level> levels;  ///< coarse to fine, those that draw anything

  double meanRatio() const {
    double sum = 0;
    for (const Level& level : levels) sum += std::log(level.ratio());
    return std::exp(sum / static_cast<double>(levels.size()));
  }
  const Level& worst() const {
    return *std::max_element(levels.begin(), levels.end(),
                             [](const Level& a, const Level& b) { return a.ratio() < b.ratio(); });
  }
};

/// A level as an engine uploads it.
struct LevelIndices {
  std::vector<uint32_t> indices;
  std::vector<lithe_range> ranges;  ///< per part
};

LevelIndices writeLevel(const lithe_asset& asset, const lithe_asset_info& info, uint32_t level, uint32_t index_count) {
  LevelIndices out;
  out.indices.resize(index_count);
  out.ranges.resize(info.part_count);
  const lithe_result result = lithe_asset_write_indices(&asset, level, LITHE_INDEX_U32, out.indices.data(),
                                                        index_count * sizeof(uint32_t), out.ranges.data());
  if (result != LITHE_OK) throw bake::Error(std::string("writing indices fails: ") + lithe_result_name(result));
  return out;
}

std::vector<uint32_t> orderedByLithe(const LevelIndices& level, uint32_t vertex_count, double* seconds) {
  const auto index_count = static_cast<uint32_t>(level.indices.size());
  std::vector<uint64_t> scratch(lithe_order_scratch(index_count, vertex_count) / 8 + 1);
  std::vector<uint32_t> out;
  *seconds = medianSeconds({[&] {
    out = level.indices;
    const lithe_result result = lithe_order_indices(out.data(), LITHE_INDEX_U32, index_count, level.ranges.data(),
                                                    static_cast<uint32_t>(level.ranges.size()), vertex_count,
                                                    scratch.data(), scratch.size() * 8);
    if (result != LITHE_OK) throw bake::Error(std::string("ordering indices fails: ") + lithe_result_name(result));
  }})[0];
  return out;
}

std::vector<uint32_t> orderedByMeshoptimizer(const LevelIndices& level, uint32_t vertex_count) {
  std::vector<uint32_t> out(level.indices.size());
  for (const lithe_range& range : level.ranges)
    if (range.index_count > 0)
      meshopt_optimizeVertexCache(out.data() + range.first_index, level.indices.data() + range.first_index,
                                  range.index_count, vertex_count);
  return out;
}

Order analyze(const std::vector<uint32_t>& indices, uint32_t vertex_count, uint32_t stride) {
  const auto cache = meshopt_analyzeVertexCache(indices.data(), indices.size(), vertex_count, kCacheSize, 0, 0);
  const auto fetch = meshopt_analyzeVertexFetch(indices.data(), indices.size(), vertex_count, stride);
  return {cache.acmr, cache.atvr, fetch.overfetch};
}

Level measureLevel(const LevelIndices& level, uint32_t vertex_count, uint32_t stride) {
  Level measured;
  measured.triangles = static_cast<uint32_t>(level.indices.size() / 3);
  measured.written = analyze(level.indices, vertex_count, stride);
  measured.ordered = analyze(orderedByLithe(level, vertex_count, &measured.seconds), vertex_count, stride);
  measured.optimized = analyze(orderedByMeshoptimizer(level, vertex_count), vertex_count, stride);
  return measured;
}

Measured measure(const std::string& name_or_path) {
  const Character character = bakeCharacter(name_or_path);
  const AssetHandle asset = openAsset(character.bytes);
  supplyAll(*asset, character.bytes);
  lithe_asset_info info;
  lithe_asset_describe(asset.get(), &info);
  const uint32_t stride = lithe_vertex_layout_default(asset.get()).stride;
  Measured measured{character.name, {}};
  for (uint32_t i = 0; i < info.level_count; ++i) {
    lithe_level level;
    if (lithe_asset_level(asset.get(), i, &level) != LITHE_OK) throw bake::Error("a level is missing");
    if (level.triangle_count == 0) continue;
    const LevelIndices indices = writeLevel(*asset, info, i, level.index_count);
    measured.levels.push_back(measureLevel(indices, level.vertex_count, stride));
  }
  return measured;
}

template <typename Value>
double mean(const Measured& measured, const Value& value) {
  double sum = 0;
  for (const Level& level : measured.levels) sum += value(level);
  return sum / static_cast<double>(measured.levels.size());
}

// ---- Printing

void printCharacters(const std::vector<Measured>& all) {
  std::printf(
      "| character | levels | ACMR as written | ordered | by meshoptimizer | ordered / meshoptimizer | worst level | "
      "at "
      "triangles | overfetch as written | ordered | by meshoptimizer | ordering, ns a triangle |\n"
      "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  double ratios = 0;
  const Level* worst = nullptr;
  for (const Measured& m : all) {
    const Level &worst_here = m.worst(), &finest = m.levels.back();
    std::printf("| %s | %zu | %.3f | %.3f | %.3f | %.3f | %.3f | %u | %.3f | %.3f | %.3f | %.0f |\n", m.name.c_str(),
                m.levels.size(), mean(m, [](const Level& l) { return l.written.acmr; }),
                mean(m, [](const Level& l) { return l.ordered.acmr; }),
                mean(m, [](const Level& l) { return l.optimized.acmr; }), m.meanRatio(), worst_here.ratio(),
                worst_here.triangles, mean(m, [](const Level& l) { return l.written.overfetch; }),
                mean(m, [](const Level& l) { return l.ordered.overfetch; }),
                mean(m, [](const Level& l) { return l.optimized.overfetch; }), 1e9 * finest.seconds / finest.triangles);
    ratios += std::log(m.meanRatio());
    if (!worst || worst->ratio() < worst_here.ratio()) worst = &worst_here;
  }
  std::printf("| **geometric mean, worst** | | | | | **%.3f** | **%.3f** | %u | | | | |\n",
              std::exp(ratios / static_cast<double>(all.size())), worst->ratio(), worst->triangles);
}

void printLevels(const std::vector<Measured>& all) {
  std::printf(
      "\n| character | triangles | ACMR as written | ordered | by meshoptimizer | ordered / meshoptimizer | ATVR as "
      "written | ordered | by meshoptimizer | overfetch as written | ordered | by meshoptimizer |\n"
      "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const Measured& m : all)
    for (const Level& l : m.levels)
      std::printf("| %s | %u | %.3f | %.3f | %.3f | %.3f | %.3f | %.3f | %.3f | %.3f | %.3f | %.3f |\n", m.name.c_str(),
                  l.triangles, l.written.acmr, l.ordered.acmr, l.optimized.acmr, l.ratio(), l.written.atvr,
                  l.ordered.atvr, l.optimized.atvr, l.written.overfetch, l.ordered.overfetch, l.optimized.overfetch);
}

nlohmann::ordered_json jsonOf(const Order& order) {
  return {{"acmr", order.acmr}, {"atvr", order.atvr}, {"overfetch", order.overfetch}};
}

void printJson(const std::vector<Measured>& all) {
  nlohmann::ordered_json report;
  for (const Measured& m : all) {
    nlohmann::ordered_json character{
        {"name", m.name}, {"mean_ratio", m.meanRatio()}, {"worst_ratio", m.worst().ratio()}};
    for (const Level& level : m.levels)
      character["levels"].push_back({{"triangles", level.triangles},
                                     {"ratio", level.ratio()},
                                     {"written", jsonOf(level.written)},
                                     {"ordered", jsonOf(level.ordered)},
                                     {"optimized", jsonOf(level.optimized)}});
    report["characters"].push_back(character);
  }
  std::printf("%s\n", report.dump(2).c_str());
}

void run(const std::vector<std::string>& names, bool json) {
  std::vector<Measured> all;
  for (const std::string& name : names) all.push_back(measure(name));
  if (json) return printJson(all);
  printCharacters(all);
  printLevels(all);
}

}  // namespace
}  // namespace lithe::bench

int main(int argc, char** argv) {
  return lithe::bench::runOverCharacters(argc, argv, "bench_vertex_cache [NAME|FILE.glb ...] [--json]",
                                         lithe::bench::run);
}
