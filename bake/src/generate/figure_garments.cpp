// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// What the figure wears: the body's surface is cut along the edges of its shorts and its hair.
#include <algorithm>
#include <cmath>

#include "contour_cut.h"
#include "figure.h"
#include "mesh_relax.h"

namespace lithe::bake::figure {
namespace {

using glm::dvec3;

/// At the height of the shorts the arms are farther out than this, the legs nearer.
constexpr double kOutsideLegs = 0.3;
constexpr uint32_t kHairRounds = 6;

/// Above 0 where there are shorts.
double shortsAt(const dvec3& p) {
  const double inside = std::min(p.y - kHem, kWaistband - p.y);
  return std::fabs(p.x) < kOutsideLegs ? inside : -1.0;
}

/// Above 0 where the hair cap is on top; averaged over neighbours, so that its edge is a simple line.
std::vector<double> hairField(const ClosedMesh& mesh) {
  const uint32_t count = static_cast<uint32_t>(mesh.positions.size());
  const Neighbours neighbours = neighboursOf(count, mesh.triangles);
  std::vector<double> hair;
  for (const uint16_t label : mesh.labels) hair.push_back(label == kHairCap ? 1.0 : 0.0);
  for (uint32_t round = 0; round < kHairRounds; ++round) {
    const std::vector<double> before = hair;
    for (uint32_t v = 0; v < count; ++v) {
      for (uint32_t i = neighbours.first[v]; i < neighbours.first[v + 1]; ++i) hair[v] += before[neighbours.list[i]];
      hair[v] /= neighbours.first[v + 1] - neighbours.first[v] + 1;
    }
  }
  for (double& value : hair) value -= 0.5;
  return hair;
}

/// Moves what the cuts interpolated back onto the flesh, along `allowed` axes only.
void ontoFlesh(const implicit::Solid& flesh, const std::vector<uint32_t>& vertices, const dvec3& allowed,
               ClosedMesh& mesh) {
  constexpr double kReach = 0.01;
  for (const uint32_t v : vertices) {
    dvec3& p = mesh.positions[v];
    const std::vector<uint32_t> active = flesh.activeNear(p, kReach);
    for (int step = 0; step < 2; ++step) {
      const implicit::Sample s = flesh.sample(p, active);
      const dvec3 along = s.gradient * allowed;
      p -= along * (s.distance / std::max(0.04, glm::dot(along, along)));
    }
    mesh.normals[v] = glm::normalize(flesh.sample(p, active).gradient);
  }
}

double sumOf(const std::vector<double>& value, const std::array<uint32_t, 3>& triangle) {
  return value[triangle[0]] + value[triangle[1]] + value[triangle[2]];
}

}  // namespace

std::vector<PartIndex> dress(const implicit::Solid& flesh, ClosedMesh& mesh) {
  std::vector<double> hair = hairField(mesh);
  ontoFlesh(flesh, cutAlong(mesh, hair), dvec3(1.0), mesh);
  std::vector<double> shorts;
  for (const dvec3& p : mesh.positions) shorts.push_back(shortsAt(p));
  const std::vector<uint32_t> edge = cutAlong(mesh, shorts);
  ontoFlesh(flesh, edge, {1.0, 0.0, 1.0}, mesh);
  hair.resize(mesh.positions.size(), -0.5);  // the edges of the shorts are far from it
  std::vector<PartIndex> parts;
  for (const auto& triangle : mesh.triangles) {
    parts.push_back(sumOf(hair, triangle) > 0.0 ? kHair : sumOf(shorts, triangle) > 0.0 ? kShorts : kSkin);
  }
  return parts;
}

}  // namespace lithe::bake::figure
