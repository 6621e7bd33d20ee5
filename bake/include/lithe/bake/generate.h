// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The built-in characters: dense skinned models made from formulas, so that tests and demonstrations need no file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lithe/bake/model.h"

namespace lithe::bake {

/// The names generate() knows, in a fixed order.
std::vector<std::string> generatorNames();

/// Makes a built-in character.
///
/// `column`     the square column of Landreneau and Schaefer, "Simplification of Articulated Meshes" (2009): 1 x 8 x 1
/// units,
///              y in [0, 8], 114,688 triangles, one part, 4 joints in a chain with at most 2 influences; clips
///              `examples` (4 keys, one pose each, 1 s apart) and `test` (60 keys of other poses, 1/30 s apart).
/// `centipede`  about 200,000 triangles in many closed pieces, 5.5 units long, facing +z, nearly 200 joints, parts
/// `shell` and
///              `flesh`; clips `walk` (loops) and `curl`.
/// `figure`     a human of about 240,000 triangles, 1.75 units tall, soles at y = 0, facing +z, parts `skin`, `shorts`
/// and
///              `eyes`; clips `walk`, `run` (both loop, on the spot), `wave`, `crouch`, `sit`.
///
/// Every model carries positions, unit normals that point outwards, one uv set in [0, 1], skins of at most 4
/// influences, and a skeleton whose rest pose is the bind pose: world(joint.node) * joint.inverse_bind is the identity.
/// y is up. The model is made in memory and owned by the caller; the same name gives the same bytes on every machine.
/// Throws Error for a name that generatorNames() does not list. Safe to call from any thread; takes up to some ten
/// seconds.
Model generate(std::string_view name);

}  // namespace lithe::bake
