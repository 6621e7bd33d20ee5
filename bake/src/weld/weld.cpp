// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/weld.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "influences.h"
#include "quantize.h"
#include "vertex_clusters.h"
#include "wedge_table.h"

namespace lithe::bake {

namespace {

void requireRange(uint32_t value, uint32_t lowest, uint32_t highest, const char* name) {
  if (value >= lowest && value <= highest) return;
  throw Error(std::string("weld: ") + name + " is " + std::to_string(value) + ", give a value from " +
              std::to_string(lowest) + " to " + std::to_string(highest));
}

void checkOptions(const WeldOptions& options) {
  requireRange(options.position_bits, 8, 20, "position_bits");
  requireRange(options.weight_bits, 4, 16, "weight_bits");
  requireRange(options.normal_bits, 4, 16, "normal_bits");
  requireRange(options.uv_bits, 4, 20, "uv_bits");
  requireRange(options.max_influences, 1, kMaxImportedInfluences, "max_influences");
}

AttributeSet keptAttributes(const AttributeSet& has, const AttributeSet& wanted) {
  return {has.normal && wanted.normal, has.tangent && wanted.tangent, std::min(has.uv_sets, wanted.uv_sets),
          std::min(has.color_sets, wanted.color_sets)};
}

Mesh emptyMesh(const Model& model, const WeldOptions& options, const VertexClusters& clusters) {
  Mesh mesh;
  mesh.grid = positionGrid(model.positions, clusters.first, options.position_bits);
  mesh.weight_one = (1u << options.weight_bits) - 1;
  mesh.max_influences = options.max_influences;
  mesh.normal_bits = options.normal_bits;
  mesh.uv_bits = options.uv_bits;
  mesh.attributes = keptAttributes(model.attributes, options.attributes);
  return mesh;
}

/// Per part and uv set, the square that holds what the part's triangles use.
void chooseUvGrids(const Model& model, Mesh& mesh) {
  mesh.part_uv.resize(model.parts.size());
  for (uint32_t set = 0; set < mesh.attributes.uv_sets; ++set) {
    std::vector<std::pair<glm::dvec2, glm::dvec2>> range(model.parts.size(), {glm::dvec2(1e300), glm::dvec2(-1e300)});
    for (size_t t = 0; t < model.triangles.size(); ++t) {
      auto& [lower, upper] = range[model.triangle_part[t]];
      for (uint32_t vertex : model.triangles[t]) {
        lower = glm::min(lower, glm::dvec2(model.uvs[set][vertex]));
        upper = glm::max(upper, glm::dvec2(model.uvs[set][vertex]));
      }
    }
    for (size_t p = 0; p < range.size(); ++p) {
      if (range[p].first.x <= range[p].second.x) {
        mesh.part_uv[p][set] = uvGrid(range[p].first, range[p].second, mesh.uv_bits);
      }
    }
  }
}

/// Starts with the smallest wedge, so that equal triangles of equal orientation are equal arrays.
std::array<uint32_t, 3> rotatedToSmallest(const std::array<uint32_t, 3>& triangle) {
  const auto [a, b, c] = triangle;
  if (a <= b && a <= c) return {a, b, c};
  return b <= c ? std::array{b, c, a} : std::array{c, a, b};
}

struct TriangleHash {
  size_t operator()(const std::array<uint32_t, 3>& t) const {
    uint64_t hash = t[0];
    hash = hash * 0x9e3779b97f4a7c15u + t[1];
    hash = hash * 0x9e3779b97f4a7c15u + t[2];
    return static_cast<size_t>(hash ^ (hash >> 29));
  }
};

struct Dropped {
  uint32_t degenerate = 0, duplicate = 0;
};

Dropped addTriangles(const Model& model, const VertexClusters& clusters, WedgeTable& wedges, Mesh& mesh) {
  std::unordered_set<std::array<uint32_t, 3>, TriangleHash> seen;
  Dropped dropped;
  for (size_t t = 0; t < model.triangles.size(); ++t) {
    const auto& source = model.triangles[t];
    const uint32_t a = clusters.cluster[source[0]], b = clusters.cluster[source[1]], c = clusters.cluster[source[2]];
    if (a == b || b == c || c == a) {
      ++dropped.degenerate;
      continue;
    }
    std::array<uint32_t, 3> triangle;
    for (uint32_t k = 0; k < 3; ++k) triangle[k] = wedges.wedge(source[k], model.triangle_part[t]);
    if (!seen.insert(rotatedToSmallest(triangle)).second) {
      ++dropped.duplicate;
      continue;
    }
    mesh.triangles.push_back(triangle);
  }
  return dropped;
}

/// Gives the clusters that triangles use their vertices, in the order of the wedges; returns how many skins were
/// capped.
uint32_t addVertices(const Model& model, const std::vector<Pose>& poses, const VertexClusters& clusters, Mesh& mesh) {
  std::vector<uint32_t> vertex_of(clusters.first.size(), kNone);
  uint32_t capped = 0;
  for (uint32_t& vertex : mesh.wedge_vertex) {
    const uint32_t cluster = vertex, first = clusters.first[cluster];
    if (vertex_of[cluster] == kNone) {
      vertex_of[cluster] = mesh.vertexCount();
      mesh.positions.push_back(toGrid(mesh.grid, model.positions[first]));
      mesh.skins.push_back(capAndQuantize(model, poses, first, mesh.max_influences, mesh.weight_one));
      mesh.rigid_vertex.push_back(clusters.rigid_node[cluster] != kNone);
      capped += model.skins[first].count > mesh.max_influences ? 1 : 0;
    }
    vertex = vertex_of[cluster];
  }
  return capped;
}

void warn(std::vector<std::string>& warnings, uint32_t count, const std::string& what) {
  if (count > 0) warnings.push_back("weld: " + std::to_string(count) + " " + what);
}

}  // namespace

Mesh weld(const Model& model, const std::vector<Pose>& poses, const WeldOptions& options,
          std::vector<std::string>& warnings) {
  checkOptions(options);
  if (model.triangles.empty()) throw Error("weld: the model has no triangles, give one that has a mesh");
  const VertexClusters clusters = clusterVertices(model);
  Mesh mesh = emptyMesh(model, options, clusters);
  chooseUvGrids(model, mesh);
  WedgeTable wedges(model, clusters.cluster, mesh);
  const Dropped dropped = addTriangles(model, clusters, wedges, mesh);
  if (mesh.triangles.empty()) {
    throw Error("weld: all " + std::to_string(model.triangles.size()) +
                " triangles are degenerate, give a model whose triangles have an area");
  }
  const uint32_t capped = addVertices(model, poses, clusters, mesh);
  warn(warnings, dropped.degenerate, "triangles dropped because two of their corners are the same vertex");
  warn(warnings, dropped.duplicate, "triangles dropped because they repeat an earlier one");
  warn(warnings, capped,
       "vertices had more than " + std::to_string(mesh.max_influences) + " influences and were refitted");
  return mesh;
}

}  // namespace lithe::bake
