// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Numbers that later stages can compute with.
#pragma once

#include "gltf_file.h"

namespace lithe::bake {

/// Throws Error if positions, or what rest pose and clips do with them, can leave a range in which neither floats nor
/// their squares overflow. The bound is a product along the hierarchy, so it refuses no character that people make.
void requireRange(const FileName& name, const Model& model);

}  // namespace lithe::bake
