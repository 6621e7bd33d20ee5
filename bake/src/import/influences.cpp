// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "influences.h"

#include <algorithm>
#include <cmath>

#include "inventory.h"

namespace lithe::bake {

namespace {

/// Four 8-bit weights, each rounded, miss one by up to 0.008.
constexpr double kSumTolerance = 0.01;

void warn(uint64_t count, const std::string& what, std::vector<std::string>& warnings) {
  if (count > 0) warnings.push_back(std::to_string(count) + " " + what);
}

}  // namespace

void SkinRepairs::addTo(std::vector<std::string>& warnings) const {
  warn(not_normalized, "vertices have weights that do not sum to one; they are scaled to do so", warnings);
  warn(without_weights, "vertices have no weights; they are bound to the first joint of their skin", warnings);
  warn(negative, "weights are negative; they are taken as zero", warnings);
  warn(foreign_joints, "influences are of joints that their skin lacks; they are dropped", warnings);
  warn(too_many,
       "vertices have more than " + std::to_string(kMaxImportedInfluences) + " influences; the largest are kept",
       warnings);
}

InfluenceArrays::InfluenceArrays(const GltfFile& file, const PrimitiveArrays& arrays, JointRange joints,
                                 std::string place)
    : file_(file), joints_(joints), place_(std::move(place)) {
  for (uint32_t set = 0;; ++set) {
    const auto joint_set = arrays.attribute(attributeName("JOINTS", set), {TINYGLTF_TYPE_VEC4});
    const auto weight_set = arrays.attribute(attributeName("WEIGHTS", set), {TINYGLTF_TYPE_VEC4});
    if (!joint_set || !weight_set) break;
    joint_sets_.push_back(*joint_set);
    weight_sets_.push_back(*weight_set);
  }
}

double InfluenceArrays::checkedWeight(uint64_t vertex, double weight, SkinRepairs& repairs) const {
  if (!std::isfinite(weight)) {
    file_.name.fail(place_, "a weight of vertex " + std::to_string(vertex) + " is not a number; re-export the file");
  }
  if (weight < 0.0) ++repairs.negative;
  return std::max(weight, 0.0);
}

/// Influences > 0 with every joint once, in the file's order.
std::vector<InfluenceArrays::Influence> InfluenceArrays::collect(uint64_t vertex, SkinRepairs& repairs) const {
  std::vector<Influence> influences;
  for (size_t set = 0; set < joint_sets_.size(); ++set) {
    for (uint32_t k = 0; k < 4; ++k) {
      const double weight =
          checkedWeight(vertex, weight_sets_[set].number(vertex, k, IntegerMeaning::kNormalized), repairs);
      if (!(weight > 0.0)) continue;
      const uint32_t joint = joint_sets_[set].integer(vertex, k);
      if (joint >= joints_.count) {
        ++repairs.foreign_joints;
        continue;
      }
      const auto same = std::find_if(influences.begin(), influences.end(),
                                     [&](const Influence& other) { return other.joint == joints_.first + joint; });
      if (same == influences.end()) {
        influences.push_back({joints_.first + joint, weight});
      } else {
        same->weight += weight;
      }
    }
  }
  return influences;
}

FileSkin InfluenceArrays::read(uint64_t vertex, SkinRepairs& repairs) const {
  std::vector<Influence> influences = collect(vertex, repairs);
  std::stable_sort(influences.begin(), influences.end(),
                   [](const Influence& a, const Influence& b) { return a.weight > b.weight; });
  double sum = 0.0;
  for (const Influence& influence : influences) sum += influence.weight;
  if (influences.empty()) {
    ++repairs.without_weights;
    influences.push_back({joints_.first, 1.0});
  } else if (std::abs(sum - 1.0) > kSumTolerance) {
    ++repairs.not_normalized;
  }
  if (influences.size() > kMaxImportedInfluences) {
    ++repairs.too_many;
    influences.resize(kMaxImportedInfluences);
  }
  sum = 0.0;
  for (const Influence& influence : influences) sum += influence.weight;
  FileSkin skin;
  for (const Influence& influence : influences) {
    const float share = static_cast<float>(influence.weight / sum);
    if (!(share > 0.0f)) break;  // beside a huge weight a tiny one is nothing; those behind are no larger
    skin.joint[skin.count] = influence.joint;
    skin.weight[skin.count] = share;
    ++skin.count;
  }
  return skin;
}

}  // namespace lithe::bake
