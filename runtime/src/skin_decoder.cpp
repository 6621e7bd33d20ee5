// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "skin_decoder.h"

#include <string.h>

#include "skin_order.h"
#include "sort.h"

namespace lithe::runtime {
namespace {

bool equal(const uint16_t* a, const uint16_t* b, size_t count) {
  for (size_t i = 0; i < count; ++i)
    if (a[i] != b[i]) return false;
  return true;
}

struct WeightEntry {
  uint32_t joint;
  int32_t weight;
};

/// Keeps the positive weights in the order of a skin. Returns false when they are no skin.
bool makeSkin(const PageFormat& format, WeightEntry* entries, uint32_t count, NodeSkin* skin) {
  uint32_t kept = 0;
  int64_t sum = 0;
  for (uint32_t i = 0; i < count; ++i) {
    if (entries[i].weight < 0) return false;
    if (entries[i].weight > 0) entries[kept++] = entries[i];
  }
  if (kept == 0 || kept > format.max_influences) return false;
  sortValues(entries, kept, [](const WeightEntry& x, const WeightEntry& y) {
    return x.weight != y.weight ? x.weight > y.weight : x.joint < y.joint;
  });
  *skin = {};
  skin->count = kept;
  for (uint32_t i = 0; i < kept; ++i) {
    if (static_cast<uint32_t>(entries[i].weight) > format.weight_one) return false;
    skin->joint[i] = static_cast<uint16_t>(entries[i].joint);
    skin->weight[i] = static_cast<uint16_t>(entries[i].weight);
    sum += entries[i].weight;
  }
  return sum == format.weight_one && skinIsOrdered(*skin);
}

}  // namespace

int32_t SkinDecoder::readMode(uint32_t node, const format::Fan& fan) {
  const size_t values = size_t{2} * format_.max_influences;
  const uint16_t* skin = out_->node_skin + values * node;
  uint32_t alike = 0;
  for (uint32_t i = 0; i < fan.count; ++i) alike += equal(skin, out_->node_skin + values * fan.next[i], values);
  return streams_->values[format::skinModeStream(alike, fan.count)][0].next();
}

bool SkinDecoder::readChildren(uint32_t node, int32_t mode, int32_t t8) {
  const uint32_t influences = format_.max_influences, child_a = out_->node_count - 2;
  const SkinRecord parent = skinOf(*out_, node, influences);
  if (mode == format::kSkinSame) {
    uint16_t* children = out_->node_skin + size_t{2} * influences * child_a;
    memcpy(children, parent.joint, 2 * influences * sizeof(uint16_t));
    memcpy(children + 2 * influences, parent.joint, 2 * influences * sizeof(uint16_t));
    return true;
  }
  uint32_t joints[format::kMaxSkinJoints], count = 0;
  WeightEntry a[format::kMaxSkinJoints] = {}, b[format::kMaxSkinJoints] = {};
  int32_t d[format::kMaxSkinJoints], of_b[format::kMaxSkinJoints];
  if (!readJoints(parent, joints, &count) || !readWeights(parent, joints, count, mode, t8, d, of_b)) return false;
  for (uint32_t i = 0; i < count; ++i) {
    a[i] = {joints[i], of_b[i] + d[i]};
    b[i] = {joints[i], of_b[i]};
  }
  NodeSkin skins[2];
  if (!makeSkin(format_, a, count, &skins[0]) || !makeSkin(format_, b, count, &skins[1])) return false;
  storeSkin(skins[0], child_a, influences, out_);
  storeSkin(skins[1], child_a + 1, influences, out_);
  return true;
}

/// Child B's weights, and how much larger child A's are.
bool SkinDecoder::readWeights(const SkinRecord& parent, const uint32_t* joints, uint32_t count, int32_t mode,
                              int32_t t8, int32_t* d, int32_t* of_b) {
  const uint32_t parent_count = parent.count();
  format::RingSlope slopes[format::kMaxSkinJoints];
  slopesOfWeights(parent, joints, count - 1, slopes);
  const int32_t one = static_cast<int32_t>(format_.weight_one);
  int32_t last_d = 0, sum_b = 0;
  for (uint32_t i = 0; i < count; ++i) {
    const bool last = i + 1 == count;
    const int32_t of_parent = i < parent_count ? parent.weight[i] : 0;
    const int64_t difference = last ? last_d : readDifference(slopes[i]);
    if (difference > one || difference < -one) return false;
    d[i] = static_cast<int32_t>(difference);
    if (mode == format::kSkinRule)
      of_b[i] = of_parent - format::eighths(d[i], t8);
    else
      of_b[i] = last ? one - sum_b : of_parent + streams_->values[format::kSkinE][0].next();
    last_d -= d[i];
    sum_b += of_b[i];
  }
  if (mode == format::kSkinRule) of_b[0] += one - sum_b;
  return true;
}

int64_t SkinDecoder::readDifference(const format::RingSlope& around) {
  const uint32_t spread = around.among(neighbours_.count, format_.weight_one);
  const int32_t low = format::lowBits(spread, streams_->parameters[format::kSkinBias]);
  const int32_t left = splitValue(&streams_->low_bits[format::kLowSkins], streams_->values[format::kSkinD], low);
  return int64_t{left} + format::scaled(streams_->parameters[format::kSkinGradient], around.slope);
}

/// The parent's joints, then those that it lacks: by their place among the ring's, or by id.
bool SkinDecoder::readJoints(const SkinRecord& parent, uint32_t* joints, uint32_t* count) {
  const uint32_t parent_count = parent.count();
  IntReader& news = streams_->values[format::kSkinNew][0];
  const uint32_t new_count = static_cast<uint32_t>(news.next());
  if (new_count > format::kMaxSkinJoints - parent_count) return false;
  *count = parent_count + new_count;
  for (uint32_t i = 0; i < parent_count; ++i) joints[i] = parent.joint[i];
  if (new_count == 0) return true;
  const format::RingJoints around = jointsAround(joints, parent_count);
  for (uint32_t i = parent_count; i < *count; ++i) {
    const uint32_t value = static_cast<uint32_t>(news.next());
    joints[i] = value < around.count ? around.joint[value] : value - around.count;
    if (joints[i] >= format_.joint_count) return false;
    for (uint32_t j = 0; j < i; ++j)
      if (joints[j] == joints[i]) return false;
  }
  return true;
}

format::RingJoints SkinDecoder::jointsAround(const uint32_t* known, uint32_t known_count) const {
  format::RingJoints around;
  for (uint32_t i = 0; i < neighbours_.count; ++i) {
    const SkinRecord skin = skinOf(*out_, out_->wedge_node[neighbours_.wedge[i]], format_.max_influences);
    for (uint32_t k = 0; k < skin.most && skin.weight[k] > 0; ++k) {
      bool is_known = false;
      for (uint32_t j = 0; j < known_count; ++j) is_known = is_known | (known[j] == skin.joint[k]);
      if (!is_known) around.add(skin.joint[k], skin.weight[k]);
    }
  }
  around.sort();
  return around;
}

/// Of joints' weights around the parent's, whose joints come first; without slopes when nothing is predicted from them.
void SkinDecoder::slopesOfWeights(const SkinRecord& parent, const uint32_t* joints, uint32_t count,
                                  format::RingSlope* slopes) const {
  const bool predicted = streams_->parameters[format::kSkinGradient] > 0;
  const uint32_t parent_count = parent.count();
  format::Moment moments[format::kMaxSkinJoints] = {};
  for (uint32_t i = 0; i < neighbours_.count; ++i) {
    const SkinRecord skin = skinOf(*out_, out_->wedge_node[neighbours_.wedge[i]], format_.max_influences);
    for (uint32_t j = 0; j < count; ++j) {
      const int32_t e = skin.weightOf(joints[j]) - (j < parent_count ? parent.weight[j] : 0);
      slopes[j].widen(e);
      if (predicted) moments[j].add(neighbours_.r[i], e);
    }
  }
  for (uint32_t j = 0; predicted && j < count; ++j) slopes[j].slope = neighbours_.gradient.of(moments[j]);
}

}  // namespace lithe::runtime
