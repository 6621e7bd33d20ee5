// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The figure's clips: a stance for every instant, sampled at 30 keys a second.
#include <cmath>
#include <functional>
#include <vector>

#include "exact_math.h"
#include "figure.h"
#include "figure_stance.h"
#include "rig.h"

namespace lithe::bake::figure {
namespace {

using glm::dquat;
using glm::dvec3;

constexpr double kArmsDown = -34.0;  ///< raise that lets the arms hang

/// A smooth curve through keys of one cycle, phase 0 .. 1 (Catmull and Rom's tangents, for uneven keys).
class CyclicCurve {
 public:
  struct Key {
    double phase, value;
  };
  CyclicCurve(std::initializer_list<Key> keys) : keys_(keys) {}

  double operator()(double phase) const {
    const double p = phase - std::floor(phase);
    long i = 0;
    while (i + 1 < static_cast<long>(keys_.size()) && p >= keys_[i + 1].phase) ++i;
    const Key a = at(i), b = at(i + 1);
    const double width = b.phase - a.phase, t = (p - a.phase) / width, t2 = t * t, t3 = t2 * t;
    return a.value * (2.0 * t3 - 3.0 * t2 + 1.0) + b.value * (3.0 * t2 - 2.0 * t3) +
           width * (slope(i) * (t3 - 2.0 * t2 + t) + slope(i + 1) * (t3 - t2));
  }

 private:
  Key at(long i) const {
    const long n = static_cast<long>(keys_.size());
    const long turn = i < 0 ? -1 : i / n;
    return {keys_[i - turn * n].phase + static_cast<double>(turn), keys_[i - turn * n].value};
  }
  double slope(long i) const {
    const Key before = at(i - 1), after = at(i + 1);
    return (after.value - before.value) / (after.phase - before.phase);
  }

  std::vector<Key> keys_;
};

double wave(double phase) { return exact::cosine(exact::kTau * phase); }

/// A gait's feet over one cycle of the left foot; phase 0 is its first touch of the ground. The right is half a cycle
/// late.
struct Gait {
  CyclicCurve forward, lift, pitch;

  FootPlace foot(double phase) const { return {forward(phase), std::max(0.0, lift(phase)), pitch(phase)}; }
};

Stance walkStance(double phase) {
  static const Gait kGait = {
      {{0.0, 0.285}, {0.15, 0.135}, {0.30, -0.015}, {0.45, -0.165}, {0.60, -0.300}, {0.78, 0.0}, {0.92, 0.265}},
      {{0.0, 0.0}, {0.30, 0.0}, {0.60, 0.0}, {0.72, 0.055}, {0.86, 0.030}},
      {{0.0, 20.0}, {0.10, 0.0}, {0.35, 0.0}, {0.50, -16.0}, {0.61, -44.0}, {0.74, -28.0}, {0.88, 10.0}}};
  Stance stance;
  stance.hips_shift = {0.018 * wave(phase - 0.30), -0.024 + 0.016 * wave(2.0 * (phase - 0.31)), 0.0};
  stance.hips = {1.5, -5.0 * wave(phase), 2.5 * wave(phase - 0.20)};
  stance.spine = {3.0, 11.0 * wave(phase), -3.5 * wave(phase - 0.20)};
  stance.head = {-3.0, -5.5 * wave(phase), 1.0 * wave(phase - 0.20)};
  for (int side = 0; side < 2; ++side) {
    const double own = phase + 0.5 * side;
    stance.foot[side] = kGait.foot(own);
    const double swing = 2.0 - 24.0 * wave(own - 0.03);
    stance.arm[side] = {kArmsDown + 1.5, swing, 0.0, 14.0 - 10.0 * wave(own - 0.10), 3.0, 0.0, 9.0, 0.0};
  }
  return stance;
}

Stance runStance(double phase) {
  static const Gait kGait = {
      {{0.0, 0.16}, {0.12, -0.02}, {0.24, -0.21}, {0.36, -0.39}, {0.52, -0.36}, {0.70, 0.05}, {0.86, 0.30}},
      {{0.0, 0.0}, {0.15, 0.0}, {0.33, 0.005}, {0.44, 0.17}, {0.56, 0.32}, {0.72, 0.24}, {0.88, 0.09}},
      {{0.0, 6.0}, {0.10, 0.0}, {0.20, -8.0}, {0.36, -58.0}, {0.54, -82.0}, {0.74, -22.0}, {0.90, 8.0}}};
  Stance stance;
  stance.hips_shift = {0.008 * wave(phase - 0.16), -0.045 - 0.036 * wave(2.0 * (phase - 0.17)), 0.0};
  stance.hips = {6.0, -8.0 * wave(phase - 0.02), 3.0 * wave(phase - 0.15)};
  stance.spine = {8.0, 20.0 * wave(phase - 0.02), -4.0 * wave(phase - 0.15)};
  stance.head = {-9.0, -11.0 * wave(phase - 0.02), 1.0 * wave(phase - 0.15)};
  for (int side = 0; side < 2; ++side) {
    const double own = phase + 0.5 * side;
    stance.foot[side] = kGait.foot(own);
    const double swing = -6.0 - 42.0 * wave(own - 0.02);
    stance.arm[side] = {kArmsDown + 4.0, swing, 0.0, 78.0 - 16.0 * wave(own - 0.05), 4.0, 3.0, 28.0, 0.0};
  }
  return stance;
}

/// Standing at ease; breath is -1 .. 1.
Stance restingStance(double breath) {
  Stance stance;
  stance.hips_shift = {0.0, -0.006, 0.0};
  stance.spine = {0.6 * breath, 0.0, 0.0};
  stance.head = {-0.4 * breath, 0.0, 0.0};
  for (ArmAngles& arm : stance.arm) arm = {kArmsDown, 2.0, 0.0, 12.0, 3.0, 0.5 * breath, 8.0, 0.0};
  return stance;
}

ArmAngles blended(const ArmAngles& a, const ArmAngles& b, double t) {
  return {glm::mix(a.raise, b.raise, t), glm::mix(a.swing, b.swing, t),  glm::mix(a.twist, b.twist, t),
          glm::mix(a.elbow, b.elbow, t), glm::mix(a.wrist, b.wrist, t),  glm::mix(a.shrug, b.shrug, t),
          glm::mix(a.curl, b.curl, t),   glm::mix(a.spread, b.spread, t)};
}

/// Up, held, and down again: 0 at either end.
double heldBetween(double phase, double up, double down) {
  return exact::smoothStep(0.0, up, phase) * (1.0 - exact::smoothStep(down, 1.0, phase));
}

Stance waveStance(double phase) {
  Stance stance = restingStance(exact::sine(2.0 * exact::kTau * phase));
  const double up = heldBetween(phase, 0.24, 0.78), greet = up * exact::sine(5.0 * exact::kTau * phase);
  const ArmAngles greeting = {62.0, 14.0, 66.0, 84.0 + 20.0 * greet, 16.0 * greet, 14.0, -4.0, 7.0};
  stance.arm[kRight] = blended(stance.arm[kRight], greeting, up);
  stance.hips_shift += dvec3(0.018 * up, -0.004 * up, 0.0);
  stance.hips.tilt = -1.5 * up;
  stance.spine.tilt += 5.0 * up;
  stance.spine.turn += -4.0 * up;
  stance.head.tilt += -7.0 * up;
  stance.head.turn += -6.0 * up;
  return stance;
}

Stance crouchStance(double phase) {
  const double down = heldBetween(phase, 0.40, 0.62);
  Stance stance = restingStance(0.0);
  stance.hips_shift += down * dvec3(0.0, -0.415, -0.150);
  stance.hips.lean = 24.0 * down;
  stance.spine.lean = 26.0 * down;
  stance.head.lean = -30.0 * down;
  const ArmAngles reaching = {kArmsDown + 8.0, 62.0, 10.0, 42.0, 0.0, 2.0, 16.0, 0.0};
  for (ArmAngles& arm : stance.arm) arm = blended(arm, reaching, down);
  stance.foot[kLeft].forward = 0.05 * down;
  stance.foot[kRight].forward = -0.05 * down;
  stance.foot[kRight].pitch = -24.0 * down;
  return stance;
}

/// Sits down on a seat of chair height, rests there, and gets up again.
Stance sitStance(double phase) {
  const double down = heldBetween(phase, 0.38, 0.68);
  const double lean = exact::bump(down - 0.5, 0.5);  // the trunk tips forwards on the way, either way
  Stance stance = restingStance(0.0);
  stance.hips_shift += dvec3(0.0, -0.425 * down, -0.395 * (1.0 - (1.0 - down) * (1.0 - down)));
  stance.hips.lean = -8.0 * down + 26.0 * lean;
  stance.spine.lean = 10.0 * down + 18.0 * lean;
  stance.head.lean = -4.0 * down - 22.0 * lean;
  const ArmAngles on_thighs = {kArmsDown + 2.0, 26.0, 14.0, 52.0, 0.0, 0.0, 6.0, 2.0};
  for (ArmAngles& arm : stance.arm) arm = blended(arm, on_thighs, down);
  return stance;
}

bool moves(const std::vector<JointPose>& poses, uint32_t joint) {
  for (const JointPose& pose : poses) {
    if (pose.rotation[joint] != dquat(1.0, 0.0, 0.0, 0.0)) return true;
  }
  return false;
}

Clip makeClip(const Model& model, const char* name, uint32_t keys, const std::function<Stance(double)>& stance) {
  ClipBuilder clip(name, keys, 1.0 / 30.0);
  std::vector<JointPose> poses;
  for (uint32_t key = 0; key < keys; ++key) poses.push_back(solveStance(stance(clip.phase(key))));
  clip.translate(model.joints[kHips].node, [&](uint32_t key) { return poses[key].hips; });
  for (uint32_t joint = 0; joint < kJointCount; ++joint) {
    if (!moves(poses, joint)) continue;
    clip.rotate(model.joints[joint].node, [&](uint32_t key) { return poses[key].rotation[joint]; });
  }
  return clip.take();
}

}  // namespace

std::vector<Clip> makeClips(const Model& model) {
  return {makeClip(model, "walk", 33, walkStance), makeClip(model, "run", 22, runStance),
          makeClip(model, "wave", 91, waveStance), makeClip(model, "crouch", 61, crouchStance),
          makeClip(model, "sit", 76, sitStance)};
}

}  // namespace lithe::bake::figure
