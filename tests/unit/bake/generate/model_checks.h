// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// What every generated character promises, measured; the tests compare the measures.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "lithe/bake/generate.h"
#include "lithe/bake/model.h"
#include "lithe/bake/poses.h"

namespace lithe::bake::checks {

/// Per vertex, the first vertex at the same position.
inline std::vector<uint32_t> weldByPosition(const Model& model) {
  std::map<std::array<uint32_t, 3>, uint32_t> first;
  std::vector<uint32_t> welded;
  for (uint32_t vertex = 0; vertex < model.positions.size(); ++vertex) {
    const glm::vec3& p = model.positions[vertex];
    const std::array bits = {std::bit_cast<uint32_t>(p.x), std::bit_cast<uint32_t>(p.y), std::bit_cast<uint32_t>(p.z)};
    welded.push_back(first.try_emplace(bits, vertex).first->second);
  }
  return welded;
}

struct Topology {
  uint32_t vertices = 0;  ///< used by a triangle, after the weld
  uint32_t edges = 0;
  uint32_t boundary_edges = 0;    ///< one face
  uint32_t crowded_edges = 0;     ///< more than two faces
  uint32_t flipped_edges = 0;     ///< two faces that run through it in the same direction
  uint32_t pinched_vertices = 0;  ///< more than one fan of faces
  uint32_t degenerate_triangles = 0;
  uint32_t components = 0;
  uint32_t triangles = 0;
};

namespace detail {

inline uint32_t find(std::vector<uint32_t>& parent, uint32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}
inline void join(std::vector<uint32_t>& parent, uint32_t a, uint32_t b) {
  a = find(parent, a), b = find(parent, b);
  parent[std::max(a, b)] = std::min(a, b);
}

}  // namespace detail

/// The topology of the mesh welded by position.
inline Topology measureTopology(const Model& model) {
  const std::vector<uint32_t> welded = weldByPosition(model);
  Topology topology;
  struct HalfEdge {
    uint32_t low, high, triangle;
    bool forward;
  };
  std::vector<HalfEdge> half_edges;
  std::vector<std::array<uint32_t, 3>> triangles;
  for (const auto& corners : model.triangles) {
    const std::array t = {welded[corners[0]], welded[corners[1]], welded[corners[2]]};
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
      ++topology.degenerate_triangles;
      continue;
    }
    for (int k = 0; k < 3; ++k) {
      const uint32_t a = t[k], b = t[(k + 1) % 3];
      half_edges.push_back({std::min(a, b), std::max(a, b), static_cast<uint32_t>(triangles.size()), a < b});
    }
    triangles.push_back(t);
  }
  std::sort(half_edges.begin(), half_edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });

  // corner 3t + k is joined to the corner of the neighbouring triangle at the same vertex: fans are what stays apart
  std::vector<uint32_t> fan(3 * triangles.size()), body(model.positions.size());
  for (uint32_t i = 0; i < fan.size(); ++i) fan[i] = i;
  for (uint32_t i = 0; i < body.size(); ++i) body[i] = i;
  const auto cornerAt = [&](uint32_t triangle, uint32_t vertex) {
    uint32_t k = 0;
    while (triangles[triangle][k] != vertex) ++k;
    return 3 * triangle + k;
  };
  for (size_t begin = 0; begin < half_edges.size();) {
    size_t end = begin;
    const HalfEdge& edge = half_edges[begin];
    while (end < half_edges.size() && half_edges[end].low == edge.low && half_edges[end].high == edge.high) ++end;
    ++topology.edges;
    topology.boundary_edges += end - begin == 1;
    topology.crowded_edges += end - begin > 2;
    topology.flipped_edges += end - begin == 2 && edge.forward == half_edges[begin + 1].forward;
    detail::join(body, edge.low, edge.high);
    for (size_t other = begin + 1; other < end; ++other) {
      detail::join(fan, cornerAt(edge.triangle, edge.low), cornerAt(half_edges[other].triangle, edge.low));
      detail::join(fan, cornerAt(edge.triangle, edge.high), cornerAt(half_edges[other].triangle, edge.high));
    }
    begin = end;
  }
  std::vector<uint32_t> fans(model.positions.size(), 0);
  for (uint32_t corner = 0; corner < fan.size(); ++corner) {
    if (detail::find(fan, corner) == corner) ++fans[triangles[corner / 3][corner % 3]];
  }
  for (uint32_t vertex = 0; vertex < fans.size(); ++vertex) {
    topology.vertices += fans[vertex] > 0;
    topology.pinched_vertices += fans[vertex] > 1;
    topology.components += fans[vertex] > 0 && detail::find(body, vertex) == vertex;
  }
  topology.triangles = static_cast<uint32_t>(triangles.size());
  return topology;
}

/// Positive where closed surfaces are oriented outwards.
inline double signedVolume(const Model& model) {
  double volume = 0.0;
  for (const auto& t : model.triangles) {
    const glm::dvec3 a(model.positions[t[0]]), b(model.positions[t[1]]), c(model.positions[t[2]]);
    volume += glm::dot(a, glm::cross(b, c)) / 6.0;
  }
  return volume;
}

/// The share of the triangles' corners whose normal looks to the triangle's front.
inline double outwardNormals(const Model& model) {
  size_t outward = 0;
  for (const auto& t : model.triangles) {
    const glm::dvec3 a(model.positions[t[0]]), b(model.positions[t[1]]), c(model.positions[t[2]]);
    const glm::dvec3 front = glm::cross(b - a, c - a);
    for (uint32_t vertex : t) outward += glm::dot(front, glm::dvec3(model.normals[vertex])) > 0.0;
  }
  return static_cast<double>(outward) / (3.0 * static_cast<double>(model.triangles.size()));
}

/// Twice the inradius over the circumradius: 1 for an equilateral triangle, 0 for a sliver.
inline double triangleQuality(const Model& model, uint32_t triangle) {
  const auto& t = model.triangles[triangle];
  const glm::dvec3 a(model.positions[t[0]]), b(model.positions[t[1]]), c(model.positions[t[2]]);
  const double u = glm::length(b - a), v = glm::length(c - b), w = glm::length(a - c);
  return (v + w - u) * (w + u - v) * (u + v - w) / (u * v * w);
}

inline const Clip* findClip(const Model& model, const std::string& name) {
  const auto found =
      std::find_if(model.clips.begin(), model.clips.end(), [&](const Clip& c) { return c.name == name; });
  return found == model.clips.end() ? nullptr : &*found;
}

/// The built-in character of that name, made once for all tests of the program.
inline const Model& character(const std::string& name) {
  static std::map<std::string, Model> made;
  const auto found = made.find(name);
  return found != made.end() ? found->second : made.emplace(name, generate(name)).first->second;
}

struct Box {
  glm::dvec3 low{1e30}, high{-1e30};
};

inline double diagonal(const Box& box) { return glm::length(box.high - box.low); }

inline Box boxOf(const std::vector<glm::dvec3>& points) {
  Box box;
  for (const glm::dvec3& point : points) box = {glm::min(box.low, point), glm::max(box.high, point)};
  return box;
}

inline Box restBox(const Model& model) { return boxOf(skinPositions(model, restPose(model))); }

inline Box posedBox(const Model& model, const std::string& clip, double time) {
  const auto index = static_cast<uint32_t>(findClip(model, clip) - model.clips.data());
  return boxOf(skinPositions(model, clipPose(model, index, time)));
}

/// The longest a triangle's side gets in a pose, in units of its length at rest (sides shorter than `least` are not
/// asked).
inline double largestStretch(const Model& model, const std::string& clip, double time, double least) {
  const auto index = static_cast<uint32_t>(findClip(model, clip) - model.clips.data());
  const std::vector<glm::dvec3> posed = skinPositions(model, clipPose(model, index, time));
  double largest = 0.0;
  for (const auto& t : model.triangles) {
    for (int k = 0; k < 3; ++k) {
      const uint32_t a = t[k], b = t[(k + 1) % 3];
      const double rest = glm::length(glm::dvec3(model.positions[a]) - glm::dvec3(model.positions[b]));
      if (rest >= least) largest = std::max(largest, glm::length(posed[a] - posed[b]) / rest);
    }
  }
  return largest;
}

/// The farthest that a vertex moves when every joint takes its rest transform: 0 if the bind pose is the rest pose.
inline double restPoseError(const Model& model) {
  const std::vector<glm::dvec3> posed = skinPositions(model, restPose(model));
  double error = 0.0;
  for (size_t i = 0; i < posed.size(); ++i)
    error = std::max(error, glm::length(posed[i] - glm::dvec3(model.positions[i])));
  return error;
}

/// The sentence of the first broken promise, or nothing. Promises are those of lithe/bake/generate.h and of model.h.
inline std::string brokenPromise(const Model& model, uint32_t max_influences) {
  const size_t count = model.positions.size();
  if (model.normals.size() != count || model.uvs[0].size() != count || model.skins.size() != count)
    return "array sizes";
  if (!model.attributes.normal || model.attributes.uv_sets != 1) return "attributes";
  if (model.triangle_part.size() != model.triangles.size()) return "triangle_part size";
  if (!std::is_sorted(model.triangle_part.begin(), model.triangle_part.end())) return "triangle_part order";
  if (model.triangle_part.back() + 1 != model.parts.size()) return "a part without triangles";
  for (const Part& part : model.parts) {
    if (part.material >= model.materials.size()) return "material of part " + part.name;
  }
  std::vector<uint32_t> part_of_vertex(count, kNone);
  for (size_t t = 0; t < model.triangles.size(); ++t) {
    for (uint32_t vertex : model.triangles[t]) {
      if (vertex >= count) return "index range";
      if (part_of_vertex[vertex] != kNone && part_of_vertex[vertex] != model.triangle_part[t])
        return "vertex in two parts";
      part_of_vertex[vertex] = model.triangle_part[t];
    }
  }
  for (uint32_t node = 0; node < model.nodes.size(); ++node) {
    if (model.nodes[node].parent != kNone && model.nodes[node].parent >= node) return "node order";
  }
  for (size_t vertex = 0; vertex < count; ++vertex) {
    const std::string at = " of vertex " + std::to_string(vertex);
    if (part_of_vertex[vertex] == kNone) return "no triangle" + at;
    if (std::abs(glm::length(model.normals[vertex]) - 1.0f) > 1e-5f) return "normal" + at;
    const glm::vec2 uv = model.uvs[0][vertex];
    if (!(uv.x >= 0.0f && uv.x <= 1.0f && uv.y >= 0.0f && uv.y <= 1.0f)) return "uv" + at;
    const Skin& skin = model.skins[vertex];
    if (skin.count < 1 || skin.count > max_influences) return "influence count" + at;
    float sum = 0.0f;
    for (uint32_t k = 0; k < skin.count; ++k) {
      if (skin.joint[k] >= model.joints.size() || !(skin.weight[k] > 0.0f)) return "influence" + at;
      if (k > 0 && skin.weight[k] > skin.weight[k - 1]) return "influence order" + at;
      sum += skin.weight[k];
    }
    if (std::abs(sum - 1.0f) > 1e-5f) return "weight sum" + at;
  }
  for (const Clip& clip : model.clips) {
    for (const Channel& channel : clip.channels) {
      const std::string at = " of clip " + clip.name + ", node " + model.nodes[channel.node].name;
      if (channel.times.size() != channel.values.size()) return "key count" + at;
      if (!std::is_sorted(channel.times.begin(), channel.times.end(), std::less_equal<>())) return "key times" + at;
      for (const glm::vec4& value : channel.values) {
        const bool rotation = channel.path == Channel::Path::kRotation;
        if (rotation && std::abs(glm::length(value) - 1.0f) > 1e-5f) return "rotation" + at;
      }
    }
  }
  return {};
}

/// Equal in every array and number.
inline bool sameModel(const Model& a, const Model& b) {
  const auto sameSkin = [](const Skin& x, const Skin& y) {
    return x.count == y.count && x.joint == y.joint && x.weight == y.weight;
  };
  if (a.positions != b.positions || a.normals != b.normals || a.uvs[0] != b.uvs[0]) return false;
  if (a.triangles != b.triangles || a.triangle_part != b.triangle_part) return false;
  if (!std::equal(a.skins.begin(), a.skins.end(), b.skins.begin(), b.skins.end(), sameSkin)) return false;
  if (a.clips.size() != b.clips.size() || a.joints.size() != b.joints.size()) return false;
  for (size_t j = 0; j < a.joints.size(); ++j) {
    if (a.joints[j].node != b.joints[j].node || a.joints[j].inverse_bind != b.joints[j].inverse_bind) return false;
  }
  for (size_t i = 0; i < a.clips.size(); ++i) {
    if (a.clips[i].channels.size() != b.clips[i].channels.size()) return false;
    for (size_t c = 0; c < a.clips[i].channels.size(); ++c) {
      if (a.clips[i].channels[c].times != b.clips[i].channels[c].times) return false;
      if (a.clips[i].channels[c].values != b.clips[i].channels[c].values) return false;
    }
  }
  return true;
}

}  // namespace lithe::bake::checks
