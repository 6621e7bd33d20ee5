// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Places rectangles side by side in the unit square, all at one scale.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace lithe::bake {

struct Packing {
  double scale = 1.0;
  std::vector<glm::dvec2> corner;  ///< per rectangle, its low corner in the unit square
};

/// Rows of rectangles, tallest first, at the largest scale (within 2 %) at which they fit with `margin` around each.
Packing packCharts(const std::vector<glm::dvec2>& sizes, double margin);

}  // namespace lithe::bake
