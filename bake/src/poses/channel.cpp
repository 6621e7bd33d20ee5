// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "channel.h"

#include <algorithm>
#include <cmath>

#include "palette.h"

namespace lithe::bake {

namespace {

enum class SplinePart : size_t { kInTangent = 0, kValue = 1, kOutTangent = 2 };

glm::dvec4 splineKey(const Channel& channel, size_t key, SplinePart part) {
  return channel.values[key * 3 + static_cast<size_t>(part)];
}

glm::dvec4 keyValue(const Channel& channel, size_t key) {
  const bool cubic = channel.interpolation == Channel::Interpolation::kCubicSpline;
  return cubic ? splineKey(channel, key, SplinePart::kValue) : glm::dvec4(channel.values[key]);
}

glm::dvec4 hermite(const Channel& channel, size_t key, double u, double seconds) {
  const double u2 = u * u, u3 = u2 * u;
  return (2 * u3 - 3 * u2 + 1) * splineKey(channel, key, SplinePart::kValue) +
         seconds * (u3 - 2 * u2 + u) * splineKey(channel, key, SplinePart::kOutTangent) +
         (-2 * u3 + 3 * u2) * splineKey(channel, key + 1, SplinePart::kValue) +
         seconds * (u3 - u2) * splineKey(channel, key + 1, SplinePart::kInTangent);
}

glm::dvec4 unit(const glm::dvec4& q) {
  const double length = std::sqrt(glm::dot(q, q));
  return length > 0.0 ? q / length : glm::dvec4(0.0, 0.0, 0.0, 1.0);
}

glm::dvec4 slerp(const glm::dvec4& a, glm::dvec4 b, double u) {
  double cosine = glm::dot(a, b);
  if (cosine < 0.0) {
    b = -b;
    cosine = -cosine;
  }
  double share_a = 1.0 - u, share_b = u;
  // Below half a thousandth of a radian the sine's quotient is worse than the straight line.
  if (cosine < 0.9999995) {
    const double angle = std::acos(cosine);
    share_a = std::sin((1.0 - u) * angle) / std::sin(angle);
    share_b = std::sin(u * angle) / std::sin(angle);
  }
  return unit(a * share_a + b * share_b);
}

glm::dvec4 between(const Channel& channel, size_t key, double time) {
  const double begin = channel.times[key], seconds = channel.times[key + 1] - begin;
  const double u = seconds > 0.0 ? (time - begin) / seconds : 0.0;
  switch (channel.interpolation) {
    case Channel::Interpolation::kStep:
      return keyValue(channel, key);
    case Channel::Interpolation::kCubicSpline:
      return hermite(channel, key, u, seconds);
    case Channel::Interpolation::kLinear:
      break;
  }
  const glm::dvec4 a = keyValue(channel, key), b = keyValue(channel, key + 1);
  if (channel.path == Channel::Path::kRotation) return slerp(unit(a), unit(b), u);
  return a * (1.0 - u) + b * u;
}

glm::dvec4 valueAt(const Channel& channel, double time) {
  const size_t keys = channel.times.size();
  if (keys == 1 || !(time > channel.times.front())) return keyValue(channel, 0);
  if (time >= channel.times.back()) return keyValue(channel, keys - 1);
  const auto later = std::upper_bound(channel.times.begin(), channel.times.end(), time,
                                      [](double t, float key) { return t < static_cast<double>(key); });
  return between(channel, static_cast<size_t>(later - channel.times.begin()) - 1, time);
}

}  // namespace

void applyChannel(const Channel& channel, double time, Transform& local) {
  if (channel.times.empty()) return;
  const glm::dvec4 value = valueAt(channel, time);
  switch (channel.path) {
    case Channel::Path::kTranslation:
      local.translation = glm::dvec3(value);
      break;
    case Channel::Path::kRotation:
      local.rotation = glm::dquat(value.w, value.x, value.y, value.z);
      break;
    case Channel::Path::kScale:
      local.scale = glm::dvec3(value);
      break;
  }
}

}  // namespace lithe::bake
