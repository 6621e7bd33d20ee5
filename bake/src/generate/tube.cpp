// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "tube.h"

#include <algorithm>
#include <cmath>

#include "exact_math.h"
#include "rig.h"

namespace lithe::bake {

glm::dvec3 surfaceNormal(const std::function<glm::dvec3(double, double)>& position, double angle, double v) {
  constexpr double kStep = 1e-4, kPoleBand = 1e-9;
  if (v < kPoleBand || v > 1.0 - kPoleBand) {
    const double inside = v < 0.5 ? 0.02 : 0.98;
    glm::dvec3 middle(0.0);
    for (int k = 0; k < 4; ++k) middle += 0.25 * position(k * exact::kPi / 2.0, inside);
    return glm::normalize(position(0.0, v) - middle);
  }
  const double below = std::max(v - kStep, 0.0), above = std::min(v + kStep, 1.0);
  const glm::dvec3 around = position(angle + kStep, v) - position(angle - kStep, v);
  const glm::dvec3 along = position(angle, above) - position(angle, below);
  return glm::normalize(glm::cross(around, along));
}

void addTube(SurfaceBuilder& surface, const Tube& tube) {
  surface.addSheet(tube.part, tube.columns, tube.rows, [&](uint32_t column, uint32_t row) {
    const double u = static_cast<double>(column) / tube.columns, v = static_cast<double>(row) / tube.rows;
    const double angle = column == tube.columns ? 0.0 : exact::kTau * u;  // the last column lies on the first
    SurfacePoint point;
    const bool pole = row == 0 || row == tube.rows;
    point.position = tube.position(pole ? 0.0 : angle, v);
    point.normal = surfaceNormal(tube.position, angle, v);
    point.uv = tube.uv.at(u, v);
    point.skin = tube.skin(v);
    return point;
  });
}

Limb::Limb(std::vector<glm::dvec3> points, std::vector<double> radii, const glm::dvec3& side)
    : points_(std::move(points)), radii_(std::move(radii)), side_(side) {
  v_.push_back(0.0);
  for (size_t i = 1; i < points_.size(); ++i) v_.push_back(v_.back() + glm::length(points_[i] - points_[i - 1]));
  length_ = v_.back();
  for (double& v : v_) v /= length_;
  for (size_t i = 0; i < points_.size(); ++i) {
    const glm::dvec3 before = points_[i > 0 ? i - 1 : 0], after = points_[std::min(i + 1, points_.size() - 1)];
    tangents_.push_back(glm::normalize(after - before));
  }
}

Limb::Place Limb::placeAt(double v) const {
  uint32_t piece = 0;
  while (piece + 2 < v_.size() && v >= v_[piece + 1]) ++piece;
  return {piece, glm::clamp((v - v_[piece]) / (v_[piece + 1] - v_[piece]), 0.0, 1.0)};
}

glm::dvec3 Limb::centerAt(double v) const {
  const auto [i, t] = placeAt(v);
  const double chord = glm::length(points_[i + 1] - points_[i]);
  const double t2 = t * t, t3 = t2 * t;
  return points_[i] * (2.0 * t3 - 3.0 * t2 + 1.0) + points_[i + 1] * (3.0 * t2 - 2.0 * t3) +
         chord * (tangents_[i] * (t3 - 2.0 * t2 + t) + tangents_[i + 1] * (t3 - t2));
}

glm::dvec3 Limb::tangentAt(double v) const {
  const auto [i, t] = placeAt(v);
  const double chord = glm::length(points_[i + 1] - points_[i]);
  const double t2 = t * t;
  const glm::dvec3 derivative =
      (points_[i + 1] - points_[i]) * (6.0 * t - 6.0 * t2) +
      chord * (tangents_[i] * (3.0 * t2 - 4.0 * t + 1.0) + tangents_[i + 1] * (3.0 * t2 - 2.0 * t));
  return glm::normalize(derivative);
}

double Limb::radiusAt(double v) const {
  const auto [i, t] = placeAt(v);
  const double base = radii_[i] * (1.0 - t) + radii_[i + 1] * t;
  const double near_joint = std::min(i == 0 ? 1.0 : t, i + 2 == v_.size() ? 1.0 : 1.0 - t);
  const double waist = 0.72 + 0.28 * exact::smoothStep(0.0, 0.22, near_joint);
  const double swelling = 1.0 + 0.16 * exact::bump(t - 0.78, 0.22);
  // the ends close with an ellipse, whatever the radius there
  const double cap = 1.2 * base / length_;
  const double inside = std::min({v / cap, (1.0 - v) / cap, 1.0});
  return base * waist * swelling * std::sqrt(inside * (2.0 - inside));
}

glm::dvec3 Limb::surfaceAt(double angle, double v) const {
  const glm::dvec3 up = glm::cross(tangentAt(v), side_);
  return centerAt(v) + radiusAt(v) * (exact::cosine(angle) * side_ + exact::sine(angle) * up);
}

Skin Limb::skinAt(double v, const std::vector<uint32_t>& joints, double half_width) const {
  std::vector<Influence> influences;
  double rest = 1.0;
  for (size_t k = joints.size(); k-- > 1;) {
    const double reached = rest * exact::smoothStep(-half_width, half_width, v - v_[k]);
    influences.push_back({joints[k], reached});
    rest -= reached;
  }
  influences.push_back({joints[0], rest});
  return makeSkin(influences, 4);
}

}  // namespace lithe::bake
