// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "silhouette.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "posed_surface.h"

namespace lithe::bake {

namespace {

constexpr uint32_t kMargin = kSilhouettePixels / 2;  // pixels around the original's box

/// Two unit vectors across the direction of view.
struct View {
  glm::dvec3 right, up;
};

/// One of each two opposite vertices of an icosahedron.
std::array<View, kSilhouetteViews> makeViews() {
  constexpr double kLong = std::numbers::phi;
  const std::array<glm::dvec3, kSilhouetteViews> axes{
      {{0, 1, kLong}, {0, -1, kLong}, {1, kLong, 0}, {-1, kLong, 0}, {kLong, 0, 1}, {-kLong, 0, 1}}};
  std::array<View, kSilhouetteViews> views;
  for (uint32_t i = 0; i < kSilhouetteViews; ++i) {
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), axes[i]));
    views[i] = {right, glm::normalize(glm::cross(axes[i], right))};
  }
  return views;
}

/// A bit per pixel.
class Mask {
 public:
  Mask(uint32_t width, uint32_t height) : row_words_((width + 63) / 64), words_(size_t{row_words_} * height) {}

  /// Covers the pixels [first, end) of a row.
  void cover(uint32_t row, uint32_t first, uint32_t end) {
    uint64_t* words = &words_[size_t{row} * row_words_];
    for (uint32_t begin = first / 64 * 64; begin < end; begin += 64)
      words[begin / 64] |= bitsBelow(std::min(end - begin, 64u)) & ~bitsBelow(first > begin ? first - begin : 0);
  }

  uint64_t covered() const {
    uint64_t count = 0;
    for (const uint64_t word : words_) count += static_cast<uint64_t>(std::popcount(word));
    return count;
  }
  /// Pixels that one of two masks of the same size covers and the other does not.
  static uint64_t differing(const Mask& a, const Mask& b) {
    uint64_t count = 0;
    for (size_t i = 0; i < a.words_.size(); ++i)
      count += static_cast<uint64_t>(std::popcount(a.words_[i] ^ b.words_[i]));
    return count;
  }

 private:
  /// @param count  0..64
  static uint64_t bitsBelow(uint32_t count) { return count < 64 ? (uint64_t{1} << count) - 1 : ~uint64_t{0}; }

  uint32_t row_words_;
  std::vector<uint64_t> words_;
};

/// Where the pixels of a view lie: a position's distances along `right` and `up`, less `origin`, in pixels.
struct Grid {
  glm::dvec3 right, up;
  glm::dvec2 origin;
  uint32_t width, height;
};

glm::dvec2 pixelsOf(const glm::dvec3& position, const Grid& grid) {
  return glm::dvec2(glm::dot(position, grid.right), glm::dot(position, grid.up)) - grid.origin;
}

/// Holds the positions and the margin around them.
Grid gridAround(std::span<const glm::dvec3> positions, const View& view, double pixel) {
  Grid grid{view.right / pixel, view.up / pixel, {}, 0, 0};
  glm::dvec2 low(std::numeric_limits<double>::infinity()), high(-low);
  for (const glm::dvec3& position : positions) {
    low = glm::min(low, pixelsOf(position, grid));
    high = glm::max(high, pixelsOf(position, grid));
  }
  grid.origin = low - glm::dvec2(kMargin);
  grid.width = static_cast<uint32_t>(std::ceil(high.x - low.x)) + 2 * kMargin;
  grid.height = static_cast<uint32_t>(std::ceil(high.y - low.y)) + 2 * kMargin;
  return grid;
}

/// Along an axis of `size` pixels: the first whose centre is behind `from`.
uint32_t firstCentre(double from, uint32_t size) {
  return static_cast<uint32_t>(std::clamp(from, 0.0, static_cast<double>(size)) + 0.5);
}

/// A vertex on the grid, and the first column and row whose centres are behind it.
struct GridPoint {
  glm::dvec2 at;
  uint32_t column, row;
};

std::vector<GridPoint> pointsOn(const Grid& grid, std::span<const glm::dvec3> positions) {
  std::vector<GridPoint> points;
  points.reserve(positions.size());
  for (const glm::dvec3& position : positions) {
    const glm::dvec2 at = pixelsOf(position, grid);
    points.push_back({at, firstCentre(at.x, grid.width), firstCentre(at.y, grid.height)});
  }
  return points;
}

/// Ends are given lower one first, so that both triangles of an edge compute the same bits and leave no crack.
double crossing(const glm::dvec2& low, const glm::dvec2& high, double y) {
  return low.x + (high.x - low.x) * ((y - low.y) / (high.y - low.y));
}

/// Row by row; a centre on an edge belongs to the triangle on one side of it. @param a, b, c  by rising y
void coverRows(const GridPoint& a, const GridPoint& b, const GridPoint& c, uint32_t width, Mask& mask) {
  for (uint32_t row = a.row; row < c.row; ++row) {
    const double y = row + 0.5;
    const double across = crossing(a.at, c.at, y);
    const double around = y <= b.at.y ? crossing(a.at, b.at, y) : crossing(b.at, c.at, y);
    const uint32_t first = firstCentre(std::min(across, around), width);
    const uint32_t end = firstCentre(std::max(across, around), width);
    if (first < end) mask.cover(row, first, end);
  }
}

/// What the triangles cover.
Mask maskOf(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles, const Grid& grid) {
  const std::vector<GridPoint> points = pointsOn(grid, positions);
  Mask mask(grid.width, grid.height);
  for (const Triangle& triangle : triangles) {
    const GridPoint *a = &points[triangle[0]], *b = &points[triangle[1]], *c = &points[triangle[2]];
    // Most triangles of a dense mesh lie between the centres.
    if ((a->row == b->row && a->row == c->row) || (a->column == b->column && a->column == c->column)) continue;
    if (b->at.y < a->at.y) std::swap(a, b);
    if (c->at.y < a->at.y) std::swap(a, c);
    if (c->at.y < b->at.y) std::swap(b, c);
    coverRows(*a, *b, *c, grid.width, mask);
  }
  return mask;
}

}  // namespace

double silhouetteDifference(std::span<const glm::dvec3> original_positions,
                            std::span<const Triangle> original_triangles,
                            std::span<const glm::dvec3> simplified_positions,
                            std::span<const Triangle> simplified_triangles) {
  const double pixel = diagonalOf(original_positions) / kSilhouettePixels;
  if (!(pixel > 0.0)) return 0.0;
  static const std::array<View, kSilhouetteViews> kViews = makeViews();
  uint64_t covered = 0, differing = 0;
  for (const View& view : kViews) {
    const Grid grid = gridAround(original_positions, view, pixel);
    const Mask original_mask = maskOf(original_positions, original_triangles, grid);
    const Mask simplified_mask = maskOf(simplified_positions, simplified_triangles, grid);
    covered += original_mask.covered();
    differing += Mask::differing(original_mask, simplified_mask);
  }
  if (covered == 0) return differing > 0 ? 1.0 : 0.0;
  return static_cast<double>(differing) / static_cast<double>(covered);
}

}  // namespace lithe::bake
