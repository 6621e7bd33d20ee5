// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Vertices and triangles of all primitives, one after another.
#pragma once

#include "draft.h"
#include "inventory.h"

namespace lithe::bake {

/// Reads every primitive of the inventory: parts, vertices in the space of their skin (rigid ones in their node's),
/// joints as the file lists them, triangles, and rest_diagonal. Attributes that a primitive lacks are neutral, but
/// normals and tangents that it lacks are zero. Throws Error for damaged arrays, and where references make the file
/// expand beyond all proportion.
Draft readGeometry(const GltfFile& file, const Inventory& inventory);

}  // namespace lithe::bake
