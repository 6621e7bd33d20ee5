// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Views and instances for tests of selection.
#pragma once

#include "lithe/runtime.h"

namespace lithe::test {

/// At the origin; an error of 1 at distance 1 is 500 pixels.
inline lithe_view perspective(float threshold_px) {
  lithe_view view = {};
  view.pixels_per_radian = 500;
  view.near_distance = 0.1f;
  view.threshold_px = threshold_px;
  return view;
}

inline lithe_instance instanceAt(float distance, uint32_t level = LITHE_UNDRAWN) {
  lithe_instance instance = {};
  instance.center[2] = distance;
  instance.scale = 1;
  instance.bias = 1;
  instance.level = static_cast<uint8_t>(level);
  return instance;
}

}  // namespace lithe::test
