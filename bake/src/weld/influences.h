// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Imported skins -> capped, quantised skins.
#pragma once

#include <vector>

#include "lithe/bake/mesh.h"

namespace lithe::bake {

// The `max_influences` largest weights of a skin, refitted over the poses if more existed, quantised to `weight_one`.
QuantizedSkin capAndQuantize(const Model& model, const std::vector<Pose>& poses, uint32_t vertex,
                             uint32_t max_influences, uint32_t weight_one);

}  // namespace lithe::bake
