// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// How the skins of a split's children are written against their parent's.
#pragma once

#include "lithe/bake/mesh.h"
#include "page_streams.h"
#include "residuals.h"

namespace lithe::bake {

/// Which way the weights run over the ring of the split node.
class SkinSlopes {
 public:
  /// An empty one predicts nothing.
  SkinSlopes() = default;
  SkinSlopes(const format::Gradient& gradient, const QuantizedSkin& parent) : gradient_(gradient), parent_(&parent) {}
  /// r: shifted, relative to the split node.
  void addNeighbour(format::Int3 r, const QuantizedSkin& skin) { neighbours_.push_back({r, &skin}); }
  format::Slope of(uint16_t joint) const;

 private:
  struct Neighbour {
    format::Int3 r;
    const QuantizedSkin* skin;
  };
  format::Gradient gradient_;
  const QuantizedSkin* parent_ = nullptr;
  std::vector<Neighbour> neighbours_;
};

/// Writes the skin mode and its values. a, b: the children; t8 from b (0) to a (8).
void encodeSkins(const QuantizedSkin& parent, const QuantizedSkin& a, const QuantizedSkin& b, int32_t t8,
                 uint32_t weight_one, const SkinSlopes& slopes, PageData& page, Residuals& residuals);

}  // namespace lithe::bake
