// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Head, eyes, antennae, fangs, legs and their bristles: closed tubes that reach into one another.
#include <cmath>

#include "centipede.h"
#include "exact_math.h"
#include "noise.h"
#include "rig.h"

namespace lithe::bake::centipede {
namespace {

Skin rigidSkin(uint32_t joint) {
  const Influence whole[] = {{joint, 1.0}};
  return makeSkin(whole, 1);
}

/// The flat head shield; v runs from the neck forwards.
glm::dvec3 headAt(double angle, double v) {
  constexpr double kRear = kNeckZ - 0.05, kLength = 0.36;
  const double c = exact::cosine(angle), s = exact::sine(angle), along = 2.0 * v - 1.0;
  const double outline = std::sqrt(std::max(0.0, 1.0 - along * along * along * along)) * (1.0 - 0.22 * v);
  const double suture = exact::bump(c, 0.05) * (s > 0.0 ? 1.0 : 0.0) * exact::smoothStep(0.1, 0.3, v) * (1.0 - v);
  const double brow =
      exact::bump(std::fabs(c) - 0.62, 0.2) * exact::bump(v - 0.72, 0.16) * exact::smoothStep(0.0, 0.4, s);
  const double grains = s > 0.0 ? s * noise::grains(angle / 0.13, v / 0.06, 23) : 0.0;
  const double relief = 1.0 - 0.05 * suture + 0.09 * brow + 0.02 * grains * (1.0 - along * along);
  const double height = s > 0.0 ? 0.46 : 0.36;
  return {0.172 * outline * relief * c, kBodyY + 0.03 + 0.172 * outline * relief * height * s, kRear + kLength * v};
}

/// A small ball; the poles of its tube lie on the z axis.
glm::dvec3 ballAt(const glm::dvec3& center, double radius, double angle, double v) {
  const double polar = exact::kPi * (1.0 - v), ring = v <= 0.0 || v >= 1.0 ? 0.0 : radius * exact::sine(polar);
  return center + glm::dvec3(ring * exact::cosine(angle), ring * exact::sine(angle), radius * exact::cosine(polar));
}

/// Four simple eyes in a square on either side of the head.
void addEyes(SurfaceBuilder& surface, const Plan& plan) {
  for (uint32_t eye = 0; eye < 8; ++eye) {
    const bool left = eye < 4;
    const uint32_t row = eye / 2 % 2, column = eye % 2;
    const double raised = exact::radians(26.0 + 9.0 * column);
    const glm::dvec3 center = headAt(left ? raised : exact::kPi - raised, 0.7 + 0.06 * row + 0.015 * column);
    const glm::dvec2 corner(0.42 + 0.03 * (eye % 4), left ? 0.5 : 0.54);
    Tube tube{kShell, 14, 10, {corner, corner + glm::dvec2(0.025, 0.03)}, {}, {}};
    tube.position = [center](double angle, double v) { return ballAt(center, 0.012, angle, v); };
    tube.skin = [&](double) { return rigidSkin(plan.head); };
    addTube(surface, tube);
  }
}

Tube limbTube(const Limb& limb, const JointedLimb& plan, double blend) {
  Tube tube;
  tube.position = [&limb](double angle, double v) { return limb.surfaceAt(angle, v); };
  tube.skin = [&limb, &plan, blend](double v) { return limb.skinAt(v, plan.joints, blend); };
  return tube;
}

/// A cone of three rows that stands on the limb and leans to its tip.
void addBristle(SurfaceBuilder& surface, const Limb& limb, const JointedLimb& plan, double angle, double v,
                double length, const UvRect& uv) {
  const glm::dvec3 foot = limb.surfaceAt(angle, v), center = limb.centerAt(v);
  const glm::dvec3 lean = limb.tangentAt(v), out = glm::normalize(foot - center);
  const glm::dvec3 direction = glm::normalize(out + 0.8 * lean);
  const glm::dvec3 first =
      glm::normalize(glm::cross(direction, std::fabs(out.y) > 0.8 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  const glm::dvec3 second = glm::cross(direction, first);
  Tube tube{kFlesh, 5, 4, uv, {}, {}};
  tube.position = [=](double a, double w) {
    const double radius = 0.09 * length * std::sqrt(std::min(1.0, 8.0 * w)) * (1.0 - w);
    return foot + direction * length * (w - 0.12) + radius * (exact::cosine(a) * first + exact::sine(a) * second);
  };
  tube.skin = [&](double) { return limb.skinAt(v, plan.joints, 0.05); };
  addTube(surface, tube);
}

/// A leg and its bristles. `cell` picks its place among the legs' charts.
void addLeg(SurfaceBuilder& surface, const JointedLimb& plan, uint32_t cell, uint32_t columns, uint32_t rows) {
  const Limb limb(plan.points, plan.radii, plan.side);
  const glm::dvec2 corner(0.12 + 0.145 * (cell % 6), 0.02 + 0.135 * (cell / 6));
  Tube tube = limbTube(limb, plan, 0.05);
  tube.part = kFlesh;
  tube.columns = columns;
  tube.rows = rows;
  tube.uv = {corner, corner + glm::dvec2(0.05, 0.125)};
  addTube(surface, tube);
  for (uint32_t k = 0; k < 12; ++k) {
    const double angle = exact::kTau * noise::cell(cell, k, 31), v = 0.28 + 0.055 * k;
    const glm::dvec2 low = corner + glm::dvec2(0.06 + 0.02 * (k % 4), 0.04 * (k / 4));
    addBristle(surface, limb, plan, angle, v, 0.022 + 0.018 * noise::cell(cell, k, 32),
               {low, low + glm::dvec2(0.015, 0.03)});
  }
}

/// An antenna: a limb strung of beads.
void addAntenna(SurfaceBuilder& surface, const JointedLimb& plan, uint32_t index) {
  constexpr double kBeads = 17.0;
  const Limb limb(plan.points, plan.radii, plan.side);
  Tube tube = limbTube(limb, plan, 0.06);
  tube.part = kFlesh;
  tube.columns = 14;
  tube.rows = 17 * 8;
  tube.uv = {{0.12 + 0.05 * index, 0.965}, {0.16 + 0.05 * index, 1.0}};
  tube.position = [&limb](double angle, double v) {
    const glm::dvec3 center = limb.centerAt(v), skin = limb.surfaceAt(angle, v);
    const double in_bead = kBeads * v - std::floor(kBeads * v);
    return center + (skin - center) * (0.78 + 0.34 * exact::bump(in_bead - 0.5, 0.62));
  };
  addTube(surface, tube);
}

void addFang(SurfaceBuilder& surface, const JointedLimb& plan, uint32_t index) {
  const Limb limb(plan.points, plan.radii, plan.side);
  Tube tube = limbTube(limb, plan, 0.12);
  tube.part = kShell;
  tube.columns = 24;
  tube.rows = 56;
  tube.uv = {{0.42 + 0.1 * index, 0.3}, {0.5 + 0.1 * index, 0.45}};
  addTube(surface, tube);
}

}  // namespace

void addHead(SurfaceBuilder& surface, const Plan& plan) {
  Tube tube{kShell, 72, 60, {{0.16, 0.0}, {0.4, 0.1}}, headAt, [&](double) { return rigidSkin(plan.head); }};
  addTube(surface, tube);
  addEyes(surface, plan);
}

void addLimbs(SurfaceBuilder& surface, const Plan& plan) {
  for (uint32_t i = 0; i < 2; ++i) {
    addFang(surface, plan.fang[i], i);
    addAntenna(surface, plan.antenna[i], i);
  }
  uint32_t cell = 0;
  for (const auto& pair : plan.legs) {
    for (const JointedLimb& leg : pair) addLeg(surface, leg, cell++, 14, 54);
  }
  for (const JointedLimb& leg : plan.trailing) addLeg(surface, leg, cell++, 18, 90);
}

}  // namespace lithe::bake::centipede
