// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Residuals put together again from the streams, the low bits and the page's parameters.
#include "residuals.h"

#include <gtest/gtest.h>

#include "page_reader.h"
#include "random.h"

namespace lithe::bake {
namespace {

using Kind = Residual::Kind;

constexpr format::WedgeAttributes kHas{true, true, 2, 0};

Residual randomResidual(test::Random& random) {
  Residual r;
  r.kind = static_cast<Kind>(random.below(5));
  r.components = r.kind == Kind::kPosition ? 3 : r.kind == Kind::kExtra ? 1 : 2;
  r.set = r.kind == Kind::kUv ? static_cast<uint8_t>(random.below(2)) : uint8_t{0};
  r.extent = r.kind == Kind::kExtra ? (random.chance(50) ? format::kExtraLowBits : 0u) : random.octave(8000);
  const int32_t width = r.kind == Kind::kExtra ? 200 : static_cast<int32_t>(r.extent) / 2;
  const bool predictable = r.kind != Kind::kExtra && r.kind != Kind::kTangent;
  if (predictable && random.chance(80)) r.count_a = 2 + random.below(8), r.count_b = 2 + random.below(8);
  for (uint32_t i = 0; i < r.components; ++i) {
    r.difference[i] = random.between(-width, width);
    if (r.count_a == 0) continue;
    // Neighbours that tell half of the difference.
    const int32_t base = random.between(0, 8000);
    r.sum_b[i] = r.count_b * base;
    r.sum_a[i] = r.count_a * (base + r.difference[i] / 2 + random.between(-3, 3));
  }
  return r;
}

uint32_t streamOf(const Residual& r) {
  switch (r.kind) {
    case Kind::kPosition:
      return format::kSplits;
    case Kind::kNormal:
      return format::kNormals;
    case Kind::kTangent:
      return format::kTangents;
    case Kind::kUv:
      return format::kUv0 + r.set;
    default:
      return format::kExtras;
  }
}

/// Low bits and sixteenths of the prediction that a page's parameters give a residual (docs/format.md, 4.3 and 4.4).
std::pair<int32_t, int32_t> parametersOf(const PageData& page, const Residual& r) {
  const auto& p = page.parameters;
  switch (r.kind) {
    case Kind::kPosition:
      return {format::lowBits(r.extent, p[format::kPositionBias]), p[format::kLaplacian]};
    case Kind::kNormal:
      return {p[format::kNormalShift], p[format::kNormalLaplacian]};
    case Kind::kTangent:
      return {p[format::kTangentShift], 0};
    case Kind::kUv:
      return {format::lowBits(r.extent, p[format::kUvBias0 + r.set]), p[format::kUvLaplacian0 + r.set]};
    default:
      return {static_cast<int32_t>(r.extent), 0};
  }
}

TEST(Residuals, ComeBackInTheOrderInWhichTheyWereAdded) {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    test::Random random(seed);
    std::vector<Residual> items;
    Residuals residuals;
    for (int i = 0; i < 400; ++i) residuals.add(items.emplace_back(randomResidual(random)));
    PageData page = makePage(format::kSplitPage, kHas);
    residuals.finish(page);

    std::vector<size_t> at(page.streams.size(), 0);
    test::BitReader low_bits(page.low_bits);
    for (const Residual& r : items) {
      const uint32_t stream = streamOf(r);
      const auto& high = page.streams[stream].attributes[stream == format::kSplits ? 4 : 0].values;
      const auto [low, laplacian] = parametersOf(page, r);
      for (uint32_t c = 0; c < r.components; ++c) {
        const int32_t value = high.at(at[stream]++) * (1 << low) + static_cast<int32_t>(low_bits.read(low));
        const int32_t predicted =
            laplacian ? format::predictDifference(r.sum_a[c], r.count_a, r.sum_b[c], r.count_b, laplacian) : 0;
        ASSERT_EQ(value + predicted, r.difference[c]) << "seed " << seed << " stream " << stream;
      }
    }
    EXPECT_TRUE(low_bits.atEnd());
  }
}

TEST(Residuals, ParametersStayInTheirRanges) {
  test::Random random(8);
  Residuals residuals;
  for (int i = 0; i < 300; ++i) residuals.add(randomResidual(random));
  PageData page = makePage(format::kSplitPage, kHas);
  residuals.finish(page);
  for (uint32_t i : {uint32_t{format::kLaplacian}, uint32_t{format::kNormalLaplacian}, format::kUvLaplacian0 + 1u})
    EXPECT_LE(page.parameters[i], 32) << i;
  for (uint32_t i : {uint32_t{format::kPositionBias}, uint32_t{format::kUvBias0}, format::kUvBias0 + 1u})
    EXPECT_LE(page.parameters[i], 31) << i;
  for (uint32_t i : {uint32_t{format::kNormalShift}, uint32_t{format::kTangentShift}})
    EXPECT_LE(page.parameters[i], 15) << i;
}

TEST(Residuals, AbsentAttributesLeaveTheirParametersZero) {
  Residuals residuals;
  Residual r;
  r.components = 3;
  r.extent = 900;
  for (int i = 0; i < 100; ++i) {
    r.difference = {i * 37 % 101, -i, i * i};
    residuals.add(r);
  }
  PageData page = makePage(format::kSplitPage, {false, false, 0, 0});
  residuals.finish(page);
  for (uint32_t i = 0; i < format::kParameterBytes; ++i) {
    if (i == format::kLaplacian || i == format::kPositionBias) continue;
    EXPECT_EQ(page.parameters[i], 0) << i;
  }
}

// What the prediction is for: where neighbours tell the difference exactly, nothing but zeros is left.
TEST(Residuals, AFittingPredictionIsFound) {
  test::Random random(9);
  Residuals residuals;
  for (int i = 0; i < 200; ++i) {
    Residual r;
    r.components = 3;
    r.extent = 200;
    r.count_a = r.count_b = 4;
    for (size_t c = 0; c < 3; ++c) {
      r.difference[c] = random.between(-50, 50);
      r.sum_a[c] = 4 * 2 * r.difference[c];  // the means lie twice as far apart: eight sixteenths
    }
    residuals.add(r);
  }
  PageData page = makePage(format::kSplitPage, kHas);
  residuals.finish(page);
  EXPECT_EQ(page.parameters[format::kLaplacian], 8);
  for (int32_t value : page.streams[format::kSplits].attributes[4].values) ASSERT_EQ(value, 0);
  EXPECT_TRUE(page.low_bits.empty());
}

}  // namespace
}  // namespace lithe::bake
