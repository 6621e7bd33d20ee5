// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Residuals of a split page: collected in the order in which a reader consumes them, then split into an entropy-coded
/// high part and raw low bits with the shifts that cost least for the page.
#pragma once

#include <cstdint>
#include <vector>

#include "page_streams.h"

namespace lithe::bake {

/// The position difference of one split, with what its prediction depends on.
struct PositionResidual {
  std::array<int32_t, 3> difference;
  std::array<int64_t, 3> sum_a, sum_b;  ///< of the neighbourhoods
  int64_t count_a, count_b;
  uint32_t extent;  ///< of the ring: what the low bits' number follows
};

class Residuals {
 public:
  enum class Kind : uint8_t { kPosition, kNormal, kTangent, kUv };

  void addPosition(const PositionResidual& residual);
  /// A two-component difference; extent is |D| for uvs and unused for the others.
  void add(Kind kind, uint32_t set, int32_t x, int32_t y, uint32_t extent);

  /// Chooses the page's parameters and fills the streams and the low bits.
  void finish(PageData& page) const;

 private:
  struct Item {
    Kind kind;
    uint8_t set;
    uint32_t index;  ///< into positions_, for kPosition
    int32_t x, y;
    uint32_t extent;
  };
  struct Series;
  Series seriesOf(Kind kind, uint32_t set, int32_t laplacian) const;

  std::vector<PositionResidual> positions_;
  std::vector<Item> items_;
};

}  // namespace lithe::bake
