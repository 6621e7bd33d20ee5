// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Model -> Mesh: vertices welded by position and skin, influences capped, everything quantised.
#pragma once

#include <string>
#include <vector>

#include "lithe/bake/mesh.h"

namespace lithe::bake {

struct WeldOptions {
  uint32_t position_bits = 14;  ///< [limit: 8..20] the grid's coordinates
  uint32_t weight_bits = 8;     ///< [limit: 4..16]
  uint32_t normal_bits = 10;    ///< [limit: 4..16] octahedral, per component; tangents too
  uint32_t uv_bits = 12;        ///< [limit: 4..20]
  uint32_t max_influences = 4;  ///< [limit: 1..8] the influence cap of every vertex
  AttributeSet attributes{true, true, kMaxUvSets, kMaxColorSets};  ///< what to keep of what the model has
};

/// Welds and quantises a model.
///
/// Vertices are welded when their original positions lie within 1e-6 of the bounding box's diagonal of each other AND
/// the L1 difference of their weights is below 0.02 AND they belong to the same rigid node (or both to none). A welded
/// vertex has the position and the skin of the first of its source vertices. Vertices that only share a grid point stay
/// apart. Skins with more influences than the cap keep those that, refitted, come closest in the least-squares sense to
/// where `poses` put the vertex; the largest without poses. Wedges are numbered in the order of their first use by a
/// triangle; vertices in the order of their wedges. Normals and tangents go to the octahedral grid point whose
/// direction is closest in angle among the rounding neighbours.
///
/// @param poses     palettes per model.joints; used for refitting only, may be empty
/// @param warnings  one sentence is appended per kind of loss: degenerate and duplicate triangles, capped influences
/// @return a mesh with at least one triangle. Triangles keep the model's order; those that degenerate by welding or
/// repeat
///         an earlier one (same wedges, same orientation) are left out.
/// @throws Error when an option is out of its limits or no triangle remains
/// No global state; callable from any thread.
Mesh weld(const Model& model, const std::vector<Pose>& poses, const WeldOptions& options,
          std::vector<std::string>& warnings);

}  // namespace lithe::bake
