// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// One bind space for all parts of a character.
///
/// A skin's vertices lie in whatever space its inverse binds undo: another unit, or a quantisation of positions that
/// was folded into them. Within one skin, joints that never influence a common vertex can differ in that too. One grid
/// over all positions would then waste most of its bits, and equal joints of two skins would look different.
#pragma once

#include "draft.h"
#include "scene.h"

namespace lithe::bake {

/// Moves the vertices of every group of joints (those that influence common vertices) by one affine map and multiplies
/// the joints' inverse binds by its inverse, so that all groups share a space and posed positions stay.
///
/// If they share one already (a node has one inverse bind wherever it occurs, and bind space is to rest-posed space the
/// same scale in all groups), skinned parts are left untouched. Otherwise groups that share nodes are first brought
/// together through these, and then moved to where the rest pose shows them by way of their heaviest joint. Rigid parts
/// are moved to where the rest pose shows them beside the skinned ones.
void unifyBindSpace(Draft& draft, const SceneTree& tree);

}  // namespace lithe::bake
