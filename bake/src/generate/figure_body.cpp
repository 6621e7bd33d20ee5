// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Flesh of trunk and legs, muscle by muscle; only the left of a pair is stated.
#include <utility>

#include "figure.h"

namespace lithe::bake::figure {
namespace {

using glm::dvec3;
using implicit::ellipsoid;
using implicit::Primitive;
using implicit::roundCone;
using implicit::Solid;

Primitive flattened(Primitive primitive, const dvec3& axis, double factor) {
  primitive.flat_axis = glm::normalize(axis);
  primitive.flat_factor = factor;
  return primitive;
}

/// An ellipsoid whose second axis points along `up` and whose third faces `front`, as nearly as it can.
Primitive turned(Primitive primitive, const dvec3& up, const dvec3& front) {
  const dvec3 y = glm::normalize(up), x = glm::normalize(glm::cross(y, front));
  primitive.frame = glm::dmat3(x, y, glm::cross(x, y));
  return primitive;
}

void addBelly(Solid& solid) {
  solid.add(ellipsoid({0, 1.085, 0.000}, {0.127, 0.170, 0.096}, 0.05));
  solid.add(ellipsoid({0, 0.965, -0.005}, {0.160, 0.120, 0.108}, 0.06));
  solid.addPair(turned(ellipsoid({0.108, 1.045, 0.010}, {0.045, 0.085, 0.075}, 0.04), {0.10, 1, 0.1}, {0, 0, 1}));
  solid.addPair(roundCone({0.036, 1.215, 0.078}, 0.030, {0.030, 0.985, 0.070}, 0.030, 0.025));
  solid.cut(roundCone({0, 1.230, 0.121}, 0.004, {0, 1.075, 0.114}, 0.003, 0.022));
  // the upper ones lie farther out, where the ribs lift the surface: deeper they would be too narrow for the lattice
  for (const auto& [y, z] : {std::pair(1.195, 0.128), std::pair(1.142, 0.123), std::pair(1.088, 0.122)}) {
    solid.cutPair(roundCone({0.008, y, z}, 0.003, {0.058, y + 0.006, z - 0.019}, 0.002, 0.018));
  }
  solid.cut(ellipsoid({0, 1.050, 0.108}, {0.005, 0.008, 0.009}, 0.014));
}

void addBreast(Solid& solid) {
  solid.add(ellipsoid({0, 1.270, -0.012}, {0.150, 0.195, 0.112}, 0.05));
  solid.add(flattened(roundCone({-0.120, 1.385, -0.025}, 0.072, {0.120, 1.385, -0.025}, 0.072, 0.06), {0, 0, 1}, 0.95));
  solid.addPair(turned(ellipsoid({0.074, 1.318, 0.062}, {0.080, 0.058, 0.046}, 0.028), {-0.25, 1, 0.35}, {0.25, 0, 1}));
  solid.cut(roundCone({0, 1.37, 0.112}, 0.006, {0, 1.265, 0.128}, 0.004, 0.03));
  solid.addPair(ellipsoid({0.082, 1.290, 0.101}, {0.006, 0.006, 0.004}, 0.012));
  // flank: the broad back muscle and the ribs' teeth
  solid.addPair(roundCone({0.138, 1.325, -0.050}, 0.048, {0.108, 1.120, -0.040}, 0.028, 0.05));
  for (int i = 0; i < 3; ++i) {
    const double y = 1.235 - 0.032 * i;
    solid.addPair(roundCone({0.136 - 0.004 * i, y, 0.018}, 0.010, {0.108 - 0.004 * i, y - 0.022, 0.058}, 0.007, 0.024));
  }
}

void addBack(Solid& solid) {
  solid.addPair(turned(ellipsoid({0.080, 1.340, -0.098}, {0.060, 0.078, 0.028}, 0.035), {0.15, 1, 0.1}, {0.3, 0, -1}));
  solid.addPair(roundCone({0.034, 1.30, -0.093}, 0.030, {0.032, 1.02, -0.080}, 0.028, 0.03));
  solid.addPair(roundCone({0.020, 1.505, -0.052}, 0.032, {0.150, 1.428, -0.040}, 0.030, 0.045));
  solid.cut(roundCone({0, 1.40, -0.138}, 0.008, {0, 1.00, -0.117}, 0.006, 0.03));
  solid.addPair(turned(ellipsoid({0.076, 0.905, -0.070}, {0.085, 0.098, 0.078}, 0.035), {0.1, 1, 0.1}, {0, 0, -1}));
  solid.cut(roundCone({0, 0.955, -0.150}, 0.006, {0, 0.850, -0.140}, 0.008, 0.02));
}

void addNeck(Solid& solid) {
  solid.add(flattened(roundCone({0, 1.420, -0.038}, 0.061, {0, 1.565, -0.030}, 0.0475, 0.035), {1, 0, 0}, 0.98));
  solid.addPair(roundCone({0.047, 1.580, -0.020}, 0.012, {0.014, 1.437, 0.026}, 0.010, 0.022));
  solid.addPair(roundCone({0.018, 1.428, 0.040}, 0.0115, {0.150, 1.438, -0.010}, 0.012, 0.02));
  solid.cut(ellipsoid({0, 1.436, 0.054}, {0.014, 0.016, 0.012}, 0.035));
  solid.add(ellipsoid({0, 1.492, 0.026}, {0.011, 0.016, 0.012}, 0.018));
}

void addThigh(Solid& solid, const Anatomy& a) {
  solid.addPair(roundCone({0.096, 0.900, -0.004}, 0.082, a.knee + dvec3(0, 0.02, -0.002), 0.051, 0.028));
  solid.addPair(turned(ellipsoid({0.106, 0.700, 0.030}, {0.055, 0.170, 0.052}, 0.03), {0.02, 1, 0}, {0, 0, 1}));
  solid.addPair(turned(ellipsoid({0.098, 0.690, -0.034}, {0.055, 0.165, 0.048}, 0.03), {0, 1, 0.05}, {0, 0, -1}));
  solid.addPair(ellipsoid({0.072, 0.795, -0.004}, {0.046, 0.110, 0.058}, 0.02));
  solid.addPair(ellipsoid({0.076, 0.562, 0.028}, {0.027, 0.052, 0.028}, 0.025));
  solid.addPair(ellipsoid({0.124, 0.590, 0.026}, {0.025, 0.060, 0.028}, 0.025));
  solid.addPair(ellipsoid({0.098, 0.503, 0.043}, {0.025, 0.031, 0.018}, 0.022));
  solid.cutPair(ellipsoid({0.098, 0.500, -0.062}, {0.018, 0.035, 0.016}, 0.03));
}

void addShin(Solid& solid, const Anatomy& a) {
  solid.addPair(roundCone(a.knee + dvec3(0, -0.015, -0.004), 0.049, a.ankle + dvec3(0, 0.01, 0.006), 0.030, 0.035));
  solid.addPair(turned(ellipsoid({0.083, 0.372, -0.036}, {0.037, 0.100, 0.041}, 0.028), {0.04, 1, 0}, {0, 0, -1}));
  solid.addPair(turned(ellipsoid({0.117, 0.385, -0.030}, {0.035, 0.092, 0.039}, 0.028), {-0.02, 1, 0}, {0, 0, -1}));
  solid.addPair(roundCone({0.096, 0.455, 0.034}, 0.021, {0.101, 0.130, 0.002}, 0.018, 0.03));
  solid.addPair(roundCone({0.102, 0.260, -0.048}, 0.019, {0.104, 0.060, -0.064}, 0.015, 0.03));
  solid.addPair(ellipsoid({0.075, 0.090, -0.016}, {0.012, 0.016, 0.014}, 0.018));
  solid.addPair(ellipsoid({0.132, 0.082, -0.024}, {0.011, 0.016, 0.014}, 0.018));
}

void addFoot(Solid& solid, const Anatomy& a) {
  solid.addPair(ellipsoid({0.105, 0.034, -0.052}, {0.032, 0.038, 0.036}, 0.025));
  solid.addPair(roundCone(a.ankle + dvec3(0, -0.022, 0.010), 0.032, {0.112, 0.034, 0.078}, 0.027, 0.05));
  solid.addPair(turned(ellipsoid({0.117, 0.025, 0.092}, {0.046, 0.025, 0.042}, 0.025), {0, 1, 0.15}, {0.1, 0, 1}));
  solid.addPair(roundCone({0.140, 0.022, 0.060}, 0.022, {0.128, 0.024, -0.030}, 0.024, 0.02));
  // neighbours overlap all the way: a groove between two toes, never a gap too narrow for the lattice
  const std::array<std::array<double, 4>, 5> toes = {{{0.0900, 0.170, 0.0145, 0.0},
                                                      {0.1130, 0.171, 0.0115, 0.002},
                                                      {0.1315, 0.165, 0.0110, 0.004},
                                                      {0.1490, 0.156, 0.0105, 0.006},
                                                      {0.1655, 0.145, 0.0100, 0.008}}};
  for (const auto& [x, z, r, pull] : toes) {
    const dvec3 tip(x, r * 0.95, z), root(0.7 * x + 0.034, 0.022, 0.110 - pull);
    const dvec3 knuckle = glm::mix(root, tip, 0.6) + dvec3(0, 0.006, 0);
    solid.addPair(roundCone(root, r, knuckle, r * 0.92, 0.004));
    solid.addPair(roundCone(knuckle, r * 0.92, tip, r, 0.001));
  }
}

}  // namespace

void addTrunkFlesh(Solid& solid) {
  addBelly(solid);
  addBreast(solid);
  addBack(solid);
  addNeck(solid);
}

void addLegFlesh(Solid& solid) {
  const Anatomy& a = anatomy();
  addThigh(solid, a);
  addShin(solid, a);
  addFoot(solid, a);
}

Solid makeFlesh() {
  Solid solid;
  addTrunkFlesh(solid);
  addLegFlesh(solid);

  Primitive cloth;
  cloth.operation = implicit::Operation::kSwell;
  cloth.a.y = kHem;
  cloth.b.y = kWaistband;
  cloth.radius_a = 0.006;
  cloth.blend = 0.018;
  solid.add(cloth);
  addArmFlesh(solid);  // after the shorts, which lie at the hands' height
  addHeadFlesh(solid);

  Primitive ground;
  ground.shape = implicit::Shape::kHalfSpace;
  ground.flat_axis = {0, 1, 0};
  ground.blend = 0.008;
  solid.cut(ground);
  return solid;
}

}  // namespace lithe::bake::figure
