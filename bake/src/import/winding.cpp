// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "winding.h"

#include <utility>

#include "transform.h"

namespace lithe::bake {

namespace {

/// Per part: how much of its weight hangs on joints that mirror it at rest, less that on joints that do not.
std::vector<double> mirroredWeights(const Draft& draft, const SceneTree& tree) {
  std::vector<double> side;  // per joint
  for (const FileJoint& joint : draft.joints) {
    const glm::dmat4 to_rest = tree.world[joint.node] * joint.inverse_bind;
    side.push_back(mirrors(to_rest) ? 1.0 : invertible(to_rest) ? -1.0 : 0.0);
  }
  std::vector<double> weights(draft.model.parts.size(), 0.0);
  for (size_t t = 0; t < draft.model.triangles.size(); ++t) {
    for (const uint32_t corner : draft.model.triangles[t]) {
      const FileSkin& skin = draft.skins[corner];
      for (uint32_t k = 0; k < skin.count; ++k) {
        weights[draft.model.triangle_part[t]] += side[skin.joint[k]] * static_cast<double>(skin.weight[k]);
      }
    }
  }
  return weights;
}

void turnHandedness(Model& model, const std::vector<bool>& turned) {
  if (!model.attributes.tangent) return;
  std::vector<bool> done(model.positions.size(), false);
  for (size_t t = 0; t < model.triangles.size(); ++t) {
    if (!turned[model.triangle_part[t]]) continue;
    for (const uint32_t corner : model.triangles[t]) {
      if (!done[corner]) model.tangents[corner].w = -model.tangents[corner].w;
      done[corner] = true;
    }
  }
}

}  // namespace

void turnMirroredParts(Draft& draft, const SceneTree& tree) {
  std::vector<bool> turned;  // per part
  for (const double weight : mirroredWeights(draft, tree)) {
    draft.part_mirrored.push_back(weight > 0.0);
    turned.push_back(weight > 0.0 && mirrors(tree.world[draft.part_node[turned.size()]]));
  }
  Model& model = draft.model;
  for (size_t t = 0; t < model.triangles.size(); ++t) {
    if (turned[model.triangle_part[t]]) std::swap(model.triangles[t][1], model.triangles[t][2]);
  }
  turnHandedness(model, turned);
}

}  // namespace lithe::bake
