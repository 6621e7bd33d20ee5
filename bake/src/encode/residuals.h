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

/// A difference between two children and what its prediction depends on: sums over either child's neighbours.
struct Residual {
  enum class Kind : uint8_t { kPosition, kNormal, kTangent, kUv, kExtra };
  Kind kind = Kind::kPosition;
  uint8_t set = 0;         ///< uv set
  uint8_t components = 1;  ///< of the arrays below
  std::array<int32_t, 3> difference{};
  std::array<int64_t, 3> sum_a{}, sum_b{};
  int64_t count_a = 0, count_b = 0;
  uint32_t extent =
      0;  ///< the number of low bits follows it: the ring's size, |D| for uvs; the number itself for extras
};

class Residuals {
 public:
  void add(const Residual& residual) { items_.push_back(residual); }

  /// Chooses the page's parameters and fills the streams and the low bits.
  void finish(PageData& page) const;

 private:
  struct Series;
  Series seriesOf(Residual::Kind kind, uint32_t set, int32_t laplacian) const;
  uint8_t bestLaplacian(Residual::Kind kind, uint32_t set) const;

  std::vector<Residual> items_;
};

}  // namespace lithe::bake
