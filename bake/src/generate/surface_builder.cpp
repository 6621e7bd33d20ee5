// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "surface_builder.h"

#include <cmath>

namespace lithe::bake {
namespace {

double boxDiagonal(const std::vector<glm::vec3>& points) {
  glm::dvec3 low(points.front()), high(points.front());
  for (const glm::vec3& point : points) {
    low = glm::min(low, glm::dvec3(point));
    high = glm::max(high, glm::dvec3(point));
  }
  return std::sqrt(glm::dot(high - low, high - low));
}

}  // namespace

uint32_t SurfaceBuilder::addVertex(uint32_t part, const SurfacePoint& point) {
  PartSurface& surface = parts_[part];
  surface.positions.push_back(glm::vec3(point.position) + 0.0f);  // no negative zeros: vertices weld by their bits
  surface.normals.push_back(glm::vec3(point.normal) + 0.0f);
  surface.uvs.push_back(glm::vec2(point.uv) + 0.0f);
  surface.skins.push_back(point.skin);
  return static_cast<uint32_t>(surface.positions.size() - 1);
}

void SurfaceBuilder::addTriangle(uint32_t part, std::array<uint32_t, 3> corners) {
  const std::vector<glm::vec3>& p = parts_[part].positions;
  const glm::vec3 &a = p[corners[0]], &b = p[corners[1]], &c = p[corners[2]];
  if (a == b || b == c || c == a) return;
  parts_[part].triangles.push_back(corners);
}

void SurfaceBuilder::finish(Model& model) {
  for (uint32_t part = 0; part < parts_.size(); ++part) {
    const PartSurface& surface = parts_[part];
    std::vector<uint32_t> place(surface.positions.size(), kNone);  // in the model; kNone while no triangle asks for it
    for (const auto& corners : surface.triangles) {
      for (uint32_t vertex : corners) place[vertex] = 0;
    }
    for (uint32_t vertex = 0; vertex < place.size(); ++vertex) {
      if (place[vertex] == kNone) continue;
      place[vertex] = static_cast<uint32_t>(model.positions.size());
      model.positions.push_back(surface.positions[vertex]);
      model.normals.push_back(surface.normals[vertex]);
      model.uvs[0].push_back(surface.uvs[vertex]);
      model.skins.push_back(surface.skins[vertex]);
    }
    for (const auto& [a, b, c] : surface.triangles) {
      model.triangles.push_back({place[a], place[b], place[c]});
      model.triangle_part.push_back(part);
    }
  }
  model.attributes.normal = true;
  model.attributes.uv_sets = 1;
  model.rest_diagonal = boxDiagonal(model.positions);
  parts_.clear();
}

void addPart(Model& model, const std::string& name, const std::string& material) {
  Part part;
  part.name = name;
  part.material = static_cast<uint32_t>(model.materials.size());
  part.source_mesh = 0;
  part.source_primitive = static_cast<uint32_t>(model.parts.size());
  model.materials.push_back(material);
  model.parts.push_back(part);
}

}  // namespace lithe::bake
