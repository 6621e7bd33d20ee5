// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Turns the splits of a level into the symbols of its pages.
#pragma once

#include "cut.h"
#include "lithe/format/octahedral_chart.h"
#include "lithe/format/placement_prediction.h"
#include "page_streams.h"
#include "pick_encoder.h"
#include "residuals.h"
#include "skin_code.h"
#include "split_plan.h"

namespace lithe::bake {

struct SplitSettings {
  uint32_t placement_shift = 0;
  uint32_t weight_one = 255;
  int32_t normal_center = 511;
  uint32_t uv_greatest = 4095;
  format::WedgeAttributes has{};
};

/// One page of splits being made. Splits are applied to the cut as they are written, as a reader would.
class SplitEncoder {
 public:
  SplitEncoder(Cut& cut, const SplitSettings& settings);

  void flag(bool old_node, bool split) { page_.streams[old_node ? format::kFlagsOld : format::kFlagsNew].put(split); }
  void split(uint32_t node);
  /// What has been written, but for the residuals.
  PageData& page() { return page_; }
  /// The page so far; the encoder goes on with an empty one.
  PageData finish();
  /// Corners visited by the page so far: a reader's limit on the work of one page.
  uint64_t work() const { return work_; }

 private:
  using Plan = SplitPlan;
  using NewFace = SplitPlan::NewFace;

  /// The stream that says how the children's skins are said.
  uint32_t skinModesOf(uint32_t hierarchy_node, const format::Fan& fan) const;
  Plan planSplit(uint32_t hierarchy_node, const format::Fan& fan, const format::Ring& ring) const;
  Plan assignChildren(uint32_t hierarchy_node, uint32_t which_is_a, const format::Fan& fan) const;
  std::vector<NewFace> birthsOf(uint32_t hierarchy_node, uint32_t a) const;
  bool tryRing(Plan& plan, const format::Fan& fan, const format::Ring& ring, size_t births) const;
  void writeConnectivity(uint32_t node, const Plan& plan, const format::Fan& fan, const format::Ring& ring);
  void writeCut(uint32_t node, const Plan& plan, const format::Fan& fan, const format::Ring& ring);
  void writeList(const Plan& plan, const format::Fan& fan);
  void writePosition(uint32_t hierarchy_node, const Plan& plan, const format::Fan& fan);
  format::PredictedPlacement predictPlacement(uint32_t hierarchy_node, const Plan& plan, const format::Fan& fan) const;
  void writePlacement(uint32_t hierarchy_node, const Plan& plan, const format::Fan& fan);
  void writeClasses(uint32_t node, const std::vector<WedgeClass>& classes, const Plan& plan);
  void writeClass(uint32_t wedge, const WedgeClass& wedge_class, const Plan& plan);
  void addChildren(const std::vector<WedgeClass>& classes, const Plan& plan);
  void writeAttributes(uint32_t node, const std::vector<WedgeClass>& classes, const Plan& plan, const format::Fan& fan,
                       const format::Ring& ring);
  void writePair(uint32_t wedge, uint32_t a, uint32_t b, const Plan& plan, const format::Fan& fan,
                 const format::Ring& ring);
  Residual uvResidual(uint32_t set, uint32_t parent, uint32_t a, uint32_t b,
                      const format::RingNeighbours& neighbours) const;
  Residual directionResidual(uint32_t at, uint32_t parent, uint32_t a, uint32_t b, const Plan& plan,
                             const format::RingNeighbours& neighbours) const;
  bool isPredicted(uint32_t node, const format::Fan& fan) const;
  uint32_t neighbourWedge(const format::Fan& fan, uint32_t i, uint32_t step) const {
    return cut_.face_wedges[fan.corner[i] / 3][(fan.corner[i] % 3 + 1 + step) % 3];
  }
  format::RingNeighbours neighboursOf(uint32_t node, uint32_t wedge, const Plan& plan, const format::Fan& fan,
                                      const format::Ring& ring) const;
  format::Int2 normalDifference(uint32_t wedge, const Plan& plan, const format::Fan& fan,
                                const format::OctahedralChart& chart) const;

  Cut& cut_;
  const SplitSettings& settings_;
  PageData page_;
  Residuals residuals_;
  uint64_t work_ = 0;
  std::vector<uint32_t> fan_wedge_;  ///< of the node that is being split: per fan corner, before it moves
  uint32_t extent_ = 0;              ///< of the ring and of D, for the node that is being split
};

}  // namespace lithe::bake
