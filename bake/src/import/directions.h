// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Normals and tangents where the file has none.
#pragma once

#include "draft.h"

namespace lithe::bake {

/// Makes every normal and tangent a unit vector. Vectors without a direction are replaced: normals by the area-weighted
/// mean over the triangles around the position (of all parts that one node shows, as those share a surface), tangents
/// by some direction at right angles to the normal. Adds warnings.
void completeDirections(Draft& draft);

}  // namespace lithe::bake
