// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// How far the silhouette of a simplified surface is from the original's: the error that shows against any background.
/// Looking from all around and comparing what is seen is Lindstrom and Turk's measure ("Image-driven simplification",
/// 2000); here a picture is a mask, so that no material, light or texture has a say.
#pragma once

#include <span>

#include "lithe/bake/nearest.h"

namespace lithe::bake {

/// Views: towards the centre from the vertices of an icosahedron, the most even spread of six axes; opposite vertices
/// see the same silhouette mirrored. No axis of the model is among them.
inline constexpr uint32_t kSilhouetteViews = 6;
/// Resolution: pixels along the diagonal of the original's bounding box. A pixel is covered where its centre is.
inline constexpr uint32_t kSilhouettePixels = 512;

/// The area that one of the two surfaces covers and the other does not, over the area that the original covers; both
/// summed over the views, so that a view counts by what it shows. Zero or more; zero also where neither covers a pixel,
/// one where only the simplified surface does. What lies more than half the diagonal outside the original's box
/// in a view is not seen. The positions are those of one frame; all of `original_positions` belong to its box.
double silhouetteDifference(std::span<const glm::dvec3> original_positions,
                            std::span<const Triangle> original_triangles,
                            std::span<const glm::dvec3> simplified_positions,
                            std::span<const Triangle> simplified_triangles);

}  // namespace lithe::bake
