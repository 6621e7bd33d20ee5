// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Quantised skins: how weights become integers that sum exactly, and how a parent's skin follows from its children's.
#pragma once

#include <cstdint>
#include <span>

#include "lithe/bake/mesh.h"

namespace lithe::bake {

/// Rounds weights to integers that sum exactly to `weight_one` by largest remainders (ties: lower position in the
/// span). Joints whose weight rounds to zero are dropped; the result is sorted as QuantizedSkin says.
/// @param joints   distinct, at most eight
/// @param weights  >= 0, same length, positive sum (need not be 1)
QuantizedSkin quantizeSkin(std::span<const uint16_t> joints, std::span<const double> weights, uint32_t weight_one);

/// The skin at t8 eighths from v (0) to u (8): the default form of a parent's skin, in integers only.
///
/// Per joint of the union: v_j + eighths(u_j - v_j, t8); the `max_influences` largest are kept (ties: lower joint).
/// Where that cut something off, the kept ones are scaled up to weight_one, rounded down. What is missing (or too much
/// by rounding) goes to the largest. Exchanging the ends (t8 -> 8 - t8) gives the same skin.
QuantizedSkin interpolateSkin(const QuantizedSkin& v, const QuantizedSkin& u, int32_t t8, uint32_t weight_one,
                              uint32_t max_influences);

}  // namespace lithe::bake
