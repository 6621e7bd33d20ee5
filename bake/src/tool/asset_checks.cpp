// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "asset_checks.h"

#include <cmath>
#include <string>

#include "float_vertices.h"
#include "lithe/bake/model.h"
#include "text.h"

namespace lithe::tool {
namespace {

[[noreturn]] void fail(const Asset& asset, const std::string& place, const std::string& what) {
  throw bake::Error(asset.name() + ": " + place + ": " + what + "; bake it again");
}

// ---- Triangles -----------------------------------------------------------------------------------------------------

void checkTriangles(const Asset& asset, const LevelIndices& indices, uint32_t vertex_count, const std::string& place) {
  for (size_t i = 0; i < indices.triangles.size(); ++i) {
    const auto& [a, b, c] = indices.triangles[i];
    const std::string where = place + ", triangle " + std::to_string(i);
    if (a >= vertex_count || b >= vertex_count || c >= vertex_count)
      fail(asset, where, "a corner is no vertex of the level");
    if (a == b || b == c || c == a) fail(asset, where, "two corners are the same vertex");
  }
}

void checkRanges(const Asset& asset, const LevelIndices& indices, const std::string& place) {
  uint64_t at = 0;
  for (size_t part = 0; part < indices.ranges.size(); ++part) {
    const lithe_range& range = indices.ranges[part];
    if (range.first_index != at || range.index_count % 3 != 0) {
      fail(asset, place + ", part " + std::to_string(part), "its indices do not follow those of the part before");
    }
    at += range.index_count;
  }
  if (at != 3 * indices.triangles.size()) fail(asset, place, "the parts do not cover all indices");
}

// ---- Vertices ------------------------------------------------------------------------------------------------------

void checkPosition(const Asset& asset, const glm::vec3& position, const std::string& place) {
  const lithe_asset_info& info = asset.info();
  // A float's rounding of grid coordinates is allowed at the box's faces.
  const float slack = 1e-5f * info.rest_diagonal;
  for (int axis = 0; axis < 3; ++axis) {
    const bool inside = position[axis] >= info.box_min[axis] - slack && position[axis] <= info.box_max[axis] + slack;
    if (!inside) fail(asset, place, "the position is outside the asset's box");
  }
}

void checkSkin(const Asset& asset, const FloatVertices& vertices, uint32_t vertex, const std::string& place) {
  double sum = 0;
  for (uint32_t i = 0; i < vertices.influences(); ++i) {
    if (!(vertices.weight(vertex, i) >= 0)) fail(asset, place, "a weight is negative or no number");
    if (vertices.joint(vertex, i) >= asset.info().joint_count) fail(asset, place, "a joint does not exist");
    sum += vertices.weight(vertex, i);
  }
  if (std::abs(sum - 1) > 1e-6) fail(asset, place, format("the weights sum to %.9g", sum));
}

void checkUnit(const Asset& asset, const glm::vec3& direction, const char* name, const std::string& place) {
  const double length = glm::length(glm::dvec3(direction));
  if (!(std::abs(length - 1) < 1e-3)) fail(asset, place, format("the %s has length %.6g", name, length));
}

void checkVertices(const Asset& asset, uint32_t vertex_count, const std::string& place) {
  const FloatVertices vertices(asset, vertex_count);
  const lithe_asset_info& info = asset.info();
  for (uint32_t vertex = 0; vertex < vertex_count; ++vertex) {
    const std::string where = place + ", vertex " + std::to_string(vertex);
    checkPosition(asset, vertices.position(vertex), where);
    checkSkin(asset, vertices, vertex, where);
    if (info.has_normals) checkUnit(asset, vertices.normal(vertex), "normal", where);
    if (info.has_tangents) checkUnit(asset, glm::vec3(vertices.tangent(vertex)), "tangent", where);
    for (uint32_t set = 0; set < info.uv_sets; ++set) {
      const glm::vec2 uv = vertices.uv(vertex, set);
      if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) fail(asset, where, "a uv is no number");
    }
  }
}

void checkMorphSources(const Asset& asset, uint32_t level, const std::string& place) {
  if (level == 0) return;
  std::vector<uint32_t> source(asset.level(level).vertex_count);
  require(lithe_asset_write_morph_sources(asset.get(), level, source.data(), source.size()));
  const uint32_t above = asset.level(level - 1).vertex_count;
  for (uint32_t vertex = 0; vertex < source.size(); ++vertex) {
    if (source[vertex] >= above)
      fail(asset, place + ", vertex " + std::to_string(vertex), "it comes from no vertex of the level above");
  }
}

uint64_t mix(uint64_t hash, const void* data, size_t size) {
  const auto* bytes = static_cast<const uint8_t*>(data);
  for (size_t i = 0; i < size; ++i) hash = (hash ^ bytes[i]) * 1099511628211u;  // FNV-1a
  return hash;
}

}  // namespace

void checkTables(const Asset& asset) {
  const lithe_asset_info& info = asset.info();
  if (info.file_bytes != asset.bytes().size()) {
    fail(asset, "header",
         "states " + grouped(info.file_bytes) + " bytes but the file has " + grouped(asset.bytes().size()));
  }
  for (uint32_t level = 1; level < info.level_count; ++level) {
    if (!(asset.level(level).error <= asset.level(level - 1).error)) {
      fail(asset, "level " + std::to_string(level), "its error is larger than the coarser level's");
    }
  }
  for (uint32_t joint = 0; joint < info.joint_count; ++joint) {
    if (asset.joint(joint).node >= info.node_count)
      fail(asset, "joint " + std::to_string(joint), "its node does not exist");
  }
}

void checkLevel(const Asset& asset, uint32_t level) {
  const std::string place = "level " + std::to_string(level);
  const uint32_t vertex_count = asset.level(level).vertex_count;
  const LevelIndices indices = levelIndices(asset, level);
  checkTriangles(asset, indices, vertex_count, place);
  checkRanges(asset, indices, place);
  checkVertices(asset, vertex_count, place);
  checkMorphSources(asset, level, place);
}

uint64_t fingerprint(const Asset& asset, uint32_t level) {
  const FloatVertices vertices(asset, asset.level(level).vertex_count);
  const LevelIndices indices = levelIndices(asset, level);
  const uint64_t hash = mix(14695981039346656037u, vertices.bytes().data(), vertices.bytes().size());
  return mix(hash, indices.triangles.data(), indices.triangles.size() * sizeof indices.triangles[0]);
}

}  // namespace lithe::tool
