// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// How large .lithe files are, beside the finest level alone under Draco (draco_reference.h), and where their bytes go.
//
//     bench_size [NAME|FILE.glb ...] [--json]
//
// Without names: the built-in characters and the shared ones. Prints markdown, or JSON with the same figures.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "bench_character.h"
#include "draco_reference.h"

namespace lithe::bench {
namespace {

/// What is measured of one character.
struct Sizes {
  std::string name;
  uint32_t triangles = 0;
  uint32_t vertices = 0;        ///< of the finest level alone
  uint32_t base_triangles = 0;  ///< of the first picture
  uint64_t file_bytes = 0;
  uint64_t first_bytes = 0;  ///< head and page 0
  uint64_t reference_bytes = 0;
  uint32_t left_out = 0;
  std::string carried;  ///< attributes of both, beside positions, joints and weights
  std::vector<bake::EncodeReport::Kind> kinds;

  double ratio() const { return static_cast<double>(file_bytes) / static_cast<double>(reference_bytes); }
  double firstShare() const { return static_cast<double>(first_bytes) / static_cast<double>(file_bytes); }
};

std::string carriedNames(const DracoReference& reference) {
  std::string text;
  for (const std::string& name : reference.names)
    if (name != "position" && name != "joints" && name != "weights") text += (text.empty() ? "" : " ") + name;
  return text.empty() ? "none" : text;
}

uint64_t firstPictureBytes(const lithe_asset& asset, const bake::BakeReport& report) {
  lithe_page page;
  if (lithe_asset_page(&asset, 0, &page) != LITHE_OK) throw bake::Error("a baked file has no page");
  return report.head_bytes + page.size;
}

Sizes measure(const std::string& name_or_path) {
  const Character character = bakeCharacter(name_or_path);
  const AssetHandle asset = openAsset(character.bytes);
  supplyAll(*asset, character.bytes);
  const DracoReference reference = encodeReference(*asset);
  LevelBuffers buffers(*asset, lithe_vertex_layout_default(asset.get()));
  buffers.write(*asset);

  Sizes sizes;
  sizes.name = character.name;
  sizes.triangles = reference.triangles + reference.left_out;
  sizes.vertices = usedVertices(buffers);
  sizes.base_triangles = character.report.levels.front().triangles;
  sizes.file_bytes = character.bytes.size();
  sizes.first_bytes = firstPictureBytes(*asset, character.report);
  sizes.reference_bytes = reference.byteCount();
  sizes.left_out = reference.left_out;
  sizes.carried = carriedNames(reference);
  sizes.kinds = character.report.kinds;
  return sizes;
}

template <typename Value>
double geometricMean(const std::vector<Sizes>& all, const Value& value) {
  double sum = 0;
  for (const Sizes& sizes : all) sum += std::log(value(sizes));
  return std::exp(sum / static_cast<double>(all.size()));
}

/// Kinds in the order of their first appearance.
std::vector<std::string> kindNames(const std::vector<Sizes>& all) {
  std::vector<std::string> names;
  for (const Sizes& sizes : all)
    for (const auto& kind : sizes.kinds)
      if (std::find(names.begin(), names.end(), kind.name) == names.end()) names.push_back(kind.name);
  return names;
}

uint64_t kindBytes(const Sizes& sizes, const std::string& name) {
  for (const auto& kind : sizes.kinds)
    if (kind.name == name) return kind.bytes;
  return 0;
}

// ---- Markdown
// --------------------------------------------------------------------------------------------------------

unsigned long long wide(uint64_t number) { return number; }

void printSizeTable(const std::vector<Sizes>& all) {
  std::printf(
      "| character | triangles | vertices | attributes | .lithe bytes | Draco bytes | ratio | first picture | its "
      "triangles |\n|---|---:|---:|---|---:|---:|---:|---:|---:|\n");
  for (const Sizes& sizes : all)
    std::printf("| %s | %u | %u | %s | %llu | %llu | %.3f | %.2f %% | %u |\n", sizes.name.c_str(), sizes.triangles,
                sizes.vertices, sizes.carried.c_str(), wide(sizes.file_bytes), wide(sizes.reference_bytes),
                sizes.ratio(), 100 * sizes.firstShare(), sizes.base_triangles);
  std::printf("| **geometric mean** | | | | | | **%.3f** | **%.2f %%** | |\n",
              geometricMean(all, [](const Sizes& sizes) { return sizes.ratio(); }),
              100 * geometricMean(all, [](const Sizes& sizes) { return sizes.firstShare(); }));
  for (const Sizes& sizes : all)
    if (sizes.left_out > 0)
      std::printf("\n%s: %u triangles have two corners in one place; Draco leaves them out, lithe keeps them.\n",
                  sizes.name.c_str(), sizes.left_out);
}

void printKindTable(const std::vector<Sizes>& all) {
  const std::vector<std::string> names = kindNames(all);
  std::printf("\n| character |");
  for (const std::string& name : names) std::printf(" %s |", name.c_str());
  std::printf(" bytes per vertex |\n|---|");
  for (size_t i = 0; i < names.size(); ++i) std::printf("---:|");
  std::printf("---:|\n");
  for (const Sizes& sizes : all) {
    std::printf("| %s |", sizes.name.c_str());
    for (const std::string& name : names) std::printf(" %llu |", wide(kindBytes(sizes, name)));
    std::printf(" %.2f |\n", static_cast<double>(sizes.file_bytes) / sizes.vertices);
  }
}

// ---- JSON
// ------------------------------------------------------------------------------------------------------------

nlohmann::ordered_json jsonOf(const Sizes& sizes) {
  nlohmann::ordered_json kinds;
  for (const auto& kind : sizes.kinds) kinds[kind.name] = kind.bytes;
  return {{"name", sizes.name},
          {"triangles", sizes.triangles},
          {"vertices", sizes.vertices},
          {"attributes", sizes.carried},
          {"bytes", sizes.file_bytes},
          {"reference_bytes", sizes.reference_bytes},
          {"reference_left_out", sizes.left_out},
          {"ratio", sizes.ratio()},
          {"first_picture_bytes", sizes.first_bytes},
          {"first_picture_share", sizes.firstShare()},
          {"first_picture_triangles", sizes.base_triangles},
          {"kinds", kinds}};
}

void printJson(const std::vector<Sizes>& all) {
  nlohmann::ordered_json report;
  for (const Sizes& sizes : all) report["characters"].push_back(jsonOf(sizes));
  report["geometric_mean"] = {
      {"ratio", geometricMean(all, [](const Sizes& sizes) { return sizes.ratio(); })},
      {"first_picture_share", geometricMean(all, [](const Sizes& sizes) { return sizes.firstShare(); })}};
  std::printf("%s\n", report.dump(2).c_str());
}

void run(const std::vector<std::string>& names, bool json) {
  std::vector<Sizes> all;
  for (const std::string& name : names) all.push_back(measure(name));
  if (json) return printJson(all);
  printSizeTable(all);
  printKindTable(all);
}

}  // namespace
}  // namespace lithe::bench

int main(int argc, char** argv) {
  return lithe::bench::runOverCharacters(argc, argv, "bench_size [NAME|FILE.glb ...] [--json]", lithe::bench::run);
}
