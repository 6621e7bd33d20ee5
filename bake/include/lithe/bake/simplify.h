// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Mesh -> CollapseSequence: edge collapses in the order of the error they make on the posed surface.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lithe/bake/mesh.h"

namespace lithe::bake {

struct SimplifyOptions {
  /// How a collapse is judged; see metricNames(). Quadrics are weighted by area in all of them, where the papers of
  /// articulated, dsd, pose-independent and rest sum planes of equal weight; and all have planes along borders, seams
  /// and folds.
  /// articulated       example poses, a quadric each: position optimised for all of them, weights where that pays
  ///                   (Landreneau and Schaefer 2009; quadrics of the current surface, guarded by accumulated ones;
  ///                   weights stay on the simplex)
  /// rest              the bind pose only, the best position (Garland and Heckbert 1997)
  /// dsd               a quadric per pose, end points only, each with its own skin (Mohr and Gleicher 2003, as
  ///                   Landreneau and Schaefer describe it)
  /// pose-independent  one quadric per vertex, pulled back from the poses through the vertex's own matrices; the best
  ///                   position in the bind pose, interpolated weights (DeCoro and Rusinkiewicz 2005, as Landreneau and
  ///                   Schaefer describe it)
  /// dod               dsd, and what edges cost that change their length over the poses: the largest change over its
  ///                   standard deviation, times the area at the edge, times the squared mean change (Huang, Chen and
  ///                   Chuang 2006). The sum, the area and the standard deviation are the paper's; the product, and
  ///                   changes taken from the mean length, are a reconstruction in consistent units.
  std::string metric = "articulated";
  uint32_t placement_shift = 4;  ///< of format::latticeStep: how finely parents are placed; 31 = every grid point
  uint32_t threads = 0;          ///< 0 = as many as the machine has; the result does not depend on it
  /// Stop here. It is always reached, but for what can only vanish as a whole (the last two triangles of a closed
  /// surface): unless 0 is asked for, something stays.
  uint32_t min_triangles = 0;

  double boundary_weight = 1.0;  ///< of border edges, in units of half the edge length squared
  double seam_weight = 0.1;      ///< of edges whose wedges or parts differ, per side
  double fold_weight = 1.0;      ///< of edges whose faces fold back on each other, per side
  /// What it costs to lose a whole component or a flap of one, in units of what its surface would be away from the
  /// rest; the second value counts below vanish_coarse of the triangles.
  double vanish_factor = 1000.0;
  double vanish_factor_coarse = 100.0;
  double vanish_coarse = 0.03;
  /// An optimised skin replaces the interpolated one (which costs nothing in the file) only where it lowers the cost by
  /// more than this share; in a refit too.
  double weight_gain = 0.3;

  /// Triangle counts of the levels, in any order; the end of the sequence is one beside them. Where a level ends, nodes
  /// without triangles are absorbed by others, and the nodes made since the last level are refit.
  std::vector<uint32_t> levels;
  /// Refit: move nodes, and weigh their joints anew, so that the posed surface lies closest to the original's. Only the
  /// metric `articulated` does so.
  bool refit = true;

  std::function<void(double)> progress;  ///< called now and then with 0..1, from the calling thread; may be empty
};

/// The names that SimplifyOptions::metric may have.
const std::vector<std::string>& metricNames();

/// Simplifies until at most options.min_triangles are left.
///
/// @param joints  the palette that mesh.skins refer to
/// @param poses   example poses, at least one, a palette of joints.size() each; the metric `rest` does not read them
/// @return collapses as mesh.h describes them: every position follows format/placement.h with `placement_shift` and
/// lies in
///         the grid; every skin has at most mesh.max_influences influences and sums to mesh.weight_one. `triangles`
///         counts triangles with the same three nodes in the same orientation once, whatever their wedges and parts.
///         Nodes that have lost all their triangles are absorbed by others where a level ends: such a collapse changes
///         no triangle, and its parent is child[0] again. So every node of a level has triangles, unless none is left
///         at all.
/// @throws Error for an unknown metric (listing the names), no poses, or a palette of another size
/// Deterministic: the same input gives the same result on any number of threads. Uses its own threads; no global state.
CollapseSequence simplify(const Mesh& mesh, const std::vector<Joint>& joints, const std::vector<Pose>& poses,
                          const SimplifyOptions& options);

}  // namespace lithe::bake
