// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Which side of a triangle is outside when nodes or joints mirror.
#pragma once

#include "draft.h"
#include "scene.h"

namespace lithe::bake {

/// Fills in Draft::part_mirrored, and turns the triangles of mirrored parts round where a viewer draws them turned:
/// when the node that shows the part mirrors too (glTF 2.0, section 3.7.4). A skinned mesh whose joints mirror below a
/// node that does not is drawn as it is wound. Posed triangles are then counter-clockwise seen from outside, and the
/// handedness of turned tangents fits their mirrored uvs.
void turnMirroredParts(Draft& draft, const SceneTree& tree);

}  // namespace lithe::bake
