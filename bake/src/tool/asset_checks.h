// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// What must hold of a decoded character beyond what the reader itself refuses.
#pragma once

#include <cstdint>

#include "asset.h"

namespace lithe::tool {

/// The tables: the file is exactly as long as it says, errors never grow towards finer levels, joints have nodes.
/// @throws bake::Error naming the file and the place
void checkTables(const Asset& asset);

/// One resident level: corners in range and different, part ranges that cover the indices, vertices finite and inside
/// the asset's box, weights that sum to one over joints that exist, unit normals, morph sources that the level above
/// has.
/// @throws bake::Error naming the level and the vertex or triangle
void checkLevel(const Asset& asset, uint32_t level);

/// A number that depends on every byte a level's buffers have: it must not change while finer levels come and go.
uint64_t fingerprint(const Asset& asset, uint32_t level);

}  // namespace lithe::tool
