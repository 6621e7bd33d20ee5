// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "options.h"

#include <CLI/CLI.hpp>

namespace {

void describe(CLI::App& app, Options& options) {
  app.add_option("characters", options.characters,
                 "The .lithe files; clips come from the .glb of the same name beside each")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_option("--instances", options.instances, "How many characters stand in the crowd")
      ->check(CLI::Range(1, 100000));
  app.add_option("--pixels", options.threshold_px, "Largest error on screen, in pixels")
      ->check(CLI::Range(0.05, 100.0));
  app.add_option("--triangles", options.triangles,
                 "At most so many triangles in the picture, and the best picture that they give (0: no limit)");
  app.add_option("--bandwidth", options.bytes_per_second, "Bytes per simulated second that pages arrive with")
      ->check(CLI::Range(1e3, 1e12));
  app.add_option("--width", options.width, "Pixels")->check(CLI::Range(64, 8192));
  app.add_option("--height", options.height, "Pixels")->check(CLI::Range(64, 8192));
  app.add_option("--frames", options.frames, "Pictures along the camera path")->check(CLI::Range(1, 1000));
  app.add_option("--out", options.output, "Folder for the pictures and crowd.json");
  app.add_flag("--lod-colors", options.level_colors, "Colour the instances by their level");
  app.add_flag("--both", options.both, "Write each picture a second time, coloured by level, as crowd_NNN_levels.png");
  app.add_flag("--window", options.window, "Open a window instead of writing pictures (L levels, P pause, Esc ends)");
  app.add_flag("!--no-shadows", options.shadows, "Leave the shadows out");
}

}  // namespace

Options readOptions(int argc, char** argv) {
  Options options;
  CLI::App app("A streamed crowd of skinned characters, each at the level its size on screen asks for", "lithe_crowd");
  describe(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::exit(app.exit(error) == 0 ? 0 : 2);
  }
  return options;
}
