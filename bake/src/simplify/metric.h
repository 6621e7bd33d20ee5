// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// What a metric is: it judges where two nodes would best meet, and remembers what it must when they do.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "edge_placer.h"
#include "node_state.h"
#include "surface.h"

namespace lithe::bake {

struct MetricInput {
  const NodeState& nodes;
  const Surface& surface;
  const SimplifyOptions& options;
};

class Metric {
 public:
  virtual ~Metric() = default;

  /// Brings what the metric knows about a slot up to date; called for both ends before place(). Any thread, but no two
  /// at one slot, and none in place(). @param fan scratch
  virtual void refresh(uint32_t slot, std::vector<FanFace>& fan) = 0;

  /// Asks for the memory that refresh() and place() will read of a slot, so that it arrives while others work.
  virtual void prefetch(uint32_t /*slot*/) const {}
  /// The same for the nodes around it, once its triangles have arrived.
  virtual void prefetchAround(uint32_t /*slot*/) const {}

  /// The best placement of the parent of a and b. Leaves its posed position in placer.posed. Any thread, own placer.
  virtual Placement place(uint32_t a, uint32_t b, EdgePlacer& placer) const = 0;

  /// Leaves in the placer what place() left there when it gave this placement; neither end has changed since.
  virtual void placeAgain(uint32_t a, uint32_t b, const Placement& placement, EdgePlacer& placer) const {
    placer.poseBetween(a, b, placement);
  }

  /// A skin other than the interpolated one, where it pays; called after place() or placeAgain() with the same placer.
  virtual void improveSkin(uint32_t a, uint32_t b, EdgePlacer& placer, Placement& placement,
                           QuantizedSkin& skin) const = 0;

  /// a and b become one in slot a; the nodes still hold the children, `posed` is the parent's posed position.
  virtual void merge(uint32_t a, uint32_t b, const Placement& parent, const PosedPoint* posed) = 0;

  /// Whether nodes may be moved after they have been made; then moved() tells where from.
  virtual bool allowsRefit() const { return false; }
  virtual void moved(uint32_t /*slot*/, const PosedPoint* /*from*/) {}

  /// The triangles around a slot have changed.
  virtual void invalidate(uint32_t slot) = 0;
};

/// The palettes in which a metric judges. Throws Error for an unknown metric and for poses that do not fit the joints.
std::vector<std::vector<glm::dmat4>> palettesOf(const std::string& metric, const std::vector<Joint>& joints,
                                                const std::vector<Pose>& poses);

std::unique_ptr<Metric> makeArticulatedMetric(const MetricInput& input);
std::unique_ptr<Metric> makeAccumulatedMetric(const MetricInput& input, bool ends_only);
std::unique_ptr<Metric> makePoseIndependentMetric(const MetricInput& input);
std::unique_ptr<Metric> makeDeformationMetric(const MetricInput& input);

/// By input.options.metric. Throws Error, listing the names, when there is none of that name.
std::unique_ptr<Metric> makeMetric(const MetricInput& input);

}  // namespace lithe::bake
