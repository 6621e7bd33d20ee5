// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The step to where a quadratic energy is least.
#pragma once

#include <glm/glm.hpp>

#include "kernels.h"

namespace lithe::bake {

/// (H + stay trace I)^-1 (-g), by cofactors in doubles; `stay` holds the point where the quadric says nothing.
inline glm::dvec3 solveNormalEquations(const NormalEquations& n, double stay_share) {
  const double stay = stay_share * (double{n.xx} + n.yy + n.zz);
  if (!(stay > 0.0)) return glm::dvec3(0.0);
  const double xx = n.xx + stay, yy = n.yy + stay, zz = n.zz + stay, xy = n.xy, xz = n.xz, yz = n.yz;
  const double cxx = yy * zz - yz * yz, cxy = xz * yz - xy * zz, cxz = xy * yz - xz * yy;
  const double cyy = xx * zz - xz * xz, cyz = xy * xz - xx * yz, czz = xx * yy - xy * xy;
  const double determinant = xx * cxx + xy * cxy + xz * cxz;
  if (!(determinant > 0.0)) return glm::dvec3(0.0);
  const glm::dvec3 g(n.gx, n.gy, n.gz);
  return -glm::dvec3(cxx * g.x + cxy * g.y + cxz * g.z, cxy * g.x + cyy * g.y + cyz * g.z,
                     cxz * g.x + cyz * g.y + czz * g.z) /
         determinant;
}

}  // namespace lithe::bake
