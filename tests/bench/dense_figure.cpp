// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "dense_figure.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "lithe/bake/cut.h"
#include "lithe/bake/generate.h"
#include "lithe/bake/poses.h"
#include "lithe/bake/simplify.h"
#include "lithe/bake/weld.h"

namespace lithe::bench {
namespace {

using bake::Model;
using bake::Skin;

constexpr uint32_t kCutPoses = 8;

// Of the 1.75 units that the figure is tall; its edges are about 0.002 long when cut.
constexpr float kReliefHeight = 0.0004f;
constexpr float kReliefFrequency = 500.0f;

Model cutTo(const Model& model, uint32_t triangles) {
  bake::PoseOptions pose_options;
  pose_options.count = kCutPoses;
  const std::vector<bake::Pose> poses = bake::choosePoses(model, pose_options);
  std::vector<std::string> warnings;
  const bake::Mesh mesh = bake::weld(model, poses, {}, warnings);
  bake::SimplifyOptions options;
  options.min_triangles = triangles;
  return bake::cutToModel(model, mesh, bake::simplify(mesh, model.joints, poses, options), triangles);
}

Skin meanSkin(const Skin& a, const Skin& b) {
  std::map<uint16_t, float> weights;
  for (const Skin* skin : {&a, &b})
    for (uint32_t k = 0; k < skin->count; ++k) weights[skin->joint[k]] += 0.5f * skin->weight[k];
  std::vector<std::pair<uint16_t, float>> sorted(weights.begin(), weights.end());
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& x, const auto& y) { return x.second > y.second; });
  Skin mean;
  mean.count = static_cast<uint8_t>(std::min<size_t>(sorted.size(), bake::kMaxImportedInfluences));
  float sum = 0.0f;
  for (uint32_t k = 0; k < mean.count; ++k) sum += sorted[k].second;
  for (uint32_t k = 0; k < mean.count; ++k) {
    mean.joint[k] = sorted[k].first;
    mean.weight[k] = sorted[k].second / sum;
  }
  return mean;
}

template <class Value>
void appendMean(std::vector<Value>& values, uint32_t a, uint32_t b) {
  values.push_back(0.5f * (values[a] + values[b]));
}

/// Cuts a model's edges in the middle, each once.
class EdgeCutter {
 public:
  explicit EdgeCutter(Model& model) : model_(model) {}

  uint32_t middleOf(uint32_t a, uint32_t b) {
    const auto next = static_cast<uint32_t>(model_.positions.size());
    const auto [found, is_new] = middle_.try_emplace({std::min(a, b), std::max(a, b)}, next);
    if (is_new) append(a, b);
    return found->second;
  }

 private:
  void append(uint32_t a, uint32_t b) {
    appendMean(model_.positions, a, b);
    model_.skins.push_back(meanSkin(model_.skins[std::min(a, b)], model_.skins[std::max(a, b)]));
    if (model_.attributes.normal) {
      const glm::vec3 sum = model_.normals[a] + model_.normals[b];
      model_.normals.push_back(glm::dot(sum, sum) > 0.0f ? glm::normalize(sum) : model_.normals[a]);
    }
    for (uint32_t set = 0; set < model_.attributes.uv_sets; ++set) appendMean(model_.uvs[set], a, b);
  }

  Model& model_;
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> middle_;
};

void cutInFour(Model& model) {
  EdgeCutter cutter(model);
  std::vector<std::array<uint32_t, 3>> triangles;
  std::vector<uint32_t> parts;
  for (size_t t = 0; t < model.triangles.size(); ++t) {
    const auto [a, b, c] = model.triangles[t];
    const uint32_t ab = cutter.middleOf(a, b), bc = cutter.middleOf(b, c), ca = cutter.middleOf(c, a);
    triangles.insert(triangles.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    parts.insert(parts.end(), 4, model.triangle_part[t]);
  }
  model.triangles = std::move(triangles);
  model.triangle_part = std::move(parts);
}

/// By position alone, so that vertices in one place stay there together.
void addRelief(Model& model) {
  for (glm::vec3& p : model.positions) {
    const glm::vec3 q = kReliefFrequency * p;
    p += kReliefHeight * glm::vec3(std::sin(q.y + 0.7f * q.z), std::sin(q.z + 0.9f * q.x), std::sin(q.x + 0.8f * q.y));
  }
}

}  // namespace

std::vector<std::string> denseFigureNames() { return {"50k", "200k", "figure", "1M"}; }

Model denseFigure(const std::string& name) {
  Model model = bake::generate("figure");
  if (name == "figure") return model;
  if (name == "50k") return cutTo(model, 50'000);
  if (name == "200k") return cutTo(model, 200'000);
  if (name != "1M") throw bake::Error("there is no " + name + ", choose one of 50k, 200k, figure, 1M");
  cutInFour(model);
  addRelief(model);
  return model;
}

}  // namespace lithe::bench
