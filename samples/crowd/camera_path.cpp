// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "camera_path.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {

struct Key {
  float seconds;
  glm::vec3 position, target;
};

// Metres. The three characters of the group stand around the origin; see crowd.cpp.
constexpr std::array<Key, 7> kKeys{{{0.0f, {6.0f, 27.0f, 58.0f}, {0.0f, 0.0f, 4.0f}},
                                    {5.0f, {-20.0f, 10.0f, 34.0f}, {0.0f, 1.0f, 4.0f}},
                                    {9.0f, {-9.0f, 3.4f, 17.0f}, {0.5f, 0.8f, 0.0f}},
                                    {13.0f, {-2.4f, 1.7f, 6.4f}, {0.2f, 0.8f, 0.0f}},
                                    {17.0f, {0.2f, 1.45f, 3.3f}, {0.05f, 0.85f, 0.0f}},
                                    {20.0f, {0.42f, 1.70f, 1.05f}, {0.0f, 1.58f, 0.0f}},
                                    {26.0f, {16.0f, 9.0f, 26.0f}, {0.0f, 0.5f, 0.0f}}}};

constexpr float kLowHeight = 3.6f;   ///< below it the camera may meet somebody's head
constexpr float kFreeRadius = 1.5f;  ///< around the low part of the path

/// The slope of a cubic through uneven keys: the difference of the neighbours; the path starts and ends at rest.
glm::vec3 slope(size_t key, glm::vec3 Key::*value) {
  if (key == 0 || key + 1 == kKeys.size()) return glm::vec3(0);
  return (kKeys[key + 1].*value - kKeys[key - 1].*value) / (kKeys[key + 1].seconds - kKeys[key - 1].seconds);
}

glm::vec3 between(size_t before, float seconds, glm::vec3 Key::*value) {
  const Key &a = kKeys[before], &b = kKeys[before + 1];
  const float length = b.seconds - a.seconds, t = (seconds - a.seconds) / length, u = 1 - t;
  return (1 + 2 * t) * u * u * (a.*value) + t * u * u * length * slope(before, value) +
         t * t * (3 - 2 * t) * (b.*value) - t * t * u * length * slope(before + 1, value);
}

}  // namespace

double cameraPathSeconds() { return kKeys.back().seconds; }

sample::Camera cameraAt(double seconds) {
  const float at = std::clamp(static_cast<float>(seconds), kKeys.front().seconds, kKeys.back().seconds);
  size_t before = 0;
  while (before + 2 < kKeys.size() && kKeys[before + 1].seconds <= at) ++before;
  return {between(before, at, &Key::position), between(before, at, &Key::target), glm::radians(45.0f)};
}

bool isInCamerasWay(const glm::vec3& position) {
  for (double seconds = 0; seconds <= cameraPathSeconds(); seconds += 0.1) {
    const glm::vec3 eye = cameraAt(seconds).position;
    if (eye.y < kLowHeight && std::hypot(eye.x - position.x, eye.z - position.z) < kFreeRadius) return true;
  }
  return false;
}
