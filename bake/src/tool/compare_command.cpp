// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// `lithe compare`: the posed distance between two characters.
#include "lithe/bake/compare.h"

#include <cstdio>
#include <memory>
#include <optional>

#include "command.h"
#include "files.h"
#include "lithe/bake/import.h"
#include "lithe/bake/output_files.h"
#include "text.h"

namespace lithe::tool {
namespace {

struct CompareArguments {
  std::string original, simplified, json;
  bake::CompareOptions options;
  std::optional<double> fail_above_rms;
  bool quiet = false;
};

void print(const bake::CompareReport& report, const CompareArguments& arguments) {
  if (!arguments.json.empty()) writeText(arguments.json, bake::compareJson(report));
  if (!arguments.quiet && arguments.json != "-") std::fputs(bake::compareText(report).c_str(), stdout);
}

void requireBelow(const bake::CompareReport& report, const CompareArguments& arguments) {
  if (!arguments.fail_above_rms || report.mean.rms <= *arguments.fail_above_rms) return;
  throw bake::Error(
      arguments.simplified + ": " +
      format("posed RMS distance %.6g of the rest diagonal is above the allowed %.6g; keep more triangles",
             report.mean.rms, *arguments.fail_above_rms));
}

ExitCode compare(const CompareArguments& arguments) {
  if (!arguments.json.empty() && arguments.json != "-") bake::requireWritable(arguments.json);
  const bake::Model original = bake::importGltf(arguments.original);
  const bake::Model simplified = bake::importGltf(arguments.simplified);
  const bake::CompareReport report = bake::compare(original, simplified, arguments.options);
  print(report, arguments);
  requireBelow(report, arguments);
  return kDone;
}

void addOptions(CLI::App& command, CompareArguments& arguments) {
  bake::CompareOptions& options = arguments.options;
  command.add_option("original", arguments.original, "The full character, .glb or .gltf")->required();
  command.add_option("simplified", arguments.simplified, "The one to measure against it")->required();
  command
      .add_option("--anim", options.animation, "all, a clip's name or number, sampled (poses) or none (the rest pose)")
      ->capture_default_str();
  command.add_option("--frames", options.frames, "Frames over all clips; 0: every clip at 30 a second")
      ->capture_default_str();
  const auto setPhase = [&options](const std::string& name) {
    options.phase = name == "mid"    ? bake::FramePhase::kMid
                    : name == "ends" ? bake::FramePhase::kEnds
                                     : bake::FramePhase::kBetween;
  };
  command
      .add_option_function<std::string>("--phase", setPhase,
                                        "Frames in the middle of equal slices (mid), from first to last key (ends), or "
                                        "halfway between instants that a bake may have seen (between)")
      ->check(CLI::IsMember({"mid", "ends", "between"}))
      ->default_str("mid");
  command
      .add_option("--first-pose", options.first_pose,
                  "Number of the first sampled pose; a bake without clips sees 0 to 14")
      ->check(CLI::Range(0u, 1000000000u))
      ->capture_default_str();
  command.add_option("--beyond", options.beyond, "Say how many samples are farther than this, in the file's units")
      ->check(CLI::NonNegativeNumber);
  command.add_option("--samples", options.samples, "Points per frame and direction")
      ->check(CLI::Range(1u, 10000000u))
      ->capture_default_str();
  command.add_option("--seed", options.seed, "Of the samples")->capture_default_str();
  command.add_option("--threads", options.threads, "0: one per core; the result is the same")->capture_default_str();
  command.add_flag("--include-rigid", options.include_rigid, "Measure rigid parts too, not only skinned ones");
  command
      .add_option("--fail-above-rms", arguments.fail_above_rms,
                  "Exit with 1 when the mean posed RMS distance, in rest diagonals, is larger")
      ->check(CLI::NonNegativeNumber);
  command.add_option("--json", arguments.json,
                     "Write the report as JSON to this file; - is stdout, instead of the text");
  command.add_flag("--quiet", arguments.quiet, "Print nothing when all is well");
}

}  // namespace

void addCompareCommand(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command = app.add_subcommand("compare", "Posed surface distance between a character and a simplified one");
  addOptions(*command, *arguments);
  command->callback([arguments, &action] { action = [arguments] { return compare(*arguments); }; });
}

}  // namespace lithe::tool
