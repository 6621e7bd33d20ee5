// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "implicit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact_math.h"

namespace lithe::bake::implicit {
namespace {

using glm::dot;
using glm::dvec3;

double lengthOf(const dvec3& v) { return std::sqrt(dot(v, v)); }

/// Distance to the ball that touches the cone next to the point: the hull of two balls seen in the plane of point and
/// axis.
Sample roundConeSample(const Primitive& cone, const dvec3& point) {
  const double across = dot(point - cone.a, cone.flat_axis);
  const double squeeze = 1.0 / cone.flat_factor - 1.0, scale = std::min(1.0, cone.flat_factor);
  const dvec3 p = point + cone.flat_axis * (across * squeeze);

  const dvec3 axis = cone.b - cone.a;
  const double length2 = dot(axis, axis), length = std::sqrt(length2);
  const dvec3 u = axis / length;
  const double along = dot(p - cone.a, u);
  const dvec3 off = (p - cone.a) - u * along;
  const double radial = lengthOf(off);
  // the touching ball's center lies behind the foot of the perpendicular by the cone's slope
  const double slope = (cone.radius_a - cone.radius_b) / length;
  const double t =
      glm::clamp((along - slope / std::sqrt(std::max(1e-12, 1.0 - slope * slope)) * radial) / length, 0.0, 1.0);
  const dvec3 from_center = p - (cone.a + axis * t);
  const double distance = lengthOf(from_center);
  const dvec3 g = distance > 0.0 ? from_center / distance : dvec3(0.0, 1.0, 0.0);
  return {scale * (distance - glm::mix(cone.radius_a, cone.radius_b, t)),
          scale * (g + cone.flat_axis * (dot(g, cone.flat_axis) * squeeze))};
}

/// k0 (k0 - 1) / k1 with k0 = |p / r|, k1 = |p / r^2|: exact on the surface, close to the distance near it.
Sample ellipsoidSample(const Primitive& e, const dvec3& point) {
  const dvec3 p = (point - e.a) * e.frame;  // row vector times matrix: coordinates in the frame
  const dvec3 q = p / e.radii, s = q / e.radii, w = s / e.radii / e.radii;
  const double k0 = lengthOf(q), k1 = lengthOf(s);
  if (k1 < 1e-9) return {-std::min({e.radii.x, e.radii.y, e.radii.z}), dvec3(0.0)};
  const dvec3 gradient = s * ((2.0 * k0 - 1.0) / (k0 * k1)) - w * (k0 * (k0 - 1.0) / (k1 * k1 * k1));
  return {k0 * (k0 - 1.0) / k1, e.frame * gradient};
}

Sample lensSample(const Primitive& lens, const dvec3& point) {
  const dvec3 from_a = point - lens.a, from_b = point - lens.b;
  const double a = lengthOf(from_a), b = lengthOf(from_b);
  if (a > b) return {a - lens.radius_a, from_a / a};
  return {b - lens.radius_a, b > 0.0 ? from_b / b : dvec3(0.0)};
}

/// The ellipsoid with a wave around its third axis, which dies out at the poles (slowly enough to leave it out of the
/// gradient).
Sample ridgesSample(const Primitive& e, const dvec3& point) {
  Sample sample = ellipsoidSample(e, point);
  const dvec3 p = (point - e.a) * e.frame;
  const double rho2 = p.x * p.x + p.y * p.y;
  if (rho2 < 1e-8 || std::fabs(sample.distance) > 4.0 * e.ridge_height) return sample;
  const double rho = std::sqrt(rho2), reach = e.radii.x;
  const double phase = e.ridge_count * exact::arcTangent2(p.x, p.y) + 1.4 * exact::sine(p.z / (0.22 * reach));
  const double fade = exact::smoothStep(0.2, 0.85, rho / reach) * exact::bump(sample.distance, 4.0 * e.ridge_height);
  const double amplitude = e.ridge_height * fade, slope = amplitude * exact::cosine(phase);
  const dvec3 wave = {slope * e.ridge_count * p.y / rho2, -slope * e.ridge_count * p.x / rho2,
                      slope * 1.4 / (0.22 * reach) * exact::cosine(p.z / (0.22 * reach))};
  sample.distance += amplitude * exact::sine(phase);
  sample.gradient += e.frame * wave;
  return sample;
}

Sample shapeSample(const Primitive& primitive, const dvec3& point) {
  switch (primitive.shape) {
    case Shape::kRoundCone:
      return roundConeSample(primitive, point);
    case Shape::kEllipsoid:
      return ellipsoidSample(primitive, point);
    case Shape::kLens:
      return lensSample(primitive, point);
    case Shape::kRidges:
      return ridgesSample(primitive, point);
    case Shape::kHalfSpace:
      break;
  }
  return {dot(point - primitive.a, primitive.flat_axis), primitive.flat_axis};
}

/// The quadratic smooth minimum: I. Quilez, "Smooth minimum" (2013).
Sample smoothMinimum(const Sample& x, const Sample& y, double blend) {
  const Sample &low = x.distance <= y.distance ? x : y, &high = x.distance <= y.distance ? y : x;
  const double gap = high.distance - low.distance;
  if (gap >= blend) return low;
  const double h = (blend - gap) / blend;
  return {low.distance - 0.25 * h * h * blend, low.gradient * (1.0 - 0.5 * h) + high.gradient * (0.5 * h)};
}

Sample negated(const Sample& sample) { return {-sample.distance, -sample.gradient}; }

Sample swollen(const Sample& sample, const Primitive& swell, const dvec3& point) {
  const double soft = swell.blend;
  const auto step = [&](double t) { return t <= 0.0 ? 0.0 : t >= 1.0 ? 1.0 : t * t * (3.0 - 2.0 * t); };
  const auto slope = [&](double t) { return t <= 0.0 || t >= 1.0 ? 0.0 : 6.0 * t * (1.0 - t) / soft; };
  const double from = (point.y - swell.a.y) / soft, to = (swell.b.y - point.y) / soft;
  const double rate = slope(from) * step(to) - step(from) * slope(to);
  return {sample.distance - swell.radius_a * step(from) * step(to),
          sample.gradient - dvec3(0.0, swell.radius_a * rate, 0.0)};
}

/// A primitive beyond this many blends has no say in where the surface is: the blends of several primitives in a row
/// can bring what lies at one blend's width down to less, but not to this.
constexpr double kBlendReach = 2.0;

struct Ball {
  dvec3 center;
  double radius;
};

Ball boundingBall(const Primitive& primitive) {
  if (primitive.shape == Shape::kEllipsoid || primitive.shape == Shape::kRidges) {
    return {primitive.a, std::max({primitive.radii.x, primitive.radii.y, primitive.radii.z}) + primitive.ridge_height};
  }
  const double widest = std::max(primitive.radius_a, primitive.radius_b) * std::max(1.0, primitive.flat_factor);
  return {0.5 * (primitive.a + primitive.b), 0.5 * lengthOf(primitive.b - primitive.a) + widest};
}

}  // namespace

Primitive roundCone(const dvec3& a, double radius_a, const dvec3& b, double radius_b, double blend) {
  Primitive cone;
  cone.a = a;
  cone.b = b;
  cone.radius_a = radius_a;
  cone.radius_b = radius_b;
  cone.blend = blend;
  return cone;
}

Primitive ellipsoid(const dvec3& center, const dvec3& radii, double blend) {
  Primitive primitive;
  primitive.shape = Shape::kEllipsoid;
  primitive.a = center;
  primitive.radii = radii;
  primitive.blend = blend;
  return primitive;
}

Primitive lens(const dvec3& center, double half_width, double half_height, double blend) {
  // balls of radius r at +-c above and below: r - c = half_height, r^2 - c^2 = half_width^2
  const double sum = half_width * half_width / half_height;
  const double c = 0.5 * (sum - half_height);
  Primitive primitive = roundCone(center + dvec3(0, c, 0), 0.5 * (sum + half_height), center - dvec3(0, c, 0),
                                  0.5 * (sum + half_height), blend);
  primitive.shape = Shape::kLens;
  return primitive;
}

Primitive mirrored(const Primitive& primitive) {
  const dvec3 flip(-1.0, 1.0, 1.0);
  Primitive image = primitive;
  image.a *= flip;
  image.b *= flip;
  image.flat_axis *= flip;
  for (int column = 0; column < 3; ++column) image.frame[column] *= flip;
  return image;
}

void Solid::add(const Primitive& primitive) {
  primitives_.push_back(primitive);
  widest_blend_ = std::max(widest_blend_, primitive.blend);
}

void Solid::cut(Primitive primitive) {
  primitive.operation = Operation::kCut;
  add(primitive);
}

void Solid::addPair(const Primitive& primitive) {
  add(primitive);
  add(mirrored(primitive));
}

void Solid::cutPair(const Primitive& primitive) {
  cut(primitive);
  cut(mirrored(primitive));
}

std::vector<uint32_t> Solid::activeNear(const dvec3& center, double radius) const {
  std::vector<uint32_t> active;
  for (uint32_t i = 0; i < primitives_.size(); ++i) {
    const Primitive& primitive = primitives_[i];
    double distance = 0.0;
    if (primitive.shape == Shape::kHalfSpace) {
      distance = dot(center - primitive.a, primitive.flat_axis);
    } else if (primitive.operation == Operation::kSwell) {
      distance = std::max(primitive.a.y - center.y, center.y - primitive.b.y);
    } else {
      const Ball ball = boundingBall(primitive);
      distance = lengthOf(center - ball.center) - ball.radius;
    }
    // far enough outside, a primitive changes nothing: not the surface, and not what later blends see near it
    if (distance < radius + kBlendReach * widest_blend_) active.push_back(i);
  }
  return active;
}

std::vector<uint32_t> Solid::activeAt(const dvec3& point, double reach, std::span<const uint32_t> candidates) const {
  std::vector<uint32_t> active;
  double blend = 0.0;  // the widest of those that come later: what lies beyond it is blended away by none of them
  for (size_t k = candidates.size(); k-- > 0;) {
    const Primitive& primitive = primitives_[candidates[k]];
    blend = std::max(blend, primitive.blend);
    const bool always = primitive.operation == Operation::kSwell;
    if (always || shapeSample(primitive, point).distance < kBlendReach * blend + reach) active.push_back(candidates[k]);
  }
  std::reverse(active.begin(), active.end());
  return active;
}

Sample Solid::sample(const dvec3& point, std::span<const uint32_t> active) const {
  Sample sum{1.0, dvec3(0.0)};
  for (uint32_t i : active) {
    const Primitive& primitive = primitives_[i];
    if (primitive.operation == Operation::kAdd) {
      sum = smoothMinimum(sum, shapeSample(primitive, point), primitive.blend);
    } else if (primitive.operation == Operation::kCut) {
      sum = negated(smoothMinimum(negated(sum), shapeSample(primitive, point), primitive.blend));
    } else {
      sum = swollen(sum, primitive, point);
    }
  }
  return sum;
}

uint16_t Solid::labelAt(const dvec3& point, std::span<const uint32_t> active) const {
  uint16_t label = 0;
  double nearest = std::numeric_limits<double>::max();
  for (uint32_t i : active) {
    if (primitives_[i].operation != Operation::kAdd) continue;
    const double distance = shapeSample(primitives_[i], point).distance;
    if (distance < nearest) {
      nearest = distance;
      label = primitives_[i].label;
    }
  }
  return label;
}

void Solid::bounds(dvec3& low, dvec3& high) const {
  low = dvec3(std::numeric_limits<double>::max());
  high = -low;
  for (const Primitive& primitive : primitives_) {
    if (primitive.operation != Operation::kAdd) continue;
    const Ball ball = boundingBall(primitive);
    low = glm::min(low, ball.center - ball.radius);
    high = glm::max(high, ball.center + ball.radius);
  }
}

}  // namespace lithe::bake::implicit
