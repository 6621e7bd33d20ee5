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
  std::string animation = "all";
  uint32_t frames = 10;
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

/// A stated error is a promise: in poses that the bake did not see, fewer samples than this share are farther away.
constexpr double kMostBeyond = 0.01;
/// Of the rest diagonal: what the floats of decoded vertices and the stored skeleton may be off beside the stated
/// error.
constexpr double kRounding = 2e-6;
/// No bake takes sampled poses with numbers as high as this.
constexpr uint32_t kUnseenPose = 1'000'000;

bake::CompareReport compareUnseen(const bake::Model& original, const bake::Model& level, double stated,
                                  const VerifyOptions& options) {
  bake::CompareOptions unseen;
  unseen.include_rigid = true;
  unseen.animation = options.animation;
  unseen.frames = options.frames;
  unseen.phase = bake::FramePhase::kBetween;
  unseen.first_pose = kUnseenPose;
  unseen.beyond = stated + kRounding * level.rest_diagonal;
  return bake::compare(original, level, unseen);
}

/// A level's posed distance to the original, and the stated error held against it.
Json measure(const Asset& asset, const bake::Model& original, uint32_t level, const VerifyOptions& options) {
  const double stated = asset.level(level).error;
  const bake::CompareReport report = compareUnseen(original, modelOfLevel(asset, level), stated, options);
  const std::string where = asset.name() + ": level " + std::to_string(level) + ": ";
  if (report.mean.beyond >= kMostBeyond) {
    throw bake::Error(where +
                      format("%.3g %% of its samples are farther away than the stated error, %.6g; bake it again with "
                             "more --poses, or poses like those it is seen in",
                             100 * report.mean.beyond, stated));
  }
  const double rms = report.mean.rms * report.rest_diagonal;
  if (rms > *report.beyond) {
    throw bake::Error(where +
                      format("posed RMS distance %.6g is above the stated error, %.6g; bake it again with more --poses",
                             rms, stated));
  }
  return {{"rms", rms},
          {"max", report.worst.max * report.rest_diagonal},
          {"beyond", report.mean.beyond},
          {"rms_of_diagonal", report.mean.rms}};
}

Json verifyLevels(const Asset& asset, const VerifyOptions& options, Progress& progress) {
  std::optional<bake::Model> original;
  if (!options.against.empty()) original = bake::importGltf(options.against);
  Json levels = Json::array();
  for (uint32_t level = 0; level < asset.info().level_count; ++level) {
    const lithe_level record = asset.level(level);
    Json json{{"triangles", record.triangle_count}, {"vertices", record.vertex_count}, {"error", record.error}};
    // A tiny character may end in nothing at all, from which there is no distance.
    if (original && record.triangle_count > 0) json["measured"] = measure(asset, *original, level, options);
    levels.push_back(std::move(json));
    progress.report("measure", (level + 1.0) / asset.info().level_count);
  }
  return levels;
}

std::string text(const Json& json) {
  std::vector<std::vector<std::string>> rows{{"level", "triangles", "vertices", "stated error"}};
  const Json& levels = json["levels"];
  const bool measured = levels.back().contains("measured");
  if (measured) rows[0].insert(rows[0].end(), {"measured rms", "measured max", "beyond"});
  for (size_t i = 0; i < levels.size(); ++i) {
    rows.push_back({std::to_string(i), grouped(levels[i]["triangles"]), grouped(levels[i]["vertices"]),
                    format("%.4g", levels[i]["error"].get<double>())});
    if (!levels[i].contains("measured")) continue;
    rows.back().push_back(format("%.4g", levels[i]["measured"]["rms"].get<double>()));
    rows.back().push_back(format("%.4g", levels[i]["measured"]["max"].get<double>()));
    rows.back().push_back(format("%.3f %%", 100 * levels[i]["measured"]["beyond"].get<double>()));
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
  command->add_option("--against", options->against,
                      "Measure every level against this glTF in poses that the bake did not see, and fail "
                      "when 1 % of the surface is farther away than stated");
  command->add_option("--anim", options->animation, "With --against: all, a clip's name or number, or sampled (poses)")
      ->capture_default_str();
  command->add_option("--frames", options->frames, "With --against: frames over all clips")
      ->check(CLI::Range(1u, 100000u))
      ->capture_default_str();
  command->add_flag("--json", options->json, "Print JSON");
  command->add_flag("--quiet", options->quiet, "Print nothing when all is well");
  command->callback([options, &action] { action = [options] { return verify(*options); }; });
}

}  // namespace lithe::tool
