// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The animations of a file.
#pragma once

#include "gltf_file.h"

namespace lithe::bake {

/// Reads every animation. Channels of nodes that the model does without are left out, as are those of morph weights,
/// but both count for the clip's length. A clip without a name is called "anim" and its number.
/// @param node_index  per node of the file: its index in Model::nodes or kNone
/// Throws Error for damaged keys.
std::vector<Clip> readClips(const GltfFile& file, const std::vector<uint32_t>& node_index,
                            std::vector<std::string>& warnings);

}  // namespace lithe::bake
