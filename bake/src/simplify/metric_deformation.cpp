// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Huang, Chen and Chuang 2006, deformation oriented decimation: DOD_ab = DSD_ab + d_ab, where d_ab keeps edges that
// change their length over the poses.
//
// From the paper: the sum; DSD with area-weighted quadrics; that d grows with Abar_ab, the mean over the poses of the
// area of the triangles at the edge, and with w_ab, the largest deformation divided by the standard deviation of the
// length changes. Reconstructed here, so that d is an area times a squared length like DSD:
//
//     l_t  = |e_t| - mean over the poses of |e|      the standard deviation is the same about any fixed length, and
//                                                    the order of the poses, which are no frames, does not matter
//     w    = max |l_t| / standard deviation of l_t   1 for a steady change, up to sqrt(poses - 1) for a sudden one
//     d    = w * Abar * (mean of |l_t|)^2
//
// The paper lets every frame place the new vertex by itself. A skinned vertex cannot: DSD is the metric `dsd`, end
// points with their own skins.
#include <algorithm>
#include <cmath>

#include "metric.h"

namespace lithe::bake {

namespace {

// Of a length's standard deviation, in posed diagonals: floats hold no less, and a turn of the whole must cost nothing.
constexpr double kRounding = 1e-7;

class DeformationMetric : public Metric {
 public:
  explicit DeformationMetric(const MetricInput& input)
      : nodes_(input.nodes), surface_(input.surface), dsd_(makeAccumulatedMetric(input, true)) {}

  void refresh(uint32_t slot, std::vector<FanFace>& fan) override { dsd_->refresh(slot, fan); }

  Placement place(uint32_t a, uint32_t b, EdgePlacer& placer) const override {
    Placement placement = dsd_->place(a, b, placer);
    placement.cost += deformationOf(a, b);
    return placement;
  }

  void improveSkin(uint32_t, uint32_t, EdgePlacer&, Placement&, QuantizedSkin&) const override {}

  void merge(uint32_t a, uint32_t b, const Placement& parent, const PosedPoint* posed) override {
    dsd_->merge(a, b, parent, posed);
  }

  void invalidate(uint32_t slot) override { dsd_->invalidate(slot); }

 private:
  glm::dvec3 pointIn(uint32_t pose, uint32_t slot) const {
    const PosedPoint& block = nodes_.posed.at(slot)[pose / kLanes];
    const uint32_t lane = pose % kLanes;
    return {block.x[lane], block.y[lane], block.z[lane]};
  }

  double lengthIn(uint32_t pose, uint32_t a, uint32_t b) const {
    return glm::length(pointIn(pose, b) - pointIn(pose, a));
  }

  double areaIn(uint32_t pose, const Face& face) const {
    const glm::dvec3 origin = pointIn(pose, face.corner[0]);
    return 0.5 *
           glm::length(glm::cross(pointIn(pose, face.corner[1]) - origin, pointIn(pose, face.corner[2]) - origin));
  }

  double meanLength(uint32_t a, uint32_t b) const {
    const uint32_t poses = nodes_.posed.pose_count;
    double sum = 0.0;
    for (uint32_t pose = 0; pose < poses; ++pose) sum += lengthIn(pose, a, b);
    return sum / poses;
  }

  double meanAreaAt(uint32_t a, uint32_t b) const {
    const uint32_t poses = nodes_.posed.pose_count;
    double sum = 0.0;
    for (uint32_t id : surface_.facesAt(a)) {
      const Face& face = surface_.face(id);
      if (!face.has(b)) continue;
      for (uint32_t pose = 0; pose < poses; ++pose) sum += areaIn(pose, face);
    }
    return sum / poses;
  }

  double deformationOf(uint32_t a, uint32_t b) const {
    const uint32_t poses = nodes_.posed.pose_count;
    const double mean_length = meanLength(a, b);
    double largest = 0.0, sum = 0.0, sum_of_squares = 0.0;
    for (uint32_t pose = 0; pose < poses; ++pose) {
      const double change = std::abs(lengthIn(pose, a, b) - mean_length);
      largest = std::max(largest, change);
      sum += change;
      sum_of_squares += change * change;
    }
    const double deviation = std::sqrt(sum_of_squares / poses);
    if (deviation <= kRounding) return 0.0;  // one pose, or a length that never changes: nothing to keep
    const double mean_change = sum / poses;
    return largest / deviation * meanAreaAt(a, b) * mean_change * mean_change;
  }

  const NodeState& nodes_;
  const Surface& surface_;
  std::unique_ptr<Metric> dsd_;
};

}  // namespace

std::unique_ptr<Metric> makeDeformationMetric(const MetricInput& input) {
  return std::make_unique<DeformationMetric>(input);
}

}  // namespace lithe::bake
