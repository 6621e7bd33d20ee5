// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// `lithe export`: any level, or any triangle count between them, as plain skinned glTF.
#include "lithe/bake/export.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "asset.h"
#include "asset_model.h"
#include "command.h"
#include "lithe/bake/output_files.h"
#include "text.h"

namespace lithe::tool {
namespace {

struct WriteOptions {
  std::string file, output, from;
  std::optional<uint32_t> triangles, level;
  std::optional<double> ratio;
  bool all_levels = false, json = false, quiet = false;
};

void requireLevel(const Asset& asset, uint32_t level) {
  if (level < asset.info().level_count) return;
  throw bake::Error(asset.name() + ": has no level " + std::to_string(level) + "; choose 0 (coarsest) to " +
                    std::to_string(asset.info().level_count - 1));
}

/// The models to write: one, or every level, finest first.
std::vector<bake::Model> chosenModels(Asset& asset, const WriteOptions& options) {
  std::vector<bake::Model> models;
  if (options.level) {
    requireLevel(asset, *options.level);
    asset.load(*options.level);
    models.push_back(modelOfLevel(asset, *options.level));
    return models;
  }
  asset.loadAll();
  if (options.all_levels) {
    for (uint32_t level = asset.info().level_count; level-- > 0;) models.push_back(modelOfLevel(asset, level));
    return models;
  }
  const double wanted =
      options.triangles ? *options.triangles : std::round(*options.ratio * asset.info().triangle_count);
  models.push_back(modelOfTriangles(asset, static_cast<uint32_t>(std::max(wanted, 1.0))));
  return models;
}

void warnWhenFarOff(const bake::Model& model, const WriteOptions& options) {
  if (!options.triangles) return;
  const double got = static_cast<double>(model.triangles.size());
  if (std::abs(got - *options.triangles) <= 0.01 * *options.triangles) return;
  std::fprintf(stderr, "lithe: warning: %s: %u triangles are outside what it holds; wrote %zu\n", options.file.c_str(),
               *options.triangles, model.triangles.size());
}

ExitCode exportFile(const WriteOptions& options) {
  bake::requireWritable(options.output);
  Asset asset = Asset::open(options.file);
  const std::vector<bake::Model> models = chosenModels(asset, options);
  bake::ExportOptions write;
  write.from = options.from;
  if (options.all_levels)
    bake::writeGltfLevels(models, options.output, write);
  else
    bake::writeGltf(models.front(), options.output, write);
  if (!options.quiet) warnWhenFarOff(models.front(), options);

  nlohmann::ordered_json json{{"file", options.output}};
  std::string text = options.output + ":";
  for (const bake::Model& model : models) {
    json["meshes"].push_back({{"triangles", model.triangles.size()}, {"vertices", model.positions.size()}});
    text += (&model == models.data() ? " " : ", ") + grouped(model.triangles.size()) + " triangles";
  }
  if (options.json)
    std::fputs((json.dump(2) + "\n").c_str(), stdout);
  else if (!options.quiet)
    std::fputs((text + "\n").c_str(), stdout);
  return kDone;
}

}  // namespace

void addExportCommand(CLI::App& app, Action& action) {
  const auto options = std::make_shared<WriteOptions>();
  CLI::App* command = app.add_subcommand("export", "Write a level, or any triangle count, as plain skinned glTF");
  command->add_option("file", options->file, "The .lithe file")->required();
  command->add_option("-o,--output", options->output, "The .glb or .gltf to write")->required();
  CLI::Option_group* what = command->add_option_group("What to write", "One of these:");
  what->add_option("--triangles", options->triangles, "The cut closest to this many triangles")
      ->check(CLI::PositiveNumber);
  what->add_option("--ratio", options->ratio, "The same, as a share of the finest level")->check(CLI::Range(0.0, 1.0));
  what->add_option("--level", options->level, "A level, 0 is the coarsest");
  what->add_flag("--all-levels", options->all_levels,
                 "Every level, as meshes <name>_LOD0 (finest), _LOD1, ... on one skeleton");
  what->require_option(1);
  command->add_option("--from", options->from, "Bring clips, materials and textures along from this glTF");
  command->add_flag("--json", options->json, "Print JSON");
  command->add_flag("--quiet", options->quiet, "Print nothing when all is well");
  command->callback([options, &action] { action = [options] { return exportFile(*options); }; });
}

}  // namespace lithe::tool
