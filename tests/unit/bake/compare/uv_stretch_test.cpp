// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "uv_stretch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>
#include <sstream>

#include "lithe/bake/compare.h"
#include "shapes.h"

namespace lithe::bake {
namespace {

using glm::dmat2;
using glm::dvec2;
using glm::dvec3;

constexpr double kExact = 1e-12;

/// On the texture as on the surface: J is the unit matrix.
constexpr TexturedTriangle kPlain{{dvec3(0, 0, 0), dvec3(1, 0, 0), dvec3(0, 1, 0)},
                                  {dvec2(0, 0), dvec2(1, 0), dvec2(0, 1)}};

template <typename Map>
TexturedTriangle moved(TexturedTriangle triangle, const Map& map) {
  for (dvec3& position : triangle.positions) position = map(position);
  return triangle;
}

template <typename Map>
TexturedTriangle retextured(TexturedTriangle triangle, const Map& map) {
  for (dvec2& uv : triangle.uvs) uv = map(uv);
  return triangle;
}

TexturedTriangle scaled(const TexturedTriangle& triangle, const dvec3& factors) {
  return moved(triangle, [&](const dvec3& p) { return p * factors; });
}

/// In both directions: which of the two is the original does not matter where both have a texture.
void expectStretch(const TexturedTriangle& original, const TexturedTriangle& simplified, double stretch) {
  EXPECT_NEAR(uvStretch(original, simplified).value(), stretch, kExact * stretch);
  EXPECT_NEAR(uvStretch(simplified, original).value(), stretch, kExact * stretch);
}

TEST(UvStretch, ATextureThatLiesAsOnTheOriginalIsNotStretched) {
  expectStretch(kPlain, kPlain, 1.0);
  const TexturedTriangle long_one = scaled(kPlain, {1000.0, 0.01, 1.0});
  expectStretch(long_one, long_one, 1.0);
}

TEST(UvStretch, UvsOfTwiceTheSizeSqueezeTheTextureToHalf) {
  expectStretch(kPlain, retextured(kPlain, [](const dvec2& uv) { return 2.0 * uv; }), 2.0);
}

TEST(UvStretch, TheDirectionThatIsWorstOffCounts) {
  expectStretch(kPlain, scaled(kPlain, {3, 1, 1}), 3.0);
  expectStretch(kPlain, scaled(kPlain, {1, 1.0 / 3, 1}), 3.0);
  expectStretch(kPlain, scaled(kPlain, {2, 0.2, 1}), 5.0);
  expectStretch(kPlain, scaled(kPlain, {5, 0.5, 1}), 5.0);
}

TEST(UvStretch, AShearStretchesByTheGoldenRatio) {
  // (1 1; 0 1) times its transpose is (2 1; 1 1), whose eigenvalues are (3 +- sqrt 5) / 2: phi^2 and 1 / phi^2.
  expectStretch(kPlain, moved(kPlain, [](const dvec3& p) { return dvec3(p.x + p.y, p.y, 0.0); }), std::numbers::phi);
}

TEST(UvStretch, TurningAndShiftingStretchNothing) {
  const double c = std::cos(0.7), s = std::sin(0.7);
  const auto turned_uvs = [&](const dvec2& uv) { return dvec2(c * uv.x - s * uv.y + 0.3, s * uv.x + c * uv.y - 0.9); };
  const auto turned = [&](const dvec3& p) { return dvec3(p.z + 5.0, c * p.x - s * p.y, s * p.x + c * p.y); };
  expectStretch(kPlain, retextured(kPlain, turned_uvs), 1.0);
  expectStretch(kPlain, moved(kPlain, turned), 1.0);
  expectStretch(kPlain, moved(scaled(kPlain, {3, 1, 1}), turned), 3.0);
}

TEST(UvStretch, OtherTrianglesOfOneMapAreNotStretched) {
  const auto onTheMap = [](const dvec2& uv) { return dvec3(2.0 * uv.x + 1.0, 3.0 * uv.y, uv.x - uv.y); };
  const auto at = [&](const dvec2& a, const dvec2& b, const dvec2& c) {
    return TexturedTriangle{{onTheMap(a), onTheMap(b), onTheMap(c)}, {a, b, c}};
  };
  expectStretch(at({0, 0}, {0.1, 0}, {0, 0.1}), at({0.5, 0.2}, {4, 1}, {0.3, 0.7}), 1.0);
}

/// How long a step in a direction of the texture is on the triangle.
double lengthOn(const TexturedTriangle& triangle, const dvec2& step) {
  const dmat2 edges(triangle.uvs[1] - triangle.uvs[0], triangle.uvs[2] - triangle.uvs[0]);
  const dvec2 shares = glm::inverse(edges) * step;
  return glm::length(shares.x * (triangle.positions[1] - triangle.positions[0]) +
                     shares.y * (triangle.positions[2] - triangle.positions[0]));
}

TEST(UvStretch, IsTheMostThatAnyDirectionIsStretchedOrSqueezed) {
  std::mt19937_64 random(1);
  const auto plane = [&] { return dvec2(test::randomPoint(random, 1.0)); };
  const auto triangle = [&]() -> TexturedTriangle {
    const auto space = [&] { return test::randomPoint(random, 1.0); };
    return {{space(), space(), space()}, {plane(), plane(), plane()}};
  };
  uint32_t judged = 0;
  for (int i = 0; i < 300; ++i) {
    const TexturedTriangle original = triangle(), simplified = triangle();
    double most = 1.0;
    for (int k = 0; k < 2000; ++k) {
      const double angle = std::numbers::pi * k / 2000;
      const dvec2 step(std::cos(angle), std::sin(angle));
      const double longer = lengthOn(simplified, step) / lengthOn(original, step);
      most = std::max({most, longer, 1.0 / longer});
    }
    const double stretch = uvStretch(original, simplified).value();
    if (stretch == kMostUvStretch) continue;
    EXPECT_GE(stretch, most * (1.0 - kExact)) << i;
    EXPECT_LE(stretch, most * 1.01) << i;
    ++judged;
  }
  EXPECT_GT(judged, 75u);
}

TEST(UvStretch, StopsAtItsLimit) {
  expectStretch(kPlain, scaled(kPlain, {15.9, 1, 1}), 15.9);
  expectStretch(kPlain, scaled(kPlain, {17, 1, 1}), kMostUvStretch);
}

TEST(UvStretch, AMirroredTextureIsAtTheLimit) {
  const TexturedTriangle mirrored = retextured(kPlain, [](const dvec2& uv) { return dvec2(-uv.x, uv.y); });
  const auto turnedOver = [](TexturedTriangle triangle) {
    std::swap(triangle.positions[1], triangle.positions[2]);
    std::swap(triangle.uvs[1], triangle.uvs[2]);
    return triangle;
  };
  expectStretch(kPlain, mirrored, kMostUvStretch);
  expectStretch(mirrored, mirrored, 1.0);
  // The same seen from behind: a face that faces the other way shows its texture mirrored.
  expectStretch(kPlain, turnedOver(kPlain), kMostUvStretch);
  expectStretch(mirrored, turnedOver(kPlain), 1.0);
}

TEST(UvStretch, WithoutAreaTheOriginalSaysNothingAndTheSimplifiedIsAtTheLimit) {
  const TexturedTriangle bare = retextured(kPlain, [](const dvec2& uv) { return dvec2(0.4 + uv.x, 0.2); });
  const TexturedTriangle dot = retextured(kPlain, [](const dvec2&) { return dvec2(0.0); });
  const TexturedTriangle line = scaled(kPlain, {1, 0, 1}), point = scaled(kPlain, dvec3(0.0));
  for (const TexturedTriangle& none : {bare, dot, line, point}) {
    EXPECT_EQ(uvStretch(kPlain, none), kMostUvStretch);
    EXPECT_EQ(uvStretch(none, kPlain), std::nullopt);
    EXPECT_EQ(uvStretch(none, none), std::nullopt);
  }
}

TEST(UvStretch, WhatRoundingMakesOfNoAreaIsNone) {
  // Three uvs of one line, rounded to floats.
  TexturedTriangle rounded = kPlain;
  for (int i = 0; i < 3; ++i)
    rounded.uvs[i] = {static_cast<float>(0.3 + 0.1 * i * i), static_cast<float>(0.7 + 0.07 * i * i)};
  ASSERT_NE(glm::determinant(glm::dmat2(rounded.uvs[1] - rounded.uvs[0], rounded.uvs[2] - rounded.uvs[0])), 0.0);
  EXPECT_EQ(uvStretch(rounded, kPlain), std::nullopt);
  // A small triangle far above the rounding is one.
  const auto small = [](const dvec2& uv) { return dvec2(0.5) + 1e-4 * uv; };
  expectStretch(retextured(kPlain, small), retextured(kPlain, small), 1.0);
}

/// In two frames of a bend.
CompareReport report(const Model& original, const Model& simplified) {
  CompareOptions options;
  options.frames = 2;
  options.samples = 3000;
  options.animation = "bend";
  return compare(original, simplified, options);
}

Model withUvs(Model model, const std::function<glm::vec2(const glm::vec2&, const glm::vec3&)>& map) {
  for (size_t i = 0; i < model.positions.size(); ++i) model.uvs[0][i] = map(model.uvs[0][i], model.positions[i]);
  return model;
}

/// Both in one model, on a's skeleton.
Model together(Model a, const Model& b) {
  const auto append = [](auto& values, const auto& more) { values.insert(values.end(), more.begin(), more.end()); };
  const uint32_t first = static_cast<uint32_t>(a.positions.size());
  append(a.positions, b.positions);
  append(a.normals, b.normals);
  append(a.uvs[0], b.uvs[0]);
  append(a.skins, b.skins);
  append(a.triangle_part, b.triangle_part);
  for (const auto& t : b.triangles) a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return a;
}

TEST(UvStretchOfModels, IsTheMeanLogarithm) {
  const Model original = test::tube(24, 16);
  EXPECT_NEAR(report(original, original).worst.uv_stretch, 0.0, kExact);
  const Model twice = withUvs(original, [](const auto& uv, const auto&) { return 2.0f * uv; });
  // All of the texture on the upper half of the tube is squeezed four times: half of the area, but for the ring
  // between.
  const Model half =
      withUvs(original, [](const auto& uv, const auto& p) { return glm::vec2(p.z > 2.01f ? 4 : 1, 1) * uv; });
  const CompareReport whole = report(original, twice), rest = report(original, half);
  for (const FrameReport& frame : whole.frames) {
    EXPECT_NEAR(frame.original_to_simplified.uv_stretch, std::log(2.0), 1e-9);
    EXPECT_NEAR(frame.simplified_to_original.uv_stretch, std::log(2.0), 1e-9);
  }
  EXPECT_NEAR(whole.mean.uv_stretch, std::log(2.0), 1e-9);
  EXPECT_GT(rest.mean.uv_stretch, 0.47 * std::log(4.0));
  EXPECT_LT(rest.mean.uv_stretch, 0.55 * std::log(4.0));
}

TEST(UvStretchOfModels, AMirroredTextureIsAtTheLimitAllOver) {
  const Model original = test::tube(24, 16);
  const Model mirrored = withUvs(original, [](const auto& uv, const auto&) { return glm::vec2(1.0f - uv.x, uv.y); });
  EXPECT_NEAR(report(original, mirrored).mean.uv_stretch, std::log(kMostUvStretch), kExact);
}

TEST(UvStretchOfModels, WhereTheOriginalHasNoTextureNothingCounts) {
  const Model original = test::tube(24, 16);
  const Model none = withUvs(original, [](const auto&, const auto&) { return glm::vec2(0.5f); });
  const Model twice = withUvs(original, [](const auto& uv, const auto&) { return 2.0f * uv; });
  for (const Model* simplified : {&none, &twice}) {
    const CompareReport without = report(none, *simplified);
    EXPECT_TRUE(without.has_uv);
    EXPECT_EQ(without.worst.uv_stretch, 0.0);
  }
  // None above the middle: what is left below says the same as before.
  const Model lower =
      withUvs(original, [](const auto& uv, const auto& p) { return p.z > 1.99f ? glm::vec2(0.5f) : uv; });
  const Model lower_twice = withUvs(lower, [](const auto& uv, const auto&) { return 2.0f * uv; });
  EXPECT_NEAR(report(lower, lower_twice).worst.uv_stretch, std::log(2.0), 1e-9);
}

TEST(UvStretchOfModels, ATextureThatTheSimplifiedModelLostIsItsFaultInBothDirections) {
  const Model original = test::tube(24, 16);
  const Model lost = withUvs(original, [](const auto&, const auto&) { return glm::vec2(0.5f); });
  for (const FrameReport& frame : report(original, lost).frames) {
    EXPECT_NEAR(frame.original_to_simplified.uv_stretch, std::log(kMostUvStretch), kExact);
    EXPECT_NEAR(frame.simplified_to_original.uv_stretch, std::log(kMostUvStretch), kExact);
  }
}

TEST(UvStretchOfModels, OfEquallyNearTrianglesTheOneThatAgreesBestCounts) {
  const Model original = test::tube(24, 16);
  const Model twice = withUvs(original, [](const auto& uv, const auto&) { return 2.0f * uv; });
  const Model doubled = together(twice, original);
  for (const FrameReport& frame : report(original, doubled).frames) {
    EXPECT_NEAR(frame.original_to_simplified.uv_stretch, 0.0, kExact);
    EXPECT_NEAR(frame.simplified_to_original.uv_stretch, 0.5 * std::log(2.0), 0.02);
  }
}

TEST(UvStretchOfModels, WhereAnEquallyNearTriangleOfTheOriginalHasNoTextureNothingCounts) {
  const Model original = test::tube(24, 16);
  const Model none = withUvs(original, [](const auto&, const auto&) { return glm::vec2(0.5f); });
  const Model layers = together(original, none);
  EXPECT_NEAR(report(layers, layers).worst.uv_stretch, 0.0, kExact);
}

TEST(UvStretchOfModels, IsInTheReports) {
  const Model original = test::tube(24, 16);
  const CompareReport twice =
      report(original, withUvs(original, [](const auto& uv, const auto&) { return 2.0f * uv; }));
  const nlohmann::json json = nlohmann::json::parse(compareJson(twice));
  EXPECT_DOUBLE_EQ(json["mean_of_frames"]["uv_stretch"].get<double>(), twice.mean.uv_stretch);
  EXPECT_DOUBLE_EQ(json["frames"][1]["symmetric"]["uv_stretch"].get<double>(), twice.frames[1].symmetric.uv_stretch);
  std::istringstream text(compareText(twice));
  size_t ends = 0, lines = 0;
  for (std::string line; std::getline(text, line);) {
    if (line.ends_with("uv stretch")) ends = line.size();
    if (!line.starts_with("mean of frames") && !line.starts_with("worst frame")) continue;
    ++lines;
    EXPECT_TRUE(line.ends_with(" 0.6931")) << line;
    EXPECT_EQ(line.size(), ends) << line;
  }
  EXPECT_EQ(lines, 2u);
  Model without = original;
  without.uvs[0].clear();
  without.attributes.uv_sets = 0;
  EXPECT_EQ(compareText(report(original, without)).find("uv"), std::string::npos);
  EXPECT_EQ(compareJson(report(original, without)).find("uv"), std::string::npos);
}

}  // namespace
}  // namespace lithe::bake
