// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Attributes of a wedge as a record of integers, and the record of a parent wedge.
#pragma once

#include "lithe/bake/hierarchy.h"
#include "lithe/bake/octahedral_difference.h"

namespace lithe::bake {

/// A wedge's record; directions are the points that a reader gets, see format::octahedralPointOf().
void gatherAttributes(const Mesh& mesh, uint32_t wedge, const WedgeRecord& record, int32_t* out);

/// The record at t8 eighths between two wedges; its directions by the rule. Octahedral directions go the short way over
/// the fold where a reader can undo it from either end, see octahedralDifference().
void attributesBetween(const WedgeRecord& record, const int32_t* from, const int32_t* to, DirectionRule rule,
                       int32_t* out);

}  // namespace lithe::bake
