// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include "candidates.h"
#include "lithe/bake/poses.h"

namespace lithe::bake {

namespace {

/// Vertices that stand for all in the distance between two poses.
constexpr size_t kProbes = 512;
/// Poses closer than this part of the rest pose's radius are the same.
constexpr double kSamePose = 1e-5;

/// Posed probe vertices relative to their centroid: where the character stands is no part of its shape.
using Shape = std::vector<glm::dvec3>;

/// A model of every n-th vertex, to pose instead of the whole.
Model probeModel(const Model& model) {
  Model probes;
  const size_t count = std::min(kProbes, model.positions.size());
  for (size_t i = 0; i < count; ++i) {
    const size_t vertex = i * model.positions.size() / count;
    probes.positions.push_back(model.positions[vertex]);
    probes.skins.push_back(model.skins[vertex]);
  }
  return probes;
}

Shape shapeOf(const Model& probes, const Pose& pose) {
  Shape shape = skinPositions(probes, pose);
  glm::dvec3 centroid(0.0);
  for (const glm::dvec3& p : shape) centroid += p;
  centroid /= static_cast<double>(std::max<size_t>(shape.size(), 1));
  for (glm::dvec3& p : shape) p -= centroid;
  return shape;
}

double squaredDistance(const Shape& a, const Shape& b) {
  double sum = 0.0;
  for (size_t i = 0; i < a.size(); ++i) sum += glm::dot(a[i] - b[i], a[i] - b[i]);
  return sum / static_cast<double>(std::max<size_t>(a.size(), 1));
}

/// The squared root mean square distance from the centroid.
double squaredRadius(const Shape& shape) { return squaredDistance(shape, Shape(shape.size(), glm::dvec3(0.0))); }

size_t farthest(const std::vector<double>& distance) {
  return static_cast<size_t>(std::max_element(distance.begin(), distance.end()) - distance.begin());
}

/// Indices of at most `count` shapes, the one farthest from rest first, then each time the one farthest from all
/// chosen.
std::vector<size_t> kCentre(const std::vector<Shape>& shapes, const Shape& rest, uint32_t count) {
  std::vector<double> from_rest;
  for (const Shape& shape : shapes) from_rest.push_back(squaredDistance(shape, rest));
  std::vector<size_t> chosen{farthest(from_rest)};
  std::vector<double> from_chosen(shapes.size(), std::numeric_limits<double>::infinity());
  const double same = kSamePose * kSamePose * squaredRadius(rest);
  while (chosen.size() < count) {
    const Shape& latest = shapes[chosen.back()];
    for (size_t i = 0; i < shapes.size(); ++i) {
      from_chosen[i] = std::min(from_chosen[i], squaredDistance(shapes[i], latest));
    }
    const size_t next = farthest(from_chosen);
    if (!(from_chosen[next] > same)) break;
    chosen.push_back(next);
  }
  return chosen;
}

std::vector<Pose> posesFromClips(const Model& model, const PoseOptions& options) {
  const std::vector<Pose> candidates = clipCandidates(model, findClips(model, options.clips));
  const Model probes = probeModel(model);
  std::vector<Shape> shapes;
  for (const Pose& pose : candidates) shapes.push_back(shapeOf(probes, pose));
  std::vector<Pose> poses;
  for (const size_t i : kCentre(shapes, shapeOf(probes, restPose(model)), options.count))
    poses.push_back(candidates[i]);
  return poses;
}

std::vector<Pose> posesWithoutClips(const Model& model, uint32_t count) {
  std::vector<Pose> poses{restPose(model)};
  for (Pose& pose : sampledPoses(model, count - 1)) poses.push_back(std::move(pose));
  return poses;
}

}  // namespace

std::vector<Pose> choosePoses(const Model& model, const PoseOptions& options) {
  if (!options.file.empty()) return readPoseFile(model, options.file);
  if (options.count == 0) throw Error("a bake needs at least one example pose; ask for 1 or more");
  if (!model.clips.empty()) return posesFromClips(model, options);
  findClips(model, options.clips);  // a name asked for in vain is an error, not a reason to sample
  return posesWithoutClips(model, options.count);
}

}  // namespace lithe::bake
