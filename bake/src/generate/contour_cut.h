// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Cutting a mesh along a curve on it, so that no triangle lies on both sides.
#pragma once

#include "isosurface.h"

namespace lithe::bake {

/// Cuts along the zero set of a function that is linear on triangles. Vertices close to the curve are moved onto it,
/// edges that still cross it are split; a closed mesh stays closed. Positions and normals of what is moved or new are
/// interpolated, so those of a curved surface want correcting.
/// @param value  the function, one number per vertex; grows with the mesh, and is exactly 0 on the curve
/// @return the vertices that were moved or are new, ascending
std::vector<uint32_t> cutAlong(ClosedMesh& mesh, std::vector<double>& value);

}  // namespace lithe::bake
