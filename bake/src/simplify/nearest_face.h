// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The nearest point of the faces around some slots, in all poses at once: a point and a triangle in all poses are one
// point and one triangle of a space of three dimensions per pose.
//
// Six squared distances between a triangle's corners and a point say all about how these four lie. The corners' are
// kept from search to search, the point's are shared by the faces around it: so a face costs a few sums, not a few
// passes over the poses.
#pragma once

#include <array>
#include <vector>

#include "kernels.h"
#include "node_state.h"
#include "surface.h"

namespace lithe::bake {

/// Squared lengths of a face's edges 0-1, 0-2 and 1-2, summed over the poses.
using EdgeLengths = std::array<float, 3>;
EdgeLengths edgeLengths(const Face& face, const PosedMesh& posed);

/// A point of a face, as shares of its corners; kNone where there is no face.
struct FacePoint {
  uint32_t face = kNone;
  std::array<float, 3> share{};

  bool operator==(const FacePoint&) const = default;
};

/// One per thread. The surface, the nodes and the lengths must not change between searches.
class FaceSearch {
 public:
  /// @param lengths  of every face by id; those of faces that are gone are not read
  FaceSearch(const NodeState& nodes, const Surface& surface, const std::vector<EdgeLengths>& lengths);

  /// The nearest point of the faces at the slots, which may be equal; the first of several faces equally near.
  FacePoint nearest(const PosedPoint* point, const std::array<uint32_t, 3>& slots);

 private:
  struct Candidate {
    uint32_t face;
    std::array<uint32_t, 3> corner;  // of vertices_
  };
  struct Mark {
    uint32_t stamp = 0, index = 0;
  };

  void makeRoom(const std::array<uint32_t, 3>& slots);
  void gather(const std::array<uint32_t, 3>& slots);
  uint32_t indexOf(uint32_t slot);
  FacePoint pointOf(const Candidate& candidate) const;

  const NodeState& nodes_;
  const Surface& surface_;
  const std::vector<EdgeLengths>& lengths_;

  // What was gathered last: neighbours in a list of points have the same slots.
  std::array<uint32_t, 3> slots_{kNone, kNone, kNone};
  uint32_t candidate_count_ = 0, vertex_count_ = 0;
  std::vector<Candidate> candidates_;  // this and all below are as long as it ever took
  std::vector<const PosedPoint*> vertices_;
  std::vector<Mark> marks_;  // per slot: its place in vertices_ when the stamp is the last one
  uint32_t last_stamp_ = 0;
  std::vector<float> distance_;  // per vertex, to the point
  std::vector<FaceDistances> batch_;
  std::vector<float> nearness_;  // kLanes per batch: squared distances
};

}  // namespace lithe::bake
