// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// `lithe info`: what a file holds, from its tables; pages are decoded only to say what each kind of data takes
/// (--bytes).
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "asset.h"
#include "command.h"
#include "file_costs.h"
#include "page_bytes.h"
#include "text.h"

namespace lithe::tool {
namespace {

using Json = nlohmann::ordered_json;

struct InfoOptions {
  std::string file;
  bool bytes = false;
  bool json = false;
};

Json attributesJson(const lithe_asset_info& info) {
  return {{"normals", info.has_normals != 0},
          {"tangents", info.has_tangents != 0},
          {"uv_sets", info.uv_sets},
          {"color_sets", info.color_sets},
          {"max_influences", info.max_influences}};
}

Json levelJson(const Asset& asset, uint32_t index) {
  const lithe_level level = asset.level(index);
  return {{"triangles", level.triangle_count},
          {"vertices", level.vertex_count},
          {"error", level.error},
          {"error_rms", level.error_rms},
          {"error_of_diagonal", asset.info().rest_diagonal > 0 ? level.error / asset.info().rest_diagonal : 0.0f},
          {"joints", level.joint_count},
          {"pages", level.page_end},
          {"bytes", level.bytes_end}};
}

Json partJson(const Asset& asset, uint32_t index) {
  const lithe_part part = asset.part(index);
  Json json{{"name", part.name}, {"material", part.material}};
  if (part.rigid_node != LITHE_NO_INDEX) json["rigid_node"] = asset.node(part.rigid_node).name;
  return json;
}

double bitsPer(uint64_t bytes, uint32_t count) { return 8 * static_cast<double>(bytes) / count; }

Json costJson(uint64_t bytes, const FileCosts& costs) {
  return {{"bytes", bytes},
          {"bits_per_vertex", bitsPer(bytes, costs.vertices)},
          {"bits_per_wedge", bitsPer(bytes, costs.wedges)}};
}

Json costsJson(const Asset& asset) {
  const FileCosts costs = fileCosts(*asset.get(), asset.bytes(), asset.name());
  Json json{{"vertices", costs.vertices}, {"wedges", costs.wedges}};
  for (const FileCosts::Kind& kind : costs.kinds) {
    if (!json["groups"].contains(kind.group)) json["groups"][kind.group] = costJson(costs.bytesOf(kind.group), costs);
    json["groups"][kind.group]["kinds"][kind.name] = costJson(kind.bytes, costs);
  }
  json["file"] = costJson(asset.info().file_bytes, costs);
  return json;
}

Json describe(const Asset& asset) {
  const lithe_asset_info& info = asset.info();
  Json json{{"file", asset.name()},
            {"bytes", info.file_bytes},
            {"head_bytes", asset.headBytes()},
            {"triangles", info.triangle_count},
            {"vertices", info.vertex_count},
            {"nodes", info.node_count},
            {"joints", info.joint_count},
            {"attributes", attributesJson(info)},
            {"rest_diagonal", info.rest_diagonal},
            {"posed_diagonal", info.posed_diagonal}};
  for (uint32_t i = 0; i < info.level_count; ++i) json["levels"].push_back(levelJson(asset, i));
  for (uint32_t i = 0; i < info.page_count; ++i) {
    const lithe_page page = asset.page(i);
    json["pages"].push_back({{"level", page.level}, {"offset", page.offset}, {"bytes", page.size}});
  }
  for (const auto& [kind, bytes] : bytesByKind(asset)) json["kinds"][kind] = bytes;
  for (uint32_t i = 0; i < info.part_count; ++i) json["parts"].push_back(partJson(asset, i));
  return json;
}

std::string attributesLine(const Json& attributes) {
  std::string line = "position, joints and weights (at most " + attributes["max_influences"].dump() + ")";
  if (attributes["normals"]) line += ", normal";
  if (attributes["tangents"]) line += ", tangent";
  if (attributes["uv_sets"] > 0) line += ", " + attributes["uv_sets"].dump() + " uv";
  if (attributes["color_sets"] > 0) line += ", " + attributes["color_sets"].dump() + " colour";
  return line;
}

std::string levelTable(const Json& levels, uint64_t head_bytes) {
  std::vector<std::vector<std::string>> rows{{"level", "triangles", "vertices", "joints", "pages", "bytes so far",
                                              "bytes", "error", "of diagonal", "error rms"}};
  uint64_t before = head_bytes;
  for (size_t i = 0; i < levels.size(); ++i) {
    const Json& level = levels[i];
    const uint64_t bytes = level["bytes"];
    rows.push_back({std::to_string(i), grouped(level["triangles"]), grouped(level["vertices"]), level["joints"].dump(),
                    level["pages"].dump(), grouped(bytes), grouped(bytes - before),
                    format("%.3g", level["error"].get<double>()),
                    format("%.3f %%", 100 * level["error_of_diagonal"].get<double>()),
                    format("%.3g", level["error_rms"].get<double>())});
    before = bytes;
  }
  return table(rows);
}

std::string pageTable(const Json& pages) {
  std::vector<std::vector<std::string>> rows{{"page", "level", "offset", "bytes"}};
  for (size_t i = 0; i < pages.size(); ++i) {
    rows.push_back(
        {std::to_string(i), pages[i]["level"].dump(), grouped(pages[i]["offset"]), grouped(pages[i]["bytes"])});
  }
  return table(rows);
}

std::string kindTable(const Json& kinds, uint64_t file_bytes) {
  std::vector<std::vector<std::string>> rows{{"bytes of", "bytes", "share"}};
  for (const auto& [kind, bytes] : kinds.items()) {
    const double share = 100 * bytes.get<double>() / static_cast<double>(file_bytes);
    rows.push_back({kind, grouped(bytes), format("%.1f %%", share)});
  }
  return table(rows, 1);
}

std::vector<std::string> costRow(const std::string& name, const Json& cost, uint64_t file_bytes) {
  return {name, grouped(cost["bytes"]),
          format("%.1f %%", 100 * cost["bytes"].get<double>() / static_cast<double>(file_bytes)),
          format("%.3f", cost["bits_per_vertex"].get<double>()), format("%.3f", cost["bits_per_wedge"].get<double>())};
}

std::string costTable(const Json& costs, uint64_t file_bytes) {
  std::vector<std::vector<std::string>> rows{{"bytes of", "bytes", "share", "bits/vertex", "bits/GPU vertex"}};
  for (const auto& [group, cost] : costs["groups"].items()) {
    rows.push_back(costRow(group, cost, file_bytes));
    if (cost["kinds"].size() == 1) continue;
    for (const auto& [kind, part] : cost["kinds"].items()) rows.push_back(costRow("  " + kind, part, file_bytes));
  }
  rows.push_back(costRow("file", costs["file"], file_bytes));
  return "the finest level has " + grouped(costs["vertices"]) + " vertices (welded) and " + grouped(costs["wedges"]) +
         " GPU vertices (wedges)\n" + table(rows, 1);
}

std::string partTable(const Json& parts) {
  std::vector<std::vector<std::string>> rows{{"part", "material", "hangs on"}};
  for (const Json& part : parts) {
    rows.push_back({part["name"], part["material"],
                    part.contains("rigid_node") ? part["rigid_node"].get<std::string>() : "(skinned)"});
  }
  return table(rows, 3);
}

std::string text(const Json& json) {
  std::string out = json["file"].get<std::string>() + ": " + grouped(json["bytes"]) + " bytes, head " +
                    grouped(json["head_bytes"]) + " bytes\n";
  out += grouped(json["triangles"]) + " triangles, " + grouped(json["vertices"]) +
         " vertices of all levels together, " + json["joints"].dump() + " joints, " + json["nodes"].dump() + " nodes\n";
  out += attributesLine(json["attributes"]) + "\n";
  out += format("diagonal %.6g at rest, %.6g posed\n", json["rest_diagonal"].get<double>(),
                json["posed_diagonal"].get<double>());
  out += "\n" + levelTable(json["levels"], json["head_bytes"]);
  out += "\n" + pageTable(json["pages"]);
  out += "\n" +
         (json.contains("costs") ? costTable(json["costs"], json["bytes"]) : kindTable(json["kinds"], json["bytes"]));
  out += "\n" + partTable(json["parts"]);
  return out;
}

ExitCode info(const InfoOptions& options) {
  Asset asset = Asset::open(options.file);
  Json json = describe(asset);
  if (options.bytes) {
    asset.loadAll();
    json["costs"] = costsJson(asset);
  }
  std::fputs((options.json ? json.dump(2) + "\n" : text(json)).c_str(), stdout);
  return kDone;
}

}  // namespace

void addInfoCommand(CLI::App& app, Action& action) {
  const auto options = std::make_shared<InfoOptions>();
  CLI::App* command = app.add_subcommand("info", "Levels, pages, bytes, errors and joints of a .lithe file");
  command->add_option("file", options->file, "The .lithe file")->required();
  command->add_flag(
      "--bytes", options->bytes,
      "Say what connectivity, positions, each attribute and the tables take: bytes, and bits per vertex of "
      "the finest level; reads all pages");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options, &action] { action = [options] { return info(*options); }; });
}

}  // namespace lithe::tool
