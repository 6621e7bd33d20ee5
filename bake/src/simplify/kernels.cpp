// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "kernels.h"

#include <cstring>
#include <vector>

#include "kernel_templates.h"

namespace lithe::bake {

LITHE_KERNEL void fanQuadric(std::span<const FanFace> fan, uint32_t blocks, Symmetric* result) {
  for (uint32_t block = 0; block < blocks; ++block) {
    Symmetric sum{};
    for (const FanFace& f : fan) {
      addFanFace(sum, f.corner[block], f.next[block], f.last[block], f.next_weight, f.last_weight);
    }
    result[block] = sum;
  }
}

LITHE_KERNEL void combineLess(std::span<const FanFace> between, const Symmetric* qa, const Symmetric* qb,
                              const PosedPoint* a, const PosedPoint* b, uint32_t blocks, Quadric* sum) {
  for (uint32_t block = 0; block < blocks; ++block) {
    Symmetric twice{};
    for (const FanFace& f : between) addFanFace(twice, f.corner[block], f.next[block], f.last[block], 0.0f, 0.0f);
    Quadric result = shifted(withoutLinearTerm(qb[block]), a[block] - b[block]);
    addSymmetric(result, qa[block]);
    addSymmetric(result, {-twice.xx, -twice.xy, -twice.xz, -twice.yy, -twice.yz, -twice.zz});
    sum[block] = result;
  }
}

LITHE_KERNEL void combine(const Quadric* qa, const Quadric* qb, const PosedPoint* a, const PosedPoint* b,
                          uint32_t blocks, Quadric* sum) {
  for (uint32_t block = 0; block < blocks; ++block) {
    sum[block] = sumOf(qa[block], shifted(qb[block], a[block] - b[block]));
  }
}

LITHE_KERNEL void accumulate(const Quadric* qa, const Quadric* qb, const PosedPoint* a, const PosedPoint* b,
                             const PosedPoint* parent, uint32_t blocks, Quadric* result) {
  for (uint32_t block = 0; block < blocks; ++block) {
    result[block] = sumOf(shifted(qa[block], parent[block] - a[block]), shifted(qb[block], parent[block] - b[block]));
  }
}

LITHE_KERNEL void recenter(const PosedPoint* from, const PosedPoint* to, uint32_t blocks, Quadric* q) {
  for (uint32_t block = 0; block < blocks; ++block) q[block] = shifted(q[block], to[block] - from[block]);
}

LITHE_KERNEL float energy(const Quadric* q, const PosedPoint* origin, const PosedPoint* point, uint32_t blocks) {
  Lanes sum{};
  for (uint32_t block = 0; block < blocks; ++block) sum += energyAt(q[block], point[block] - origin[block]);
  return laneSum(sum);
}

// At the origin itself nothing but the constant is left.
LITHE_KERNEL std::array<float, 2> energiesAtEnds(const Quadric* q, const PosedPoint* origin, const PosedPoint* other,
                                                 uint32_t blocks) {
  Lanes here{}, there{};
  for (uint32_t block = 0; block < blocks; ++block) {
    here += q[block].c;
    there += energyAt(q[block], other[block] - origin[block]);
  }
  return {laneSum(here), laneSum(there)};
}

LITHE_KERNEL float energyOfPlace(const Quadric* q, const PosedPoint* origin, const Affine* blend,
                                 const glm::vec3& grid_point, uint32_t blocks, PosedPoint* result) {
  Lanes sum{};
  for (uint32_t block = 0; block < blocks; ++block) {
    const PosedPoint place = transformed(blend[block], grid_point.x, grid_point.y, grid_point.z);
    result[block] = place;
    sum += energyAt(q[block], place - origin[block]);
  }
  return laneSum(sum);
}

LITHE_KERNEL std::array<float, 2> energies(const Quadric* qa, const Quadric* qb, const PosedPoint* a,
                                           const PosedPoint* b, const PosedPoint* point, uint32_t blocks) {
  Lanes of_a{}, of_b{};
  for (uint32_t block = 0; block < blocks; ++block) {
    of_a += energyAt(qa[block], point[block] - a[block]);
    of_b += energyAt(qb[block], point[block] - b[block]);
  }
  return {laneSum(of_a), laneSum(of_b)};
}

LITHE_KERNEL NormalEquations normalEquations(const Quadric* q, const Affine* blend, const PosedPoint* origin,
                                             const PosedPoint* point, uint32_t blocks) {
  NormalTerms<Lanes> sum{};
  for (uint32_t block = 0; block < blocks; ++block) {
    addNormalTerms(sum, q[block], blend[block].m, point[block] - origin[block]);
  }
  return {laneSum(sum.xx), laneSum(sum.xy), laneSum(sum.xz), laneSum(sum.yy), laneSum(sum.yz),
          laneSum(sum.zz), laneSum(sum.gx), laneSum(sum.gy), laneSum(sum.gz)};
}

LITHE_KERNEL void weightTerms(const Quadric* q, const PosedPoint* origin, const PosedPoint* candidates, uint32_t size,
                              uint32_t blocks, double* matrix, double* linear) {
  for (uint32_t i = 0; i < size; ++i) {
    for (uint32_t k = 0; k <= i; ++k) {
      Lanes product{}, with_linear{};
      for (uint32_t block = 0; block < blocks; ++block) {
        const PosedPoint c = candidates[i * blocks + block] - origin[block];
        const PosedPoint d = candidates[k * blocks + block] - origin[block];
        const Lanes b_term = q[block].bx * d.x + q[block].by * d.y + q[block].bz * d.z;
        const PosedPoint g = halfGradient(q[block], c);
        product += dot(g, d) - b_term;
        with_linear += b_term;
      }
      matrix[i * size + k] = matrix[k * size + i] = double{laneSum(product)};
      if (k == i) linear[i] = double{laneSum(with_linear)};
    }
  }
}

LITHE_KERNEL uint32_t countFlips(const FanFace& face, const PosedPoint* moved, uint32_t blocks) {
  uint32_t flips = 0;
  for (uint32_t block = 0; block < blocks; ++block) {
    const PosedPoint before = cross(face.next[block] - face.corner[block], face.last[block] - face.corner[block]);
    const PosedPoint after = cross(face.next[block] - moved[block], face.last[block] - moved[block]);
    flips += countLess(dot(before, after), Lanes{});
  }
  return flips;
}

LITHE_KERNEL float squaredDistances(const PosedPoint* a, const PosedPoint* b, uint32_t blocks) {
  Lanes sum{};
  for (uint32_t block = 0; block < blocks; ++block) {
    const PosedPoint edge = b[block] - a[block];
    sum += dot(edge, edge);
  }
  return laneSum(sum);
}

LITHE_KERNEL void squaredDistancesFrom(const PosedPoint* point, std::span<const PosedPoint* const> others,
                                       uint32_t blocks, float* result) {
  for (size_t i = 0; i < others.size(); ++i) {
    Lanes sum{};
    for (uint32_t block = 0; block < blocks; ++block) {
      const PosedPoint edge = others[i][block] - point[block];
      sum += dot(edge, edge);
    }
    result[i] = laneSum(sum);
  }
}

LITHE_KERNEL void squaredDistancesToFaces(std::span<const FaceDistances> faces, float* result) {
  for (size_t i = 0; i < faces.size(); ++i) {
    const Lanes of_eight = squaredDistanceToFace(faces[i]);
    std::memcpy(result + kLanes * i, &of_eight, sizeof of_eight);
  }
}

}  // namespace lithe::bake
