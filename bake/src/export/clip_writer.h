// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The animations of an exported file.
#pragma once

#include "gltf_builder.h"
#include "lithe/bake/model.h"

namespace lithe::bake {

/// Writes the clips; channels without keys and clips without channels are left out.
void writeClips(const std::vector<Clip>& clips, GltfBuilder& gltf);

/// The clips of `source` with their channels on the nodes of `target` that have the same name, or where the name is not
/// there once, the same index and name or an index without a name. Channels of other nodes are dropped.
std::vector<Clip> retargetedClips(const Model& source, const Model& target);

}  // namespace lithe::bake
