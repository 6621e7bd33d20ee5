// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The value of an animation channel at a time.
#pragma once

#include "lithe/bake/model.h"

namespace lithe::bake {

/// Sets the property that the channel animates. Times before the first and after the last key hold that key.
void applyChannel(const Channel& channel, double time, Transform& local);

}  // namespace lithe::bake
