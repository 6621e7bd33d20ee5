// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// How the skins of a split's children are written against their parent's.
#pragma once

#include <functional>

#include "lithe/bake/mesh.h"
#include "lithe/format/ring_prediction.h"
#include "page_streams.h"
#include "residuals.h"

namespace lithe::bake {

/// The ring of the split node, and the skins of its neighbours.
struct SkinRing {
  const format::RingNeighbours& neighbours;
  std::function<const QuantizedSkin&(uint32_t wedge)> skin_of;
};

/// Writes the skin mode to `modes`, a stream of the page, and its values. a, b: the children; t8 from b (0) to a (8).
void encodeSkins(const QuantizedSkin& parent, const QuantizedSkin& a, const QuantizedSkin& b, int32_t t8,
                 uint32_t weight_one, const SkinRing& ring, StreamData& modes, PageData& page, Residuals& residuals);

}  // namespace lithe::bake
