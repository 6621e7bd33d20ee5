// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Attributes of a wedge as a record of integers, and the record of a parent wedge.
#pragma once

#include "lithe/bake/hierarchy.h"
#include "lithe/format/octahedral.h"

namespace lithe::bake {

void gatherAttributes(const Mesh& mesh, uint32_t wedge, const WedgeRecord& record, int32_t* out);

/// The record at t8 eighths between two wedges. Octahedral directions go the short way over the fold where a reader can
/// undo it from either end, see octahedralDifference().
void attributesBetween(const WedgeRecord& record, int32_t normal_center, const int32_t* from, const int32_t* to,
                       int32_t t8, int32_t* out);

}  // namespace lithe::bake
