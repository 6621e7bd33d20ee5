// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "directions.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace lithe::bake {

namespace {

bool hasDirection(const glm::vec3& v) {
  const float length = glm::length(v);
  return std::isfinite(length) && length > 1e-12f;
}

glm::vec3 unit(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0.0 ? glm::vec3(v / length) : glm::vec3(0.0f, 1.0f, 0.0f);
}

/// Per triangle: the node of its part, by which surfaces are told apart.
uint32_t nodeOf(const Draft& draft, size_t triangle) { return draft.part_node[draft.model.triangle_part[triangle]]; }

/// Ids of the positions: equal for vertices of one node at one place.
std::vector<uint32_t> weldPositions(const Draft& draft) {
  const std::vector<glm::vec3>& positions = draft.model.positions;
  std::vector<uint32_t> node(positions.size(), kNone);
  for (size_t t = 0; t < draft.model.triangles.size(); ++t) {
    for (const uint32_t corner : draft.model.triangles[t]) node[corner] = nodeOf(draft, t);
  }
  const auto key = [&](uint32_t v) { return std::tuple(node[v], positions[v].x, positions[v].y, positions[v].z); };
  std::vector<uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](uint32_t a, uint32_t b) { return std::pair(key(a), a) < std::pair(key(b), b); });
  std::vector<uint32_t> id(positions.size());
  for (size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && key(order[i - 1]) == key(order[i]);
    id[order[i]] = same ? id[order[i - 1]] : order[i];
  }
  return id;
}

/// Per position id: the sum of the triangles' normals times twice their areas. Triangles are counter-clockwise as
/// posed, so a part that is posed mirrored has them the other way round here.
std::vector<glm::dvec3> areaNormals(const Draft& draft, const std::vector<uint32_t>& id) {
  const Model& model = draft.model;
  std::vector<glm::dvec3> sums(model.positions.size(), glm::dvec3(0.0));
  for (size_t t = 0; t < model.triangles.size(); ++t) {
    const auto& [a, b, c] = model.triangles[t];
    const glm::dvec3 p(model.positions[a]);
    const glm::dvec3 normal = glm::cross(glm::dvec3(model.positions[b]) - p, glm::dvec3(model.positions[c]) - p);
    const double side = draft.part_mirrored[model.triangle_part[t]] ? -1.0 : 1.0;
    for (const uint32_t corner : {a, b, c}) sums[id[corner]] += side * normal;
  }
  return sums;
}

void completeNormals(Draft& draft) {
  Model& model = draft.model;
  const auto lacking = std::count_if(model.normals.begin(), model.normals.end(),
                                     [](const glm::vec3& normal) { return !hasDirection(normal); });
  if (lacking > 0) {
    const std::vector<uint32_t> id = weldPositions(draft);
    const std::vector<glm::dvec3> smooth = areaNormals(draft, id);
    for (size_t v = 0; v < model.normals.size(); ++v) {
      if (!hasDirection(model.normals[v])) model.normals[v] = unit(smooth[id[v]]);
    }
    model.warnings.push_back(std::to_string(lacking) + " vertices have no valid normal; smooth ones are made for them");
  }
  for (glm::vec3& normal : model.normals) normal = unit(glm::dvec3(normal));
}

/// The coordinate axis farthest from the normal, made orthogonal to it.
glm::vec3 someTangent(const glm::vec3& normal) {
  const glm::dvec3 n(normal);
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(n[k]) < std::abs(n[axis])) axis = k;
  }
  glm::dvec3 tangent(0.0);
  tangent[axis] = 1.0;
  return unit(tangent - n * n[axis]);
}

void completeTangents(Model& model) {
  uint64_t lacking = 0;
  for (size_t v = 0; v < model.tangents.size(); ++v) {
    const glm::vec3 stated(model.tangents[v]);
    const bool valid = hasDirection(stated);
    if (!valid) ++lacking;
    model.tangents[v] =
        glm::vec4(valid ? unit(glm::dvec3(stated)) : someTangent(model.normals[v]), model.tangents[v].w);
  }
  if (lacking > 0) {
    model.warnings.push_back(std::to_string(lacking) + " vertices have no valid tangent; some direction is taken");
  }
}

}  // namespace

void completeDirections(Draft& draft) {
  completeNormals(draft);
  completeTangents(draft.model);
}

}  // namespace lithe::bake
