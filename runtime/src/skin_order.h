// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Small rules that both kinds of pages share: the order of influences and the range of attributes.
#pragma once

#include "page.h"

namespace lithe::runtime {

/// Descending weight, ties by ascending joint, no joint twice.
inline bool skinIsOrdered(const NodeSkin& skin) {
  for (uint32_t i = 1; i < skin.count; ++i) {
    if (skin.weight[i - 1] < skin.weight[i]) return false;
    if (skin.weight[i - 1] == skin.weight[i] && skin.joint[i - 1] >= skin.joint[i]) return false;
    for (uint32_t j = 0; j < i; ++j)
      if (skin.joint[j] == skin.joint[i]) return false;
  }
  return true;
}

/// The greatest value of every entry of a wedge's record.
inline void attributeLimits(const PageFormat& format, int64_t* greatest) {
  uint32_t at = 0;
  auto fill = [&](uint32_t count, int64_t value) {
    for (uint32_t i = 0; i < count; ++i) greatest[at++] = value;
  };
  const int64_t direction = 2 * static_cast<int64_t>(format.normal_center);
  if (format.has.normals) fill(2, direction);
  if (format.has.tangents) {
    fill(2, direction);
    fill(1, 1);
  }
  fill(2 * format.has.uv_sets, (int64_t{1} << format.uv_bits) - 1);
  fill(4 * format.has.color_sets, 255);
}

inline constexpr uint32_t kMaxStride = 2 + 3 + 2 * 8 + 4 * 2;

}  // namespace lithe::runtime
