// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// One character at several densities, to see how work grows with its triangles.
#pragma once

#include <string>
#include <vector>

#include "lithe/bake/model.h"

namespace lithe::bench {

/// `50k` and `200k`: the built-in figure, simplified to as many triangles, so that their sizes follow the surface as an
/// artist's do. `1M`: all its triangles cut in four, with a relief as fine as the new edges, so that they are not flat.
/// `figure`: as it is.
std::vector<std::string> denseFigureNames();

/// @throws bake::Error for a name that denseFigureNames() does not list
bake::Model denseFigure(const std::string& name);

}  // namespace lithe::bench
