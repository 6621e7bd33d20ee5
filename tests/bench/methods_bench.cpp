// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The methods of the literature side by side, and what a cap on influences costs; methods.sh runs all of it.
//
//     bench_methods seconds [NAME|FILE ...]                        what simplification takes, by metric
//     bench_methods caps [NAME|FILE ...]                           posed RMS by influence cap
//     bench_methods curves OUT.svg TITLE METHOD=COMPARE.json ...   posed RMS by frame, from `lithe compare --json`
//
// Without names: the built-in characters and the shared ones. Prints markdown.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "bench_character.h"
#include "line_plot.h"
#include "lithe/bake/compare.h"
#include "lithe/bake/cut.h"
#include "lithe/bake/simplify.h"
#include "simplified.h"

namespace lithe::bench {
namespace {

// ---- Seconds

struct Method {
  std::string name;
  bake::BakeOptions options;
};

/// The metrics, and beside the one that refits what it is without: no paper has a refit.
std::vector<Method> methods() {
  std::vector<Method> list;
  for (const std::string& metric : bake::metricNames()) {
    list.push_back({metric, {}});
    list.back().options.metric = metric;
    if (metric != bake::BakeOptions{}.metric) continue;
    list.push_back({metric + " --no-refit", list.back().options});
    list.back().options.refit = false;
  }
  return list;
}

void printSeconds(const std::vector<std::string>& names) {
  std::printf("| character | triangles | poses |");
  for (const Method& method : methods()) std::printf(" %s |", method.name.c_str());
  std::printf("\n|---|---:|---:|");
  for (size_t i = 0; i < methods().size(); ++i) std::printf("---:|");
  std::printf("\n");
  for (const std::string& name : names) {
    const Source source = loadCharacter(name);
    const std::vector<bake::Pose> poses = bake::choosePoses(source.model, bake::BakeOptions{}.poses);
    std::printf("| %s | %zu | %zu |", source.name.c_str(), source.model.triangles.size(), poses.size());
    for (const Method& method : methods()) {
      std::printf(" %.2f |", simplified(source.model, poses, method.options).seconds);
      std::fflush(stdout);
    }
    std::printf("\n");
  }
}

// ---- Influence caps

constexpr uint32_t kCaps[] = {1, 2, 4, 8};
constexpr double kShares[] = {1.0, 0.2, 0.05};
constexpr double kAllowedLoss = 3.0;  // per cent of four influences against eight, the most the file can hold

uint32_t mostInfluences(const bake::Model& model) {
  uint32_t most = 0;
  for (const bake::Skin& skin : model.skins) most = std::max<uint32_t>(most, skin.count);
  return most;
}

/// In ten frames of its clips, which lie between those that a bake chooses from; without clips, in sampled poses, some
/// of which it was baked on.
double posedRms(const Source& source, const Simplified& simplified, double share) {
  const bake::Model cut =
      bake::cutToModel(source.model, simplified.mesh, simplified.sequence, simplified.triangles(share));
  bake::CompareOptions options;
  options.include_rigid = true;
  return bake::compare(source.model, cut, options).mean.rms;
}

void printCaps(const std::vector<std::string>& names) {
  std::printf("| character | influences | share |");
  for (const uint32_t cap : kCaps) std::printf(" n = %u |", cap);
  std::printf(" loss of 4 against 8 | limit | verdict |\n|---|---:|---:|");
  for (size_t i = 0; i < std::size(kCaps); ++i) std::printf("---:|");
  std::printf("---:|---:|---|\n");
  for (const std::string& name : names) {
    const Source source = loadCharacter(name);
    double rms[std::size(kShares)][std::size(kCaps)];
    for (size_t cap = 0; cap < std::size(kCaps); ++cap) {
      bake::BakeOptions options;
      options.max_influences = kCaps[cap];
      const Simplified result = simplified(source.model, bake::choosePoses(source.model, options.poses), options);
      for (size_t share = 0; share < std::size(kShares); ++share)
        rms[share][cap] = posedRms(source, result, kShares[share]);
    }
    for (size_t share = 0; share < std::size(kShares); ++share) {
      std::printf("| %s | %u | %g %% |", source.name.c_str(), mostInfluences(source.model), 100.0 * kShares[share]);
      for (const double value : rms[share]) std::printf(" %.4f |", 1e4 * value);
      const double loss = std::round(1000.0 * (rms[share][2] / rms[share][3] - 1.0)) / 10.0 + 0.0;  // no -0.0
      std::printf(" %.1f %% | %g %% | %s |\n", loss, kAllowedLoss, loss <= kAllowedLoss ? "pass" : "over");
      std::fflush(stdout);
    }
  }
}

// ---- Curves

nlohmann::json readJson(const std::filesystem::path& path) {
  std::ifstream file(path);
  nlohmann::json json = nlohmann::json::parse(file, nullptr, false);
  if (json.is_discarded()) throw bake::Error(path.string() + " is no JSON");
  return json;
}

void printCurves(const std::filesystem::path& output, const std::string& title,
                 const std::vector<std::string>& arguments) {
  LinePlot plot{title, "frame", "posed RMS distance, 1e-4 of the rest diagonal", {}};
  std::printf("| method | triangles | mean RMS | worst frame's RMS | largest distance |\n|---|---:|---:|---:|---:|\n");
  for (const std::string& argument : arguments) {
    const size_t equals = argument.find('=');
    if (equals == std::string::npos) throw bake::Error("\"" + argument + "\" is not METHOD=COMPARE.json");
    const nlohmann::json report = readJson(argument.substr(equals + 1));
    PlotLine line{argument.substr(0, equals), {}};
    for (const nlohmann::json& frame : report.at("frames")) {
      line.values.push_back(1e4 * frame.at("symmetric").at("rms").get<double>());
    }
    std::printf("| %s | %u | %.3f | %.3f | %.2f |\n", line.name.c_str(),
                report.at("simplified").at("triangles").get<uint32_t>(), 1e4 * report.at("rms_mean").get<double>(),
                *std::max_element(line.values.begin(), line.values.end()), 1e4 * report.at("max").get<double>());
    plot.lines.push_back(std::move(line));
  }
  std::ofstream file(output, std::ios::binary);
  if (!(file << toSvg(plot)).flush()) throw bake::Error("cannot write " + output.string());
}

int run(const std::vector<std::string>& arguments) {
  const std::string what = arguments.empty() ? "" : arguments[0];
  const std::vector<std::string> rest(arguments.begin() + (arguments.empty() ? 0 : 1), arguments.end());
  if (what == "seconds") return printSeconds(rest.empty() ? defaultCharacters() : rest), 0;
  if (what == "caps") return printCaps(rest.empty() ? defaultCharacters() : rest), 0;
  if (what == "curves" && rest.size() > 2) return printCurves(rest[0], rest[1], {rest.begin() + 2, rest.end()}), 0;
  std::fprintf(stderr,
               "bench_methods seconds [NAME|FILE ...]\nbench_methods caps [NAME|FILE ...]\n"
               "bench_methods curves OUT.svg TITLE METHOD=COMPARE.json ...\n");
  return 2;
}

}  // namespace
}  // namespace lithe::bench

int main(int argc, char** argv) try {
  return lithe::bench::run({argv + 1, argv + argc});
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
