// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// `lithe generate`: one of the built-in characters as glTF.
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.h"
#include "lithe/bake/export.h"
#include "lithe/bake/generate.h"
#include "lithe/bake/output_files.h"
#include "text.h"

namespace lithe::tool {
namespace {

struct GenerateOptions {
  std::string name, output;
  bool json = false, quiet = false;
};

nlohmann::ordered_json describe(const bake::Model& model, const GenerateOptions& options) {
  nlohmann::ordered_json json{{"file", options.output},
                              {"name", options.name},
                              {"triangles", model.triangles.size()},
                              {"vertices", model.positions.size()},
                              {"joints", model.joints.size()},
                              {"clips", nlohmann::ordered_json::array()}};
  for (const bake::Clip& clip : model.clips) json["clips"].push_back(clip.name);
  return json;
}

std::string text(const nlohmann::ordered_json& json) {
  std::string clips;
  for (const auto& clip : json["clips"]) clips += (clips.empty() ? "" : ", ") + clip.get<std::string>();
  return json["file"].get<std::string>() + ": " + json["name"].get<std::string>() + ", " + grouped(json["triangles"]) +
         " triangles, " + grouped(json["vertices"]) + " vertices, " + json["joints"].dump() + " joints, clips " +
         clips + "\n";
}

ExitCode generate(const GenerateOptions& options) {
  bake::requireWritable(options.output);
  const bake::Model model = bake::generate(options.name);
  bake::writeGltf(model, options.output, {});
  const nlohmann::ordered_json json = describe(model, options);
  if (options.json)
    std::fputs((json.dump(2) + "\n").c_str(), stdout);
  else if (!options.quiet)
    std::fputs(text(json).c_str(), stdout);
  return kDone;
}

}  // namespace

void addGenerateCommand(CLI::App& app, Action& action) {
  const auto options = std::make_shared<GenerateOptions>();
  CLI::App* command = app.add_subcommand("generate", "Write one of the built-in characters as glTF");
  command->add_option("name", options->name, "The character")->required()->check(CLI::IsMember(bake::generatorNames()));
  command->add_option("-o,--output", options->output, "The .glb or .gltf to write")->required();
  command->add_flag("--json", options->json, "Print JSON");
  command->add_flag("--quiet", options->quiet, "Print nothing when all is well");
  command->callback([options, &action] { action = [options] { return generate(*options); }; });
}

}  // namespace lithe::tool
