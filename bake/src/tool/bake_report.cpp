// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "bake_report.h"

#include <nlohmann/json.hpp>
#include <numeric>

#include "text.h"

namespace lithe::tool {
namespace {

using Json = nlohmann::ordered_json;

double ofDiagonal(const bake::BakeReport& report, double error) {
  return report.rest_diagonal > 0 ? error / report.rest_diagonal : 0;
}

/// "-" for a level that draws nothing.
std::string bitsPerTriangle(const bake::BakedLevel& level) {
  return level.triangles > 0 ? format("%.1f", 8.0 * static_cast<double>(level.bytes_end) / level.triangles) : "-";
}

std::string levelTable(const bake::BakeReport& report) {
  std::vector<std::vector<std::string>> rows{{"level", "triangles", "share", "vertices", "bytes so far",
                                              "bits/triangle", "error", "of diagonal", "error rms"}};
  for (size_t i = 0; i < report.levels.size(); ++i) {
    const bake::BakedLevel& level = report.levels[i];
    rows.push_back({std::to_string(i), grouped(level.triangles), format("%.1f %%", 100 * level.share),
                    grouped(level.vertices), grouped(level.bytes_end), bitsPerTriangle(level),
                    format("%.3g", level.error), format("%.3f %%", 100 * ofDiagonal(report, level.error)),
                    format("%.3g", level.error_rms)});
  }
  return table(rows);
}

std::string kindTable(const bake::BakeReport& report) {
  std::vector<std::vector<std::string>> rows{{"bytes of", "bytes", "share", "bits/triangle"}};
  const double triangles = report.levels.back().triangles;
  for (const auto& kind : report.kinds) {
    const double bytes = static_cast<double>(kind.bytes);
    rows.push_back({kind.name, grouped(kind.bytes),
                    format("%.1f %%", 100 * bytes / static_cast<double>(report.file_bytes)),
                    format("%.2f", 8 * bytes / triangles)});
  }
  return table(rows, 1);
}

std::string stageLine(const bake::BakeReport& report) {
  const double all = std::accumulate(report.stages.begin(), report.stages.end(), 0.0,
                                     [](double sum, const auto& stage) { return sum + stage.seconds; });
  std::string line = format("%.2f s:", all);
  for (const auto& stage : report.stages) line += format(" %s %.2f", stage.name.c_str(), stage.seconds);
  return line + "\n";
}

Json levelJson(const bake::BakeReport& report, const bake::BakedLevel& level) {
  return {{"triangles", level.triangles},
          {"vertices", level.vertices},
          {"error", level.error},
          {"error_rms", level.error_rms},
          {"error_of_diagonal", ofDiagonal(report, level.error)},
          {"share", level.share},
          {"bytes", level.bytes_end}};
}

}  // namespace

std::string bakeText(const bake::BakeReport& report, const std::string& input, const std::string& output) {
  std::string text = output + ": " + grouped(report.file_bytes) + " bytes from " + input + ": " +
                     grouped(report.source_triangles) + " triangles, " + grouped(report.source_vertices) +
                     " vertices, " + std::to_string(report.poses) + " example poses\n";
  text += format("diagonal %.6g at rest, %.6g posed; weights of %u bits\n\n", report.rest_diagonal,
                 report.posed_diagonal, report.weight_bits);
  return text + levelTable(report) + "\n" + kindTable(report) + "\n" + stageLine(report);
}

std::string bakeJson(const bake::BakeReport& report, const std::string& input, const std::string& output) {
  Json json{{"input", input}, {"output", output}, {"bytes", report.file_bytes}, {"head_bytes", report.head_bytes}};
  json["source"] = {{"triangles", report.source_triangles}, {"vertices", report.source_vertices}};
  json["poses"] = report.poses;
  json["weight_bits"] = report.weight_bits;
  json["rest_diagonal"] = report.rest_diagonal;
  json["posed_diagonal"] = report.posed_diagonal;
  for (const bake::BakedLevel& level : report.levels) json["levels"].push_back(levelJson(report, level));
  for (const auto& kind : report.kinds) json["kinds"][kind.name] = kind.bytes;
  for (const auto& stage : report.stages) json["stages"][stage.name] = stage.seconds;
  json["warnings"] = report.warnings;
  return json.dump(2) + "\n";
}

}  // namespace lithe::tool
