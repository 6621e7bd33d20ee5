// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Residuals of a split page: collected in the order in which a reader consumes them, then split into an entropy-coded
/// high part and raw low bits with the predictions and shifts that cost least for the page.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "page_streams.h"

namespace lithe::bake {

/// A difference between two children and what it may be predicted from.
struct Residual {
  enum class Kind : uint8_t {
    kPosition,
    kLattice,
    kNormal,
    kTangent,
    kUv,
    kSkin,
    // Of further wedges.
    kExtraNormal,
    kExtraTangent,
    kExtraUv,
    kExtraPlain  ///< handedness, colours
  };
  Kind kind = Kind::kPosition;
  uint8_t set = 0;         ///< uv set
  uint8_t components = 1;  ///< of the arrays below
  std::array<int32_t, 3> difference{};
  std::array<format::Slope, 3> slope{};  ///< of the neighbourhoods' means (positions), from the children's line
                                         ///< (lattice) or over the ring
  std::array<int64_t, 3> normal{};       ///< of the ring (positions)
  std::array<int32_t, 3> geometry{};     ///< of the area normals (normals)
  /// What the number of low bits follows: the ring's mean edge (positions), its spread (attributes). Of a
  /// lattice index, which has none, the lattice's step.
  uint32_t extent = 0;
};

/// The number of low bits with which values take the fewest bits: high parts entropy coded, low bits raw.
uint8_t bestShift(const std::vector<int32_t>& values);

class Residuals {
 public:
  void add(const Residual& residual) { items_.push_back(residual); }

  /// Chooses the page's parameters and fills the streams and the low bits.
  void finish(PageData& page) const;

 private:
  std::vector<Residual> items_;
};

}  // namespace lithe::bake
