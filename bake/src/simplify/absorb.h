// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Where nodes without triangles go.
//
// A component that vanishes leaves nodes behind that no edge leads away from. Kept apart they would be stored, skinned
// and carried through every coarser level for nothing; so each is absorbed by a node near it that is still in use.
#pragma once

#include <cstdint>
#include <vector>

#include "node_state.h"
#include "surface.h"

namespace lithe::bake {

/// For each of the slots without triangles the nearest slot that has some: of the same part where there is one, so that
/// its wedges have someone to join; the smaller slot of two equally near. kNone when no triangle is left.
std::vector<uint32_t> nearestHosts(const std::vector<uint32_t>& faceless, const Mesh& mesh, const NodeState& nodes,
                                   const Surface& surface);

}  // namespace lithe::bake
