// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Pictures of one character's levels: each alone, and a sheet of some side by side.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "error.h"
#include "headless.h"
#include "level_scene.h"

namespace {

struct Options {
  std::filesystem::path character, output = ".";
  PoseChoice pose;
  uint32_t columns = 5;
  int cell_width = 340, cell_height = 420;
  std::vector<std::string> rows{"shaded", "wires", "used"};
  bool each = false, plain = false;
};

void describe(CLI::App& app, Options& options) {
  app.add_option("character", options.character,
                 "The .lithe file; its clips come from the .glb of the same name beside it")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_option("--out", options.output, "Folder for NAME_levels.png and NAME_level_K.png");
  app.add_option("--clip", options.pose.clip, "Clip to pose it by; its first one if not given");
  app.add_option("--fraction", options.pose.fraction, "How far into the clip, 0 to 1")->check(CLI::Range(0.0, 1.0));
  app.add_option("--turn", options.pose.turn, "Degrees turned from facing the camera");
  app.add_option("--elevation", options.pose.elevation, "Degrees that the camera looks down")
      ->check(CLI::Range(0.0, 85.0));
  app.add_option("--columns", options.columns, "Levels on the sheet")->check(CLI::Range(1, 16));
  app.add_option("--cell-width", options.cell_width, "Pixels")->check(CLI::Range(64, 4096));
  app.add_option("--cell-height", options.cell_height, "Pixels")->check(CLI::Range(64, 4096));
  app.add_option("--rows", options.rows, "What the sheet shows of each level")
      ->delimiter(',')
      ->check(CLI::IsMember({"shaded", "wires", "checker", "used"}));
  app.add_flag("--plain", options.plain, "No labels");
  app.add_flag("--each", options.each, "Write every level's own picture too");
}

std::string grouped(uint64_t value) {
  std::string digits = std::to_string(value);
  for (size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
  return digits;
}

/// Levels whose triangle counts step evenly (in factors) from the finest to the coarsest.
std::vector<uint32_t> chooseLevels(const sample::Character& character, uint32_t count) {
  const auto& levels = character.levels;
  const double finest = std::log(std::max(levels.back().triangle_count, 1u));
  const double coarsest = std::log(std::max(levels.front().triangle_count, 1u));
  std::vector<uint32_t> chosen;
  for (uint32_t i = 0; i < count; ++i) {
    const double wish = count < 2 ? finest : finest + (coarsest - finest) * i / (count - 1);
    uint32_t best = 0;
    for (uint32_t level = 0; level < levels.size(); ++level) {
      const auto away = [&](uint32_t l) { return std::abs(std::log(std::max(levels[l].triangle_count, 1u)) - wish); };
      if (away(level) < away(best)) best = level;
    }
    if (chosen.empty() || chosen.back() != best) chosen.push_back(best);
  }
  return chosen;
}

void paste(const sample::Picture& cell, sample::Picture& sheet, int x, int y) {
  for (int row = 0; row < cell.height; ++row) {
    std::copy_n(&cell.rgb[size_t{3} * row * cell.width], size_t{3} * cell.width,
                &sheet.rgb[size_t{3} * ((y + row) * size_t(sheet.width) + x)]);
  }
}

/// Pixels per unit at which the level's error is one pixel: as large as it may be shown. 0: at any size.
float usableScale(const LevelScene& scene, uint32_t level) {
  const float error = scene.character().levels[level].error;
  return error > 0 ? 1 / error : 0;
}

std::string usableText(const LevelScene& scene, float scale) {
  const bool tall = scene.posedHeight() >= scene.posedWidth();
  const float pixels = scale * (tall ? scene.posedHeight() : scene.posedWidth());
  return scale > 0 ? "up to " + grouped(static_cast<uint64_t>(pixels)) + (tall ? " pixels tall" : " pixels wide")
                   : "any size";
}

int rowHeight(const std::string& row, const Options& options) {
  return row == "used" ? options.cell_height / 2 : options.cell_height;
}

/// One cell of a row: "shaded", "wires", "checker", or "used", which is as small as a pixel of error asks for.
Shot shotFor(const std::string& row, const LevelScene& scene, uint32_t index, const Options& options) {
  Shot shot{index, options.cell_width, rowHeight(row, options), 0, row == "wires", row == "checker", row != "used", {}};
  const lithe_level& level = scene.character().levels[index];
  if (row == "shaded" && !options.plain)
    shot.labels = {grouped(level.triangle_count) + " triangles", grouped(level.bytes_end) + " bytes"};
  if (row == "used") {
    const float scale = usableScale(scene, index);
    if (!options.plain) shot.labels = {usableText(scene, scale)};
    const bool fits = scale * scene.posedHeight() < 0.7f * static_cast<float>(shot.height) &&
                      scale * scene.posedWidth() < 0.9f * static_cast<float>(shot.width);
    if (fits) shot.pixels_per_unit = scale;
  }
  return shot;
}

sample::Picture drawSheet(LevelScene& scene, const Options& options) {
  const std::vector<uint32_t> levels = chooseLevels(scene.character(), options.columns);
  int height = 0;
  for (const std::string& row : options.rows) height += rowHeight(row, options);
  sample::Picture sheet(options.cell_width * static_cast<int>(levels.size()), height);
  for (size_t column = 0; column < levels.size(); ++column) {
    int y = 0;
    for (const std::string& row : options.rows) {
      const sample::Picture cell = scene.draw(shotFor(row, scene, levels[column], options));
      paste(cell, sheet, options.cell_width * static_cast<int>(column), y);
      y += cell.height;
    }
  }
  return sheet;
}

void writeEach(LevelScene& scene, const Options& options) {
  for (uint32_t level = 0; level < scene.character().info.level_count; ++level) {
    const Shot shot{level, options.cell_width, options.cell_height, 0, false, false, true, {}};
    sample::writePng(scene.draw(shot),
                     options.output / (scene.character().name + "_level_" + std::to_string(level) + ".png"));
  }
}

void writePictures(const Options& options) {
  const sample::Headless context;
  const std::filesystem::path gltf = std::filesystem::path(options.character).replace_extension(".glb");
  LevelScene scene(sample::openCharacter(options.character), gltf, options.pose);
  std::filesystem::create_directories(options.output);
  const std::filesystem::path sheet = options.output / (scene.character().name + "_levels.png");
  sample::writePng(drawSheet(scene, options), sheet);
  if (options.each) writeEach(scene, options);
  std::printf("%s: %u levels of %s\n", sheet.string().c_str(), scene.character().info.level_count,
              scene.character().name.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Pictures of a character's levels side by side", "lithe_levels");
  describe(app, options);
  CLI11_PARSE(app, argc, argv);
  try {
    writePictures(options);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "lithe_levels: %s\n", error.what());
    return 1;
  }
}
