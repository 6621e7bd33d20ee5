// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "residuals.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace lithe::bake {
namespace {

std::array<int32_t, 3> predicted(const PositionResidual& r, int32_t laplacian) {
  std::array<int32_t, 3> residual;
  for (int i = 0; i < 3; ++i)
    residual[i] = r.difference[i] - format::predictDifference(r.sum_a[i], r.count_a, r.sum_b[i], r.count_b, laplacian);
  return residual;
}

/// Bytes a table entry costs are charged as bits: what makes many rare symbols dear.
constexpr double kTableBits = 9.0;

}  // namespace

/// Values of one kind with the extent that decides their low bits.
struct Residuals::Series {
  std::vector<int32_t> values;
  std::vector<uint32_t> extents;  ///< one per value

  int32_t lowBitsOf(size_t i, uint32_t bias, bool adaptive) const {
    return adaptive ? format::lowBits(extents[i], bias) : static_cast<int32_t>(bias);
  }

  /// Bits for the values when `bias` is taken off the extent's bit length (adaptive) or is the number of low bits
  /// (fixed).
  double cost(uint32_t bias, bool adaptive) const {
    if (values.empty()) return 0.0;
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    std::vector<uint32_t> histogram(static_cast<size_t>(*greatest - *least) + 1, 0);
    double bits = 0.0;
    for (size_t i = 0; i < values.size(); ++i) {
      const int32_t low = lowBitsOf(i, bias, adaptive);
      // A shift towards minus infinity keeps within [least, greatest] or reaches -1 or 0.
      ++histogram[static_cast<size_t>(std::clamp(values[i] >> low, *least, *greatest) - *least)];
      bits += low;
    }
    for (uint32_t count : histogram)
      if (count)
        bits += kTableBits - count * std::log2(static_cast<double>(count) / static_cast<double>(values.size()));
    return bits;
  }

  /// A quick stand-in for the cost, to compare predictions: the sum of the values' magnitudes in bits.
  double magnitude() const {
    double bits = 0.0;
    for (int32_t value : values) bits += std::log2(1.0 + std::abs(value));
    return bits;
  }

  uint8_t best(bool adaptive) const {
    uint8_t choice = 0;
    double least = 1e300;
    for (uint8_t bias = 0; bias <= format::kLowBitsMax; ++bias) {
      const double bits = cost(bias, adaptive);
      if (bits < least) least = bits, choice = bias;
    }
    return choice;
  }
};

void Residuals::addPosition(const PositionResidual& residual) {
  items_.push_back({Kind::kPosition, 0, static_cast<uint32_t>(positions_.size()), 0, 0, residual.extent});
  positions_.push_back(residual);
}

void Residuals::add(Kind kind, uint32_t set, int32_t x, int32_t y, uint32_t extent) {
  items_.push_back({kind, static_cast<uint8_t>(set), 0, x, y, extent});
}

Residuals::Series Residuals::seriesOf(Kind kind, uint32_t set, int32_t laplacian) const {
  Series series;
  for (const Item& item : items_) {
    if (item.kind != kind || item.set != set) continue;
    if (kind == Kind::kPosition) {
      for (int32_t value : predicted(positions_[item.index], laplacian)) series.values.push_back(value);
    } else {
      series.values.push_back(item.x);
      series.values.push_back(item.y);
    }
    series.extents.resize(series.values.size(), item.extent);
  }
  return series;
}

void Residuals::finish(PageData& page) const {
  auto& parameters = page.parameters;
  double least = 1e300;
  for (uint8_t laplacian = 0; laplacian <= 20; laplacian += 2) {
    const double bits = seriesOf(Kind::kPosition, 0, laplacian).magnitude();
    if (bits < least) least = bits, parameters[format::kLaplacian] = laplacian;
  }
  parameters[format::kPositionBias] = seriesOf(Kind::kPosition, 0, parameters[format::kLaplacian]).best(true);
  parameters[format::kNormalShift] = seriesOf(Kind::kNormal, 0, 0).best(false);
  parameters[format::kTangentShift] = seriesOf(Kind::kTangent, 0, 0).best(false);
  for (uint32_t set = 0; set < 8; ++set) parameters[format::kUvBias0 + set] = seriesOf(Kind::kUv, set, 0).best(true);

  BitWriter low_bits;
  auto put = [&low_bits](std::vector<int32_t>& values, int32_t value, int32_t low) {
    values.push_back(value >> low);
    low_bits.write(static_cast<uint32_t>(value), low);
  };
  for (const Item& item : items_) {
    switch (item.kind) {
      case Kind::kPosition: {
        const int32_t low = format::lowBits(item.extent, parameters[format::kPositionBias]);
        auto& values = page.streams[format::kSplits].attributes[4].values;
        for (int32_t value : predicted(positions_[item.index], parameters[format::kLaplacian])) put(values, value, low);
        break;
      }
      case Kind::kNormal:
      case Kind::kTangent: {
        const bool normal = item.kind == Kind::kNormal;
        const int32_t low = parameters[normal ? format::kNormalShift : format::kTangentShift];
        auto& values = page.streams[normal ? format::kNormals : format::kTangents].attributes[0].values;
        put(values, item.x, low);
        put(values, item.y, low);
        break;
      }
      case Kind::kUv: {
        const int32_t low = format::lowBits(item.extent, parameters[format::kUvBias0 + item.set]);
        auto& values = page.streams[format::kUv0 + item.set].attributes[0].values;
        put(values, item.x, low);
        put(values, item.y, low);
        break;
      }
    }
  }
  page.low_bits = low_bits.bytes();
}

}  // namespace lithe::bake
