// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// How finely a character's weights must be quantised.
#pragma once

#include <vector>

#include "lithe/bake/model.h"

namespace lithe::bake {

inline constexpr uint32_t kLeastWeightBits = 8, kMostWeightBits = 12;

/// The fewest bits with which rounding a weight moves a posed vertex no further, in the root mean square over vertices
/// and poses, than two steps of the position grid: 8 suffice for most characters, wide smooth blends between joints
/// that move far apart need more.
uint32_t chooseWeightBits(const Model& model, const std::vector<Pose>& poses, uint32_t position_bits);

}  // namespace lithe::bake
