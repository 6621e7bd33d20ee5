// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The instants of clips that example poses are chosen from.
#pragma once

#include <string>
#include <vector>

#include "lithe/bake/model.h"

namespace lithe::bake {

/// Indices of the named clips, ascending; all clips if no names are given. Throws Error for a name that is no clip's.
std::vector<uint32_t> findClips(const Model& model, const std::vector<std::string>& names);

/// Poses of the clips in order of clip and time.
std::vector<Pose> clipCandidates(const Model& model, const std::vector<uint32_t>& clips);

}  // namespace lithe::bake
