// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Matrices as translation, rotation and scale, and what a matrix does to sizes.
#pragma once

#include "lithe/bake/model.h"

namespace lithe::bake {

/// The transform whose matrix is `matrix` but for shear; a mirrored matrix gets a negative scale in x.
/// @param sheared  set if the columns are not at right angles (beyond what floats make of right angles)
Transform decompose(const glm::dmat4& matrix, bool& sheared);

/// How much the linear part scales lengths, on average over directions: the cube root of |determinant|.
double lengthScale(const glm::dmat4& matrix);

/// Whether the linear part turns a right hand into a left one.
bool mirrors(const glm::dmat4& matrix);

/// Whether the linear part can be inverted without blowing up: no direction is flattened to less than a millionth of
/// another.
bool invertible(const glm::dmat4& matrix);

}  // namespace lithe::bake
