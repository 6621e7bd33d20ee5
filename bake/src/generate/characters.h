// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// One function per built-in character; what each looks like is said in lithe/bake/generate.h.
#pragma once

#include "lithe/bake/model.h"

namespace lithe::bake {

Model generateColumn();
Model generateCentipede();
Model generateFigure();

}  // namespace lithe::bake
