// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "residuals.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "lithe/bake/model.h"
#include "lithe/format/placement_prediction.h"

namespace lithe::bake {
namespace {

/// What is left of a difference. A position's components: two in the ring's plane, then the height over it.
std::array<int32_t, 3> residualOf(const Residual& r, int32_t slope, int32_t geometry) {
  std::array<int32_t, 3> left = r.difference;
  if (r.kind == Residual::Kind::kLattice) {
    const auto step = static_cast<int32_t>(r.extent);
    for (uint32_t i = 0; i < r.components; ++i) left[i] -= format::latticeIndex(slope, r.slope[i], step);
    return left;
  }
  for (uint32_t i = 0; i < r.components; ++i)
    left[i] -= format::scaled(slope, r.slope[i]) + ((geometry * r.geometry[i]) >> 4);
  if (r.kind != Residual::Kind::kPosition) return left;
  const format::Plane plane(r.normal[0], r.normal[1], r.normal[2]);
  const int32_t u = left[plane.across[0]], v = left[plane.across[1]];
  return {u, v, static_cast<int32_t>(left[plane.axis] + plane.lift(u, v))};
}

/// Bytes a table entry costs are charged as bits: what makes many rare symbols dear.
constexpr double kTableBits = 9.0;

/// Values of one kind with the extent that decides their low bits.
struct Series {
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

  struct Choice {
    uint8_t bias = 0;
    double bits = 1e300;
  };
  Choice best(bool adaptive) const {
    Choice choice;
    for (uint8_t bias = 0; bias <= format::kLowBitsMax; ++bias) {
      const double bits = cost(bias, adaptive);
      if (bits < choice.bits) choice = {bias, bits};
    }
    return choice;
  }
};

/// What predicts a kind: sixteenths of its slope, and of the geometry for normals.
struct Strength {
  uint8_t slope = 0, geometry = 0;
};

/// The residuals of one kind (and uv set) of a page.
class Kindred {
 public:
  Kindred(const std::vector<Residual>& items, Residual::Kind kind, uint32_t set) {
    for (const Residual& item : items)
      if (item.kind == kind && item.set == set) items_.push_back(&item);
  }

  enum class Part { kAll, kAcross, kHeight };
  Series series(Strength strength, Part part = Part::kAll) const {
    Series series;
    for (const Residual* item : items_) {
      const auto values = residualOf(*item, strength.slope, strength.geometry);
      const int begin = part == Part::kHeight ? 2 : 0, end = part == Part::kAcross ? 2 : item->components;
      series.values.insert(series.values.end(), values.begin() + begin, values.begin() + end);
      series.extents.resize(series.values.size(), item->extent);
    }
    return series;
  }

  /// The slope's strength with which values without low bits take the fewest bits.
  uint8_t cheapestSlope() const {
    uint8_t best = 0;
    double least = 1e300;
    for (uint8_t slope = 0; slope <= kMost; slope += kStep) {
      const double bits = series({slope}).cost(0, false);
      if (bits < least) least = bits, best = slope;
    }
    return best;
  }

  // One strength after the other, twice: they share what they explain.
  Strength bestStrength(bool with_geometry) const {
    Strength best;
    double least = series(best).magnitude();
    auto consider = [&](Strength strength) {
      const double bits = series(strength).magnitude();
      if (bits < least) least = bits, best = strength;
    };
    for (int sweep = 0; sweep < (with_geometry ? 2 : 1); ++sweep) {
      const Strength start = best;
      for (uint8_t geometry = 0; with_geometry && geometry <= kMost; geometry += kStep)
        consider({start.slope, geometry});
      const Strength halfway = best;
      for (uint8_t slope = 0; slope <= kMost; slope += kStep) consider({slope, halfway.geometry});
    }
    return best;
  }

 private:
  static constexpr uint8_t kStep = 2, kMost = 20;  // sixteenths

  std::vector<const Residual*> items_;
};

using Parameters = decltype(PageData::parameters);

void choosePositions(const std::vector<Residual>& items, Parameters& parameters) {
  const Kindred positions(items, Residual::Kind::kPosition, 0);
  const Strength mean = positions.bestStrength(false);
  parameters[format::kPositionMean] = mean.slope;
  parameters[format::kPositionBias] = positions.series(mean, Kindred::Part::kAcross).best(true).bias;
  parameters[format::kHeightBias] = positions.series(mean, Kindred::Part::kHeight).best(true).bias;
}

/// Where the parameters of a kind of attribute are; geometry kNone: it has none.
struct Places {
  uint32_t slope, geometry, bias;
};

void chooseAttribute(const Kindred& kindred, const Places& at, Parameters& parameters) {
  // Small differences may be dear all the same: where most are equal, a prediction scatters them.
  Strength strength = kindred.bestStrength(at.geometry != kNone);
  Series::Choice choice = kindred.series(strength).best(true);
  const Series::Choice unpredicted = kindred.series({}).best(true);
  if (unpredicted.bits <= choice.bits) strength = {}, choice = unpredicted;
  parameters[at.slope] = strength.slope;
  if (at.geometry != kNone) parameters[at.geometry] = strength.geometry;
  parameters[at.bias] = choice.bias;
}

/// Residuals of further wedges: no prediction is left to choose.
struct ExtraShift {
  Residual::Kind kind;
  format::Parameter parameter;
};
constexpr ExtraShift kExtraShifts[] = {{Residual::Kind::kExtraNormal, format::kExtraNormalShift},
                                       {Residual::Kind::kExtraTangent, format::kExtraTangentShift},
                                       {Residual::Kind::kExtraUv, format::kExtraUvShift}};

int32_t lowBitsOfExtra(const Residual& item, const Parameters& parameters) {
  for (const ExtraShift& shift : kExtraShifts)
    if (shift.kind == item.kind) return parameters[shift.parameter];
  return 0;
}

void chooseParameters(const std::vector<Residual>& items, Parameters& parameters) {
  using Kind = Residual::Kind;
  auto choose = [&](Kind kind, uint32_t set, const Places& at) {
    chooseAttribute(Kindred(items, kind, set), at, parameters);
  };
  choosePositions(items, parameters);
  parameters[format::kPlacement] = Kindred(items, Kind::kLattice, 0).cheapestSlope();
  choose(Kind::kNormal, 0, {format::kNormalGradient, format::kNormalGeometry, format::kNormalBias});
  choose(Kind::kTangent, 0, {format::kTangentGradient, kNone, format::kTangentBias});
  choose(Kind::kSkin, 0, {format::kSkinGradient, kNone, format::kSkinBias});
  for (const ExtraShift& shift : kExtraShifts)
    parameters[shift.parameter] = Kindred(items, shift.kind, 0).series({}).best(false).bias;
  for (uint32_t set = 0; set < kMaxUvSets; ++set)
    choose(Kind::kUv, set, {format::kUvGradient0 + set, kNone, format::kUvBias0 + set});
}

void fillStreams(const std::vector<Residual>& items, PageData& page) {
  const auto& parameters = page.parameters;
  LowBitsWriter low_bits;
  auto put = [&](const Residual& item, StreamData::Attribute& attribute, Strength strength, format::LowBits kind,
                 int32_t low) {
    const auto values = residualOf(item, strength.slope, strength.geometry);
    for (uint32_t i = 0; i < item.components; ++i) attribute.putSplit(values[i], low, low_bits[kind]);
  };
  auto lowOf = [&](const Residual& item, uint32_t bias) { return format::lowBits(item.extent, parameters[bias]); };
  auto putPosition = [&](const Residual& item) {
    const auto values = residualOf(item, parameters[format::kPositionMean], 0);
    auto& splits = page.streams[format::kSplits].attributes;
    BitWriter& bits = low_bits[format::kLowPositions];
    for (uint32_t i = 0; i < 2; ++i)
      splits[format::kSplitPosition].putSplit(values[i], lowOf(item, format::kPositionBias), bits);
    splits[format::kSplitPositionHeight].putSplit(values[2], lowOf(item, format::kHeightBias), bits);
  };
  auto putExtra = [&](const Residual& item) {
    put(item, page.streams[format::kExtras].attributes[0], {}, format::kLowExtras, lowBitsOfExtra(item, parameters));
  };
  for (const Residual& item : items) {
    switch (item.kind) {
      case Residual::Kind::kPosition:
        putPosition(item);
        break;
      case Residual::Kind::kLattice:
        put(item, page.streams[format::kSplits].attributes[format::kSplitLattice], {parameters[format::kPlacement]},
            format::kLowPositions, 0);
        break;
      case Residual::Kind::kNormal:
        put(item, page.streams[format::kNormals].attributes[0],
            {parameters[format::kNormalGradient], parameters[format::kNormalGeometry]}, format::kLowNormals,
            lowOf(item, format::kNormalBias));
        break;
      case Residual::Kind::kTangent:
        put(item, page.streams[format::kTangents].attributes[0], {parameters[format::kTangentGradient]},
            format::kLowTangents, lowOf(item, format::kTangentBias));
        break;
      case Residual::Kind::kSkin:
        put(item, page.streams[format::kSkinD].attributes[0], {parameters[format::kSkinGradient]}, format::kLowSkins,
            lowOf(item, format::kSkinBias));
        break;
      case Residual::Kind::kUv:
        put(item, page.streams[format::kUv0 + item.set].attributes[0], {parameters[format::kUvGradient0 + item.set]},
            format::kLowUvs, lowOf(item, format::kUvBias0 + item.set));
        break;
      case Residual::Kind::kExtraNormal:
      case Residual::Kind::kExtraTangent:
      case Residual::Kind::kExtraUv:
      case Residual::Kind::kExtraPlain:
        putExtra(item);
        break;
    }
  }
  low_bits.finish(page);
}

}  // namespace

uint8_t bestShift(const std::vector<int32_t>& values) { return Series{values, {}}.best(false).bias; }

void Residuals::finish(PageData& page) const {
  chooseParameters(items_, page.parameters);
  fillStreams(items_, page);
}

}  // namespace lithe::bake
