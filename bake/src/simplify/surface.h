// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The triangles as they are now: who is next to whom, which edges must be kept in place, and what a collapse does to
// them.
//
// There is no link condition: any two vertices with an edge between them may become one. Triangles with two corners
// there disappear, of equal triangles with equal orientation one remains, and opposite ones stay: a two-sided sheet.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "large_vector.h"
#include "list_pool.h"
#include "lithe/bake/mesh.h"
#include "posed_mesh.h"

namespace lithe::bake {

/// Why an edge wants to stay where it is; bits of Face::kind.
enum EdgeKind : uint8_t {
  kBorder = 1,  // one triangle
  kSeam = 2,    // two triangles whose wedges differ at either end
  kFold = 4,    // two triangles that fold back on each other: a silhouette
};

struct Face {
  std::array<uint32_t, 3> corner;  // slots
  std::array<uint32_t, 3> wedge;   // classes of wedges; kNone marks a triangle that is gone
  std::array<uint8_t, 3> kind;     // of the edge opposite to each corner
  glm::vec3 normal{0.0f};          // in the first pose, as long as twice the area

  uint32_t cornerOf(uint32_t slot) const {
    return corner[0] == slot ? 0 : corner[1] == slot ? 1 : corner[2] == slot ? 2 : 3;
  }
  bool alive() const { return wedge[0] != kNone; }
  /// Without branches: which corner it is nobody can guess.
  bool has(uint32_t slot) const {
    return (uint32_t{corner[0] == slot} | uint32_t{corner[1] == slot} | uint32_t{corner[2] == slot}) != 0;
  }
  /// Of a slot that it has.
  uint32_t knownCornerOf(uint32_t slot) const { return (corner[1] == slot ? 1u : 0u) + (corner[2] == slot ? 2u : 0u); }
  /// The corners after a slot that it has, in order.
  uint32_t nextTo(uint32_t slot) const { return corner[kAfter[knownCornerOf(slot)]]; }
  uint32_t lastTo(uint32_t slot) const { return corner[kAfter[knownCornerOf(slot) + 1]]; }

  static constexpr std::array<uint8_t, 4> kAfter{1, 2, 0, 1};
};

class Surface {
 public:
  /// Slots are the mesh's vertices. Triangles that repeat another's three vertices and orientation are left out.
  explicit Surface(const Mesh& mesh);

  uint32_t triangleCount() const { return triangle_count_; }
  const Face& face(uint32_t id) const { return faces_[id]; }
  uint32_t faceCount() const { return static_cast<uint32_t>(faces_.size()); }
  std::span<const uint32_t> facesAt(uint32_t slot) const { return at_[slot]; }
  bool hasEdge(uint32_t a, uint32_t b) const;

  /// Hints that the triangles at a slot will be read; in this order, with time in between.
  void prefetchHead(uint32_t slot) const { at_.prefetchHead(slot); }
  void prefetchList(uint32_t slot) const { at_.prefetch(slot); }
  void prefetchFaces(uint32_t slot) const {
    for (uint32_t id : at_[slot]) __builtin_prefetch(&faces_[id]);
  }

  /// Sets the kinds of all edges; positions are read for folds (in the first pose).
  void classifyEdges(const PosedMesh& posed);

  /// Whether the collapse of a and b would leave a vertex, or the new one, without triangles.
  bool wouldOrphan(uint32_t a, uint32_t b) const;

  /// Whether the collapse of a and b would leave no triangle at all.
  bool wouldVanish(uint32_t a, uint32_t b) const;

  /// How many triangles the new vertex of a and b would have.
  uint32_t valenceAfter(uint32_t a, uint32_t b) const;

  /// Makes b's triangles a's. `thirds` receives the third corners of the
  /// triangles that die: each may lose its edge to a.
  void collapse(uint32_t a, uint32_t b, std::vector<uint32_t>& thirds);

  /// Sets the kinds of the edges at a slot and opposite to it, after it moved; edges on to others have not changed.
  void classifyAround(uint32_t slot, const PosedMesh& posed);

 private:
  void uniteWedges(uint32_t a, uint32_t b);
  void mergeEqualFaces(uint32_t slot);
  void classify(uint32_t from, uint32_t to);
  void findFacesBetween(uint32_t from, uint32_t to);
  uint8_t kindBetween(uint32_t from, uint32_t to) const;

  LargeVector<Face> faces_;
  ListPool at_;  // per slot: its triangles, ascending by time of arrival
  uint32_t triangle_count_ = 0;
  std::vector<uint32_t> scratch_;
  std::vector<uint64_t> others_;
  std::vector<uint32_t> at_edge_;  // faces
};

}  // namespace lithe::bake
