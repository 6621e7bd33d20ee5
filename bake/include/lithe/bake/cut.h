// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// A cut through a collapse sequence as a model again: for judging, and as the specification of what a level shows.
#pragma once

#include <cstdint>

#include "lithe/bake/mesh.h"

namespace lithe::bake {

/// How many collapses bring the mesh to at most `triangles` triangles, with the absorptions that follow the last of
/// them; all of them if none does.
uint32_t collapsesToReach(const CollapseSequence& sequence, const Mesh& mesh, uint32_t triangles);

/// Influences as a reader's floats.
/// @param weight_one  Mesh::weight_one
Skin toFloats(const QuantizedSkin& quantized, uint32_t weight_one);

/// The mesh after collapsesToReach() collapses, dequantised; skeleton, parts, materials and clips are the original's.
///
/// Wedges: when a triangle dies because two of its corners became one node, the wedges at these corners become one,
/// whose attributes lie t8 eighths of the way from that of child 0 to that of child 1, directions half way. Every other
/// wedge goes on alone.
/// Triangles with the same three nodes in the same orientation are output once; parts may lose all their triangles.
Model cutToModel(const Model& original, const Mesh& mesh, const CollapseSequence& sequence, uint32_t triangles);

}  // namespace lithe::bake
