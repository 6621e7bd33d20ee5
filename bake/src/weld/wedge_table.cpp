// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "wedge_table.h"

#include <algorithm>

#include "quantize.h"

namespace lithe::bake {

namespace {

uint32_t keySize(const AttributeSet& attributes) {
  return 2 + (attributes.normal ? 2 : 0) + (attributes.tangent ? 3 : 0) + 2 * attributes.uv_sets +
         4 * attributes.color_sets;
}

uint64_t hashOf(const std::vector<int32_t>& key) {
  uint64_t hash = 0xcbf29ce484222325u;
  for (int32_t value : key) {
    hash = (hash ^ static_cast<uint32_t>(value)) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 31;
  }
  return hash;
}

}  // namespace

WedgeTable::WedgeTable(const Model& model, const std::vector<uint32_t>& cluster, Mesh& mesh)
    : model_(model), cluster_(cluster), mesh_(mesh), key_size_(keySize(mesh.attributes)) {
  last_part_.assign(model.positions.size(), kNone);
  last_wedge_.assign(model.positions.size(), kNone);
}

uint32_t WedgeTable::wedge(uint32_t source_vertex, uint32_t part) {
  if (last_part_[source_vertex] == part) return last_wedge_[source_vertex];
  quantize(source_vertex, part);
  const auto [entry, inserted] = head_.try_emplace(hashOf(key_), kNone);
  uint32_t found = entry->second;
  while (found != kNone && !equalsKey(found)) found = next_[found];
  if (found == kNone) {
    found = append();
    next_.push_back(entry->second);
    entry->second = found;
  }
  last_part_[source_vertex] = part;
  return last_wedge_[source_vertex] = found;
}

void WedgeTable::quantize(uint32_t source_vertex, uint32_t part) {
  key_.assign({static_cast<int32_t>(cluster_[source_vertex]), static_cast<int32_t>(part)});
  const AttributeSet& attributes = mesh_.attributes;
  if (attributes.normal) {
    const glm::ivec2 n = toOctahedral(model_.normals[source_vertex], mesh_.normal_bits);
    key_.insert(key_.end(), {n.x, n.y});
  }
  if (attributes.tangent) {
    const glm::vec4 tangent = model_.tangents[source_vertex];
    const glm::ivec2 t = toOctahedral(glm::vec3(tangent), mesh_.normal_bits);
    key_.insert(key_.end(), {t.x, t.y, tangent.w < 0.0f ? 0 : 1});
  }
  for (uint32_t set = 0; set < attributes.uv_sets; ++set) {
    const glm::ivec2 uv = toUv(mesh_.part_uv[part][set], model_.uvs[set][source_vertex], mesh_.uv_bits);
    key_.insert(key_.end(), {uv.x, uv.y});
  }
  for (uint32_t set = 0; set < attributes.color_sets; ++set) {
    const glm::ivec4 c = toUnorm8(model_.colors[set][source_vertex]);
    key_.insert(key_.end(), {c.x, c.y, c.z, c.w});
  }
}

uint32_t WedgeTable::append() {
  const int32_t* value = key_.data();
  mesh_.wedge_vertex.push_back(static_cast<uint32_t>(*value++));
  mesh_.wedge_part.push_back(static_cast<uint32_t>(*value++));
  if (mesh_.attributes.normal) {
    mesh_.wedge_normal.emplace_back(value[0], value[1]);
    value += 2;
  }
  if (mesh_.attributes.tangent) {
    mesh_.wedge_tangent.emplace_back(value[0], value[1], value[2]);
    value += 3;
  }
  for (uint32_t set = 0; set < mesh_.attributes.uv_sets; ++set, value += 2)
    mesh_.wedge_uv[set].emplace_back(value[0], value[1]);
  for (uint32_t set = 0; set < mesh_.attributes.color_sets; ++set, value += 4) {
    mesh_.wedge_color[set].emplace_back(value[0], value[1], value[2], value[3]);
  }
  keys_.insert(keys_.end(), key_.begin(), key_.end());
  return mesh_.wedgeCount() - 1;
}

bool WedgeTable::equalsKey(uint32_t wedge) const {
  return std::equal(key_.begin(), key_.end(), keys_.begin() + static_cast<ptrdiff_t>(wedge) * key_size_);
}

}  // namespace lithe::bake
