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

/// The cut whose number of triangles is closest to `triangles`: the hierarchy's splits are applied in the file's order
/// until the count is met. Triangles of the same corners and orientation count and are written once.
/// Everything must be loaded.
bake::Model modelOfTriangles(const Asset& asset, uint32_t triangles);

}  // namespace lithe::tool
