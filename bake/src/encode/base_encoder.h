// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The base page: the coarsest cut, written outright.
#pragma once

#include "cut.h"
#include "page_streams.h"

namespace lithe::bake {

/// Puts the hierarchy's roots, their wedges and the faces of every cut into the (empty) cut and into a page.
PageData encodeBase(Cut& cut, format::WedgeAttributes has);

}  // namespace lithe::bake
