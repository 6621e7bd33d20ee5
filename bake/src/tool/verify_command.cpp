// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// `lithe verify`: every check a reader makes, every level decoded, and what was stated held against the original.
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "asset.h"
#include "asset_checks.h"
#include "asset_model.h"
#include "command.h"
#include "lithe/bake/compare.h"
#include "lithe/bake/import.h"
#include "progress.h"
#include "text.h"

namespace lithe::tool {
namespace {

using Json = nlohmann::ordered_json;

struct VerifyOptions {
  std::string file, against;
  bool json = false, quiet = false;
};

/// Supplies the levels one after the other, as an engine would, and checks each as soon as it can be drawn.
std::vector<uint64_t> checkWhileLoading(Asset& asset, Progress& progress) {
  std::vector<uint64_t> fingerprints;
  const uint32_t count = asset.info().level_count;
  for (uint32_t level = 0; level < count; ++level) {
    asset.load(level);
    checkLevel(asset, level);
    fingerprints.push_back(fingerprint(asset, level));
    progress.report("decode", (level + 1.0) / count);
  }
  return fingerprints;
}

/// What a frame in flight reads of a coarse level must not have moved when finer ones arrived.
void requireUnmoved(const Asset& asset, const std::vector<uint64_t>& fingerprints) {
  for (uint32_t level = 0; level < fingerprints.size(); ++level) {
    if (fingerprint(asset, level) == fingerprints[level]) continue;
    throw bake::Error(asset.name() + ": level " + std::to_string(level) +
                      ": its buffers changed when finer levels were loaded; report this as a bug of lithe");
  }
}

/// A level's posed distance to the original. The stated error is the largest distance the bake measured, so even in
/// poses that the bake did not see the root mean square must stay below it.
Json measure(const Asset& asset, const bake::Model& original, uint32_t level) {
  bake::CompareOptions options;
  options.include_rigid = true;
  const bake::CompareReport report = bake::compare(original, modelOfLevel(asset, level), options);
  const double rms = report.mean.rms * report.rest_diagonal, stated = asset.level(level).error;
  // The grid's rounding is not part of the stated error of the finest level.
  const double rounding = 2 * asset.info().position_scale / 32767;
  if (rms > stated + rounding) {
    throw bake::Error(
        asset.name() + ": level " + std::to_string(level) +
        format(": posed RMS distance %.6g is above the stated error %.6g; bake it again with more --poses", rms,
               stated));
  }
  return {{"rms", rms}, {"max", report.worst.max * report.rest_diagonal}, {"rms_of_diagonal", report.mean.rms}};
}

Json verifyLevels(const Asset& asset, const VerifyOptions& options, Progress& progress) {
  std::optional<bake::Model> original;
  if (!options.against.empty()) original = bake::importGltf(options.against);
  Json levels = Json::array();
  for (uint32_t level = 0; level < asset.info().level_count; ++level) {
    const lithe_level record = asset.level(level);
    Json json{{"triangles", record.triangle_count}, {"vertices", record.vertex_count}, {"error", record.error}};
    // A tiny character may end in nothing at all, from which there is no distance.
    if (original && record.triangle_count > 0) json["measured"] = measure(asset, *original, level);
    levels.push_back(std::move(json));
    progress.report("measure", (level + 1.0) / asset.info().level_count);
  }
  return levels;
}

std::string text(const Json& json) {
  std::vector<std::vector<std::string>> rows{{"level", "triangles", "vertices", "stated error"}};
  const Json& levels = json["levels"];
  const bool measured = levels.back().contains("measured");
  if (measured) rows[0].insert(rows[0].end(), {"measured rms", "measured max"});
  for (size_t i = 0; i < levels.size(); ++i) {
    rows.push_back({std::to_string(i), grouped(levels[i]["triangles"]), grouped(levels[i]["vertices"]),
                    format("%.4g", levels[i]["error"].get<double>())});
    if (!levels[i].contains("measured")) continue;
    rows.back().push_back(format("%.4g", levels[i]["measured"]["rms"].get<double>()));
    rows.back().push_back(format("%.4g", levels[i]["measured"]["max"].get<double>()));
  }
  return table(rows) + json["file"].get<std::string>() + ": all checks passed, " + json["pages"].dump() +
         " pages decoded\n";
}

ExitCode verify(const VerifyOptions& options) {
  Progress progress(options.quiet);
  Asset asset = Asset::open(options.file);
  checkTables(asset);
  const std::vector<uint64_t> fingerprints = checkWhileLoading(asset, progress);
  requireUnmoved(asset, fingerprints);
  const Json json{
      {"file", options.file}, {"pages", asset.info().page_count}, {"levels", verifyLevels(asset, options, progress)}};
  progress.finish();
  if (options.json)
    std::fputs((json.dump(2) + "\n").c_str(), stdout);
  else if (!options.quiet)
    std::fputs(text(json).c_str(), stdout);
  return kDone;
}

}  // namespace

void addVerifyCommand(CLI::App& app, Action& action) {
  const auto options = std::make_shared<VerifyOptions>();
  CLI::App* command = app.add_subcommand("verify", "Every check a reader makes, and every level decoded");
  command->add_option("file", options->file, "The .lithe file")->required();
  command->add_option("--against", options->against, "Measure every level against this glTF, and its stated error too");
  command->add_flag("--json", options->json, "Print JSON");
  command->add_flag("--quiet", options->quiet, "Print nothing when all is well");
  command->callback([options, &action] { action = [options] { return verify(*options); }; });
}

}  // namespace lithe::tool
