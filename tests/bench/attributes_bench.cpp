// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// What each attribute costs: whole files beside the finest level alone under Draco (draco_reference.h), both without
// one attribute after the other, and what each kind of data takes in bits per vertex of the finest level.
//
//     bench_attributes [NAME|FILE.glb ...] [--json]
//
// Without names: the built-in characters and the shared ones. An attribute is taken from the model before the bake, so
// that seams which were its own go with it. Without skin means one joint, no clips and a skeleton of one node.
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "bench_character.h"
#include "draco_reference.h"
#include "file_costs.h"

namespace lithe::bench {
namespace {

// ---- What is left out

void dropTangents(bake::Model& model) {
  model.attributes.tangent = false;
  model.tangents.clear();
}

void dropNormals(bake::Model& model) {
  model.attributes.normal = false;
  model.normals.clear();
}

void dropUvs(bake::Model& model) {
  model.attributes.uv_sets = 0;
  for (auto& set : model.uvs) set.clear();
}

void dropColors(bake::Model& model) {
  model.attributes.color_sets = 0;
  for (auto& set : model.colors) set.clear();
}

void dropSkin(bake::Model& model) {
  bake::Skin skin;
  skin.count = 1;
  skin.weight[0] = 1;
  model.skins.assign(model.positions.size(), skin);
  model.nodes = {{"root", bake::kNone, {}}};
  model.joints = {{0, glm::dmat4(1.0)}};
  model.clips.clear();
  for (bake::Part& part : model.parts) part.rigid_node = bake::kNone;
}

void dropAllButPositions(bake::Model& model) {
  dropTangents(model);
  dropNormals(model);
  dropUvs(model);
  dropColors(model);
  dropSkin(model);
}

struct Variant {
  const char* name;
  void (*drop)(bake::Model&);
  bool with_skin;
};

constexpr Variant kVariants[] = {{"all", [](bake::Model&) {}, true},
                                 {"without tangents", dropTangents, true},
                                 {"without normals", dropNormals, true},
                                 {"without uvs", dropUvs, true},
                                 {"without colours", dropColors, true},
                                 {"without skin", dropSkin, false},
                                 {"positions only", dropAllButPositions, false}};
constexpr size_t kVariantCount = std::size(kVariants);

// ---- Measuring

struct Sizes {
  uint64_t file = 0, reference = 0;
  double ratio() const { return static_cast<double>(file) / static_cast<double>(reference); }
};

struct Measured {
  std::string name;
  Sizes sizes[kVariantCount];
  tool::FileCosts costs;  ///< with all attributes
};

Sizes measureVariant(const bake::Model& model, bool with_skin, tool::FileCosts* costs) {
  const std::vector<uint8_t> bytes = bake::bake(model, {}, nullptr);
  const AssetHandle asset = openAsset(bytes);
  supplyAll(*asset, bytes);
  if (costs) *costs = tool::fileCosts(*asset, bytes, "a baked character");
  return {bytes.size(), encodeReference(*asset, with_skin).byteCount()};
}

bool sameAttributes(const bake::AttributeSet& a, const bake::AttributeSet& b) {
  return a.normal == b.normal && a.tangent == b.tangent && a.uv_sets == b.uv_sets && a.color_sets == b.color_sets;
}

/// What a character lacks cannot be dropped: its sizes stay.
Measured measure(const std::string& name_or_path) {
  const Source source = loadCharacter(name_or_path);
  Measured measured{source.name, {}, {}};
  for (size_t v = 0; v < kVariantCount; ++v) {
    bake::Model model = source.model;
    kVariants[v].drop(model);
    const bool unchanged = v > 0 && kVariants[v].with_skin && sameAttributes(model.attributes, source.model.attributes);
    if (!unchanged) std::fprintf(stderr, "baking %s, %s\n", source.name.c_str(), kVariants[v].name);
    measured.sizes[v] = unchanged ? measured.sizes[0]
                                  : measureVariant(model, kVariants[v].with_skin, v == 0 ? &measured.costs : nullptr);
  }
  return measured;
}

template <typename Value>
double geometricMean(const std::vector<Measured>& all, const Value& value) {
  double sum = 0;
  for (const Measured& measured : all) sum += std::log(value(measured));
  return std::exp(sum / static_cast<double>(all.size()));
}

struct Means {
  double file, reference;  ///< of what they are with all attributes
  double ratio;
};

Means meansOf(const std::vector<Measured>& all, size_t v) {
  auto quotient = [](uint64_t part, uint64_t whole) { return static_cast<double>(part) / static_cast<double>(whole); };
  return {geometricMean(all, [&](const Measured& m) { return quotient(m.sizes[v].file, m.sizes[0].file); }),
          geometricMean(all, [&](const Measured& m) { return quotient(m.sizes[v].reference, m.sizes[0].reference); }),
          geometricMean(all, [&](const Measured& m) { return m.sizes[v].ratio(); })};
}

// ---- Printing

void printVariants(const std::vector<Measured>& all) {
  std::printf("| attributes | .lithe / with all | Draco / with all | .lithe / Draco |\n|---|---:|---:|---:|\n");
  for (size_t v = 0; v < kVariantCount; ++v) {
    const Means means = meansOf(all, v);
    std::printf("| %s | %.3f | %.3f | %.3f |\n", kVariants[v].name, means.file, means.reference, means.ratio);
  }
}

void printRatios(const std::vector<Measured>& all) {
  std::printf("\n.lithe / Draco by character:\n\n| character |");
  for (const Variant& variant : kVariants) std::printf(" %s |", variant.name);
  std::printf("\n|---|");
  for (size_t v = 0; v < kVariantCount; ++v) std::printf("---:|");
  std::printf("\n");
  for (const Measured& measured : all) {
    std::printf("| %s |", measured.name.c_str());
    for (const Sizes& sizes : measured.sizes) std::printf(" %.3f |", sizes.ratio());
    std::printf("\n");
  }
}

double bitsPerVertex(uint64_t bytes, const tool::FileCosts& costs) {
  return 8 * static_cast<double>(bytes) / costs.vertices;
}

std::vector<std::string> groupsOf(const tool::FileCosts& costs) {
  std::vector<std::string> groups;
  for (const tool::FileCosts::Kind& kind : costs.kinds)
    if (groups.empty() || groups.back() != kind.group) groups.push_back(kind.group);
  return groups;
}

void printGroups(const std::vector<Measured>& all) {
  const std::vector<std::string> groups = groupsOf(all.front().costs);
  std::printf(
      "\nBits per welded vertex of the finest level, with all attributes:\n\n| character | vertices | wedges |");
  for (const std::string& group : groups) std::printf(" %s |", group.c_str());
  std::printf(" file |\n|---|---:|---:|");
  for (size_t g = 0; g < groups.size(); ++g) std::printf("---:|");
  std::printf("---:|\n");
  for (const Measured& measured : all) {
    const tool::FileCosts& costs = measured.costs;
    std::printf("| %s | %u | %u |", measured.name.c_str(), costs.vertices, costs.wedges);
    for (const std::string& group : groups) std::printf(" %.2f |", bitsPerVertex(costs.bytesOf(group), costs));
    std::printf(" %.2f |\n", bitsPerVertex(measured.sizes[0].file, costs));
  }
}

/// Kinds in parts of the file: characters of all sizes count alike.
void printKinds(const std::vector<Measured>& all) {
  std::printf("\n| kind | mean bits per vertex | mean share of the file |\n|---|---:|---:|\n");
  for (size_t k = 0; k < all.front().costs.kinds.size(); ++k) {
    const tool::FileCosts::Kind& kind = all.front().costs.kinds[k];
    double bits = 0, share = 0;
    for (const Measured& measured : all) {
      const uint64_t bytes = measured.costs.kinds[k].bytes;
      bits += bitsPerVertex(bytes, measured.costs);
      share += static_cast<double>(bytes) / static_cast<double>(measured.sizes[0].file);
    }
    const double count = static_cast<double>(all.size());
    const std::string name = kind.group == kind.name ? kind.name : kind.group + ": " + kind.name;
    std::printf("| %s | %.2f | %.1f %% |\n", name.c_str(), bits / count, 100 * share / count);
  }
}

nlohmann::ordered_json jsonOf(const Measured& measured) {
  nlohmann::ordered_json json{
      {"name", measured.name}, {"vertices", measured.costs.vertices}, {"wedges", measured.costs.wedges}};
  for (size_t v = 0; v < kVariantCount; ++v)
    json["variants"][kVariants[v].name] = {{"bytes", measured.sizes[v].file},
                                           {"reference_bytes", measured.sizes[v].reference}};
  for (const tool::FileCosts::Kind& kind : measured.costs.kinds) json["bytes"][kind.group][kind.name] = kind.bytes;
  return json;
}

void printJson(const std::vector<Measured>& all) {
  nlohmann::ordered_json report;
  for (const Measured& measured : all) report["characters"].push_back(jsonOf(measured));
  for (size_t v = 0; v < kVariantCount; ++v) report["geometric_mean"][kVariants[v].name] = meansOf(all, v).ratio;
  std::printf("%s\n", report.dump(2).c_str());
}

void run(const std::vector<std::string>& names, bool json) {
  std::vector<Measured> all;
  for (const std::string& name : names) all.push_back(measure(name));
  if (json) return printJson(all);
  printVariants(all);
  printRatios(all);
  printGroups(all);
  printKinds(all);
}

}  // namespace
}  // namespace lithe::bench

int main(int argc, char** argv) {
  return lithe::bench::runOverCharacters(argc, argv, "bench_attributes [NAME|FILE.glb ...] [--json]",
                                         lithe::bench::run);
}
