// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Which cuts become levels, and how far each is from the original.
#pragma once

#include <vector>

#include "lithe/bake/bake.h"
#include "lithe/bake/encode.h"
#include "lithe/bake/mesh.h"

namespace lithe::bake {

/// How many triangles a share of the finest level is; at least one.
uint32_t trianglesOf(double share, const Mesh& mesh);

/// The cuts, coarse to fine, without their errors.
std::vector<LevelPlan> planLevels(const CollapseSequence& sequence, const Mesh& mesh,
                                  const std::vector<double>& shares);

/// Measures every level against the original in up to 8 of the example poses, both directions, from samples and all
/// vertices: error is the largest distance found, error_rms the largest root mean square of a pose. Errors are made
/// monotone: a coarser level never states less than a finer one.
void measureLevels(const Model& model, const Mesh& mesh, const CollapseSequence& sequence,
                   const std::vector<Pose>& poses, uint32_t threads, std::vector<LevelPlan>& levels,
                   const std::function<void(double)>& progress);

}  // namespace lithe::bake
