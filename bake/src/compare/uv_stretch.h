// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// How much a texture is stretched or squeezed on a simplified surface beyond what it is on the original. The singular
/// values of the map from texture to surface say how much a texture is stretched (Sander, Snyder, Gortler and Hoppe,
/// "Texture mapping progressive meshes", 2001); here they are those of the map from one surface to the other through
/// the texture.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>

namespace lithe::bake {

/// The largest stretch that is told apart from a texture that is torn or mirrored.
inline constexpr double kMostUvStretch = 16.0;

/// A triangle of a posed surface with its uvs, corner by corner.
struct TexturedTriangle {
  std::array<glm::dvec3, 3> positions;
  std::array<glm::dvec2, 3> uvs;  ///< as read from floats
};

/// With Gamma >= gamma the singular values of J_simplified * J_original^-1, J = d position / d uv of a triangle: the
/// larger of Gamma and 1 / gamma (Sorkine, Cohen-Or, Goldenthal and Lischinski, "Bounded-distortion piecewise mesh
/// parameterization", 2002), 1 for a texture that lies as on the original, at most kMostUvStretch. The triangles need
/// not be of one size or place.
///
/// kMostUvStretch too where the texture is mirrored, that is where its uvs turn the other way round than on the
/// original, seen from each triangle's own front; and where the simplified triangle has no area or its uvs have none.
/// Nothing where this is so of the original's: then it has no texture that could be stretched. A triangle has no area
/// where its height is no more than what the rounding to floats makes of none.
std::optional<double> uvStretch(const TexturedTriangle& original, const TexturedTriangle& simplified);

}  // namespace lithe::bake
