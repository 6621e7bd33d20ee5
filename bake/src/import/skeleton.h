// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Nodes, palette and influences of the finished model.
#pragma once

#include "draft.h"
#include "scene.h"

namespace lithe::bake {

/// Fills in nodes, joints and skins of the draft's model. Joints of one node whose inverse binds pose their vertices
/// alike become one; joints that move no vertex are kept if no other stands for their node.
/// @return per node of the file: its index in Model::nodes, kNone if the model does without it
/// Throws Error for more joints than influences can name.
std::vector<uint32_t> buildSkeleton(Draft& draft, const SceneTree& tree, const GltfFile& file);

}  // namespace lithe::bake
