// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "line_plot.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "lithe/bake/model.h"

namespace lithe::bench {
namespace {

constexpr double kWidth = 850, kHeight = 420;
constexpr double kLeft = 84, kRight = 660, kTop = 40, kBottom = 364;  // of the frame; names stand right of it
constexpr double kNameHeight = 16;
constexpr uint32_t kMarkEvery = 6;  // values

struct Style {
  const char* color;
  const char* dashes;
  const char* mark;  // a path about the origin
};
// Colours of Okabe and Ito, which differ for every kind of eye.
constexpr Style kStyles[kPlotStyles] = {
    {"#000000", "none", "M-4 -4H4V4H-4Z"},      {"#0072b2", "9 4", "M0 -5L5 4H-5Z"},
    {"#d55e00", "3 3", "M-4 -4L4 4M-4 4L4 -4"}, {"#009e73", "12 3 3 3", "M0 -5L5 0L0 5L-5 0Z"},
    {"#7a3e9d", "1 4", "M0 -5V5M-5 0H5"},       {"#8c6d00", "6 2 2 2 2 2", "M0 5L5 -4H-5Z"},
};

[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...) {
  char text[512];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return text;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
  return result;
}

/// 1, 2 and 5 times powers of ten: from the last one at or below `least` to the first one above `greatest`.
std::vector<double> ticksAround(double least, double greatest) {
  std::vector<double> result{0.0};
  for (int decade = static_cast<int>(std::floor(std::log10(least))) - 1; result.back() <= greatest; ++decade) {
    for (const int digit : {1, 2, 5}) {
      const double tick = digit * std::pow(10.0, decade);
      if (tick <= least) result.clear();
      if (result.empty() || result.back() <= greatest) result.push_back(tick);
    }
  }
  return result;
}

/// Values to places: steps along x, decades along y.
class Frame {
 public:
  explicit Frame(const LinePlot& plot) {
    double least = plot.lines[0].values[0], greatest = least;
    for (const PlotLine& line : plot.lines) {
      steps_ = std::max(steps_, line.values.size());
      for (const double value : line.values) {
        least = std::min(least, value);
        greatest = std::max(greatest, value);
      }
    }
    ticks_ = ticksAround(least, greatest);
    low_ = std::log10(ticks_.front());
    high_ = std::log10(ticks_.back());
  }

  double x(double step) const { return kLeft + (kRight - kLeft) * step / std::max<double>(1.0, double(steps_) - 1.0); }
  double y(double value) const { return kBottom - (kBottom - kTop) * (std::log10(value) - low_) / (high_ - low_); }
  size_t steps() const { return steps_; }
  const std::vector<double>& yTicks() const { return ticks_; }

 private:
  size_t steps_ = 0;
  std::vector<double> ticks_;
  double low_ = 0.0, high_ = 0.0;
};

std::string text(double x, double y, const char* anchor, const std::string& words, const char* more = "") {
  return formatted("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" %s>", x, y, anchor, more) + escaped(words) +
         "</text>\n";
}

std::string grid(const Frame& frame) {
  std::string svg;
  for (const double tick : frame.yTicks()) {
    svg += formatted("<path d=\"M%.0f %.1fH%.0f\" stroke=\"#cccccc\"/>\n", kLeft, frame.y(tick), kRight);
    svg += text(kLeft - 8, frame.y(tick) + 4, "end", formatted("%g", tick));
  }
  for (size_t step = 0; step < frame.steps(); step += 10) {
    const double x = frame.x(static_cast<double>(step));
    svg += formatted("<path d=\"M%.1f %.0fv5\" stroke=\"#000000\"/>\n", x, kBottom);
    svg += text(x, kBottom + 19, "middle", std::to_string(step));
  }
  return svg + formatted("<path d=\"M%.0f %.0fV%.0fH%.0f\" fill=\"none\" stroke=\"#000000\"/>\n", kLeft, kTop, kBottom,
                         kRight);
}

std::string titles(const LinePlot& plot) {
  const double middle = (kLeft + kRight) / 2, height = (kTop + kBottom) / 2;
  return text(middle, kTop - 16, "middle", plot.title, "font-weight=\"bold\"") +
         text(middle, kBottom + 42, "middle", plot.x_title) +
         text(0, 0, "middle", plot.y_title, formatted("transform=\"translate(20 %.1f) rotate(-90)\"", height).c_str());
}

std::string curve(const PlotLine& line, const Style& style, const Frame& frame, size_t first_mark) {
  std::string points, marks;
  for (size_t i = 0; i < line.values.size(); ++i) {
    const double x = frame.x(static_cast<double>(i)), y = frame.y(line.values[i]);
    points += formatted("%s%.1f %.1f", i == 0 ? "M" : "L", x, y);
    if (i % kMarkEvery != first_mark) continue;
    marks += formatted("<path d=\"%s\" transform=\"translate(%.1f %.1f)\"/>\n", style.mark, x, y);
  }
  return formatted("<g stroke=\"%s\" stroke-width=\"1.6\" fill=\"none\">\n<path stroke-dasharray=\"%s\" d=\"",
                   style.color, style.dashes) +
         points + "\"/>\n" + marks + "</g>\n";
}

/// Where the names stand: beside the ends of their lines, but apart from each other.
std::vector<double> namePlaces(const LinePlot& plot, const Frame& frame) {
  std::vector<size_t> from_above(plot.lines.size());
  for (size_t i = 0; i < from_above.size(); ++i) from_above[i] = i;
  std::vector<double> places;
  for (const PlotLine& line : plot.lines) places.push_back(frame.y(line.values.back()));
  std::stable_sort(from_above.begin(), from_above.end(), [&](size_t a, size_t b) { return places[a] < places[b]; });
  for (size_t i = 1; i < from_above.size(); ++i) {
    places[from_above[i]] = std::max(places[from_above[i]], places[from_above[i - 1]] + kNameHeight);
  }
  double lowest = kBottom;
  for (size_t i = from_above.size(); i-- > 0; lowest = places[from_above[i]] - kNameHeight) {
    places[from_above[i]] = std::min(places[from_above[i]], lowest);
  }
  return places;
}

std::string names(const LinePlot& plot, const Frame& frame) {
  const std::vector<double> places = namePlaces(plot, frame);
  std::string svg;
  for (size_t i = 0; i < plot.lines.size(); ++i) {
    const Style& style = kStyles[i];
    const double end = frame.y(plot.lines[i].values.back());
    svg += formatted("<g stroke=\"%s\" fill=\"none\"><path d=\"M%.0f %.1fL%.0f %.1f\" stroke-dasharray=\"1 2\"/>",
                     style.color, kRight + 2, end, kRight + 14, places[i]);
    svg += formatted("<path d=\"%s\" transform=\"translate(%.0f %.1f)\"/></g>\n", style.mark, kRight + 21, places[i]);
    svg += text(kRight + 31, places[i] + 4, "start", plot.lines[i].name);
  }
  return svg;
}

void check(const LinePlot& plot) {
  if (plot.lines.empty() || plot.lines.size() > kPlotStyles) {
    throw bake::Error("a plot has 1 to " + std::to_string(kPlotStyles) + " lines");
  }
  for (const PlotLine& line : plot.lines) {
    if (line.values.empty() || *std::min_element(line.values.begin(), line.values.end()) <= 0.0) {
      throw bake::Error("the line \"" + line.name + "\" has no values, or one that a logarithmic axis cannot show");
    }
  }
}

}  // namespace

std::string toSvg(const LinePlot& plot) {
  check(plot);
  const Frame frame(plot);
  std::string svg = formatted(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" font-family=\"sans-serif\" "
      "font-size=\"13\">\n<rect width=\"100%%\" height=\"100%%\" fill=\"#ffffff\"/>\n",
      kWidth, kHeight);
  svg += grid(frame) + titles(plot);
  for (size_t i = 0; i < plot.lines.size(); ++i) svg += curve(plot.lines[i], kStyles[i], frame, i % kMarkEvery);
  return svg + names(plot, frame) + "</svg>\n";
}

}  // namespace lithe::bench
