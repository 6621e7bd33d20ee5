// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Writes the records of the further wedges that a split's classes have at a child, once all corners are there.
#pragma once

#include <vector>

#include "cut.h"
#include "lithe/format/further_wedges.h"
#include "page_streams.h"
#include "pick_encoder.h"
#include "residuals.h"

namespace lithe::bake {

class FurtherEncoder {
 public:
  /// All of them outlive the encoder. The children are the cut's last two nodes.
  FurtherEncoder(const Cut& cut, const std::vector<WedgeClass>& classes, int32_t normal_center, PageData& page,
                 Residuals& residuals)
      : cut_(cut), classes_(classes), normal_center_(normal_center), page_(page), residuals_(residuals) {}

  /// Of child A, then of child B.
  void run() {
    for (uint32_t side = 0; side < 2; ++side) writeChild(side);
  }

 private:
  void writeChild(uint32_t side);
  void gatherCorners();
  void writeWedge(uint32_t first, uint32_t wedge);
  uint32_t maskOf(uint32_t first, uint32_t wedge) const;
  void writeNormal(uint32_t first, uint32_t wedge);
  void writeTangent(uint32_t first, uint32_t wedge);
  void writeUvs(uint32_t mask, uint32_t first, uint32_t wedge);
  void addTurned(Residual::Kind kind, format::Int2 predicted, format::Int2 point);
  void addPair(Residual::Kind kind, format::Int2 predicted, format::Int2 value);
  void addPlain(uint32_t first, uint32_t wedge, uint32_t at, uint32_t count);
  bool isReadBefore(uint32_t file_wedge, uint32_t further) const;

  const Cut& cut_;
  const std::vector<WedgeClass>& classes_;
  const int32_t normal_center_;
  PageData& page_;
  Residuals& residuals_;
  uint32_t child_ = 0;
  format::ChildCorners corners_;
};

}  // namespace lithe::bake
