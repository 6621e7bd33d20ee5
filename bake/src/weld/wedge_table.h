// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Unique wedges: (vertex, part, quantised attributes).
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "lithe/bake/mesh.h"

namespace lithe::bake {

class WedgeTable {
 public:
  // Fills the wedge arrays of `mesh`, whose grids and attribute set are final. wedge_vertex receives `cluster` numbers.
  WedgeTable(const Model& model, const std::vector<uint32_t>& cluster, Mesh& mesh);

  // The wedge of a source vertex in a part, made on first use.
  uint32_t wedge(uint32_t source_vertex, uint32_t part);

 private:
  void quantize(uint32_t source_vertex, uint32_t part);
  uint32_t append();
  bool equalsKey(uint32_t wedge) const;

  const Model& model_;
  const std::vector<uint32_t>& cluster_;
  Mesh& mesh_;
  uint32_t key_size_;
  std::vector<int32_t> key_;    // of the corner being looked up
  std::vector<int32_t> keys_;   // key_size_ per wedge
  std::vector<uint32_t> next_;  // per wedge: the next with the same hash
  std::unordered_map<uint64_t, uint32_t> head_;
  std::vector<uint32_t> last_part_, last_wedge_;  // per source vertex: the answer of the last look-up
};

}  // namespace lithe::bake
