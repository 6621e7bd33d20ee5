// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "range.h"

#include <algorithm>
#include <cmath>

namespace lithe::bake {

namespace {

/// In the file's units: a light year in metres is 1e16, and the square of this is far from a float's largest number.
constexpr double kFarthest = 1e15;
/// The largest component of a vector, times this, is at least its length.
constexpr double kAxes = 1.7320508075688773;

double largestComponent(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// Bounds of what a node's own transform can do, at rest and in any clip.
struct Bound {
  double shift = 0.0, scale = 0.0;
};

/// A cubic spline's tangents count for as long as its longest segment.
double largestValue(const Channel& channel) {
  double longest = 0.0, largest = 0.0;
  for (size_t i = 1; i < channel.times.size(); ++i) {
    longest = std::max(longest, static_cast<double>(channel.times[i]) - static_cast<double>(channel.times[i - 1]));
  }
  for (const glm::vec4& value : channel.values) largest = std::max(largest, largestComponent(glm::dvec3(value)));
  const bool cubic = channel.interpolation == Channel::Interpolation::kCubicSpline;
  return cubic ? largest * (1.0 + 2.0 * longest) : largest;
}

std::vector<Bound> ownBounds(const Model& model) {
  std::vector<Bound> bounds;
  for (const Node& node : model.nodes) {
    bounds.push_back({largestComponent(node.rest.translation), largestComponent(node.rest.scale)});
  }
  for (const Clip& clip : model.clips) {
    for (const Channel& channel : clip.channels) {
      Bound& bound = bounds[channel.node];
      const double value = largestValue(channel);
      if (channel.path == Channel::Path::kTranslation) bound.shift = std::max(bound.shift, value);
      if (channel.path == Channel::Path::kScale) bound.scale = std::max(bound.scale, value);
    }
  }
  return bounds;
}

/// The same down to the root. Nodes come after their parents.
std::vector<Bound> worldBounds(const Model& model) {
  std::vector<Bound> bounds = ownBounds(model);
  for (size_t i = 0; i < bounds.size(); ++i) {
    bounds[i].shift *= kAxes;
    if (model.nodes[i].parent == kNone) continue;
    const Bound& parent = bounds[model.nodes[i].parent];
    bounds[i].shift = parent.shift + parent.scale * bounds[i].shift;
    bounds[i].scale *= parent.scale;
  }
  return bounds;
}

/// How far from the origin a matrix can take points that are at most `radius` away from it.
double reachOf(const glm::dmat4& matrix, double radius) {
  double linear = 0.0;
  for (int column = 0; column < 3; ++column) linear += largestComponent(glm::dvec3(matrix[column])) * kAxes;
  return linear * radius + largestComponent(glm::dvec3(matrix[3])) * kAxes;
}

}  // namespace

void requireRange(const FileName& name, const Model& model) {
  double radius = 0.0;
  for (const glm::vec3& position : model.positions) {
    // A NaN would slip through std::max.
    const double distance = glm::length(glm::dvec3(position));
    if (!(distance <= kFarthest))
      name.fail("", "vertices are farther than 1e15 units away; scale it down and export it again");
    radius = std::max(radius, distance);
  }
  const std::vector<Bound> bounds = worldBounds(model);
  for (const Joint& joint : model.joints) {
    const double reach = bounds[joint.node].shift + bounds[joint.node].scale * reachOf(joint.inverse_bind, radius);
    if (reach <= kFarthest) continue;
    const std::string& node = model.nodes[joint.node].name;
    name.fail(node.empty() ? "a node without a name" : "node '" + node + "'",
              "its transforms, inverse bind or clips carry vertices farther than 1e15 units away; re-export the file");
  }
}

}  // namespace lithe::bake
