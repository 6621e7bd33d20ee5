// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/skin_weights.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lithe/format/placement.h"

namespace lithe::bake {

namespace {

struct Influence {
  uint16_t joint;
  int32_t weight;
};

/// Up to two skins of eight.
struct InfluenceList {
  uint32_t count = 0;
  std::array<Influence, 16> items;  // those up to count are set

  std::span<Influence> all() { return {items.data(), count}; }
};

bool heavierFirst(const Influence& a, const Influence& b) {
  return a.weight != b.weight ? a.weight > b.weight : a.joint < b.joint;
}

/// Sixteen entries at most: insertion sort beats the library's and needs no scratch.
void sortHeavierFirst(InfluenceList& list) {
  for (uint32_t i = 1; i < list.count; ++i) {
    const Influence moved = list.items[i];
    uint32_t j = i;
    for (; j > 0 && heavierFirst(moved, list.items[j - 1]); --j) list.items[j] = list.items[j - 1];
    list.items[j] = moved;
  }
}

void dropZeros(InfluenceList& list) {
  uint32_t kept = 0;
  for (const Influence& influence : list.all()) {
    if (influence.weight > 0) list.items[kept++] = influence;
  }
  list.count = kept;
}

QuantizedSkin toSkin(const InfluenceList& list) {
  QuantizedSkin skin;
  skin.count = static_cast<uint8_t>(list.count);
  for (uint32_t i = 0; i < list.count; ++i) {
    skin.joint[i] = list.items[i].joint;
    skin.weight[i] = static_cast<uint16_t>(list.items[i].weight);
  }
  return skin;
}

InfluenceList blendEighths(const QuantizedSkin& v, const QuantizedSkin& u, int32_t t8) {
  InfluenceList blend;
  for (uint32_t i = 0; i < v.count; ++i) {
    int32_t other = 0;
    for (uint32_t k = 0; k < u.count; ++k) {
      if (u.joint[k] == v.joint[i]) other = u.weight[k];
    }
    blend.items[blend.count++] = {v.joint[i], v.weight[i] + format::eighths(other - v.weight[i], t8)};
  }
  for (uint32_t k = 0; k < u.count; ++k) {
    const auto end = v.joint.begin() + v.count;
    if (std::find(v.joint.begin(), end, u.joint[k]) != end) continue;
    blend.items[blend.count++] = {u.joint[k], format::eighths(u.weight[k], t8)};
  }
  return blend;
}

int32_t sumOf(InfluenceList& list) {
  int32_t sum = 0;
  for (const Influence& influence : list.all()) sum += influence.weight;
  return sum;
}

}  // namespace

QuantizedSkin quantizeSkin(std::span<const uint16_t> joints, std::span<const double> weights, uint32_t weight_one) {
  double sum = 0.0;
  for (double weight : weights) sum += weight;
  InfluenceList list;
  std::array<double, 16> remainder{};
  uint32_t assigned = 0;
  for (uint32_t i = 0; i < joints.size(); ++i) {
    const double exact = weights[i] / sum * weight_one;
    const auto whole = static_cast<int32_t>(std::floor(exact));
    remainder[i] = exact - whole;
    list.items[list.count++] = {joints[i], whole};
    assigned += static_cast<uint32_t>(whole);
  }
  for (; assigned < weight_one; ++assigned) {
    uint32_t best = 0;
    for (uint32_t i = 1; i < list.count; ++i) {
      if (remainder[i] > remainder[best]) best = i;
    }
    list.items[best].weight += 1;
    remainder[best] -= 1.0;
  }
  dropZeros(list);
  sortHeavierFirst(list);
  return toSkin(list);
}

QuantizedSkin interpolateSkin(const QuantizedSkin& v, const QuantizedSkin& u, int32_t t8, uint32_t weight_one,
                              uint32_t max_influences) {
  if (v == u) return v;
  InfluenceList blend = blendEighths(v, u, t8);
  dropZeros(blend);
  sortHeavierFirst(blend);
  const auto one = static_cast<int32_t>(weight_one);
  const bool cut = blend.count > max_influences;
  if (cut) {
    blend.count = max_influences;
    const int32_t sum = sumOf(blend);
    for (Influence& influence : blend.all()) {
      influence.weight = static_cast<int32_t>(int64_t{influence.weight} * one / sum);
    }
  }
  const int32_t missing = one - sumOf(blend);
  blend.items[0].weight += missing;
  if (cut || missing < 0) {
    dropZeros(blend);
    sortHeavierFirst(blend);
  }
  return toSkin(blend);
}

}  // namespace lithe::bake
