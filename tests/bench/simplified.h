// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// A bake's stages up to the collapses, for benches that judge simplification and not the file.
#pragma once

#include <vector>

#include "lithe/bake/bake.h"
#include "lithe/bake/mesh.h"
#include "lithe/bake/poses.h"

namespace lithe::bench {

struct Simplified {
  bake::Mesh mesh;
  bake::CollapseSequence sequence;
  double seconds = 0.0;  ///< of processor time for the collapses, one thread: other work on the machine does not count

  /// The triangles that a share of the finest level is.
  uint32_t triangles(double share) const;
};

/// Welds and simplifies as bake() does with these options, on one thread.
/// @throws bake::Error as weld() and simplify()
Simplified simplified(const bake::Model& model, const std::vector<bake::Pose>& poses, const bake::BakeOptions& options);

}  // namespace lithe::bench
