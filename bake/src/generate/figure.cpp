// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "figure.h"

#include "characters.h"
#include "exact_math.h"
#include "rig.h"
#include "tube.h"

namespace lithe::bake {
namespace figure {

/// Balls with a bulging cornea, the pupil at the pole so that the texture's top row is its middle.
void addEyeballs(SurfaceBuilder& surface) {
  for (const Side side : {kLeft, kRight}) {
    const glm::dvec3 center = side == kLeft ? anatomy().eye : mirror(anatomy().eye);
    const double column = side == kLeft ? 0.0 : 0.5;
    Tube ball{kEyes, 32, 26, {{column + 0.02, 0.02}, {column + 0.48, 0.98}}, {}, {}};
    ball.position = [center](double angle, double v) {
      const double polar = exact::kPi * (1.0 - v);
      const double cornea = 1.0 + 0.06 * exact::bump(polar, exact::radians(38.0));
      const double radius = kEyeRadius * cornea, ring = v <= 0.0 || v >= 1.0 ? 0.0 : radius * exact::sine(polar);
      return center + glm::dvec3(ring * exact::cosine(angle), ring * exact::sine(angle), radius * exact::cosine(polar));
    };
    ball.skin = [side](double) {
      const Influence whole[] = {{jointOf(side, kEye), 1.0}};
      return makeSkin(whole, 1);
    };
    addTube(surface, ball);
  }
}

namespace {

/// Cells are finest where the figure is: the face, then hands and toes.
PolygoniseOptions latticeOptions() {
  const Anatomy& a = anatomy();
  const glm::dvec3 hand = a.wrist + 0.095 * a.along + 0.008 * a.across;
  PolygoniseOptions options;
  options.cell = 0.0065;
  const glm::dvec3 toes = glm::mix(a.toes, a.toe_tip, 0.5);
  options.spots = {{{0.0, 1.615, 0.055}, 0.105, 3.2},
                   {hand, 0.085, 2.3},
                   {mirror(hand), 0.085, 2.3},
                   {toes, 0.055, 1.9},
                   {mirror(toes), 0.055, 1.9}};
  return options;
}

}  // namespace
}  // namespace figure

Model generateFigure() {
  Model model;
  for (const char* name : {"skin", "hair", "shorts", "eyes"}) addPart(model, name, name);
  figure::addSkeleton(model);
  const implicit::Solid flesh = figure::makeFlesh();
  ClosedMesh mesh = polygonise(flesh, figure::latticeOptions());
  const std::vector<figure::PartIndex> parts = figure::dress(flesh, mesh);
  SurfaceBuilder surface(figure::kPartCount);
  figure::addBody(surface, mesh, parts, figure::bindToSkeleton(model, mesh));
  figure::addEyeballs(surface);
  surface.finish(model);
  model.clips = figure::makeClips(model);
  return model;
}

}  // namespace lithe::bake
