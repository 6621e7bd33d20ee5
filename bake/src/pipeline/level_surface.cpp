// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "level_surface.h"

#include <algorithm>
#include <numeric>

#include "lithe/bake/cut.h"

namespace lithe::bake {
namespace {

/// Per node: the node of the cut that it is part of.
std::vector<uint32_t> cutNodes(const Mesh& mesh, const CollapseSequence& sequence, uint32_t collapses) {
  std::vector<uint32_t> cut_node(mesh.vertexCount() + collapses);
  std::iota(cut_node.begin(), cut_node.end(), 0u);
  for (uint32_t i = collapses; i-- > 0;)
    for (const uint32_t child : sequence.collapses[i].child) cut_node[child] = cut_node[mesh.vertexCount() + i];
  return cut_node;
}

/// Per node: the vertex that is reached by always taking the child whose share of the attributes is larger.
std::vector<uint32_t> verticesNear(const Mesh& mesh, const CollapseSequence& sequence, uint32_t collapses) {
  std::vector<uint32_t> vertex_near(mesh.vertexCount() + collapses);
  std::iota(vertex_near.begin(), vertex_near.begin() + mesh.vertexCount(), 0u);
  for (uint32_t i = 0; i < collapses; ++i) {
    const Collapse& collapse = sequence.collapses[i];
    vertex_near[mesh.vertexCount() + i] = vertex_near[collapse.child[collapse.t8 <= 4 ? 0 : 1]];
  }
  return vertex_near;
}

/// The triangles that still have three different nodes, in the order of the mesh.
std::vector<Triangle> livingTriangles(const Mesh& mesh, const std::vector<uint32_t>& cut_node) {
  std::vector<Triangle> living;
  for (uint32_t triangle = 0; triangle < mesh.triangleCount(); ++triangle) {
    Triangle nodes;
    for (uint32_t k = 0; k < 3; ++k) nodes[k] = cut_node[mesh.corner(triangle, k)];
    if (nodes[0] != nodes[1] && nodes[1] != nodes[2] && nodes[2] != nodes[0]) living.push_back(nodes);
  }
  return living;
}

/// Leaves the first of the triangles with the same nodes in the same orientation.
void dropRepeated(std::vector<Triangle>& triangles) {
  std::vector<std::pair<Triangle, uint32_t>> sorted;
  sorted.reserve(triangles.size());
  for (uint32_t i = 0; i < triangles.size(); ++i) {
    Triangle from_least = triangles[i];
    std::rotate(from_least.begin(), std::min_element(from_least.begin(), from_least.end()), from_least.end());
    sorted.emplace_back(from_least, i);
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<bool> repeated(triangles.size(), false);
  for (size_t i = 1; i < sorted.size(); ++i) repeated[sorted[i].second] = sorted[i].first == sorted[i - 1].first;
  size_t kept = 0;
  for (size_t i = 0; i < triangles.size(); ++i)
    if (!repeated[i]) triangles[kept++] = triangles[i];
  triangles.resize(kept);
}

}  // namespace

TrianglesAt::TrianglesAt(std::span<const Triangle> triangles, std::span<const uint32_t> place_of, uint32_t places)
    : begin_(places + 1, 0), entries_(3 * triangles.size()) {
  for (const Triangle& triangle : triangles)
    for (const uint32_t vertex : triangle) ++begin_[place_of[vertex] + 1];
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  std::vector<uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (uint32_t i = 0; i < triangles.size(); ++i)
    for (const uint32_t vertex : triangles[i]) entries_[next[place_of[vertex]]++] = i;
}

LevelSurface levelSurface(const Mesh& mesh, const CollapseSequence& sequence, uint32_t collapses) {
  const std::vector<uint32_t> cut_node = cutNodes(mesh, sequence, collapses);
  const std::vector<uint32_t> vertex_near = verticesNear(mesh, sequence, collapses);
  LevelSurface level;
  Model& shape = level.shape;
  shape.triangles = livingTriangles(mesh, cut_node);
  dropRepeated(shape.triangles);
  std::vector<uint32_t> number(cut_node.size(), kNone);
  for (Triangle& triangle : shape.triangles)
    for (uint32_t& node : triangle) {
      if (number[node] == kNone) {
        number[node] = static_cast<uint32_t>(shape.positions.size());
        const Collapse* made = node < mesh.vertexCount() ? nullptr : &sequence.collapses[node - mesh.vertexCount()];
        const glm::ivec3 position = made ? made->position : mesh.positions[node];
        shape.positions.emplace_back(mesh.grid.origin + mesh.grid.step * glm::dvec3(position));
        shape.skins.push_back(toFloats(made ? made->skin : mesh.skins[node], mesh.weight_one));
        level.vertex_near.push_back(vertex_near[node]);
      }
      node = number[node];
    }
  level.node_of.resize(mesh.vertexCount());
  for (uint32_t vertex = 0; vertex < mesh.vertexCount(); ++vertex) level.node_of[vertex] = number[cut_node[vertex]];
  std::vector<uint32_t> itself(shape.positions.size());
  std::iota(itself.begin(), itself.end(), 0u);
  level.triangles_at = TrianglesAt(shape.triangles, itself, static_cast<uint32_t>(itself.size()));
  return level;
}

}  // namespace lithe::bake
