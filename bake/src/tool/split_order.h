// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The order in which splits are applied one by one to reach the cuts between two levels.
#pragma once

#include <cstdint>
#include <vector>

#include "asset.h"

namespace lithe::tool {

/// Any set of splits that holds a node's split only together with its ancestors' gives a mesh; this order makes every
/// prefix one. Level follows level, so every level is a prefix too. Inside a level the node comes first that is
/// farthest from the surface it stands for, see standInCosts().
struct SplitOrder {
  std::vector<uint32_t> rank;  ///< per node: how many splits come before its own; LITHE_NO_INDEX where it has none
  uint32_t count = 0;          ///< splits in all
};

/// The asset must be loaded.
SplitOrder orderSplits(const Asset& asset);

/// Per node, what it costs that it is not split: its squared distance to the planes of the finest faces below it,
/// weighted by area (the accumulated quadrics of Garland and Heckbert, "Surface Simplification Using Quadric Error
/// Metrics", 1997; open edges get their upright planes), summed over the rest pose and some sampled poses.
std::vector<double> standInCosts(const Asset& asset);

}  // namespace lithe::tool
