// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Reading a glTF 2.0 file (.glb or .gltf) as a Model.
///
/// Taken: any number of skins, meshes, primitives and materials; triangle lists, strips and fans, indexed or not;
/// sparse, interleaved and quantised accessors (KHR_mesh_quantization); KHR_draco_mesh_compression;
/// EXT_meshopt_compression and KHR_meshopt_compression with version 0 of the vertex codec; rigid meshes beside skinned
/// ones, each bound to its node by one joint; all animations. Only what the default scene shows is read (the first
/// scene where none is the default, every node where there is no scene). Images are never opened.
///
/// Repaired with a warning: weights that do not sum to one or are negative, vertices without weights (bound to the
/// skin's first joint), influences beyond eight or of joints the skin lacks, missing or invalid normals (area-weighted
/// over all triangles around a position), keys out of order, sheared node matrices (the shear is dropped). Dropped with
/// a warning: morph targets, uv sets beyond kMaxUvSets, colour sets beyond kMaxColorSets, primitives without
/// triangles (empty ones, points, lines). Dropped silently: cameras, lights, channels of nodes that move no vertex,
/// vertices no triangle uses.
#pragma once

#include <filesystem>

#include "lithe/bake/model.h"

namespace lithe::bake {

/// Reads a glTF 2.0 file.
///
/// Bind space: parts may be stored in spaces of their own (another unit, a quantisation folded into the inverse binds).
/// Where they are, all vertices are moved into one common space and the inverse binds changed to match, so that one
/// grid over all positions wastes nothing; where they are not, positions stay as in the file. Posed positions are the
/// same either way. Rigid parts are moved to where the rest pose shows them beside the skinned ones.
///
/// Winding: triangles are counter-clockwise seen from outside once they are posed. Those of a node that mirrors (a
/// negative determinant at rest) are turned round, as viewers do; those of a skinned mesh only if its joints mirror
/// too, since glTF ignores the transform of its node.
///
/// Attributes that only some primitives have are filled in for the others: uv by zero, colours by opaque white (glTF's
/// neutral values), tangents by a unit vector at right angles to the normal. Normals are always present.
/// @throws Error if the file cannot be read, is damaged, refers to what it does not contain, has no triangle, or needs
///         something listed above as not taken
Model importGltf(const std::filesystem::path& path);

}  // namespace lithe::bake
