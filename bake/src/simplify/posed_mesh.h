// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The live nodes in all example poses.
#pragma once

#include <vector>

#include "lanes.h"
#include "large_vector.h"
#include "lithe/bake/mesh.h"

namespace lithe::bake {

/// The 3x4 matrices of one joint (or a blend of joints) in eight poses, row by row.
struct alignas(kLanesAlignment) Affine {
  Lanes m[3][4];
};
using PosedPoint = Vec3<Lanes>;

/// Posed positions, in units of the posed diagonal and about the middle of each pose: all tolerances are relative to
/// what is seen, whatever units the bind space has. Lanes beyond the last pose are zero everywhere and so add nothing
/// to any sum.
struct PosedMesh {
  uint32_t pose_count = 0;
  uint32_t blocks = 0;                // of eight poses
  double unit = 1.0;                  // the posed diagonal in model units
  float weight_scale = 1.0f;          // 1 / Mesh::weight_one
  std::vector<Affine> palette;        // [joint][block]: from grid coordinates
  LargeVector<PosedPoint> positions;  // [slot][block]

  PosedPoint* at(uint32_t slot) { return positions.data() + size_t{slot} * blocks; }
  const PosedPoint* at(uint32_t slot) const { return positions.data() + size_t{slot} * blocks; }
};

/// Poses every vertex of the mesh. @param palettes one matrix per joint and pose, from bind space.
PosedMesh poseMesh(const Mesh& mesh, const std::vector<std::vector<glm::dmat4>>& palettes);

/// The blended matrices of a skin, one per block: in `storage`, or in the palette itself for a single joint.
const Affine* blendSkin(const PosedMesh& posed, const QuantizedSkin& skin, Affine* storage);

LITHE_INLINE PosedPoint transformed(const Affine& blend, float x, float y, float z) {
  const auto& m = blend.m;
  return {m[0][0] * x + m[0][1] * y + m[0][2] * z + m[0][3], m[1][0] * x + m[1][1] * y + m[1][2] * z + m[1][3],
          m[2][0] * x + m[2][1] * y + m[2][2] * z + m[2][3]};
}

/// Where matrices put a grid point, one per block.
void transformPoint(const Affine* blend, uint32_t blocks, const glm::vec3& grid_point, PosedPoint* result);

}  // namespace lithe::bake
