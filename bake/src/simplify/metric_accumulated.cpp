// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Quadrics that are only ever added up: Garland and Heckbert 1997 in one pose, Mohr and Gleicher 2003 in several.
#include "fan.h"
#include "metric.h"

namespace lithe::bake {

namespace {

class AccumulatedMetric : public Metric {
 public:
  AccumulatedMetric(const MetricInput& input, bool ends_only)
      : nodes_(input.nodes), surface_(input.surface), weights_(input.options), ends_only_(ends_only) {
    quadrics_.resize(nodes_.positions.size() * nodes_.posed.blocks);
    known_.assign(nodes_.positions.size(), 0);
  }

  void refresh(uint32_t slot, std::vector<FanFace>& fan) override {
    if (known_[slot]) return;
    known_[slot] = 1;
    gatherFan(surface_, slot, nodes_.posed, weights_, fan);
    std::vector<Symmetric> start(nodes_.posed.blocks);
    fanQuadric(fan, nodes_.posed.blocks, start.data());
    for (uint32_t block = 0; block < nodes_.posed.blocks; ++block) {
      at(slot)[block] = withoutLinearTerm(start[block]);
    }
  }

  Placement place(uint32_t a, uint32_t b, EdgePlacer& placer) const override {
    combine(at(a), at(b), nodes_.posed.at(a), nodes_.posed.at(b), nodes_.posed.blocks, placer.quadric.data());
    return ends_only_ ? placer.placeAtEnd(a, b) : placer.placeFreely(a, b);
  }

  void improveSkin(uint32_t, uint32_t, EdgePlacer&, Placement&, QuantizedSkin&) const override {}

  void merge(uint32_t a, uint32_t b, const Placement&, const PosedPoint* parent) override {
    accumulate(at(a), at(b), nodes_.posed.at(a), nodes_.posed.at(b), parent, nodes_.posed.blocks, at(a));
  }

  void invalidate(uint32_t) override {}

 private:
  Quadric* at(uint32_t slot) { return quadrics_.data() + size_t{slot} * nodes_.posed.blocks; }
  const Quadric* at(uint32_t slot) const { return quadrics_.data() + size_t{slot} * nodes_.posed.blocks; }

  const NodeState& nodes_;
  const Surface& surface_;
  EdgeWeights weights_;
  bool ends_only_;
  std::vector<Quadric> quadrics_;  // [slot][block]
  std::vector<uint8_t> known_;     // per slot
};

}  // namespace

std::unique_ptr<Metric> makeAccumulatedMetric(const MetricInput& input, bool ends_only) {
  return std::make_unique<AccumulatedMetric>(input, ends_only);
}

}  // namespace lithe::bake
