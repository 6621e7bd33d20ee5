// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The segmented trunk: plates of shell above, folded flesh below, one closed surface cut along both flanks.
#include <algorithm>
#include <cmath>

#include "centipede.h"
#include "exact_math.h"
#include "noise.h"
#include "rig.h"

namespace lithe::bake::centipede {
namespace {

constexpr uint32_t kRowsPerSegment = 24;
constexpr uint32_t kCapRows = 12;
constexpr uint32_t kRows = kSegments * kRowsPerSegment + 2 * kCapRows;
constexpr uint32_t kDorsalColumns = 72, kVentralColumns = 38;
constexpr double kCapLength = 0.09;
constexpr double kFlank = -0.28;  ///< angle of the left cut; the right one is at pi - kFlank

/// Where a row lies: z, the segment it belongs to and how far back in it.
struct Station {
  double z = 0.0;
  uint32_t segment = 0;
  double t = 0.0;  ///< 0 at the segment's front edge, 1 at its rear edge
};

Station stationAt(double z) {
  Station station{z, 0, 0.0};
  while (station.segment + 1 < kSegments && z <= segmentFront(station.segment + 1)) ++station.segment;
  const double front = segmentFront(station.segment), rear = segmentFront(station.segment + 1);
  station.t = glm::clamp((front - z) / (front - rear), 0.0, 1.0);
  return station;
}

/// z of a row, tail first. Rows crowd at the rear lip of each plate, where the relief is steep.
double rowZ(uint32_t row) {
  if (row <= kCapRows) {
    const double t = 1.0 - static_cast<double>(row) / kCapRows;
    return kTailZ - kCapLength * t * (2.0 - t);
  }
  if (row >= kRows - kCapRows) {
    const double t = 1.0 - static_cast<double>(kRows - row) / kCapRows;
    return kNeckZ + kCapLength * t * (2.0 - t);
  }
  const uint32_t inner = row - kCapRows, segment = kSegments - 1 - inner / kRowsPerSegment;
  const double t = static_cast<double>(inner % kRowsPerSegment) / kRowsPerSegment;
  const double crowded = t * (0.45 + t * (0.75 - 0.2 * t));
  return segmentFront(segment + 1) * (1.0 - crowded) + segmentFront(segment) * crowded;
}

/// How much a plate stands out at t from its front edge: low under the lip before it, highest at its own lip.
double plateProfile(double t) {
  const double rise = exact::smoothStep(0.0, 0.3, t), slope = 0.055 * t, lip = 0.035 * exact::bump(t - 0.92, 0.12);
  return -0.12 * (1.0 - rise) + slope + lip - 0.15 * exact::smoothStep(0.95, 1.0, t);
}

/// Relief of the back in units of the trunk's half width; x is -1 .. 1 across the back.
double dorsalRelief(const Station& at, double x, double angle) {
  const double middle = exact::bump(at.t - 0.5, 0.5);
  const double furrows = exact::bump(std::fabs(x) - 0.34, 0.07) + exact::bump(std::fabs(x) - 0.8, 0.06);
  const double keel = exact::bump(x, 0.06) * middle;
  const double rim = exact::bump(std::fabs(x) - 0.92, 0.1);
  const double arc = angle * trunkHalfWidth(at.z);
  const double grain_field = exact::smoothStep(0.25, 0.7, std::fabs(x)) * exact::smoothStep(0.1, 0.4, at.t);
  const double grains = noise::grains(arc / 0.022, at.z / 0.022, 11) * (0.25 + grain_field);
  return plateProfile(at.t) - 0.045 * furrows + 0.03 * keel + 0.06 * rim + 0.035 * grains;
}

/// Relief of the belly: one cushion to a segment, split in the middle, folds across the gap between two.
double ventralRelief(const Station& at, double x) {
  const double cushion = exact::bump(at.t - 0.5, 0.55);
  const double folds = exact::sine(exact::kTau * 5.0 * at.t) * (1.0 - cushion);
  return 0.09 * cushion - 0.1 + 0.018 * folds - 0.07 * exact::bump(x, 0.1) * cushion;
}

/// Shrinks the cross-section to a point at either end.
double capScale(double z) {
  const double outside = std::max({0.0, kTailZ - z, z - kNeckZ}) / kCapLength;
  return std::sqrt(std::max(0.0, 1.0 - outside * outside));
}

glm::dvec3 trunkAt(double angle, double z) {
  const Station station = stationAt(z);
  const double c = exact::cosine(angle), s = exact::sine(angle);
  const double back = exact::smoothStep(exact::sine(kFlank), 0.3, s);
  const double relief = back * dorsalRelief(station, c, angle) + (1.0 - back) * ventralRelief(station, c);
  const double size = trunkHalfWidth(z) * (1.0 + relief) * capScale(z);
  // a flat dome above, flatter still below
  const double height = s > 0.0 ? 0.52 : 0.42;
  const double squareness = 1.0 + 0.1 * (4.0 * c * c * s * s);
  return {size * squareness * c, kBodyY + size * squareness * height * s, z};
}

glm::dvec3 trunkNormal(double angle, uint32_t row) {
  constexpr double kStep = 1e-4;
  if (row == 0 || row == kRows) return {0.0, 0.0, row == 0 ? -1.0 : 1.0};
  const double z = rowZ(row);
  const glm::dvec3 around = trunkAt(angle + kStep, z) - trunkAt(angle - kStep, z);
  return glm::normalize(glm::cross(around, trunkAt(angle, z + kStep) - trunkAt(angle, z - kStep)));
}

/// Quadratic B-spline over the segments' middles: three influences that change smoothly. Plates on the back hold
/// together a little more than the belly does.
Skin trunkSkin(const Plan& plan, double angle, double z) {
  const Station station = stationAt(z);
  const double back = exact::smoothStep(exact::sine(kFlank), 0.3, exact::sine(angle));
  const double stiff = station.t * (1.0 - back) + back * exact::smoothStep(0.0, 1.0, station.t);
  const double t = glm::clamp(stiff, 0.0, 1.0), s = station.segment;
  const auto jointAt = [&](double segment) {
    return plan.segment[static_cast<uint32_t>(glm::clamp(segment, 0.0, kSegments - 1.0))];
  };
  const Influence influences[] = {
      {jointAt(s - 1.0), 0.5 * (1.0 - t) * (1.0 - t)}, {jointAt(s), 0.5 + t - t * t}, {jointAt(s + 1.0), 0.5 * t * t}};
  return makeSkin(influences, 4);
}

struct Strip {
  PartIndex part;
  uint32_t columns;
  double from, to;  ///< angles; `to` is given as the very number the other strip starts from, so that they weld
  double width;     ///< of the strip's texture
};

void addStrip(SurfaceBuilder& surface, const Plan& plan, const Strip& strip) {
  const double length = rowZ(kRows) - rowZ(0);
  const double end = strip.to > strip.from ? strip.to : strip.to + exact::kTau;
  surface.addSheet(strip.part, strip.columns, kRows, [&](uint32_t column, uint32_t row) {
    const double u = static_cast<double>(column) / strip.columns, z = rowZ(row);
    const double angle = column == strip.columns ? strip.to : strip.from * (1.0 - u) + end * u;
    SurfacePoint point;
    point.position = trunkAt(row == 0 || row == kRows ? 0.0 : angle, z);
    point.normal = trunkNormal(angle, row);
    point.uv = {strip.width * u, glm::clamp((z - rowZ(0)) / length, 0.0, 1.0)};
    point.skin = trunkSkin(plan, row == 0 || row == kRows ? 0.0 : angle, z);
    return point;
  });
}

}  // namespace

void addTrunk(SurfaceBuilder& surface, const Plan& plan) {
  addStrip(surface, plan, {kShell, kDorsalColumns, kFlank, exact::kPi - kFlank, 0.14});
  addStrip(surface, plan, {kFlesh, kVentralColumns, exact::kPi - kFlank, kFlank, 0.1});
}

}  // namespace lithe::bake::centipede
