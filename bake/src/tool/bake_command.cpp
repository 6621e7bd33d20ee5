// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// `lithe bake`: glTF in, a checked .lithe file out.
#include <cstdio>
#include <memory>

#include "asset.h"
#include "asset_checks.h"
#include "bake_report.h"
#include "command.h"
#include "files.h"
#include "lithe/bake/bake.h"
#include "lithe/bake/import.h"
#include "lithe/bake/output_files.h"
#include "lithe/bake/simplify.h"
#include "progress.h"

namespace lithe::tool {
namespace {

struct BakeArguments {
  std::string input, output, json;
  bake::BakeOptions options;
  std::string pose_file;
  bool quiet = false;
};

/// Nothing is written that the real reader does not take, level for level.
void requireReadable(const std::vector<uint8_t>& bytes, const std::string& name, Progress& progress) {
  progress.report("check", 0.0);
  Asset asset = Asset::openBytes(bytes, name);
  checkTables(asset);
  const uint32_t levels = asset.info().level_count;
  for (uint32_t level = 0; level < levels; ++level) {
    asset.load(level);
    checkLevel(asset, level);
    progress.report("check", (level + 1.0) / levels);
  }
}

/// The stages know no file names; a pose file's complaint has its own.
std::vector<uint8_t> bakeModel(const bake::Model& model, const BakeArguments& arguments, bake::BakeReport& report) {
  try {
    return bake::bake(model, arguments.options, &report);
  } catch (const bake::Error& error) {
    const std::string what = error.what();
    const bool named = !arguments.pose_file.empty() && what.rfind(arguments.pose_file, 0) == 0;
    throw bake::Error(named ? what : arguments.input + ": " + what);
  }
}

/// A file without a size would be refused by every reader.
void requireSize(const bake::BakeReport& report, const std::string& input) {
  if (report.posed_diagonal > 0) return;
  throw bake::Error(input + ": every pose shrinks it to a point; choose --clips in which it is to be seen");
}

ExitCode bakeFile(BakeArguments arguments) {
  const bool json_file = !arguments.json.empty() && arguments.json != "-";
  bake::requireWritable(arguments.output);
  if (json_file) bake::requireWritable(arguments.json);
  Progress progress(arguments.quiet);
  progress.report("import", 0.0);
  const bake::Model model = bake::importGltf(arguments.input);
  arguments.options.poses.file = arguments.pose_file;
  arguments.options.progress = [&](const char* stage, double fraction) { progress.report(stage, fraction); };
  bake::BakeReport report;
  const std::vector<uint8_t> bytes = bakeModel(model, arguments, report);
  requireSize(report, arguments.input);
  requireReadable(bytes, arguments.output, progress);
  progress.finish();

  const std::string json = bakeJson(report, arguments.input, arguments.output);
  std::vector<bake::OutputFile> files{{arguments.output, bytes}};
  if (json_file) files.push_back({arguments.json, bytesOf(json)});
  bake::writeTogether(files);
  if (arguments.json == "-") std::fputs(json.c_str(), stdout);
  if (arguments.quiet) return kDone;
  for (const std::string& warning : report.warnings) {
    std::fprintf(stderr, "lithe: warning: %s: %s\n", arguments.input.c_str(), warning.c_str());
  }
  if (arguments.json != "-") std::fputs(bakeText(report, arguments.input, arguments.output).c_str(), stdout);
  return kDone;
}

// ---- Arguments -----------------------------------------------------------------------------------------------------

/// Spelling is bad usage; what the model lacks is for the bake to say.
std::string checkAttribute(const std::string& name) {
  const auto isSet = [&](const std::string& prefix, char last) {
    return name.size() == prefix.size() + 1 && name.rfind(prefix, 0) == 0 && name.back() >= '0' && name.back() <= last;
  };
  if (name == "normal" || name == "tangent" || isSet("uv", '7') || isSet("color", '1')) return {};
  return "'" + name + "' is no attribute: use normal, tangent, uv0 to uv7, color0, color1";
}

/// Shares of the finest level's triangles: (0, 1].
std::string checkShare(const std::string& text) {
  char* end = nullptr;
  const double share = std::strtod(text.c_str(), &end);
  return end != text.c_str() && *end == '\0' && share > 0 && share <= 1 ? ""
                                                                        : "'" + text + "' is not above 0 and at most 1";
}

/// Turns "auto" into the number that stands for it.
std::string readWeightBits(std::string& text) {
  if (text == "auto") text = "0";
  const bool number = !text.empty() && text.size() <= 2 && text.find_first_not_of("0123456789") == std::string::npos;
  const int bits = number ? std::stoi(text) : -1;
  return bits == 0 || (bits >= 4 && bits <= 16) ? "" : "'" + text + "' is not auto, 0 or 4 to 16";
}

void addChoices(CLI::App& command, BakeArguments& arguments) {
  bake::BakeOptions& options = arguments.options;
  command.add_option("--metric", options.metric, "How a collapse is judged")
      ->check(CLI::IsMember(bake::metricNames()))
      ->capture_default_str();
  command
      .add_option("--poses", options.poses.count, "Example poses to choose from the clips, or to sample without clips")
      ->check(CLI::Range(1u, 256u))
      ->capture_default_str();
  command.add_option("--clips", options.poses.clips, "Take poses from these clips only: NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_flag_callback(
      "--no-refit", [&options] { options.refit = false; }, "Leave the levels' vertices where their collapses put them");
  command.add_option("--pose-file", arguments.pose_file, "Take exactly the poses of this JSON file");
  command.add_option("--max-influences", options.max_influences, "Joints per vertex, at every level")
      ->check(CLI::Range(1u, 8u))
      ->capture_default_str();
  command
      .add_option("--attributes", options.attributes,
                  "What to carry: normal,tangent,uv0,...,color0,... (default: normals, tangents, uv0 and color0 where "
                  "they say something)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::Validator(checkAttribute, "NAME,..."));
  command.add_option("--levels", options.levels, "Triangles of the levels as shares of the finest")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::Validator(checkShare, "SHARE,..."));
}

void addPrecision(CLI::App& command, bake::BakeOptions& options) {
  const auto bits = [&](const char* name, uint32_t& value, uint32_t least, uint32_t most, const char* what) {
    command.add_option(name, value, what)->check(CLI::Range(least, most))->capture_default_str();
  };
  bits("--position-bits", options.position_bits, 8, 16, "Grid of the positions, per axis");
  bits("--normal-bits", options.normal_bits, 4, 15, "Octahedral normals and tangents, per component");
  bits("--uv-bits", options.uv_bits, 4, 16, "Grid of the uvs, per part and component");
  command
      .add_option("--weight-bits", options.weight_bits,
                  "The weights of a vertex sum to 2^bits - 1; 0 or auto chooses the 8 to 12 bits that the blends need")
      ->transform(CLI::Validator(readWeightBits, "BITS"))
      ->default_str("auto");
  bits("--precision", options.precision, 0, 31, "How finely coarse vertices are placed: more is better and larger");
}

}  // namespace

void addBakeCommand(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<BakeArguments>();
  CLI::App* command = app.add_subcommand("bake", "Make a .lithe file of a glTF character");
  command->add_option("input", arguments->input, "The character, .glb or .gltf")->required();
  command->add_option("-o,--output", arguments->output, "The .lithe file to write")->required();
  addChoices(*command, *arguments);
  addPrecision(*command, arguments->options);
  command->add_option("--threads", arguments->options.threads, "0: one per core; the bytes are the same")
      ->capture_default_str();
  command->add_option("--json", arguments->json,
                      "Write the report as JSON to this file; - is stdout, instead of the text");
  command->add_flag("--quiet", arguments->quiet, "Print nothing when all is well, not even warnings");
  command->callback([arguments, &action] { action = [arguments] { return bakeFile(*arguments); }; });
}

}  // namespace lithe::tool
