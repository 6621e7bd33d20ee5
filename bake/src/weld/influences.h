// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Imported skins -> capped, quantised skins.
#pragma once

#include <vector>

#include "lithe/bake/mesh.h"

namespace lithe::bake {

// A skin with at most `max_influences` weights, quantised to `weight_one`. Of more, those are kept that, refitted, put
// the vertex closest to where it was in the poses; without poses the largest.
QuantizedSkin capAndQuantize(const Model& model, const std::vector<Pose>& poses, uint32_t vertex,
                             uint32_t max_influences, uint32_t weight_one);

}  // namespace lithe::bake
