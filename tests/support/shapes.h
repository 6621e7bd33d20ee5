// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Meshes and small characters for the tests of distances and comparisons.
#pragma once

#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "lithe/bake/model.h"
#include "lithe/bake/nearest.h"

namespace lithe::bake::test {

struct Shape {
  std::vector<glm::dvec3> positions;
  std::vector<Triangle> triangles;
};

inline glm::dvec3 randomPoint(std::mt19937_64& random, double extent) {
  std::uniform_real_distribution<double> unit(-extent, extent);
  const double x = unit(random), y = unit(random), z = unit(random);
  return {x, y, z};
}

/// Triangles of all sizes at random places, slivers, segments and points among them.
inline Shape randomSoup(uint32_t triangles, uint64_t seed) {
  std::mt19937_64 random(seed);
  Shape soup;
  for (uint32_t i = 0; i < triangles; ++i) {
    const glm::dvec3 centre = randomPoint(random, 1.0);
    const double size = std::pow(10.0, -3.0 * (i % 5) / 4.0);
    const glm::dvec3 a = centre + randomPoint(random, size), b = centre + randomPoint(random, size);
    const glm::dvec3 c = i % 17 == 0 ? a : i % 13 == 0 ? 0.3 * a + 0.7 * b : centre + randomPoint(random, size);
    const uint32_t first = static_cast<uint32_t>(soup.positions.size());
    soup.positions.insert(soup.positions.end(), {a, i % 29 == 0 ? a : b, c});
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

/// A square [0, size]^2 in the plane z = height, facing +z, cells x cells quads.
inline Shape square(double size, double height, uint32_t cells) {
  Shape shape;
  for (uint32_t y = 0; y <= cells; ++y) {
    for (uint32_t x = 0; x <= cells; ++x) shape.positions.emplace_back(size * x / cells, size * y / cells, height);
  }
  for (uint32_t y = 0; y < cells; ++y) {
    for (uint32_t x = 0; x < cells; ++x) {
      const uint32_t corner = y * (cells + 1) + x;
      shape.triangles.push_back({corner, corner + 1, corner + cells + 2});
      shape.triangles.push_back({corner, corner + cells + 2, corner + cells + 1});
    }
  }
  return shape;
}

/// An open tube around the z axis, radius 0.5, from z = 0 to z = 4, on the joints `root` (z = 0) and `elbow` (z = 2);
/// the weights pass linearly from one to the other between z = 1 and z = 3. It has a seam: the first and the last
/// vertex of a ring coincide. uv = (around, z). The clip `bend`, 1 s, turns the elbow by 90 degrees about x; `still`, 2
/// s, keeps it.
class TubeMaker {
 public:
  TubeMaker(uint32_t around, uint32_t rings) : around_(around), rings_(rings) {}

  Model make() {
    addSkeleton();
    addClip("bend", 1.0, std::sqrt(0.5));
    addClip("still", 2.0, 0.0);
    for (uint32_t ring = 0; ring <= rings_; ++ring) {
      for (uint32_t step = 0; step <= around_; ++step) addVertex(step, 4.0 * ring / rings_);
    }
    for (uint32_t ring = 0; ring < rings_; ++ring) {
      for (uint32_t step = 0; step < around_; ++step) addQuad(ring * (around_ + 1) + step);
    }
    model_.triangle_part.assign(model_.triangles.size(), 0);
    model_.rest_diagonal = std::sqrt(1.0 + 1.0 + 16.0);
    return std::move(model_);
  }

 private:
  void addSkeleton() {
    model_.nodes = {{"root", kNone, {}}, {"elbow", 0, {{0.0, 0.0, 2.0}}}};
    glm::dmat4 from_elbow(1.0);
    from_elbow[3] = {0.0, 0.0, -2.0, 1.0};
    model_.joints = {{0, glm::dmat4(1.0)}, {1, from_elbow}};
    model_.materials = {"rubber"};
    model_.parts = {{"tube", 0, kNone, 0, 0}};
    model_.attributes.normal = true;
    model_.attributes.uv_sets = 1;
  }

  void addClip(const char* name, double duration, double sine) {
    Channel channel;
    channel.node = 1;
    channel.path = Channel::Path::kRotation;
    channel.times = {0.0f, static_cast<float>(duration)};
    channel.values = {{0, 0, 0, 1}, {sine, 0, 0, std::sqrt(1.0 - sine * sine)}};
    model_.clips.push_back({name, 0.0, duration, {channel}});
  }

  void addVertex(uint32_t step, double z) {
    const double angle = 6.283185307179586 * (step % around_) / around_;
    const glm::dvec3 normal(std::cos(angle), std::sin(angle), 0.0);
    model_.positions.emplace_back(glm::dvec3(0.5 * normal.x, 0.5 * normal.y, z));
    model_.normals.emplace_back(normal);
    model_.uvs[0].emplace_back(static_cast<float>(step) / static_cast<float>(around_), static_cast<float>(z / 4.0));
    const float elbow = static_cast<float>(std::min(1.0, std::max(0.0, (z - 1.0) / 2.0)));
    Skin skin;
    if (elbow < 1.0f) addInfluence(skin, 0, 1.0f - elbow);
    if (elbow > 0.0f) addInfluence(skin, 1, elbow);
    if (skin.count == 2 && skin.weight[1] > skin.weight[0]) {
      std::swap(skin.weight[0], skin.weight[1]);
      std::swap(skin.joint[0], skin.joint[1]);
    }
    model_.skins.push_back(skin);
  }

  static void addInfluence(Skin& skin, uint16_t joint, float weight) {
    skin.joint[skin.count] = joint;
    skin.weight[skin.count++] = weight;
  }

  void addQuad(uint32_t corner) {
    const uint32_t above = corner + around_ + 1;
    model_.triangles.push_back({corner, corner + 1, above + 1});
    model_.triangles.push_back({corner, above + 1, above});
  }

  uint32_t around_, rings_;
  Model model_;
};

inline Model tube(uint32_t around, uint32_t rings) { return TubeMaker(around, rings).make(); }

}  // namespace lithe::bake::test
