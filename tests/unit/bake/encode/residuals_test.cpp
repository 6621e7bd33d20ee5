// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Residuals put together again from the streams, the low bits and the page's parameters.
#include "residuals.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <map>

#include "page_reader.h"
#include "random.h"

namespace lithe::bake {
namespace {

using Kind = Residual::Kind;

constexpr format::WedgeAttributes kHas{true, true, 2, 0};

Residual randomResidual(test::Random& random) {
  Residual r;
  r.kind = static_cast<Kind>(random.below(static_cast<uint32_t>(Kind::kExtraPlain) + 1));
  const bool extra = r.kind >= Kind::kExtraNormal;
  r.components = r.kind == Kind::kPosition ? 3 : r.kind == Kind::kExtraPlain || r.kind == Kind::kSkin ? 1 : 2;
  r.set = r.kind == Kind::kUv ? static_cast<uint8_t>(random.below(2)) : uint8_t{0};
  r.extent = random.octave(8000);
  if (r.kind == Kind::kLattice) r.extent = 1u << random.below(6);
  const int32_t width = r.kind == Kind::kLattice ? 40 : extra ? 200 : static_cast<int32_t>(r.extent) / 2;
  const bool predictable = !extra && random.chance(80);
  for (uint32_t i = 0; i < r.components; ++i) {
    r.difference[i] = random.between(-width, width);
    if (!predictable) continue;
    // A slope that tells half of the difference, and for normals a geometry that tells a quarter.
    const int64_t den = 1 + random.below(1000);
    const int64_t unit = r.kind == Kind::kLattice ? r.extent : 1;
    r.slope[i] = {den * unit * (r.difference[i] / 2 + random.between(-3, 3)), den};
    if (r.kind == Kind::kNormal) r.geometry[i] = r.difference[i] / 4;
  }
  if (r.kind == Kind::kPosition)
    r.normal = {random.between(-5000, 5000), random.between(-5000, 5000), random.between(-5000, 5000)};
  return r;
}

/// Where a residual's values are and what a page's parameters say of them (docs/format.md, 4.3, 4.4 and 4.6).
struct Rule {
  uint32_t stream, attribute;
  format::LowBits kind;
  int32_t low, slope = 0, geometry = 0;
};

Rule ruleOf(const PageData& page, const Residual& r) {
  using namespace format;  // NOLINT: the names of streams and parameters
  const auto& p = page.parameters;
  const auto low = [&](uint32_t bias) { return lowBits(r.extent, p[bias]); };
  switch (r.kind) {
    case Kind::kPosition:
      return {kSplits, kSplitPosition, kLowPositions, low(kPositionBias), p[kPositionMean]};
    case Kind::kLattice:
      return {kSplits, kSplitLattice, kLowPositions, 0, p[kPlacement]};
    case Kind::kNormal:
      return {kNormals, 0, kLowNormals, low(kNormalBias), p[kNormalGradient], p[kNormalGeometry]};
    case Kind::kTangent:
      return {kTangents, 0, kLowTangents, low(kTangentBias), p[kTangentGradient]};
    case Kind::kSkin:
      return {kSkinD, 0, kLowSkins, low(kSkinBias), p[kSkinGradient]};
    case Kind::kUv:
      return {kUv0 + r.set, 0, kLowUvs, low(kUvBias0 + r.set), p[kUvGradient0 + r.set]};
    case Kind::kExtraNormal:
      return {kExtras, 0, kLowExtras, p[kExtraNormalShift]};
    case Kind::kExtraTangent:
      return {kExtras, 0, kLowExtras, p[kExtraTangentShift]};
    case Kind::kExtraUv:
      return {kExtras, 0, kLowExtras, p[kExtraUvShift]};
    default:
      return {kExtras, 0, kLowExtras, 0};
  }
}

/// Streams, low bits and parameters read back with the rules of the specification.
class ResidualReader {
 public:
  explicit ResidualReader(const PageData& page) : page_(page) {
    for (const auto& bits : page.low_bits) low_bits_.emplace_back(bits);
  }

  std::array<int32_t, 3> read(const Residual& r) {
    const Rule rule = ruleOf(page_, r);
    std::array<int32_t, 3> value{};
    if (r.kind == Kind::kPosition)
      value = readPosition(r, rule.low);
    else
      for (uint32_t c = 0; c < r.components; ++c) value[c] = next(rule.stream, rule.attribute, rule.kind, rule.low);
    for (uint32_t c = 0; c < r.components; ++c) {
      const double exact = r.slope[c].den > 0 ? rule.slope * static_cast<double>(r.slope[c].num) /
                                                    (16.0 * static_cast<double>(r.slope[c].den))
                                              : 0.0;
      // A lattice index is in steps, and rounded.
      const double share = r.kind == Kind::kLattice ? exact / r.extent + 0.5 : exact;
      value[c] += static_cast<int32_t>(std::floor(share)) +
                  static_cast<int32_t>(std::floor(rule.geometry * r.geometry[c] / 16.0));
    }
    return value;
  }

  bool atEnd() {
    return std::all_of(low_bits_.begin(), low_bits_.end(), [](test::BitReader& bits) { return bits.atEnd(); });
  }

 private:
  int32_t next(uint32_t stream, uint32_t attribute, format::LowBits kind, int32_t low) {
    const int32_t high = page_.streams[stream].attributes[attribute].values.at(at_[{stream, attribute}]++);
    return high * (1 << low) + static_cast<int32_t>(low_bits_[kind].read(low));
  }

  /// Two components across the normal's longest axis, then the height over the plane.
  std::array<int32_t, 3> readPosition(const Residual& r, int32_t low) {
    size_t m = 0;
    for (size_t c = 1; c < 3; ++c)
      if (std::abs(r.normal[c]) > std::abs(r.normal[m])) m = c;
    const size_t a = m == 0 ? 1 : 0, b = m == 2 ? 1 : 2;
    std::array<int32_t, 3> value{};
    value[a] = next(format::kSplits, format::kSplitPosition, format::kLowPositions, low);
    value[b] = next(format::kSplits, format::kSplitPosition, format::kLowPositions, low);
    const int32_t low_height = format::lowBits(r.extent, page_.parameters[format::kHeightBias]);
    value[m] = next(format::kSplits, format::kSplitPositionHeight, format::kLowPositions, low_height);
    if (r.normal[m] != 0)
      value[m] -= static_cast<int32_t>(std::floor(static_cast<double>(r.normal[a] * value[a] + r.normal[b] * value[b]) /
                                                  static_cast<double>(r.normal[m])));
    return value;
  }

  const PageData& page_;
  std::vector<test::BitReader> low_bits_;  ///< per kind
  std::map<std::pair<uint32_t, uint32_t>, size_t> at_;
};

TEST(Residuals, ComeBackInTheOrderInWhichTheyWereAdded) {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    test::Random random(seed);
    std::vector<Residual> items;
    Residuals residuals;
    for (int i = 0; i < 400; ++i) residuals.add(items.emplace_back(randomResidual(random)));
    PageData page = makePage(format::kSplitPage, kHas);
    residuals.finish(page);
    ResidualReader reader(page);
    for (const Residual& r : items) {
      const std::array<int32_t, 3> value = reader.read(r);
      for (uint32_t c = 0; c < r.components; ++c)
        ASSERT_EQ(value[c], r.difference[c]) << "seed " << seed << " kind " << static_cast<int>(r.kind);
    }
    EXPECT_TRUE(reader.atEnd());
  }
}

/// A page of `count` residuals that make() gives.
template <class Make>
PageData pageOf(int count, format::WedgeAttributes has, const Make& make) {
  Residuals residuals;
  for (int i = 0; i < count; ++i) residuals.add(make(i));
  PageData page = makePage(format::kSplitPage, has);
  residuals.finish(page);
  return page;
}

TEST(Residuals, ParametersStayInTheirRanges) {
  test::Random random(8);
  const PageData page = pageOf(300, kHas, [&](int) { return randomResidual(random); });
  for (uint32_t i : {uint32_t{format::kPositionMean}, uint32_t{format::kPlacement}, uint32_t{format::kNormalGradient},
                     uint32_t{format::kNormalGeometry}, uint32_t{format::kTangentGradient},
                     uint32_t{format::kSkinGradient}, format::kUvGradient0 + 1u})
    EXPECT_LE(page.parameters[i], 32) << i;
  for (uint32_t i :
       {uint32_t{format::kPositionBias}, uint32_t{format::kHeightBias}, uint32_t{format::kNormalBias},
        uint32_t{format::kTangentBias}, uint32_t{format::kSkinBias}, uint32_t{format::kUvBias0}, format::kUvBias0 + 1u})
    EXPECT_LE(page.parameters[i], 31) << i;
}

TEST(Residuals, AbsentAttributesLeaveTheirParametersZero) {
  const PageData page = pageOf(100, {false, false, 0, 0}, [](int i) {
    Residual r;
    r.components = 3;
    r.extent = 900;
    r.difference = {i * 37 % 101, -i, i * i};
    return r;
  });
  for (uint32_t i = 0; i < format::kParameterBytes; ++i) {
    if (i == format::kPositionMean || i == format::kPositionBias || i == format::kHeightBias) continue;
    EXPECT_EQ(page.parameters[i], 0) << i;
  }
}

// What predictions are for: where they tell the difference exactly, nothing but zeros is left.
TEST(Residuals, AFittingSlopeIsFound) {
  test::Random random(9);
  const PageData page = pageOf(200, kHas, [&](int) {
    Residual r;
    r.components = 3;
    r.extent = 200;
    for (size_t c = 0; c < 3; ++c) {
      r.difference[c] = random.between(-50, 50);
      r.slope[c] = {4 * 2 * r.difference[c], 4};  // twice the difference: eight sixteenths
    }
    return r;
  });
  EXPECT_EQ(page.parameters[format::kPositionMean], 8);
  for (uint32_t attribute : {format::kSplitPosition, format::kSplitPositionHeight})
    for (int32_t value : page.streams[format::kSplits].attributes[attribute].values) ASSERT_EQ(value, 0);
  for (const auto& bits : page.low_bits) EXPECT_TRUE(bits.empty());
}

TEST(Residuals, AFittingGeometryIsFound) {
  test::Random random(10);
  const PageData page = pageOf(200, kHas, [&](int) {
    Residual r;
    r.kind = Kind::kNormal;
    r.components = 2;
    for (size_t c = 0; c < 2; ++c) {
      r.difference[c] = random.between(-50, 50);
      r.geometry[c] = 2 * r.difference[c];
      r.slope[c] = {random.between(-50, 50), 1};
    }
    return r;
  });
  EXPECT_EQ(page.parameters[format::kNormalGeometry], 8);
  EXPECT_EQ(page.parameters[format::kNormalGradient], 0);
  for (int32_t value : page.streams[format::kNormals].attributes[0].values) ASSERT_EQ(value, 0);
}

// Differences that lie in the ring's plane have no height.
TEST(Residuals, HeightsOfAPlaneAreZero) {
  test::Random random(11);
  const PageData page = pageOf(200, kHas, [&](int) {
    Residual r;
    r.components = 3;
    r.extent = 200;
    r.normal = {100, -200, 400};
    const int32_t u = 4 * random.between(-30, 30), v = 4 * random.between(-30, 30);
    r.difference = {u, v, -(100 * u - 200 * v) / 400};
    return r;
  });
  for (int32_t value : page.streams[format::kSplits].attributes[format::kSplitPositionHeight].values)
    ASSERT_EQ(value, 0);
}

// Where most differences are equal a prediction would scatter them.
TEST(Residuals, APredictionThatCostsMoreIsLeftOut) {
  test::Random random(12);
  const PageData page = pageOf(400, kHas, [&](int i) {
    Residual r;
    r.kind = Kind::kUv;
    r.components = 2;
    const bool rare = i % 40 == 0;
    r.difference = {rare ? random.between(-4000, 4000) : 60, rare ? random.between(-4000, 4000) : 60, 0};
    for (size_t c = 0; c < 2; ++c) r.slope[c] = {rare ? r.difference[c] : random.between(20, 100), 1};
    return r;
  });
  EXPECT_EQ(page.parameters[format::kUvGradient0], 0);
}

}  // namespace
}  // namespace lithe::bake
