// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Collapses applied to triangles and wedges, one by one.
#pragma once

#include <array>
#include <vector>

#include "list_pool.h"
#include "lithe/bake/mesh.h"

namespace lithe::bake {

struct ReplayFace {
  std::array<uint32_t, 3> node;
  std::array<uint32_t, 3> wedge;
  uint32_t part;

  bool alive() const { return node[0] != node[1] && node[1] != node[2] && node[2] != node[0]; }
};

/// A wedge's attributes: directions as unit vectors, the rest as the mesh's integers.
struct WedgeValue {
  glm::vec3 normal{0.0f};
  glm::vec4 tangent{0.0f};
  std::array<glm::ivec2, kMaxUvSets> uv{};
  std::array<glm::ivec4, kMaxColorSets> color{};
};

class WedgeReplay {
 public:
  explicit WedgeReplay(const Mesh& mesh);

  void collapse(uint32_t node, const Collapse& collapse);

  const std::vector<ReplayFace>& faces() const { return faces_; }
  const WedgeValue& value(uint32_t wedge) const { return values_[wedge]; }
  uint32_t wedgeCount() const { return static_cast<uint32_t>(values_.size()); }

 private:
  /// Wedges that become one: those of child 0 and of child 1, in the order of the dying triangles.
  struct Union {
    std::vector<uint32_t> members[2];
  };

  std::vector<Union> findUnions(uint32_t a, uint32_t b) const;
  WedgeValue blend(const WedgeValue& v, const WedgeValue& u, int32_t t8) const;

  const Mesh& mesh_;
  std::vector<ReplayFace> faces_;
  std::vector<WedgeValue> values_;
  std::vector<uint32_t> slot_of_;  // per node
  ListPool at_;                    // per slot: its triangles, ascending
};

}  // namespace lithe::bake
