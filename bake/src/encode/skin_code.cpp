// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "skin_code.h"

#include <algorithm>
#include <set>

#include "lithe/format/placement.h"

namespace lithe::bake {
namespace {

int32_t weightOf(const QuantizedSkin& skin, uint16_t joint) {
  for (uint32_t i = 0; i < skin.count; ++i)
    if (skin.joint[i] == joint) return skin.weight[i];
  return 0;
}

/// The parent's joints in their order, then the children's others as the file says them: those of the ring by their
/// place there, then the rest by id behind it.
struct JointList {
  std::vector<uint16_t> joints;
  uint32_t known = 0;            ///< how many are the parent's
  std::vector<int32_t> said_as;  ///< of the others
};

format::RingJoints jointsAround(const SkinRing& ring, const QuantizedSkin& parent) {
  format::RingJoints around;
  for (uint32_t i = 0; i < ring.neighbours.count; ++i) {
    const QuantizedSkin& skin = ring.skin_of(ring.neighbours.wedge[i]);
    for (uint32_t k = 0; k < skin.count; ++k)
      if (weightOf(parent, skin.joint[k]) == 0) around.add(skin.joint[k], skin.weight[k]);
  }
  around.sort();
  return around;
}

JointList listJoints(const QuantizedSkin& parent, const QuantizedSkin& a, const QuantizedSkin& b,
                     const SkinRing& ring) {
  std::set<uint16_t> others;
  for (const QuantizedSkin* skin : {&a, &b})
    for (uint32_t i = 0; i < skin->count; ++i)
      if (weightOf(parent, skin->joint[i]) == 0) others.insert(skin->joint[i]);
  JointList list;
  list.joints.assign(parent.joint.begin(), parent.joint.begin() + parent.count);
  list.known = parent.count;
  const format::RingJoints around = jointsAround(ring, parent);
  for (uint32_t i = 0; i < around.count; ++i) {
    if (others.erase(static_cast<uint16_t>(around.joint[i])) == 0) continue;
    list.joints.push_back(static_cast<uint16_t>(around.joint[i]));
    list.said_as.push_back(static_cast<int32_t>(i));
  }
  for (uint16_t joint : others) {
    list.joints.push_back(joint);
    list.said_as.push_back(static_cast<int32_t>(around.count + joint));
  }
  return list;
}

/// What a reader makes of kSkinRule: b = parent - eighths(D, t8), the remainder at the parent's first joint.
bool ruleGives(const JointList& list, const QuantizedSkin& parent, const QuantizedSkin& a, const QuantizedSkin& b,
               int32_t t8, uint32_t weight_one) {
  int32_t remainder = static_cast<int32_t>(weight_one);
  std::vector<int32_t> weights(list.joints.size());
  for (size_t i = 0; i < list.joints.size(); ++i) {
    const int32_t d = weightOf(a, list.joints[i]) - weightOf(b, list.joints[i]);
    weights[i] = weightOf(parent, list.joints[i]) - format::eighths(d, t8);
    remainder -= weights[i];
  }
  weights[0] += remainder;
  for (size_t i = 0; i < list.joints.size(); ++i)
    if (weights[i] != weightOf(b, list.joints[i])) return false;
  return true;
}

}  // namespace

void encodeSkins(const QuantizedSkin& parent, const QuantizedSkin& a, const QuantizedSkin& b, int32_t t8,
                 uint32_t weight_one, const SkinRing& ring, StreamData& modes, PageData& page, Residuals& residuals) {
  if (a == parent && b == parent) {
    modes.put(format::kSkinSame);
    return;
  }
  const JointList list = listJoints(parent, a, b, ring);
  const bool rule = ruleGives(list, parent, a, b, t8, weight_one);
  modes.put(rule ? format::kSkinRule : format::kSkinFree);
  StreamData& news = page.streams[format::kSkinNew];
  news.put(static_cast<int32_t>(list.said_as.size()));
  for (int32_t value : list.said_as) news.put(value);
  // The last difference follows from the sum, so a single joint costs nothing.
  for (size_t i = 0; i + 1 < list.joints.size(); ++i) {
    const int32_t of_b = weightOf(b, list.joints[i]);
    Residual residual;
    residual.kind = Residual::Kind::kSkin;
    residual.difference[0] = weightOf(a, list.joints[i]) - of_b;
    const uint16_t joint = list.joints[i];
    const int32_t at_parent = weightOf(parent, joint);
    const format::RingSlope around =
        ring.neighbours.slopeOf([&](uint32_t wedge) { return weightOf(ring.skin_of(wedge), joint) - at_parent; });
    residual.slope[0] = around.slope;
    residual.extent = around.among(ring.neighbours.count, weight_one);
    residuals.add(residual);
    if (!rule) page.streams[format::kSkinE].put(of_b - weightOf(parent, list.joints[i]));
  }
}

}  // namespace lithe::bake
