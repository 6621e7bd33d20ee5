// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <array>

#include "characters.h"
#include "exact_math.h"
#include "rig.h"
#include "surface_builder.h"

namespace lithe::bake {
namespace {

constexpr uint32_t kAcross = 32;  ///< quads along an edge of the square
constexpr uint32_t kAlong = 432;  ///< quads along the column: 2 * (4 * 32 * 432 + 2 * 32 * 32) = 114,688 triangles
constexpr double kHeight = 8.0;
constexpr uint32_t kJoints = 4;
constexpr double kJointSpacing = kHeight / kJoints;
constexpr double kBlendHalfWidth = 1.0;  ///< half the spacing: two blends meet and never overlap

/// The rotation vectors (radians about x, y, z) of one pose, for joints 1 .. 3; joint 0 stands still.
using ColumnPose = std::array<glm::dvec3, kJoints - 1>;

constexpr double degrees(double angle) { return exact::radians(angle); }

const std::array<ColumnPose, 4> kExamples = {{
    {{{0.0, 0.0, degrees(90)}, {0.0, 0.0, 0.0}, {0.0, 0.0, degrees(-20)}}},                          // an elbow
    {{{degrees(15), 0.0, 0.0}, {degrees(-75), 0.0, 0.0}, {degrees(-65), 0.0, 0.0}}},                 // a hook
    {{{0.0, degrees(45), 0.0}, {0.0, degrees(90), 0.0}, {0.0, degrees(45), 0.0}}},                   // a screw
    {{{0.0, 0.0, degrees(-60)}, {degrees(60), degrees(25), degrees(15)}, {0.0, 0.0, degrees(75)}}},  // a bent screw
}};

Skin skinAt(double y) {
  for (uint32_t joint = 1; joint < kJoints; ++joint) {
    const double above = exact::smoothStep(-kBlendHalfWidth, kBlendHalfWidth, y - joint * kJointSpacing);
    if (above < 1.0) return makeSkin(std::array{Influence{joint - 1, 1.0 - above}, Influence{joint, above}}, 2);
  }
  return makeSkin(std::array{Influence{kJoints - 1, 1.0}}, 2);
}

/// Column i of 0 .. kAcross from -0.5 to 0.5; exact in binary, so that neighbouring sheets weld.
double across(uint32_t i) { return static_cast<double>(i) / kAcross - 0.5; }

/// The four sides, each with its own strip of the texture.
void addSides(SurfaceBuilder& surface) {
  for (uint32_t side = 0; side < 4; ++side) {
    surface.addSheet(0, kAcross, kAlong, [side](uint32_t column, uint32_t row) {
      const double s = across(column), y = kHeight * row / kAlong;
      SurfacePoint point;
      switch (side) {
        case 0:
          point = {{s, y, 0.5}, {0, 0, 1}, {}, {}};
          break;
        case 1:
          point = {{0.5, y, -s}, {1, 0, 0}, {}, {}};
          break;
        case 2:
          point = {{-s, y, -0.5}, {0, 0, -1}, {}, {}};
          break;
        default:
          point = {{-0.5, y, s}, {-1, 0, 0}, {}, {}};
          break;
      }
      point.uv = {0.125 * (side + static_cast<double>(column) / kAcross), static_cast<double>(row) / kAlong};
      point.skin = skinAt(y);
      return point;
    });
  }
}

void addCaps(SurfaceBuilder& surface) {
  for (const bool top : {false, true}) {
    surface.addSheet(0, kAcross, kAcross, [top](uint32_t column, uint32_t row) {
      const double y = top ? kHeight : 0.0, sign = top ? 1.0 : -1.0;
      SurfacePoint point;
      point.position = {across(column), y, -sign * across(row)};
      point.normal = {0.0, sign, 0.0};
      point.uv = {0.625 + 0.125 * column / kAcross, (top ? 0.25 : 0.0) + 0.125 * row / kAcross};
      point.skin = skinAt(y);
      return point;
    });
  }
}

void addSkeleton(Model& model) {
  uint32_t parent = addNode(model, "root", kNone, glm::dvec3(0.0));
  for (uint32_t joint = 0; joint < kJoints; ++joint) {
    addJoint(model, "bone" + std::to_string(joint), parent, {0.0, joint * kJointSpacing, 0.0});
    parent = model.joints[joint].node;
  }
}

Clip examplesClip(const Model& model) {
  ClipBuilder clip("examples", static_cast<uint32_t>(kExamples.size()), 1.0);
  for (uint32_t joint = 1; joint < kJoints; ++joint) {
    clip.rotate(model.joints[joint].node, [&](uint32_t key) { return exact::rotation(kExamples[key][joint - 1]); });
  }
  return clip.take();
}

/// Poses the examples span but do not contain: every joint mixes the examples' rotations, slowly and out of step with
/// the other joints.
Clip testClip(const Model& model) {
  constexpr std::array kAmplitude = {0.3, 0.3, 0.2, 0.2};
  ClipBuilder clip("test", 60, 1.0 / 30.0);
  for (uint32_t joint = 1; joint < kJoints; ++joint) {
    clip.rotate(model.joints[joint].node, [&](uint32_t key) {
      glm::dvec3 mixed(0.0);
      for (uint32_t example = 0; example < kExamples.size(); ++example) {
        const double turns = (1.0 + 0.5 * example) * key / 60.0 + 0.13 * joint + 0.29 * example;
        mixed += kAmplitude[example] * (0.4 + 1.8 * exact::sine(exact::kTau * turns)) * kExamples[example][joint - 1];
      }
      return exact::rotation(mixed);
    });
  }
  return clip.take();
}

}  // namespace

Model generateColumn() {
  Model model;
  addPart(model, "column", "stone");
  addSkeleton(model);
  SurfaceBuilder surface(1);
  addSides(surface);
  addCaps(surface);
  surface.finish(model);
  model.clips = {examplesClip(model), testClip(model)};
  return model;
}

}  // namespace lithe::bake
