// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "residuals.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace lithe::bake {
namespace {

std::array<int32_t, 3> predicted(const Residual& r, int32_t laplacian) {
  std::array<int32_t, 3> residual = r.difference;
  for (uint32_t i = 0; i < r.components; ++i)
    residual[i] -= format::predictDifference(r.sum_a[i], r.count_a, r.sum_b[i], r.count_b, laplacian);
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

Residuals::Series Residuals::seriesOf(Residual::Kind kind, uint32_t set, int32_t laplacian) const {
  Series series;
  for (const Residual& item : items_) {
    if (item.kind != kind || item.set != set) continue;
    const auto values = predicted(item, laplacian);
    series.values.insert(series.values.end(), values.begin(), values.begin() + item.components);
    series.extents.resize(series.values.size(), item.extent);
  }
  return series;
}

uint8_t Residuals::bestLaplacian(Residual::Kind kind, uint32_t set) const {
  uint8_t choice = 0;
  double least = 1e300;
  for (uint8_t laplacian = 0; laplacian <= 20; laplacian += 2) {
    const double bits = seriesOf(kind, set, laplacian).magnitude();
    if (bits < least) least = bits, choice = laplacian;
  }
  return choice;
}

void Residuals::finish(PageData& page) const {
  using Kind = Residual::Kind;
  auto& parameters = page.parameters;
  parameters[format::kLaplacian] = bestLaplacian(Kind::kPosition, 0);
  parameters[format::kPositionBias] = seriesOf(Kind::kPosition, 0, parameters[format::kLaplacian]).best(true);
  parameters[format::kNormalLaplacian] = bestLaplacian(Kind::kNormal, 0);
  parameters[format::kNormalShift] = seriesOf(Kind::kNormal, 0, parameters[format::kNormalLaplacian]).best(false);
  parameters[format::kTangentShift] = seriesOf(Kind::kTangent, 0, 0).best(false);
  for (uint32_t set = 0; set < 8; ++set) {
    parameters[format::kUvLaplacian0 + set] = bestLaplacian(Kind::kUv, set);
    parameters[format::kUvBias0 + set] = seriesOf(Kind::kUv, set, parameters[format::kUvLaplacian0 + set]).best(true);
  }

  BitWriter low_bits;
  auto put = [&](const Residual& item, StreamData::Attribute& attribute, int32_t laplacian, int32_t low) {
    const auto values = predicted(item, laplacian);
    for (uint32_t i = 0; i < item.components; ++i) {
      attribute.values.push_back(values[i] >> low);
      low_bits.write(static_cast<uint32_t>(values[i]), low);
    }
  };
  for (const Residual& item : items_) {
    switch (item.kind) {
      case Kind::kPosition:
        put(item, page.streams[format::kSplits].attributes[4], parameters[format::kLaplacian],
            format::lowBits(item.extent, parameters[format::kPositionBias]));
        break;
      case Kind::kNormal:
        put(item, page.streams[format::kNormals].attributes[0], parameters[format::kNormalLaplacian],
            parameters[format::kNormalShift]);
        break;
      case Kind::kTangent:
        put(item, page.streams[format::kTangents].attributes[0], 0, parameters[format::kTangentShift]);
        break;
      case Kind::kUv:
        put(item, page.streams[format::kUv0 + item.set].attributes[0], parameters[format::kUvLaplacian0 + item.set],
            format::lowBits(item.extent, parameters[format::kUvBias0 + item.set]));
        break;
      case Kind::kExtra:
        put(item, page.streams[format::kExtras].attributes[0], 0, static_cast<int32_t>(item.extent));
        break;
    }
  }
  page.low_bits = low_bits.bytes();
}

}  // namespace lithe::bake
