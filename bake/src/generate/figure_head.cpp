// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Flesh of the head: skull, face, ears and a cap of combed hair. Order matters: what is cut is cut from what came
/// before.
#include "exact_math.h"
#include "figure.h"

namespace lithe::bake::figure {
namespace {

using glm::dvec3;
using implicit::ellipsoid;
using implicit::Primitive;
using implicit::roundCone;
using implicit::Solid;

void addSkull(Solid& solid) {
  solid.add(ellipsoid({0, 1.664, -0.014}, {0.0735, 0.086, 0.096}, 0.03));
  solid.add(ellipsoid({0, 1.612, 0.026}, {0.056, 0.085, 0.067}, 0.03));
  solid.addPair(roundCone({0.045, 1.588, -0.004}, 0.018, {0.014, 1.5410, 0.070}, 0.015, 0.022));
  solid.add(ellipsoid({0, 1.5395, 0.072}, {0.023, 0.018, 0.018}, 0.02));
  solid.addPair(ellipsoid({0.0405, 1.6220, 0.060}, {0.020, 0.016, 0.021}, 0.03));
  solid.addPair(roundCone({0.012, 1.6635, 0.0855}, 0.0085, {0.048, 1.6640, 0.064}, 0.0085, 0.016));
  solid.addPair(ellipsoid({0.031, 1.5900, 0.052}, {0.022, 0.032, 0.028}, 0.03));
  solid.cutPair(ellipsoid({0.078, 1.665, 0.040}, {0.012, 0.030, 0.030}, 0.03));
}

void addEyelids(Solid& solid, const Anatomy& a) {
  solid.cutPair(ellipsoid(a.eye + dvec3(0.001, 0.0015, 0.0265), {0.0205, 0.0135, 0.0165}, 0.012));
  solid.addPair(ellipsoid(a.eye, dvec3(kEyeRadius + 0.0030), 0.006));
  // brow fold and lower fold
  solid.addPair(
      roundCone(a.eye + dvec3(-0.012, 0.0090, 0.0115), 0.0020, a.eye + dvec3(0.014, 0.0085, 0.0050), 0.0020, 0.006));
  solid.cutPair(implicit::lens(a.eye + dvec3(0.0008, 0.0, 0.0125), 0.0138, 0.0056, 0.0026));
  solid.cutPair(ellipsoid(a.eye, dvec3(kEyeRadius - 0.0004), 0.0008));
}

void addNose(Solid& solid) {
  solid.add(roundCone({0, 1.652, 0.0860}, 0.0085, {0, 1.628, 0.0985}, 0.0085, 0.014));
  solid.add(roundCone({0, 1.628, 0.0985}, 0.0080, {0, 1.6075, 0.1120}, 0.0100, 0.010));
  solid.add(ellipsoid({0, 1.6100, 0.0940}, {0.0110, 0.0170, 0.0140}, 0.006));
  solid.addPair(ellipsoid({0.0115, 1.6030, 0.1005}, {0.0062, 0.0075, 0.0105}, 0.007));
  solid.add(ellipsoid({0, 1.6005, 0.1070}, {0.0050, 0.0050, 0.0080}, 0.006));
  solid.cutPair(ellipsoid({0.0074, 1.5950, 0.1035}, {0.0031, 0.0050, 0.0052}, 0.0020));
}

void addMouth(Solid& solid) {
  solid.add(ellipsoid({0, 1.5720, 0.0760}, {0.030, 0.026, 0.0235}, 0.018));
  solid.cut(roundCone({0, 1.5940, 0.1075}, 0.0028, {0, 1.5835, 0.1070}, 0.0032, 0.005));
  solid.addPair(roundCone({0.0045, 1.5780, 0.0985}, 0.0050, {0.0225, 1.5725, 0.0860}, 0.0022, 0.004));
  solid.add(roundCone({-0.0060, 1.5660, 0.0960}, 0.0062, {0.0060, 1.5660, 0.0960}, 0.0062, 0.004));
  solid.addPair(roundCone({0.0060, 1.5660, 0.0960}, 0.0062, {0.0215, 1.5705, 0.0870}, 0.0024, 0.004));
  solid.cutPair(roundCone({0, 1.5722, 0.1045}, 0.0016, {0.0215, 1.5722, 0.0938}, 0.0013, 0.0034));
  solid.cut(roundCone({-0.010, 1.5545, 0.0985}, 0.0040, {0.010, 1.5545, 0.0985}, 0.0040, 0.010));
}

/// An ear leans back and stands off from the head; its frame: outwards, up, backwards.
void addEar(Solid& solid) {
  const dvec3 out = glm::normalize(dvec3(1.0, 0.10, -0.42 + 0.80)), up = glm::normalize(dvec3(0.10, 1.0, -0.22));
  const dvec3 back = glm::normalize(glm::cross(out, up));
  const glm::dmat3 frame(glm::normalize(glm::cross(up, back)), up, back);
  const dvec3 center(0.0755, 1.6270, -0.0130);
  const auto at = [&](double x, double y, double z) { return center + frame * dvec3(x, y, z); };
  const auto put = [&](Primitive primitive, bool cut) {
    primitive.frame = frame;
    cut ? solid.cutPair(primitive) : solid.addPair(primitive);
  };
  put(ellipsoid(at(0.0035, 0.0, 0.004), {0.0078, 0.0310, 0.0185}, 0.005), false);
  put(ellipsoid(at(0.0090, 0.0030, 0.0035), {0.0060, 0.0215, 0.0115}, 0.003), true);
  solid.addPair(roundCone(at(0.0055, 0.015, 0.006), 0.0026, at(0.006, -0.010, 0.008), 0.0026, 0.004));
  solid.cutPair(ellipsoid(at(0.0080, -0.0050, -0.0010), {0.0060, 0.0090, 0.0062}, 0.003));
  solid.addPair(ellipsoid(at(0.0040, -0.0275, -0.0015), {0.0055, 0.0085, 0.0080}, 0.005));
}

void addHair(Solid& solid) {
  Primitive cap = ellipsoid({0, 1.6755, -0.0200}, {0.0805, 0.0815, 0.0990}, 0.003);
  cap.shape = implicit::Shape::kRidges;
  cap.label = kHairCap;
  const double tilt = exact::radians(-3.0);  // the front pole hides just under the hairline
  cap.frame = glm::mat3_cast(exact::rotation({1, 0, 0}, tilt));
  cap.ridge_count = 30.0;
  cap.ridge_height = 0.0016;
  solid.add(cap);
}

}  // namespace

void addHeadFlesh(Solid& solid) {
  const Anatomy& a = anatomy();
  addSkull(solid);
  addNose(solid);
  addMouth(solid);
  addEyelids(solid, a);
  addHair(solid);
  addEar(solid);
}

}  // namespace lithe::bake::figure
