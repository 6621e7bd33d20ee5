// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The arithmetic of vertex formats: one number or one vertex at a time, exact and the same on every machine.
#pragma once

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "lithe/format/octahedral.h"

namespace lithe::runtime {

inline uint32_t bitsOf(float value) {
  uint32_t bits;
  memcpy(&bits, &value, sizeof bits);
  return bits;
}

/// IEEE binary16, rounded to nearest, ties to even. Beyond 65504 + half a step: infinity. No number stays none.
inline uint16_t toHalf(float value) {
  const uint32_t sign = bitsOf(value) >> 16 & 0x8000u, magnitude = bitsOf(value) & 0x7fffffffu;
  if (magnitude > 0x7f800000u) return static_cast<uint16_t>(sign | 0x7e00u);
  if (magnitude >= 0x477ff000u) return static_cast<uint16_t>(sign | 0x7c00u);
  if (magnitude < 0x38800000u) {
    // Below 2^-14 a half counts steps of 2^-24, as a float in [0.5, 1) does: the addition rounds to them.
    float positive;
    memcpy(&positive, &magnitude, sizeof positive);
    return static_cast<uint16_t>(sign | (bitsOf(positive + 0.5f) - bitsOf(0.5f)));
  }
  const uint32_t rounded = magnitude + 0xfffu + (magnitude >> 13 & 1u);
  return static_cast<uint16_t>(sign | ((rounded - 0x38000000u) >> 13));
}

/// To the nearest integer, halves away from zero. |value| < 2^22.
inline int32_t roundToInt(float value) { return static_cast<int32_t>(value + (value < 0 ? -0.5f : 0.5f)); }

/// uv in units of 1/65535; out of range when the uv is not within 0..1 (by more than the rounding).
inline int32_t toUnorm16(float uv) { return uv > -1 && uv < 2 ? roundToInt(uv * 65535.0f) : -1; }

/// A component of an octahedral point as snorm16: (grid - center) / center, rounded to nearest.
inline int16_t octahedralSnorm16(int32_t grid, int32_t center) {
  const int32_t d = grid - center, size = d < 0 ? -d : d;
  const int32_t scaled = (size * 65534 + center) / (2 * center);
  return static_cast<int16_t>(d < 0 ? -scaled : scaled);
}

/// A tangent's second component: |y| = (b + 1) / 2 for b = (grid - center) / center, at least one step; y is negative
/// where the handedness is.
inline int16_t handedSnorm16(int32_t grid, int32_t center, bool positive) {
  const uint32_t size = 2 * static_cast<uint32_t>(center);
  uint32_t scaled = (static_cast<uint32_t>(grid) * 65534 + size) / (2 * size);
  if (scaled == 0) scaled = 1;
  return static_cast<int16_t>(positive ? static_cast<int32_t>(scaled) : -static_cast<int32_t>(scaled));
}

/// The unit vector of an octahedral point.
inline void octahedralUnit(int32_t x, int32_t y, int32_t center, float unit[3]) {
  int32_t d[3];
  format::octahedralDirection({x, y}, center, d);
  const float length = sqrtf(static_cast<float>(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]));
  for (int c = 0; c < 3; ++c) unit[c] = static_cast<float>(d[c]) / length;
}

/// Weights that sum to one, scaled so that they sum to target: rounded down, then the largest remainders up, ties by
/// index. Exact for every one and target up to 65535.
inline void rescaleWeights(const uint16_t* weights, uint32_t count, uint32_t one, uint32_t target, uint16_t* out) {
  uint32_t remainder[8], left = target;
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t scaled = weights[i] * target;
    out[i] = static_cast<uint16_t>(scaled / one);
    remainder[i] = scaled % one;
    left -= out[i];
  }
  for (; left > 0; --left) {
    uint32_t largest = 0;
    for (uint32_t i = 1; i < count; ++i)
      if (remainder[i] > remainder[largest]) largest = i;
    ++out[largest];
    remainder[largest] = 0;
  }
}

}  // namespace lithe::runtime
