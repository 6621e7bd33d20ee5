// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "wedge_replay.h"

#include <algorithm>
#include <iterator>

#include "lithe/format/octahedral.h"
#include "lithe/format/placement.h"

namespace lithe::bake {

namespace {

glm::vec3 toDirection(const glm::ivec2& point, uint32_t bits) {
  int32_t d[3];
  format::octahedralDirection({point.x, point.y}, format::octahedralCenter(bits), d);
  return glm::vec3(glm::normalize(glm::dvec3(d[0], d[1], d[2])));
}

WedgeValue valueOf(const Mesh& mesh, uint32_t wedge) {
  WedgeValue value;
  if (mesh.attributes.normal) value.normal = toDirection(mesh.wedge_normal[wedge], mesh.normal_bits);
  if (mesh.attributes.tangent) {
    const glm::ivec3 tangent = mesh.wedge_tangent[wedge];
    value.tangent = glm::vec4(toDirection(glm::ivec2(tangent), mesh.normal_bits), tangent.z == 0 ? -1.0f : 1.0f);
  }
  for (uint32_t set = 0; set < mesh.attributes.uv_sets; ++set) value.uv[set] = mesh.wedge_uv[set][wedge];
  for (uint32_t set = 0; set < mesh.attributes.color_sets; ++set) value.color[set] = mesh.wedge_color[set][wedge];
  return value;
}

/// Half way between two directions as in a file (format::directionEighths), but on the sphere; the one that t8 is
/// nearer to where they are more than a third of a turn apart.
glm::vec3 blendDirections(const glm::vec3& v, const glm::vec3& u, int32_t t8) {
  if (glm::dot(v, u) < -0.5f) return t8 < 4 ? v : u;
  return glm::vec3(glm::normalize(glm::dvec3(v) + glm::dvec3(u)));
}

template <class Vector>
Vector blendIntegers(const Vector& v, const Vector& u, int32_t t8) {
  Vector result = v;
  for (int i = 0; i < Vector::length(); ++i) result[i] += format::eighths(u[i] - v[i], t8);
  return result;
}

bool holds(const std::vector<uint32_t>& wedges, uint32_t wedge) {
  return std::find(wedges.begin(), wedges.end(), wedge) != wedges.end();
}

void add(std::vector<uint32_t>& wedges, uint32_t wedge) {
  if (!holds(wedges, wedge)) wedges.push_back(wedge);
}

uint32_t wedgeAt(const ReplayFace& face, uint32_t node) {
  return face.wedge[face.node[0] == node ? 0 : face.node[1] == node ? 1 : 2];
}

bool touches(const ReplayFace& face, uint32_t node) {
  return face.node[0] == node || face.node[1] == node || face.node[2] == node;
}

std::vector<uint32_t> facesPerVertex(const Mesh& mesh) {
  std::vector<uint32_t> count(mesh.vertexCount(), 0);
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    for (uint32_t k = 0; k < 3; ++k) ++count[mesh.corner(t, k)];
  }
  return count;
}

}  // namespace

WedgeReplay::WedgeReplay(const Mesh& mesh) : mesh_(mesh), at_(facesPerVertex(mesh)) {
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const ReplayFace face{{mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)},
                          mesh.triangles[t],
                          mesh.wedge_part[mesh.triangles[t][0]]};
    for (uint32_t vertex : face.node) at_.append(vertex, t);
    faces_.push_back(face);
  }
  for (uint32_t wedge = 0; wedge < mesh.wedgeCount(); ++wedge) values_.push_back(valueOf(mesh, wedge));
  for (uint32_t vertex = 0; vertex < mesh.vertexCount(); ++vertex) slot_of_.push_back(vertex);
}

void WedgeReplay::collapse(uint32_t node, const Collapse& collapse) {
  const uint32_t a = collapse.child[0], b = collapse.child[1];
  const std::vector<Union> unions = findUnions(a, b);
  const auto first_new = static_cast<uint32_t>(values_.size());
  for (const Union& u : unions)
    values_.push_back(blend(values_[u.members[0][0]], values_[u.members[1][0]], collapse.t8));

  const std::span<const uint32_t> at_a = at_[slot_of_[a]], at_b = at_[slot_of_[b]];
  std::vector<uint32_t> merged;
  std::set_union(at_a.begin(), at_a.end(), at_b.begin(), at_b.end(), std::back_inserter(merged));
  std::erase_if(merged, [&](uint32_t id) { return touches(faces_[id], a) && touches(faces_[id], b); });
  for (const uint32_t slot : {slot_of_[a], slot_of_[b]}) {
    for (uint32_t id : at_[slot]) {
      ReplayFace& face = faces_[id];
      for (uint32_t k = 0; k < 3; ++k) {
        if (face.node[k] != a && face.node[k] != b) continue;
        const uint32_t side = face.node[k] == a ? 0 : 1;
        for (uint32_t i = 0; i < unions.size(); ++i) {
          if (holds(unions[i].members[side], face.wedge[k])) {
            face.wedge[k] = first_new + i;
            break;
          }
        }
        face.node[k] = node;
      }
    }
  }
  at_.assign(slot_of_[a], merged);
  at_.assign(slot_of_[b], {});
  slot_of_.push_back(slot_of_[a]);
}

std::vector<WedgeReplay::Union> WedgeReplay::findUnions(uint32_t a, uint32_t b) const {
  std::vector<Union> unions;
  for (uint32_t id : at_[slot_of_[a]]) {
    const ReplayFace& face = faces_[id];
    if (!touches(face, b) || !face.alive()) continue;
    const uint32_t wedge_a = wedgeAt(face, a), wedge_b = wedgeAt(face, b);
    Union joined;
    for (auto it = unions.begin(); it != unions.end();) {
      if (!holds(it->members[0], wedge_a) && !holds(it->members[1], wedge_b)) {
        ++it;
        continue;
      }
      for (int side = 0; side < 2; ++side) {
        for (uint32_t wedge : it->members[side]) add(joined.members[side], wedge);
      }
      it = unions.erase(it);
    }
    add(joined.members[0], wedge_a);
    add(joined.members[1], wedge_b);
    unions.push_back(joined);
  }
  return unions;
}

WedgeValue WedgeReplay::blend(const WedgeValue& v, const WedgeValue& u, int32_t t8) const {
  WedgeValue value = v;
  if (mesh_.attributes.normal) value.normal = blendDirections(v.normal, u.normal, t8);
  if (mesh_.attributes.tangent) {
    const glm::vec3 direction = blendDirections(glm::vec3(v.tangent), glm::vec3(u.tangent), t8);
    value.tangent = glm::vec4(direction, t8 < 4 ? v.tangent.w : u.tangent.w);
  }
  for (uint32_t set = 0; set < mesh_.attributes.uv_sets; ++set) value.uv[set] = blendIntegers(v.uv[set], u.uv[set], t8);
  for (uint32_t set = 0; set < mesh_.attributes.color_sets; ++set) {
    value.color[set] = blendIntegers(v.color[set], u.color[set], t8);
  }
  return value;
}

}  // namespace lithe::bake
