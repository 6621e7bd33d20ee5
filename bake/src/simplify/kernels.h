// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The loops over poses. All arguments are arrays of one entry per block of eight poses; all sums are in a fixed order.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "posed_mesh.h"
#include "quadric.h"

namespace lithe::bake {

/// A of a quadric whose planes all pass through its origin: b and c are zero.
template <class L>
struct alignas(kLanesAlignment) SymmetricOf {
  L xx, xy, xz, yy, yz, zz;
};
using Symmetric = SymmetricOf<Lanes>;

inline Quadric withoutLinearTerm(const Symmetric& q) {
  return {q.xx, q.xy, q.xz, q.yy, q.yz, q.zz, Lanes{}, Lanes{}, Lanes{}, Lanes{}};
}

/// A triangle seen from one of its corners.
struct FanFace {
  const PosedPoint* corner;  // the fan's own
  const PosedPoint* next;
  const PosedPoint* last;
  float next_weight = 0.0f;  // of the edges corner-next and corner-last: how much they want to stay in place
  float last_weight = 0.0f;
};

/// A third of each face's area times its plane, and half of each weighted edge's plane (through the edge, perpendicular
/// to the face, weight * |edge|^2 / 2), so that faces and edges count once in the sum over all vertices.
void fanQuadric(std::span<const FanFace> fan, uint32_t blocks, Symmetric* result);

/// The sum of two vertices' quadrics, each about its own position, about a's position.
void combine(const Quadric* qa, const Quadric* qb, const PosedPoint* a, const PosedPoint* b, uint32_t blocks,
             Quadric* sum);

/// combine(), less one third of the areas of the faces between the two, a's fan: they are in both quadrics.
void combineLess(std::span<const FanFace> between, const Symmetric* qa, const Symmetric* qb, const PosedPoint* a,
                 const PosedPoint* b, uint32_t blocks, Quadric* sum);

/// qa and qb, about a and b, become one quadric about `parent`; the result may be qa.
void accumulate(const Quadric* qa, const Quadric* qb, const PosedPoint* a, const PosedPoint* b,
                const PosedPoint* parent, uint32_t blocks, Quadric* result);

/// A quadric about `from` becomes one about `to`.
void recenter(const PosedPoint* from, const PosedPoint* to, uint32_t blocks, Quadric* q);

/// The sum over the poses of the quadric at a point.
float energy(const Quadric* q, const PosedPoint* origin, const PosedPoint* point, uint32_t blocks);

/// energy() at the origin itself and at another point.
std::array<float, 2> energiesAtEnds(const Quadric* q, const PosedPoint* origin, const PosedPoint* other,
                                    uint32_t blocks);

/// energy() where `blend` puts a grid point; `result` receives that place.
float energyOfPlace(const Quadric* q, const PosedPoint* origin, const Affine* blend, const glm::vec3& grid_point,
                    uint32_t blocks, PosedPoint* result);

/// energy() of two quadrics, each about its own origin, at one point.
std::array<float, 2> energies(const Quadric* qa, const Quadric* qb, const PosedPoint* a, const PosedPoint* b,
                              const PosedPoint* point, uint32_t blocks);

/// Hessian / 2 and gradient / 2 of the energy with respect to the grid position of a point skinned by `blend`.
struct NormalEquations {
  float xx, xy, xz, yy, yz, zz;
  float gx, gy, gz;
};
NormalEquations normalEquations(const Quadric* q, const Affine* blend, const PosedPoint* origin,
                                const PosedPoint* point, uint32_t blocks);

/// The energy as a function of the weights of joints that put the point at `candidates` (joint-major): its matrix, size
/// by size, and its linear term, in doubles.
void weightTerms(const Quadric* q, const PosedPoint* origin, const PosedPoint* candidates, uint32_t size,
                 uint32_t blocks, double* matrix, double* linear);

/// In how many poses the triangle (corner, next, last) turns over when `corner` moves to `moved`.
uint32_t countFlips(const FanFace& face, const PosedPoint* moved, uint32_t blocks);

/// The sum over the poses of the squared distance of two points.
float squaredDistances(const PosedPoint* a, const PosedPoint* b, uint32_t blocks);

/// The same for one point and many others.
void squaredDistancesFrom(const PosedPoint* point, std::span<const PosedPoint* const> others, uint32_t blocks,
                          float* result);

/// Eight triangles, each with a point: squared distances, whatever the number of dimensions.
template <class L>
struct alignas(kLanesAlignment) FaceDistancesOf {
  L to[3];    // from the point to the corners
  L edge[3];  // lengths of 0-1, 0-2 and 1-2
};
using FaceDistances = FaceDistancesOf<Lanes>;

/// The squared distance of each point to the nearest point of its triangle, kLanes for each of `faces`; rounding may
/// bring it below zero.
void squaredDistancesToFaces(std::span<const FaceDistances> faces, float* result);

}  // namespace lithe::bake
