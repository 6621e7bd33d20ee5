// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// What lithe's sizes and times are measured against: the finest level alone, as Draco's edgebreaker makes it smallest.
///
/// Each part is a mesh of its own, equal values and equal points stored once, encoded at speed 0 (the strongest
/// coding, for the encoder and the decoder). The attributes are those of the .lithe file: positions of 14 bits on the
/// file's own grid, normals of 10 bits, texture coordinates of 12 bits; colours 4 x u8; joints 4 x u8 (u16 beyond 256)
/// and weights 4 x u8 that sum to 255 as generic integers with Draco's default prediction; tangents, where the file has
/// any, as three generic integers: the two octahedral coordinates and the handedness.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lithe/runtime.h"

namespace lithe::bench {

/// The streams of one character, one per part that has triangles.
struct DracoReference {
  std::vector<std::vector<uint8_t>> parts;
  uint32_t triangles = 0;          ///< encoded
  uint32_t left_out = 0;           ///< triangles with two corners in one place, which edgebreaker never stores
  std::vector<std::string> names;  ///< of the attributes: "normal", "uv0", ...

  uint64_t byteCount() const;
};

/// Encodes the finest level of an asset whose pages have all been supplied, decodes it again and compares positions,
/// joints and weights of every triangle. The asset must have been baked with default precisions.
/// @param with_skin  false leaves joints and weights out
/// @throws bake::Error when Draco refuses, or when what comes back is not what went in
DracoReference encodeReference(const lithe_asset& asset, bool with_skin = true);

/// Decodes every part and returns the number of points. @throws bake::Error when Draco refuses
uint64_t decodeReference(const DracoReference& reference);

}  // namespace lithe::bench
