// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The list of metrics: a new one gets a row here and a file of its own.
#include <algorithm>

#include "metric.h"

namespace lithe::bake {

namespace {

struct Entry {
  const char* name;
  bool reads_poses;  // or judges in the bind pose
  std::unique_ptr<Metric> (*make)(const MetricInput&);
};

constexpr Entry kMetrics[] = {
    {"articulated", true, makeArticulatedMetric},
    {"rest", false, [](const MetricInput& input) { return makeAccumulatedMetric(input, false); }},
    {"dsd", true, [](const MetricInput& input) { return makeAccumulatedMetric(input, true); }},
    {"pose-independent", true, makePoseIndependentMetric},
    {"dod", true, makeDeformationMetric},
};

const Entry& find(const std::string& name) {
  const auto* found =
      std::find_if(std::begin(kMetrics), std::end(kMetrics), [&](const Entry& e) { return name == e.name; });
  if (found != std::end(kMetrics)) return *found;
  std::string names;
  for (const std::string& known : metricNames()) names += (names.empty() ? "" : ", ") + known;
  throw Error("simplify: there is no metric \"" + name + "\", choose one of " + names);
}

}  // namespace

const std::vector<std::string>& metricNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const Entry& entry : kMetrics) list.emplace_back(entry.name);
    return list;
  }();
  return names;
}

std::vector<std::vector<glm::dmat4>> palettesOf(const std::string& metric, const std::vector<Joint>& joints,
                                                const std::vector<Pose>& poses) {
  if (!find(metric).reads_poses) return {std::vector<glm::dmat4>(joints.size(), glm::dmat4(1.0))};
  if (poses.empty()) throw Error("simplify: there are no example poses, give at least one");
  std::vector<std::vector<glm::dmat4>> palettes;
  for (const Pose& pose : poses) {
    if (pose.palette.size() != joints.size()) {
      throw Error("simplify: example pose " + std::to_string(palettes.size()) + " has " +
                  std::to_string(pose.palette.size()) + " joints, give as many as the model has, " +
                  std::to_string(joints.size()));
    }
    palettes.push_back(pose.palette);
  }
  return palettes;
}

std::unique_ptr<Metric> makeMetric(const MetricInput& input) { return find(input.options.metric).make(input); }

}  // namespace lithe::bake
