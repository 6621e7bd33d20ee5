// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Columns of numbers as different from each other as the coder can meet: constants, rare events, bell and exponential
/// shapes of every width, few large values, ramps, noise, records of very different size.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "random.h"

namespace lithe::test {

enum class Shape {
  kConstant,
  kRare,
  kExponential,
  kBell,
  kUniform,
  kFewLarge,
  kRamp,
  kMixedSize,
  kExtremes,
  kShapeCount
};

inline int32_t exponential(Random& random, double mean) {
  const double magnitude = -mean * std::log(1.0 - random.unit());
  const int32_t value = static_cast<int32_t>(std::min(magnitude, 260000.0));
  return random.chance(50) ? value : -value;
}

inline int32_t bell(Random& random, int32_t width) {
  int32_t sum = 0;
  for (int k = 0; k < 4; ++k) sum += random.between(-width, width);
  return sum / 2;
}

/// Signed values in [-2^18, 2^18); components of a record are alike.
inline std::vector<int32_t> randomColumn(Random& random, Shape shape, uint32_t records, uint32_t components) {
  constexpr int32_t kLeast = -(1 << 18), kMost = (1 << 18) - 1;
  std::vector<int32_t> values(size_t{records} * components);
  const int32_t width = static_cast<int32_t>(random.octave(kMost / 2)), start = random.between(-width, width);
  const uint32_t percent = random.below(30);
  const int32_t few[4] = {exponential(random, 50000), exponential(random, 9000), 0, start};
  int32_t size = 1;
  for (size_t i = 0; i < values.size(); ++i) {
    if (i % components == 0) size = static_cast<int32_t>(random.octave(static_cast<uint32_t>(width)));
    int32_t value = start;
    switch (shape) {
      case Shape::kRare:
        value = random.chance(percent) ? 1 : 0;
        break;
      case Shape::kExponential:
        value = exponential(random, width / 8.0);
        break;
      case Shape::kBell:
        value = bell(random, width);
        break;
      case Shape::kUniform:
        value = random.between(-width, width);
        break;
      case Shape::kFewLarge:
        value = few[random.below(4)];
        break;
      case Shape::kRamp:
        value = start + static_cast<int32_t>(i / components) * 7 + random.between(0, 3);
        break;
      case Shape::kMixedSize:
        value = random.between(-size, size);
        break;
      case Shape::kExtremes:
        value = random.chance(50) ? kLeast : kMost;
        break;
      default:
        break;
    }
    values[i] = std::clamp(value, kLeast, kMost);
  }
  return values;
}

}  // namespace lithe::test
