// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "chart_packing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lithe::bake {
namespace {

/// Fills packing.corner; false if the rows do not fit.
bool placeRows(const std::vector<glm::dvec2>& sizes, const std::vector<size_t>& order, double margin,
               Packing& packing) {
  glm::dvec2 pen(0.0);
  double row_height = 0.0;
  for (size_t i : order) {
    const glm::dvec2 size = sizes[i] * packing.scale + 2.0 * margin;
    if (pen.x + size.x > 1.0) {
      pen = {0.0, pen.y + row_height};
      row_height = 0.0;
    }
    if (size.x > 1.0 || pen.y + size.y > 1.0) return false;
    packing.corner[i] = pen + margin;
    pen.x += size.x;
    row_height = std::max(row_height, size.y);
  }
  return true;
}

}  // namespace

Packing packCharts(const std::vector<glm::dvec2>& sizes, double margin) {
  std::vector<size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return sizes[a].y > sizes[b].y; });
  double area = 0.0;
  for (const glm::dvec2& size : sizes) area += size.x * size.y;
  Packing packing{1.0 / std::sqrt(area), std::vector<glm::dvec2>(sizes.size())};
  while (!placeRows(sizes, order, margin, packing)) packing.scale *= 0.98;
  return packing;
}

}  // namespace lithe::bake
