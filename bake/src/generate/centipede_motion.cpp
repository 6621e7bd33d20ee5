// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// walk: waves that run along the body and the rows of legs. curl: the animal coils up flat on the ground.
#include <cmath>

#include "centipede.h"
#include "exact_math.h"
#include "rig.h"

namespace lithe::bake::centipede {
namespace {

const glm::dvec3 kUp(0.0, 1.0, 0.0);

double legPhase(double phase, uint32_t pair, uint32_t side) { return phase - pair / 7.0 + 0.5 * side; }

/// Heading (radians about y) of a segment in the walk; a wave and a quarter fits on the body.
double walkHeading(double phase, double segment) {
  return exact::radians(15.0) * exact::sine(exact::kTau * (phase - 1.25 * segment / kSegments));
}

/// Rotations of the segments that give each its heading, and a sideways shift that keeps the body over its own middle.
void addHeadings(ClipBuilder& clip, const Model& model, const Plan& plan, double (*heading)(double, double)) {
  clip.translate(model.joints[plan.segment[0]].node, [&](uint32_t key) {
    double x = 0.0, sum = 0.0;
    for (uint32_t s = 0; s < kSegments; ++s) {
      x -= (segmentFront(s) - segmentFront(s + 1)) * exact::sine(heading(clip.phase(key), s));
      sum += x;
    }
    return jointPosition(model, plan.segment[0]) - glm::dvec3(sum / kSegments, 0.0, 0.0);
  });
  for (uint32_t s = 0; s < kSegments; ++s) {
    clip.rotate(model.joints[plan.segment[s]].node, [&, s](uint32_t key) {
      const double before = s == 0 ? 0.0 : heading(clip.phase(key), s - 1.0);
      return exact::rotation(kUp, heading(clip.phase(key), s) - before);
    });
  }
  clip.rotate(model.joints[plan.head].node, [&](uint32_t key) {
    return exact::rotation(kUp, heading(clip.phase(key), -1.0) - heading(clip.phase(key), 0.0));
  });
}

/// What a leg does: turn at the hip forwards, raise at the hip, straighten at the knees (all radians).
struct LegPose {
  double forward = 0.0, raise = 0.0, bend = 0.0;
};

void addLeg(ClipBuilder& clip, const Model& model, const JointedLimb& leg, const std::function<LegPose(double)>& pose) {
  const glm::dvec3 outwards = glm::normalize(glm::cross(leg.side, -kUp));
  const double turn = outwards.x > 0.0 ? -1.0 : 1.0;  // about y, forwards
  const glm::dvec3 lift = glm::cross(outwards, kUp);
  clip.rotate(model.joints[leg.joints[0]].node, [&](uint32_t key) {
    const LegPose p = pose(clip.phase(key));
    return exact::rotation(kUp, turn * p.forward) * exact::rotation(lift, 0.4 * p.raise);
  });
  clip.rotate(model.joints[leg.joints[1]].node,
              [&](uint32_t key) { return exact::rotation(lift, 0.6 * pose(clip.phase(key)).raise); });
  clip.rotate(model.joints[leg.joints[2]].node,
              [&](uint32_t key) { return exact::rotation(lift, -0.5 * pose(clip.phase(key)).bend); });
  clip.rotate(model.joints[leg.joints[3]].node,
              [&](uint32_t key) { return exact::rotation(lift, -0.5 * pose(clip.phase(key)).bend); });
}

/// Two thirds of the cycle on the ground going back, one third in the air coming forwards.
LegPose walkingLeg(double phase) {
  const double p = phase - std::floor(phase);
  const double back = exact::smoothStep(0.0, 1.0, p / 0.66), forth = exact::smoothStep(0.66, 1.0, p);
  const double swing = p < 0.66 ? 1.0 - 2.0 * (0.5 * back + 0.5 * p / 0.66) : -1.0 + 2.0 * forth;
  const double air = exact::bump(p - 0.83, 0.17);
  return {exact::radians(26.0) * swing, exact::radians(34.0) * air, exact::radians(30.0) * air};
}

/// Sways the pieces of a feeler one after the other.
void addFeeler(ClipBuilder& clip, const Model& model, const JointedLimb& limb, double degrees, double offset) {
  for (size_t piece = 0; piece < limb.joints.size(); ++piece) {
    clip.rotate(model.joints[limb.joints[piece]].node, [&, piece](uint32_t key) {
      const double turns = clip.phase(key) - 0.13 * static_cast<double>(piece) + offset;
      return exact::rotation(kUp, exact::radians(degrees) * exact::sine(exact::kTau * turns)) *
             exact::rotation(limb.side, exact::radians(0.7 * degrees) * exact::cosine(exact::kTau * turns));
    });
  }
}

void addFangs(ClipBuilder& clip, const Model& model, const Plan& plan, double degrees) {
  for (uint32_t i = 0; i < 2; ++i) {
    clip.rotate(model.joints[plan.fang[i].joints[0]].node, [&, i](uint32_t key) {
      const double open = 0.5 - 0.5 * exact::cosine(2.0 * exact::kTau * clip.phase(key));
      return exact::rotation(kUp, kSides[i] * exact::radians(degrees) * open);
    });
  }
}

/// Headings of the coil: every segment turns against the one before it, more towards the tail.
double curlHeading(double phase, double segment) {
  const double amount = exact::smoothStep(0.0, 0.85, phase - 0.006 * segment);
  const double s = std::max(segment, 0.0);
  return amount * exact::radians(70.0 - 11.5 * s - 0.25 * s * s);
}

}  // namespace

Clip walkClip(const Model& model, const Plan& plan) {
  ClipBuilder clip("walk", 33, 1.0 / 30.0);
  addHeadings(clip, model, plan, walkHeading);
  for (uint32_t pair = 0; pair < kLegPairs; ++pair) {
    for (uint32_t side = 0; side < 2; ++side) {
      addLeg(clip, model, plan.legs[pair][side], [=](double phase) { return walkingLeg(legPhase(phase, pair, side)); });
    }
  }
  for (uint32_t i = 0; i < 2; ++i) {
    addFeeler(clip, model, plan.antenna[i], 9.0, 0.5 * i);
    addFeeler(clip, model, plan.trailing[i], 6.0, 0.5 * i + 0.2);
  }
  addFangs(clip, model, plan, 14.0);
  return clip.take();
}

Clip curlClip(const Model& model, const Plan& plan) {
  ClipBuilder clip("curl", 46, 1.0 / 30.0);
  addHeadings(clip, model, plan, curlHeading);
  for (uint32_t pair = 0; pair < kLegPairs; ++pair) {
    for (uint32_t side = 0; side < 2; ++side) {
      addLeg(clip, model, plan.legs[pair][side], [=](double phase) {
        const double fold = exact::smoothStep(0.0, 0.8, phase - 0.01 * pair);
        return LegPose{exact::radians(-30.0) * fold, exact::radians(20.0) * fold, exact::radians(55.0) * fold};
      });
    }
  }
  for (uint32_t i = 0; i < 2; ++i) addFeeler(clip, model, plan.antenna[i], 14.0, 0.25 * i);
  addFangs(clip, model, plan, 22.0);
  return clip.take();
}

}  // namespace lithe::bake::centipede
