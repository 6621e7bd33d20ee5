// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Every figure of a comparison, computed a second time with nothing of the library but the models: posing written out
// for the one bent joint, regular points instead of random ones, and all triangles looked at for each.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "lithe/bake/compare.h"
#include "shapes.h"

namespace lithe::bake {
namespace {

using glm::dmat2;
using glm::dvec2;
using glm::dvec3;

/// Part of the posed diagonal up to which points count as equally near: the best match of them counts (compare.h).
constexpr double kEquallyNear = 1e-7;

struct Posed {
  std::vector<dvec3> positions, normals;
  const Model& model;
};

/// The tube with its elbow, at (0, 0, 2), turned by `angle` about x.
Posed bent(const Model& model, double angle) {
  Posed posed{{}, {}, model};
  const double c = std::cos(angle), s = std::sin(angle);
  const auto turned = [&](const dvec3& v) { return dvec3(v.x, c * v.y - s * v.z, s * v.y + c * v.z); };
  const dvec3 elbow(0, 0, 2);
  for (size_t i = 0; i < model.positions.size(); ++i) {
    const Skin& skin = model.skins[i];
    double root = 0.0, forearm = 0.0;
    for (uint32_t k = 0; k < skin.count; ++k) (skin.joint[k] == 0 ? root : forearm) += skin.weight[k];
    root /= root + forearm;
    forearm = 1.0 - root;
    const dvec3 p(model.positions[i]), n(model.normals[i]);
    posed.positions.push_back(root * p + forearm * (turned(p - elbow) + elbow));
    // The inverse transpose of root * 1 + forearm * R is a multiple of itself in the plane of the turn, and 1 along x.
    const double stretch2 = root * root + forearm * forearm + 2.0 * root * forearm * c;
    const dvec3 blend = root * n + forearm * turned(n);
    posed.normals.push_back(glm::normalize(dvec3(n.x, blend.y / stretch2, blend.z / stretch2)));
  }
  return posed;
}

template <typename Vector>
Vector mixed(const std::vector<Vector>& values, const std::array<uint32_t, 3>& t, const dvec3& weights) {
  return values[t[0]] * weights.x + values[t[1]] * weights.y + values[t[2]] * weights.z;
}

dvec3 areaVector(const Posed& posed, const std::array<uint32_t, 3>& t) {
  return 0.5 * glm::cross(posed.positions[t[1]] - posed.positions[t[0]], posed.positions[t[2]] - posed.positions[t[0]]);
}

/// Weights of the nearest point of triangle abc by the regions it may lie in (Ericson, Real-Time Collision Detection,
/// 5.1.5).
dvec3 nearestWeights(const dvec3& p, const dvec3& a, const dvec3& b, const dvec3& c) {
  const dvec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap), d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
  const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  const double on_bc = (d4 - d3) / ((d4 - d3) + (d5 - d6));
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return {0, 1 - on_bc, on_bc};
  return dvec3(va, vb, vc) / (va + vb + vc);
}

/// What a point of one surface says about the other.
struct PointError {
  double area = 0.0, distance = 0.0;
  double angle = std::numeric_limits<double>::infinity(), uv = std::numeric_limits<double>::infinity();
  double stretch = std::numeric_limits<double>::infinity();  ///< its logarithm
  bool flipped = true;
};

struct Point {
  dvec3 position, normal, face;
  dvec2 uv;
  dmat2 from_uv;  ///< of its triangle
};

/// The map from uvs to the triangle's plane, in a frame of that plane seen from the front.
dmat2 mapFromUv(const Posed& posed, const std::array<uint32_t, 3>& t) {
  const dvec3 ab = posed.positions[t[1]] - posed.positions[t[0]], ac = posed.positions[t[2]] - posed.positions[t[0]];
  const dvec3 x = glm::normalize(ab), y = glm::cross(glm::normalize(areaVector(posed, t)), x);
  const auto& uvs = posed.model.uvs[0];
  const dvec2 a(uvs[t[0]]), b(uvs[t[1]]), c(uvs[t[2]]);
  return dmat2(dvec2(glm::length(ab), 0.0), dvec2(glm::dot(ac, x), glm::dot(ac, y))) *
         glm::inverse(dmat2(b - a, c - a));
}

/// ln of the larger of the larger singular value of one map after the other's inverse, and of 1 / the smaller. A 2 x 2
/// matrix is a turning with scaling plus a mirroring with scaling: the singular values are the sum and the difference
/// of the two scales, and it mirrors where the second is larger.
double logStretch(const dmat2& from_uv, const dmat2& to_uv) {
  const dmat2 m = to_uv * glm::inverse(from_uv);
  const double turning = 0.5 * std::hypot(m[0][0] + m[1][1], m[0][1] - m[1][0]);
  const double mirroring = 0.5 * std::hypot(m[0][0] - m[1][1], m[0][1] + m[1][0]);
  const double most = std::log(16.0);
  if (mirroring >= turning) return most;
  return std::min(most, std::max(std::log(turning + mirroring), -std::log(turning - mirroring)));
}

PointError errorAt(const Point& point, const Posed& to, double slack) {
  std::vector<std::pair<double, dvec3>> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& t : to.model.triangles) {
    const dvec3 weights = nearestWeights(point.position, to.positions[t[0]], to.positions[t[1]], to.positions[t[2]]);
    nearest.emplace_back(glm::distance(mixed(to.positions, t, weights), point.position), weights);
    least = std::min(least, nearest.back().first);
  }
  PointError error;
  error.distance = least;
  for (size_t i = 0; i < nearest.size(); ++i) {
    if (nearest[i].first > least + slack) continue;
    const auto& t = to.model.triangles[i];
    const double cosine = glm::dot(point.normal, glm::normalize(mixed(to.normals, t, nearest[i].second)));
    error.angle = std::min(error.angle, std::acos(std::clamp(cosine, -1.0, 1.0)));
    const dvec3 weights = nearest[i].second;
    const auto& uvs = to.model.uvs[0];
    const dvec2 uv = dvec2(uvs[t[0]]) * weights.x + dvec2(uvs[t[1]]) * weights.y + dvec2(uvs[t[2]]) * weights.z;
    error.uv = std::min(error.uv, glm::distance(uv, point.uv));
    error.stretch = std::min(error.stretch, logStretch(point.from_uv, mapFromUv(to, t)));
    error.flipped = error.flipped && glm::dot(point.face, areaVector(to, t)) < 0.0;
  }
  return error;
}

/// Calls visit(weights) with the centres of the cells * cells equal triangles that a triangle is cut into.
void forEachCell(uint32_t cells, const std::function<void(const dvec3&)>& visit) {
  for (uint32_t i = 0; i < cells; ++i)
    for (uint32_t j = 0; i + j < cells; ++j) {
      const double third = 1.0 / 3.0;
      visit({(i + third) / cells, (j + third) / cells, 1.0 - (i + j + 2 * third) / cells});
      if (i + j + 2 > cells) continue;
      visit({(i + 2 * third) / cells, (j + 2 * third) / cells, 1.0 - (i + j + 4 * third) / cells});
    }
}

/// The least value that at least `share` of the area is at or below.
double quantile(std::vector<std::pair<double, double>> values_and_areas, double share) {
  std::sort(values_and_areas.begin(), values_and_areas.end());
  double total = 0.0, sum = 0.0;
  for (const auto& [value, area] : values_and_areas) total += area;
  for (const auto& [value, area] : values_and_areas)
    if ((sum += area) >= share * total) return value;
  return values_and_areas.back().first;
}

SurfaceError summarized(const std::vector<PointError>& points) {
  SurfaceError error;
  double area = 0.0, angle2 = 0.0, uv2 = 0.0;
  std::vector<std::pair<double, double>> distances, uvs;
  for (const PointError& p : points) {
    area += p.area;
    error.mean += p.area * p.distance;
    error.rms += p.area * p.distance * p.distance;
    error.max = std::max(error.max, p.distance);
    angle2 += p.area * p.angle * p.angle;
    uv2 += p.area * p.uv * p.uv;
    error.uv_stretch += p.area * p.stretch;
    error.flipped += p.flipped ? p.area : 0.0;
    distances.emplace_back(p.distance, p.area);
    uvs.emplace_back(p.uv, p.area);
  }
  error.mean /= area;
  error.rms = std::sqrt(error.rms / area);
  error.p999 = quantile(distances, 0.999);
  error.normal_degrees = glm::degrees(std::sqrt(angle2 / area));
  error.flipped /= area;
  error.uv_rms = std::sqrt(uv2 / area);
  error.uv_median = quantile(uvs, 0.5);
  error.uv_stretch /= area;
  return error;
}

SurfaceError bruteForce(const Posed& from, const Posed& to, uint32_t cells) {
  dvec3 low(std::numeric_limits<double>::infinity()), high(-low);
  for (const dvec3& p : to.positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const double slack = kEquallyNear * glm::distance(low, high);
  std::vector<PointError> points;
  double farthest = 0.0;
  for (const auto& t : from.model.triangles) {
    const dvec3 face = areaVector(from, t);
    const dmat2 from_uv = mapFromUv(from, t);
    const auto at = [&](const dvec3& weights) {
      const auto& uvs = from.model.uvs[0];
      const dvec2 uv = dvec2(uvs[t[0]]) * weights.x + dvec2(uvs[t[1]]) * weights.y + dvec2(uvs[t[2]]) * weights.z;
      return errorAt(
          {mixed(from.positions, t, weights), glm::normalize(mixed(from.normals, t, weights)), face, uv, from_uv}, to,
          slack);
    };
    forEachCell(cells, [&](const dvec3& weights) {
      points.push_back(at(weights));
      points.back().area = glm::length(face) / (cells * cells);
    });
    // The farthest point is often a corner or lies on an edge, which no cell's centre does.
    for (uint32_t i = 0; i <= cells; ++i)
      for (uint32_t j = 0; i + j <= cells; ++j)
        farthest = std::max(farthest, at(dvec3(i, j, cells - i - j) / static_cast<double>(cells)).distance);
  }
  SurfaceError error = summarized(points);
  error.max = std::max(error.max, farthest);
  return error;
}

/// A tube with bumps, so that no figure is zero or the same everywhere, and with uvs from the side: where a chart ends,
/// the few points that are matched across would decide the mean.
Model bumpy(uint32_t around, uint32_t rings) {
  Model model = test::tube(around, rings);
  for (size_t i = 0; i < model.positions.size(); ++i) {
    const double z = model.positions[i].z, bump = 0.06 * std::sin(3.0 * z) * std::cos(2.0 * z);
    model.positions[i] += glm::vec3(bump) * model.normals[i];
    model.uvs[0][i] = {model.positions[i].x, 0.25f * model.positions[i].z};
    model.normals[i] = glm::normalize(model.normals[i] + glm::vec3(0.0f, 0.0f, 0.3f * std::sin(static_cast<float>(z))));
  }
  return model;
}

/// A coarser one with other weights and uvs, a seam that opens, and a patch that faces inwards.
Model coarse() {
  constexpr uint32_t kAround = 8;
  Model model = bumpy(kAround, 9);
  for (size_t i = 0; i < model.skins.size(); ++i)
    if (model.skins[i].count == 2)  // no longer sums to one: to be renormalised
      model.skins[i].weight[0] *= i % (kAround + 1) == kAround ? 1.5f : 1.2f;
  for (size_t i = 0; i < model.uvs[0].size(); ++i)
    model.uvs[0][i] += glm::vec2(0.02f * std::sin(static_cast<float>(i)), 0.01f);
  for (size_t i = 40; i < 60; ++i) std::swap(model.triangles[i][1], model.triangles[i][2]);
  return model;
}

double weightSumError(const Model& model) {
  double largest = 0.0;
  for (const Skin& skin : model.skins) {
    double sum = 0.0;
    for (uint32_t k = 0; k < skin.count; ++k) sum += skin.weight[k];
    largest = std::max(largest, std::abs(sum - 1.0));
  }
  return largest;
}

/// The farthest that two vertices with one rest position are apart.
double widestGap(const Posed& posed) {
  const Posed rest = bent(posed.model, 0.0);
  double widest = 0.0;
  for (size_t i = 0; i < posed.positions.size(); ++i)
    for (size_t j = 0; j < i; ++j)
      if (glm::distance(rest.positions[i], rest.positions[j]) < 1e-7)
        widest = std::max(widest, glm::distance(posed.positions[i], posed.positions[j]));
  return widest;
}

void expectWithinAPercent(const SurfaceError& measured, const SurfaceError& expected, const std::string& where) {
  SCOPED_TRACE(where);
  const auto near = [](double value, double reference) { EXPECT_NEAR(value, reference, 0.01 * reference); };
  const auto figures = [](const SurfaceError& e) {
    return std::array{e.rms, e.mean, e.max, e.p999, e.normal_degrees, e.flipped, e.uv_rms, e.uv_median, e.uv_stretch};
  };
  const char* names[] = {"rms",     "mean",   "max",       "p999",      "normal_degrees",
                         "flipped", "uv_rms", "uv_median", "uv_stretch"};
  for (size_t i = 0; i < figures(expected).size(); ++i) {
    SCOPED_TRACE(names[i]);
    EXPECT_GT(figures(expected)[i], 0.0) << "says nothing";
    near(figures(measured)[i], figures(expected)[i]);
  }
}

TEST(CompareByBruteForce, EveryFigureAgreesWithinAPercentInBothDirections) {
  const Model original = bumpy(18, 14), simplified = coarse();
  CompareOptions options;
  options.animation = "bend";
  options.frames = 2;
  options.samples = 200000;
  const CompareReport report = compare(original, simplified, options);
  ASSERT_EQ(report.frames.size(), 2u);
  EXPECT_GT(report.weight_sum_error, 0.1);
  EXPECT_NEAR(report.weight_sum_error, weightSumError(simplified), 1e-6);
  for (const FrameReport& frame : report.frames) {
    const double angle = glm::radians(90.0) * frame.time;
    const Posed a = bent(original, angle), b = bent(simplified, angle);
    const auto inUnits = [&](SurfaceError e) {
      for (double* length : {&e.rms, &e.mean, &e.max, &e.p999}) *length *= report.rest_diagonal;
      return e;
    };
    EXPECT_GT(frame.seam.gap, 0.001);
    EXPECT_NEAR(frame.seam.gap * report.rest_diagonal, widestGap(b), 1e-6);
    EXPECT_EQ(frame.seam.opened, frame.seam.gap) << "the original's seam stays closed";
    const std::string when = "at " + std::to_string(frame.time) + " s, ";
    expectWithinAPercent(inUnits(frame.original_to_simplified), bruteForce(a, b, 8), when + "original to simplified");
    expectWithinAPercent(inUnits(frame.simplified_to_original), bruteForce(b, a, 28), when + "simplified to original");
  }
}

}  // namespace
}  // namespace lithe::bake
