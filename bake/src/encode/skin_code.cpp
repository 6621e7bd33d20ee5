// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "skin_code.h"

#include <algorithm>

#include "lithe/format/placement.h"

namespace lithe::bake {
namespace {

int32_t weightOf(const QuantizedSkin& skin, uint16_t joint) {
  for (uint32_t i = 0; i < skin.count; ++i)
    if (skin.joint[i] == joint) return skin.weight[i];
  return 0;
}

/// The parent's joints in their order, then the children's others, ascending.
struct JointList {
  std::vector<uint16_t> joints;
  uint32_t known = 0;  ///< how many are the parent's
};

JointList listJoints(const QuantizedSkin& parent, const QuantizedSkin& a, const QuantizedSkin& b) {
  JointList list;
  list.joints.assign(parent.joint.begin(), parent.joint.begin() + parent.count);
  list.known = parent.count;
  std::vector<uint16_t> others;
  for (const QuantizedSkin* skin : {&a, &b})
    for (uint32_t i = 0; i < skin->count; ++i)
      if (weightOf(parent, skin->joint[i]) == 0) others.push_back(skin->joint[i]);
  std::sort(others.begin(), others.end());
  others.erase(std::unique(others.begin(), others.end()), others.end());
  list.joints.insert(list.joints.end(), others.begin(), others.end());
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
                 uint32_t weight_one, const SkinRing& ring, PageData& page, Residuals& residuals) {
  auto& modes = page.streams[format::kSplits].attributes[format::kSplitSkin].values;
  if (a == parent && b == parent) {
    modes.push_back(format::kSkinSame);
    return;
  }
  const JointList list = listJoints(parent, a, b);
  const bool rule = ruleGives(list, parent, a, b, t8, weight_one);
  modes.push_back(rule ? format::kSkinRule : format::kSkinFree);
  StreamData& news = page.streams[format::kSkinNew];
  news.put(static_cast<int32_t>(list.joints.size() - list.known));
  for (size_t i = list.known; i < list.joints.size(); ++i) news.put(list.joints[i]);
  // The last difference follows from the sum, so a single joint costs nothing.
  for (size_t i = 0; i + 1 < list.joints.size(); ++i) {
    const int32_t of_b = weightOf(b, list.joints[i]);
    Residual residual;
    residual.kind = Residual::Kind::kSkin;
    residual.difference[0] = weightOf(a, list.joints[i]) - of_b;
    const uint16_t joint = list.joints[i];
    const int32_t at_parent = weightOf(parent, joint);
    residual.slope[0] =
        ring.neighbours.slopeOf([&](uint32_t wedge) { return weightOf(ring.skin_of(wedge), joint) - at_parent; });
    residuals.add(residual);
    if (!rule) page.streams[format::kSkinE].put(of_b - weightOf(parent, list.joints[i]));
  }
}

}  // namespace lithe::bake
