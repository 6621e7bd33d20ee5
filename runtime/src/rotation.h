// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Rotations and matrices of what the head holds: three components of a unit quaternion, and what a rotation leaves of
/// a matrix (the triangular factor of its QR decomposition), which most nodes and joints share.
#pragma once

#include <math.h>
#include <stdint.h>

namespace lithe::runtime {

/// The quaternion x y z w of its other three components, in their order. The one left out is not negative.
inline void wholeRotation(uint32_t left_out, const float* kept, float* rotation) {
  const float square = 1.0f - kept[0] * kept[0] - kept[1] * kept[1] - kept[2] * kept[2];
  for (uint32_t i = 0, from = 0; i < 4; ++i)
    rotation[i] = i == left_out ? sqrtf(square > 0.0f ? square : 0.0f) : kept[from++];
}

/// The three rows of four of R(rotation) * U, and the translation in the last column.
/// @param scale  U's xx, yy, zz, xy, xz, yz
inline void matrixOf(const float* rotation, const float* scale, const float* translation, float* rows) {
  const float x = rotation[0], y = rotation[1], z = rotation[2], w = rotation[3];
  const float r[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                         {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                         {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
  for (uint32_t i = 0; i < 3; ++i) {
    rows[4 * i] = r[i][0] * scale[0];
    rows[4 * i + 1] = r[i][0] * scale[3] + r[i][1] * scale[1];
    rows[4 * i + 2] = r[i][0] * scale[4] + r[i][1] * scale[5] + r[i][2] * scale[2];
    rows[4 * i + 3] = translation[i];
  }
}

}  // namespace lithe::runtime
