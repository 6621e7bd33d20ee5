// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "chart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "html.h"

namespace {

constexpr double kWidth = 560, kHeight = 300, kLeft = 62, kRight = 14, kTop = 26, kBottom = 44;

/// A range of values on one axis and where they lie between 0 and 1.
struct Scale {
  bool logarithmic = false;
  double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();

  bool takes(double value) const { return !logarithmic || value > 0; }
  double position(double value) const { return logarithmic ? std::log10(value) : value; }
  void include(double value) {
    if (!takes(value)) return;
    low = std::min(low, position(value));
    high = std::max(high, position(value));
  }
  double at(double value) const { return (position(value) - low) / (high - low); }
};

/// Whole decades, or zero to the next round step.
void roundOut(Scale& scale) {
  if (scale.low > scale.high) scale.low = 0, scale.high = 1;
  if (scale.logarithmic) {
    scale.low = std::floor(scale.low + 1e-9);
    scale.high = std::max(std::ceil(scale.high - 1e-9), scale.low + 1);
  } else {
    scale.low = 0;
    scale.high = std::max(scale.high, 1e-9);
  }
}

double roundStep(double range) {
  const double rough = range / 5, decade = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * decade >= rough) return factor * decade;
  }
  return 10 * decade;
}

std::vector<double> ticksOf(const Scale& scale) {
  std::vector<double> ticks;
  if (scale.logarithmic) {
    for (double decade = scale.low; decade <= scale.high + 1e-9; ++decade) ticks.push_back(std::pow(10.0, decade));
  } else {
    const double step = roundStep(scale.high);
    for (double value = 0; value <= scale.high * 1.0001; value += step) ticks.push_back(value);
  }
  return ticks;
}

std::string tickText(double value, const std::string& unit) {
  if (value >= 1e6) return number("%g", value / 1e6) + "M" + unit;
  if (value >= 1e3) return number("%g", value / 1e3) + "k" + unit;
  return number("%g", value) + unit;
}

double xOf(double at) { return kLeft + at * (kWidth - kLeft - kRight); }
double yOf(double at) { return kHeight - kBottom - at * (kHeight - kTop - kBottom); }

std::string textAt(double x, double y, const char* anchor, const std::string& text, const std::string& style = "") {
  return "<text x=\"" + number("%.1f", x) + "\" y=\"" + number("%.1f", y) + "\" text-anchor=\"" + anchor + "\"" +
         style + ">" + escaped(text) + "</text>\n";
}

std::string lineAt(double x1, double y1, double x2, double y2) {
  return "<line x1=\"" + number("%.1f", x1) + "\" y1=\"" + number("%.1f", y1) + "\" x2=\"" + number("%.1f", x2) +
         "\" y2=\"" + number("%.1f", y2) + "\" stroke=\"#e3e6ea\"/>\n";
}

std::string grid(const Scale& x, const Scale& y, const Axis& x_axis, const Axis& y_axis) {
  std::string svg;
  for (const double tick : ticksOf(x)) {
    svg += lineAt(xOf(x.at(tick)), yOf(0), xOf(x.at(tick)), yOf(1));
    svg += textAt(xOf(x.at(tick)), yOf(0) + 16, "middle", tickText(tick, x_axis.unit));
  }
  for (const double tick : ticksOf(y)) {
    svg += lineAt(xOf(0), yOf(y.at(tick)), xOf(1), yOf(y.at(tick)));
    svg += textAt(xOf(0) - 6, yOf(y.at(tick)) + 4, "end", tickText(tick, y_axis.unit));
  }
  svg += textAt(xOf(1), kHeight - 8, "end", x_axis.title);
  return svg + textAt(4, 14, "start", y_axis.title);
}

std::string curve(const Series& series, const Scale& x, const Scale& y) {
  std::string points;
  for (const auto& [px, py] : series.points) {
    if (x.takes(px) && y.takes(py)) points += number("%.1f,", xOf(x.at(px))) + number("%.1f ", yOf(y.at(py)));
  }
  return "<polyline fill=\"none\" stroke-width=\"2\" stroke=\"" + series.color + "\" points=\"" + points + "\"/>\n";
}

std::string legend(const std::vector<Series>& series) {
  std::string svg;
  double x = kWidth - kRight;
  for (auto entry = series.rbegin(); entry != series.rend(); ++entry) {
    svg += textAt(x, 14, "end", entry->name, " style=\"fill:" + entry->color + "\"");
    x -= 7.0 * static_cast<double>(entry->name.size()) + 14;
  }
  return svg;
}

}  // namespace

std::string lineChart(const Axis& x_axis, const Axis& y_axis, const std::vector<Series>& series) {
  Scale x{x_axis.logarithmic}, y{y_axis.logarithmic};
  for (const Series& one : series) {
    for (const auto& [px, py] : one.points) {
      x.include(px);
      y.include(py);
    }
  }
  roundOut(x);
  roundOut(y);
  std::string svg = "<svg viewBox=\"0 0 " + number("%g ", kWidth) + number("%g", kHeight) + "\" role=\"img\">\n";
  svg += grid(x, y, x_axis, y_axis);
  for (const Series& one : series) svg += curve(one, x, y);
  return svg + legend(series) + "</svg>\n";
}
