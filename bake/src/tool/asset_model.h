// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// A cut of a decoded character as a Model: what `export` writes and `verify` measures.
#pragma once

#include <cstdint>

#include "asset.h"
#include "lithe/bake/model.h"

namespace lithe::tool {

/// A level exactly as an engine draws it, decoded by lithe_asset_write_vertices and _write_indices.
/// The level must be loaded. Clips are not in the file; the model has none.
bake::Model modelOfLevel(const Asset& asset, uint32_t level);

/// The cut whose number of triangles is closest to `triangles`: the splits are applied one by one, level after level
/// and in a level where they matter most first, until the count is met; see split_order.h. Triangles with the same
/// nodes and orientation count and are written once. Everything must be loaded.
bake::Model modelOfTriangles(const Asset& asset, uint32_t triangles);

/// The skeleton and every vertex of every level under its own number, without triangles: for posing them all.
bake::Model modelOfAllVertices(const Asset& asset);

}  // namespace lithe::tool
