// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Line charts as inline SVG.
#pragma once

#include <string>
#include <utility>
#include <vector>

struct Series {
  std::string name, color;
  std::vector<std::pair<double, double>> points;
};

struct Axis {
  std::string title;
  bool logarithmic = false;  ///< points at or below zero are left out
  std::string unit;          ///< after each number
};

std::string lineChart(const Axis& x, const Axis& y, const std::vector<Series>& series);
