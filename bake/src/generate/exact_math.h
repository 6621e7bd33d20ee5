// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Elementary functions made of IEEE additions, products, quotients and square roots only: libm's last bit differs
/// between machines, and a generated character must not. Absolute errors are below 1e-14.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace lithe::bake::exact {

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kTau = 2.0 * kPi;

inline constexpr double radians(double degrees) { return degrees * (kPi / 180.0); }

/// sin and cos of |x| <= pi / 4 by their Taylor series, highest power first (Horner).
inline double sineKernel(double x) {
  const double y = x * x;
  double sum = 0.0;
  for (int n = 19; n >= 3; n -= 2) sum = (1.0 + sum) * (-y / (n * (n - 1.0)));
  return x * (1.0 + sum);
}
inline double cosineKernel(double x) {
  const double y = x * x;
  double sum = 0.0;
  for (int n = 18; n >= 2; n -= 2) sum = (1.0 + sum) * (-y / (n * (n - 1.0)));
  return 1.0 + sum;
}

/// sin(x + quarter * pi / 2), x in radians, |x| up to some thousands.
inline double sineOfQuarter(double x, int64_t quarter) {
  const double turns = std::floor(x * (2.0 / kPi) + 0.5);
  const double r = (x - turns * 1.57079632679489655800) - turns * 6.12323399573676603587e-17;
  switch ((static_cast<int64_t>(turns) + quarter) & 3) {
    case 0:
      return sineKernel(r);
    case 1:
      return cosineKernel(r);
    case 2:
      return -sineKernel(r);
    default:
      return -cosineKernel(r);
  }
}
inline double sine(double x) { return sineOfQuarter(x, 0); }
inline double cosine(double x) { return sineOfQuarter(x, 1); }

/// atan(t), 0 <= t <= 1: three halvings atan(t) = 2 atan(t / (1 + sqrt(1 + t^2))) bring t below 0.1, then the series.
inline double arcTangentKernel(double t) {
  for (int i = 0; i < 3; ++i) t = t / (1.0 + std::sqrt(1.0 + t * t));
  const double y = t * t;
  double sum = 0.0;
  for (int n = 17; n >= 3; n -= 2) sum = -y * (1.0 / n + sum);
  return 8.0 * t * (1.0 + sum);
}

/// The angle of (x, y) in (-pi, pi]; 0 for the zero vector.
inline double arcTangent2(double y, double x) {
  const double ax = std::fabs(x), ay = std::fabs(y);
  if (ax == 0.0 && ay == 0.0) return 0.0;
  double angle = ay <= ax ? arcTangentKernel(ay / ax) : kPi / 2.0 - arcTangentKernel(ax / ay);
  if (x < 0.0) angle = kPi - angle;
  return y < 0.0 ? -angle : angle;
}
inline double arcCosine(double c) {
  c = glm::clamp(c, -1.0, 1.0);
  return arcTangent2(std::sqrt((1.0 - c) * (1.0 + c)), c);
}

/// The rotation by |v| radians about v.
inline glm::dquat rotation(const glm::dvec3& v) {
  const double angle = std::sqrt(glm::dot(v, v));
  if (angle == 0.0) return {1.0, 0.0, 0.0, 0.0};
  const glm::dvec3 q = v * (sine(0.5 * angle) / angle);
  return {cosine(0.5 * angle), q.x, q.y, q.z};
}
inline glm::dquat rotation(const glm::dvec3& unit_axis, double angle) { return rotation(unit_axis * angle); }

/// 0 below a, 1 above b, C2 between: 6t^5 - 15t^4 + 10t^3.
inline double smoothStep(double a, double b, double x) {
  const double t = glm::clamp((x - a) / (b - a), 0.0, 1.0);
  return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}
/// A smooth bump: 1 at x = 0, 0 for |x| >= width.
inline double bump(double x, double width) {
  const double t = glm::clamp(1.0 - (x * x) / (width * width), 0.0, 1.0);
  return t * t;
}

}  // namespace lithe::bake::exact
