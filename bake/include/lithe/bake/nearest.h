// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Exact distances to a triangle mesh, and the distance between two surfaces measured by sampling.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "lithe/bake/model.h"

namespace lithe::bake {

using Triangle = std::array<uint32_t, 3>;  ///< indices into a span of positions

/// The point of a triangle mesh nearest to a query.
struct NearestPoint {
  uint32_t triangle = kNone;  ///< index into the triangles the tree was built from
  double distance2 = 0.0;     ///< squared distance to the query
  glm::dvec3 barycentric{0};  ///< of the nearest point: >= 0, sums to 1
};

/// A bounding volume tree over triangles. Owns copies of the corners, so the spans may die after construction.
/// Building is O(n log n); a query touches some tens of nodes. Degenerate triangles (segments, points) are legal.
/// const members may be called from several threads at once.
class TriangleTree {
 public:
  /// @param triangles  at least one, every index < positions.size(); every position finite (else the answers are
  /// unspecified)
  TriangleTree(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles);

  /// The same triangles elsewhere, in linear time: the tree keeps its shape, so queries stay exact but take longer the
  /// less the places resemble those it was built for. A character in another pose is no great change.
  void move(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles);

  /// The nearest point; of equally near triangles the one with the lowest index.
  /// @param hint  a triangle believed to be near (for example the last answer), kNone for none: saves time. It changes
  /// the
  ///              answer at most where two triangles are equally near to within rounding.
  NearestPoint nearest(const glm::dvec3& query, uint32_t hint = kNone) const;

  /// The nearest point of every triangle that is at most `slack` further away than the nearest one, in ascending order
  /// of (distance, triangle). Never empty. `found` is overwritten; it is a parameter so that its memory can be used
  /// again.
  void nearestWithin(const glm::dvec3& query, double slack, std::vector<NearestPoint>& found,
                     uint32_t hint = kNone) const;

  /// Squared distance from the query to one triangle.
  double distance2(const glm::dvec3& query, uint32_t triangle) const;

 private:
  struct Node {
    glm::dvec3 low, high;
    uint32_t first = 0;  ///< leaf: first entry of order_; inner node: left child, the right one follows it
    uint32_t count = 0;  ///< triangles of a leaf; 0 for an inner node
  };
  struct Corners {
    glm::dvec3 a, b, c;
  };
  friend class TreeBuilder;
  template <typename Visit>
  void traverse(const glm::dvec3& query, const double& bound2, Visit&& visit) const;

  std::vector<Node> nodes_;         ///< root first, children adjacent
  std::vector<Corners> corners_;    ///< in the order of order_
  std::vector<uint32_t> order_;     ///< leaf entry -> triangle
  std::vector<uint32_t> entry_of_;  ///< triangle -> leaf entry
};

/// The corner that a point of a triangle is nearest to, by its barycentric coordinates; of equal ones the first.
inline int largestShare(const glm::dvec3& barycentric) {
  return barycentric.x >= barycentric.y && barycentric.x >= barycentric.z ? 0 : barycentric.y >= barycentric.z ? 1 : 2;
}

/// A point of a surface.
struct SurfaceSample {
  uint32_t triangle = 0;
  glm::dvec3 barycentric{0};
};

/// Points spread over a mesh by area: the area is cut into `count` equal strata (triangle after triangle) and one
/// uniformly distributed point is taken from each. A mesh without area is sampled uniformly over its triangles instead.
/// Depends on its arguments only, to the bit.
std::vector<SurfaceSample> sampleSurface(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles,
                                         uint32_t count, uint64_t seed);

/// How far one surface is from another, in the units of the positions.
struct SurfaceDistance {
  double rms = 0.0;
  double mean = 0.0;
  double max = 0.0;   ///< surfaceDistance(): over the samples and all vertices that a triangle uses, which is the
                      ///< one-sided Hausdorff distance from below; sampledDistance(): over the samples
  double p999 = 0.0;  ///< 99.9 % of the samples are at most this far
};

/// Distance from surface A to surface B: exact point-triangle distances from `samples` points of A and from A's
/// vertices. Both surfaces need at least one triangle; samples >= 1. Not symmetric. Safe to call from any thread; same
/// arguments, same bits.
SurfaceDistance surfaceDistance(std::span<const glm::dvec3> positions_a, std::span<const Triangle> triangles_a,
                                std::span<const glm::dvec3> positions_b, std::span<const Triangle> triangles_b,
                                uint32_t samples, uint64_t seed);

/// The same with B's tree already built, for measuring several surfaces against one.
SurfaceDistance surfaceDistance(std::span<const glm::dvec3> positions_a, std::span<const Triangle> triangles_a,
                                const TriangleTree& tree_b, uint32_t samples, uint64_t seed);

/// Per vertex: triangles of another mesh that are likely to be near it. Good ones save time, bad ones change nothing.
using TrianglesNear = std::function<std::span<const uint32_t>(uint32_t vertex)>;

/// surfaceDistance() from the samples alone.
SurfaceDistance sampledDistance(std::span<const glm::dvec3> positions_a, std::span<const Triangle> triangles_a,
                                const TriangleTree& tree_b, uint32_t samples, uint64_t seed,
                                const TrianglesNear& near = {});

/// The largest distance from a vertex that a triangle uses to the tree's mesh, or `at_least` if that is larger.
/// Vertices that a triangle named by `near` shows to be no farther than the largest so far are not searched for.
double farthestVertex(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles,
                      const TriangleTree& tree, double at_least, const TrianglesNear& near = {});

/// Both directions, and member by member the larger of the two: the convention of Metro (Cignoni, Rocchini and Scopigno
/// 1998).
struct SurfaceDistances {
  SurfaceDistance a_to_b;
  SurfaceDistance b_to_a;
  SurfaceDistance symmetric;
};

SurfaceDistances surfaceDistances(std::span<const glm::dvec3> positions_a, std::span<const Triangle> triangles_a,
                                  std::span<const glm::dvec3> positions_b, std::span<const Triangle> triangles_b,
                                  uint32_t samples, uint64_t seed);

}  // namespace lithe::bake
