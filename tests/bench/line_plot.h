// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// A line plot as an SVG picture that needs no colour: lines differ in dashes and marks too, and end at their names.
#pragma once

#include <string>
#include <vector>

namespace lithe::bench {

struct PlotLine {
  std::string name;
  std::vector<double> values;  ///< one per step of the x axis, above 0
};

struct LinePlot {
  std::string title, x_title, y_title;
  std::vector<PlotLine> lines;  ///< at most as many as there are styles, kPlotStyles
};

inline constexpr size_t kPlotStyles = 6;

/// The y axis is logarithmic. @throws bake::Error for too many lines, none, an empty one, or a value that is not above
/// 0
std::string toSvg(const LinePlot& plot);

}  // namespace lithe::bench
