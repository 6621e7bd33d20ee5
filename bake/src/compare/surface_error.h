// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// One direction of one frame: everything that a sample and its matched point say about two posed surfaces.
#pragma once

#include "posed_surface.h"

namespace lithe::bake {

/// A surface at an instant, ready to be searched.
struct SearchableSurface {
  SearchableSurface(const MeasuredSurface& unposed, PosedSurface shape)
      : surface(unposed), posed(std::move(shape)), tree(posed.positions, surface.triangles) {}

  const MeasuredSurface& surface;
  PosedSurface posed;
  TriangleTree tree;
};

/// What is asked of the samples of one direction.
struct Sampling {
  uint32_t samples = 0;
  uint64_t seed = 0;
  bool with_uv = false;       ///< both surfaces have uvs and they are to be compared
  double beyond = 0.0;        ///< in the units of the positions
  bool from_original = true;  ///< the samples are the original's; else the simplified surface's
};

/// Lengths in the units of the positions.
SurfaceError surfaceError(const SearchableSurface& from, const SearchableSurface& to, const Sampling& sampling);

/// Member by member the larger.
SurfaceError largerOf(const SurfaceError& a, const SurfaceError& b);
/// sum += error, member by member.
void accumulate(SurfaceError& sum, const SurfaceError& error);
/// Lengths times `length_factor`, everything else (degrees, shares, uvs) times `other_factor`.
SurfaceError scaled(const SurfaceError& error, double length_factor, double other_factor);

}  // namespace lithe::bake
