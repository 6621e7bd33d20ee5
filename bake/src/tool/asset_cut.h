// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Cuts of a decoded hierarchy that lie between its levels.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "asset.h"
#include "split_order.h"

namespace lithe::tool {

/// A face by its wedges, which are the asset's GPU vertices.
using CutFace = std::array<uint32_t, 3>;

/// The cuts that the splits make one by one, in the order of orderSplits(). The asset must be loaded and outlive this.
class Cuts {
 public:
  explicit Cuts(const Asset& asset);

  /// How many splits there are: cuts are numbered 0 (level 0) to this (the finest).
  uint32_t splits() const { return order_.count; }

  /// The faces after the first `splits` splits, equal ones (same nodes, same orientation) once, in the file's order.
  /// @param also  a later split, by its place in the order, of a node that the first ones have made
  std::vector<CutFace> faces(uint32_t splits, uint32_t also = LITHE_NO_INDEX) const;

  /// The faces of the cut whose number of faces is closest to `target`. Where the next split brings too many, one that
  /// follows soon takes its turn.
  std::vector<CutFace> facesNear(uint32_t target) const;

  uint32_t part(const CutFace& face) const { return hierarchy_.wedge_part[face[0]]; }

 private:
  std::vector<uint32_t> standIns(uint32_t splits, uint32_t also) const;
  std::vector<uint32_t> possibleSplits(uint32_t splits, uint32_t count) const;
  CutFace nodesOf(const CutFace& face) const;
  void dropEqual(std::vector<CutFace>& faces) const;

  lithe_hierarchy hierarchy_{};
  SplitOrder order_;
};

}  // namespace lithe::tool
