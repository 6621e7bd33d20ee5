// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Writes the demonstration's report: one HTML page with everything in it, from the JSON and the pictures of a folder.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "chart.h"
#include "error.h"
#include "html.h"

namespace {

using Json = nlohmann::json;

/// What the demonstration left in its folder for one character.
struct Baked {
  std::string name, color;
  Json info;  ///< of `lithe info --json`
  uint64_t source_bytes = 0;
};

struct Demo {
  std::filesystem::path folder;
  std::vector<Baked> characters;
  Json crowd;
  std::vector<std::string> stage_times;  ///< lines of times.txt
};

Json readJson(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw sample::Error(path.string() + ": cannot be opened");
  return Json::parse(file);
}

Demo readDemo(const std::filesystem::path& folder, const std::vector<std::string>& names) {
  static constexpr const char* kColors[] = {"#c0392b", "#2471a3", "#1e8449", "#7d3c98", "#b9770e"};
  Demo demo{folder, {}, readJson(folder / "crowd.json"), {}};
  for (const std::string& name : names) {
    demo.characters.push_back({name, kColors[demo.characters.size() % std::size(kColors)],
                               readJson(folder / (name + "_info.json")),
                               std::filesystem::file_size(folder / (name + ".glb"))});
  }
  std::ifstream times(folder / "times.txt");
  for (std::string line; std::getline(times, line);) demo.stage_times.push_back(line);
  return demo;
}

std::string fact(const std::string& value, const std::string& meaning) {
  return "<div><b>" + value + "</b>" + meaning + "</div>\n";
}

/// The four numbers that matter, of the picture with the most instances in it.
std::string facts(const Demo& demo) {
  const Json* widest = &demo.crowd["pictures"][0];
  for (const Json& picture : demo.crowd["pictures"]) {
    if (picture["seen"] > (*widest)["seen"]) widest = &picture;
  }
  uint64_t first = 0, all = 0;
  for (const Baked& baked : demo.characters) {
    first += baked.info["levels"][0]["bytes"].get<uint64_t>();
    all += baked.info["bytes"].get<uint64_t>();
  }
  const double triangles = (*widest)["triangles"], finest = (*widest)["finest_triangles"];
  return "<div class=\"facts\">\n" +
         fact(grouped((*widest)["instances"]), "skinned instances, each with its own animation time") +
         fact(number("%.0f", finest / triangles) + " times fewer",
              "triangles than at the finest level: " + grouped((*widest)["triangles"]) + " instead of " +
                  grouped((*widest)["finest_triangles"])) +
         fact(bytesText(first), "read before the first picture, " +
                                    number("%.1f %%", 100.0 * static_cast<double>(first) / static_cast<double>(all)) +
                                    " of the files") +
         fact(number("%.3f ms", (*widest)["select_ms"].get<double>() + (*widest)["draws_ms"].get<double>()),
              "to choose every instance's level and fill the draws") +
         "</div>\n";
}

std::string crowdFigure(const Demo& demo, const Json& picture, const char* key) {
  const std::string name = picture[key];
  return "<figure>" + embeddedImage(demo.folder / name, name) + "<figcaption>" +
         number("%.1f s: ", picture["seconds"]) + grouped(picture["seen"]) + " instances seen, " +
         grouped(picture["triangles"]) + " triangles in " + grouped(picture["draws"]) + " draws, " +
         bytesText(picture["streamed_bytes"]) + " streamed</figcaption></figure>\n";
}

std::string crowdSection(const Demo& demo) {
  std::string html =
      "<h2>The crowd along the camera path</h2>\n<p>Nothing but each file's first page is there at the start; finer "
      "pages arrive over a link of " +
      bytesText(demo.crowd["bytes_per_second"]) +
      " per second as the camera comes near. Every instance is drawn at the coarsest level whose error stays below " +
      number("%g", demo.crowd["threshold_px"]) + " pixels.</p>\n<div class=\"two\">\n";
  for (const Json& picture : demo.crowd["pictures"]) {
    html += crowdFigure(demo, picture, "picture");
    if (picture.contains("levels_picture")) html += crowdFigure(demo, picture, "levels_picture");
  }
  return html + "</div>\n";
}

std::string timelineCharts(const Demo& demo) {
  Series streamed{"streamed", "#2471a3", {}}, resident{"on the GPU", "#7d3c98", {}},
      triangles{"triangles", "#c0392b", {}};
  for (const Json& moment : demo.crowd["timeline"]) {
    streamed.points.emplace_back(moment["seconds"], moment["streamed_bytes"]);
    resident.points.emplace_back(moment["seconds"], moment["gpu_bytes"]);
    triangles.points.emplace_back(moment["seconds"], moment["triangles"]);
  }
  const Axis seconds{"seconds along the path", false, ""};
  return "<div class=\"two\">\n<figure>" + lineChart(seconds, {"bytes", false, "B"}, {streamed, resident}) +
         "</figure>\n<figure>" + lineChart(seconds, {"triangles drawn", false, ""}, {triangles}) +
         "</figure>\n</div>\n";
}

std::string characterTable(const Demo& demo) {
  std::vector<std::vector<std::string>> rows;
  for (const Baked& baked : demo.characters) {
    const uint64_t first = baked.info["levels"][0]["bytes"], all = baked.info["bytes"];
    rows.push_back({escaped(baked.name), grouped(baked.info["triangles"]), grouped(baked.info["joints"]),
                    grouped(baked.info["levels"].size()), bytesText(baked.source_bytes), bytesText(all),
                    bytesText(first),
                    number("%.1f %%", 100.0 * static_cast<double>(first) / static_cast<double>(all))});
  }
  return htmlTable(
      {"character", "triangles", "joints", "levels", "source .glb", ".lithe", "first picture", "of the file"}, rows);
}

Series levelSeries(const Baked& baked, const char* x_key, const char* y_key) {
  Series series{baked.name, baked.color, {}};
  const double diagonal = baked.info["rest_diagonal"];
  for (const Json& level : baked.info["levels"]) {
    series.points.emplace_back(level[x_key].get<double>(), 100 * level[y_key].get<double>() / diagonal);
  }
  return series;
}

std::string errorCharts(const Demo& demo) {
  std::vector<Series> by_triangles, by_bytes;
  for (const Baked& baked : demo.characters) {
    by_triangles.push_back(levelSeries(baked, "triangles", "error_rms"));
    by_bytes.push_back(levelSeries(baked, "bytes", "error_rms"));
  }
  const Axis error{"posed error, RMS, % of the diagonal", true, ""};
  return "<div class=\"two\">\n<figure>" + lineChart({"triangles", true, ""}, error, by_triangles) +
         "</figure>\n<figure>" + lineChart({"bytes read", true, ""}, error, by_bytes) + "</figure>\n</div>\n";
}

std::string levelTable(const Demo& demo, const Baked& baked) {
  std::vector<std::vector<std::string>> rows;
  const double diagonal = baked.info["rest_diagonal"];
  for (size_t i = 0; i < baked.info["levels"].size(); ++i) {
    const Json& level = baked.info["levels"][i];
    const std::string picture = baked.name + "_level_" + std::to_string(i) + ".png";
    rows.push_back({embeddedImage(demo.folder / picture, picture), std::to_string(i), grouped(level["triangles"]),
                    grouped(level["vertices"]), bytesText(level["bytes"]), number("%.4g", level["error"]),
                    number("%.3f %%", 100 * level["error"].get<double>() / diagonal),
                    number("%.4f %%", 100 * level["error_rms"].get<double>() / diagonal),
                    level["error"] > 0 ? number("%.0f px", diagonal / level["error"].get<double>()) : "any"});
  }
  return htmlTable({"", "level", "triangles", "vertices", "bytes so far", "largest error", "of diagonal",
                    "RMS of diagonal", "diagonal on screen for 1 px"},
                   rows);
}

std::string characterSections(const Demo& demo) {
  std::string html = "<h2>The characters</h2>\n" + characterTable(demo) + errorCharts(demo);
  for (const Baked& baked : demo.characters) {
    const std::string sheet = baked.name + "_levels.png";
    html += "<h3>" + escaped(baked.name) + "</h3>\n<figure>" + embeddedImage(demo.folder / sheet, sheet) +
            "<figcaption>The same moment of a clip at some of the levels: shaded, with their edges, and at the size on "
            "screen where the "
            "level's largest error is one pixel (where that is smaller than the cell).</figcaption></figure>\n" +
            levelTable(demo, baked);
  }
  return html;
}

std::string stageSection(const Demo& demo) {
  std::string html = "<h2>How long it took</h2>\n<pre>";
  for (const std::string& line : demo.stage_times) html += escaped(line) + "\n";
  return html + "</pre>\n";
}

std::string report(const Demo& demo) {
  return "<h1>lithe: a streamed crowd of skinned characters</h1>\n<p class=\"quiet\">Written by samples/demo.sh. "
         "Errors are posed "
         "distances to the original that the bake measured over its example poses.</p>\n" +
         facts(demo) + crowdSection(demo) + timelineCharts(demo) + characterSections(demo) + stageSection(demo);
}

}  // namespace

int main(int argc, char** argv) {
  std::filesystem::path folder;
  std::vector<std::string> names;
  CLI::App app("Writes report.html into a folder of the demonstration", "lithe_report");
  app.add_option("folder", folder, "With crowd.json, and per character NAME.glb, NAME_info.json and its pictures")
      ->required();
  app.add_option("characters", names, "NAME ...")->required();
  CLI11_PARSE(app, argc, argv);
  try {
    const Demo demo = readDemo(folder, names);
    const std::filesystem::path page = folder / "report.html";
    std::ofstream(page, std::ios::binary) << htmlPage("lithe: a streamed crowd", report(demo));
    std::printf("%s: %s\n", page.string().c_str(), bytesText(std::filesystem::file_size(page)).c_str());
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "lithe_report: %s\n", error.what());
    return 1;
  }
}
