// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "posed_surface.h"

#include <limits>
#include <map>

namespace lithe::bake {

namespace {

void appendVertex(const Model& model, uint32_t vertex, MeasuredSurface& surface) {
  surface.positions.emplace_back(model.positions[vertex]);
  if (model.attributes.normal) surface.normals.emplace_back(model.normals[vertex]);
  if (model.attributes.uv_sets > 0) surface.uvs.emplace_back(model.uvs[0][vertex]);
  surface.skins.push_back(model.skins[vertex]);
}

/// The original's nodes by name; kNone where several share it.
std::map<std::string, uint32_t> nodesByName(const Model& original) {
  std::map<std::string, uint32_t> nodes;
  for (uint32_t node = 0; node < original.nodes.size(); ++node) {
    const std::string& name = original.nodes[node].name;
    if (name.empty()) continue;
    const auto [entry, is_new] = nodes.emplace(name, node);
    if (!is_new) entry->second = kNone;
  }
  return nodes;
}

glm::dvec3 unitOrZero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0.0 ? v / length : glm::dvec3(0.0);
}

/// The blended matrix, weights renormalised.
glm::dmat4 blendedMatrix(const Skin& skin, std::span<const glm::dmat4> palette) {
  glm::dmat4 blended(0.0);
  double sum = 0.0;
  for (uint32_t k = 0; k < skin.count; ++k) sum += skin.weight[k];
  for (uint32_t k = 0; k < skin.count; ++k) blended += palette[skin.joint[k]] * (skin.weight[k] / sum);
  return blended;
}

/// Inverse transpose up to a positive factor, without dividing: a flattened joint still gives a direction.
glm::dvec3 transformedNormal(const glm::dmat3& m, const glm::dvec3& normal) {
  const glm::dvec3 yz = glm::cross(m[1], m[2]), zx = glm::cross(m[2], m[0]), xy = glm::cross(m[0], m[1]);
  const double handedness = glm::dot(m[0], yz) < 0.0 ? -1.0 : 1.0;
  return unitOrZero(handedness * (yz * normal.x + zx * normal.y + xy * normal.z));
}

/// Area-weighted, for models without normals.
std::vector<glm::dvec3> smoothNormals(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles) {
  std::vector<glm::dvec3> normals(positions.size(), glm::dvec3(0.0));
  for (const Triangle& t : triangles) {
    const glm::dvec3 area = glm::cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]);
    for (const uint32_t corner : t) normals[corner] += area;
  }
  for (glm::dvec3& normal : normals) normal = unitOrZero(normal);
  return normals;
}

}  // namespace

MeasuredSurface surfaceOf(const Model& model, bool include_rigid, const char* who) {
  MeasuredSurface surface;
  std::vector<uint32_t> index_of(model.positions.size(), kNone);
  for (size_t i = 0; i < model.triangles.size(); ++i) {
    if (model.parts[model.triangle_part[i]].rigid_node != kNone && !include_rigid) continue;
    Triangle triangle{};
    for (uint32_t k = 0; k < 3; ++k) {
      const uint32_t vertex = model.triangles[i][k];
      if (index_of[vertex] == kNone) {
        index_of[vertex] = static_cast<uint32_t>(surface.positions.size());
        appendVertex(model, vertex, surface);
      }
      triangle[k] = index_of[vertex];
    }
    surface.triangles.push_back(triangle);
  }
  if (surface.triangles.empty()) {
    throw Error(std::string("the ") + who + " model has no " + (include_rigid ? "" : "skinned ") +
                "triangle to measure: give a model that has some");
  }
  return surface;
}

std::vector<uint32_t> matchJoints(const Model& original, const Model& model) {
  const std::map<std::string, uint32_t> by_name = nodesByName(original);
  std::vector<uint32_t> matched;
  for (size_t joint = 0; joint < model.joints.size(); ++joint) {
    const std::string& name = model.nodes[model.joints[joint].node].name;
    const auto found = by_name.find(name);
    if (found != by_name.end() && found->second != kNone) {
      matched.push_back(found->second);
    } else if (joint < original.joints.size()) {
      matched.push_back(original.joints[joint].node);
    } else {
      throw Error("joint " + std::to_string(joint) + " ('" + name +
                  "') of the simplified model matches no node of the original: compare models of the same skeleton");
    }
  }
  return matched;
}

std::vector<glm::dmat4> paletteAt(const Instant& instant, const std::vector<Joint>& joints,
                                  const std::vector<uint32_t>& node_of_joint) {
  std::vector<glm::dmat4> palette;
  palette.reserve(joints.size());
  for (size_t i = 0; i < joints.size(); ++i) {
    palette.push_back(instant.node_world[node_of_joint[i]] * joints[i].inverse_bind);
  }
  return palette;
}

PosedSurface poseSurface(const MeasuredSurface& surface, std::span<const glm::dmat4> palette) {
  PosedSurface posed;
  posed.positions.reserve(surface.positions.size());
  posed.normals.reserve(surface.normals.size());
  for (size_t vertex = 0; vertex < surface.positions.size(); ++vertex) {
    const glm::dmat4 matrix = blendedMatrix(surface.skins[vertex], palette);
    posed.positions.emplace_back(matrix * glm::dvec4(surface.positions[vertex], 1.0));
    if (!surface.normals.empty())
      posed.normals.push_back(transformedNormal(glm::dmat3(matrix), surface.normals[vertex]));
  }
  if (surface.normals.empty()) posed.normals = smoothNormals(posed.positions, surface.triangles);
  return posed;
}

double diagonalOf(std::span<const glm::dvec3> positions) {
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high(-low);
  for (const glm::dvec3& position : positions) {
    low = glm::min(low, position);
    high = glm::max(high, position);
  }
  return glm::length(high - low);
}

}  // namespace lithe::bake
