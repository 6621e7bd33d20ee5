// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// How the skins of a split's children are written against their parent's.
#pragma once

#include "lithe/bake/mesh.h"
#include "page_streams.h"

namespace lithe::bake {

/// Writes the skin mode and its values. a, b: the children; t8 from b (0) to a (8).
void encodeSkins(const QuantizedSkin& parent, const QuantizedSkin& a, const QuantizedSkin& b, int32_t t8,
                 uint32_t weight_one, PageData& page);

}  // namespace lithe::bake
