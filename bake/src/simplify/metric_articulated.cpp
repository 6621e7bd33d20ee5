// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Landreneau and Schaefer 2009 with area-weighted quadrics of the current surface (memoryless, Lindstrom and Turk
// 1998). What the surface has forgotten is guarded by the accumulated quadrics: without them thin parts melt away.
#include <algorithm>

#include "fan.h"
#include "large_vector.h"
#include "metric.h"
#include "prefetch.h"

namespace lithe::bake {

namespace {

// Of the accumulated energy. Chosen by measurement: none melts thin parts at 2 %, much more gives up what the current
// surface knows.
constexpr double kGuard = 2.0 / 3.0;

class ArticulatedMetric : public Metric {
 public:
  explicit ArticulatedMetric(const MetricInput& input)
      : nodes_(input.nodes), surface_(input.surface), weights_(input.options), weight_gain_(input.options.weight_gain) {
    const size_t count = nodes_.positions.size() * nodes_.posed.blocks;
    current_.resize(count);
    accumulated_.resize(count);
    stale_.assign(nodes_.positions.size(), 1);
    fresh_start_.assign(nodes_.positions.size(), 1);
  }

  void refresh(uint32_t slot, std::vector<FanFace>& fan) override {
    if (!stale_[slot]) return;
    stale_[slot] = 0;
    gatherFan(surface_, slot, nodes_.posed, weights_, fan);
    fanQuadric(fan, nodes_.posed.blocks, currentAt(slot));
    if (!fresh_start_[slot]) return;
    fresh_start_[slot] = 0;
    for (uint32_t block = 0; block < nodes_.posed.blocks; ++block) {
      accumulatedAt(slot)[block] = withoutLinearTerm(currentAt(slot)[block]);
    }
  }

  void prefetch(uint32_t slot) const override {
    prefetchAll(nodes_.posed.at(slot), nodes_.posed.blocks);
    prefetchAll(currentAt(slot), nodes_.posed.blocks);
    prefetchAll(accumulatedAt(slot), nodes_.posed.blocks);
    __builtin_prefetch(&nodes_.skins[slot]);
    __builtin_prefetch(&nodes_.positions[slot]);
  }

  void prefetchAround(uint32_t slot) const override {
    if (!stale_[slot]) return;
    for (uint32_t id : surface_.facesAt(slot)) {
      prefetchAll(nodes_.posed.at(surface_.face(id).nextTo(slot)), nodes_.posed.blocks);
    }
  }

  Placement place(uint32_t a, uint32_t b, EdgePlacer& placer) const override {
    fillQuadric(a, b, placer);
    Placement placement = placer.placeFreely(a, b);
    placement.cost = guarded(a, b, placement.cost, placer.posed.data());
    return placement;
  }

  void placeAgain(uint32_t a, uint32_t b, const Placement& placement, EdgePlacer& placer) const override {
    fillQuadric(a, b, placer);
    placer.poseBetween(a, b, placement);
  }

  void improveSkin(uint32_t a, uint32_t b, EdgePlacer& placer, Placement& placement,
                   QuantizedSkin& skin) const override {
    const PosedMesh& posed = nodes_.posed;
    Placement improved = placement;
    QuantizedSkin improved_skin = skin;
    improved.cost = std::max(0.0f, energy(placer.quadric.data(), posed.at(a), placer.posed.data(), posed.blocks));
    unimproved_ = placer.posed;
    placer.optimizeSkin(a, b, weight_gain_, improved, improved_skin);
    improved.cost = guarded(a, b, improved.cost, placer.posed.data());
    if (improved.cost < placement.cost * (1.0 - weight_gain_)) {
      placement = improved;
      skin = improved_skin;
    } else {
      placer.posed = unimproved_;
    }
  }

  void merge(uint32_t a, uint32_t b, const Placement&, const PosedPoint* parent) override {
    const PosedMesh& posed = nodes_.posed;
    accumulate(accumulatedAt(a), accumulatedAt(b), posed.at(a), posed.at(b), parent, posed.blocks, accumulatedAt(a));
  }

  bool allowsRefit() const override { return true; }

  void moved(uint32_t slot, const PosedPoint* from) override {
    recenter(from, nodes_.posed.at(slot), nodes_.posed.blocks, accumulatedAt(slot));
  }

  void invalidate(uint32_t slot) override { stale_[slot] = 1; }

 private:
  void fillQuadric(uint32_t a, uint32_t b, EdgePlacer& placer) const {
    const PosedMesh& posed = nodes_.posed;
    gatherBetween(a, b, placer);
    combineLess(placer.fan, currentAt(a), currentAt(b), posed.at(a), posed.at(b), posed.blocks, placer.quadric.data());
  }

  /// The triangles that both ends have: the sum of the ends' quadrics counts them twice, the others once.
  void gatherBetween(uint32_t a, uint32_t b, EdgePlacer& placer) const {
    const std::span<const uint32_t> ids = surface_.facesAt(a);
    placer.between.resize(ids.size());
    size_t count = 0;
    for (uint32_t id : ids) {
      placer.between[count] = id;  // without branches: which ones they are nobody can guess
      count += surface_.face(id).has(b) ? 1 : 0;
    }
    placer.fan.resize(count);
    for (size_t i = 0; i < count; ++i)
      placer.fan[i] = fanFace(surface_.face(placer.between[i]), a, nodes_.posed, weights_);
  }

  double guarded(uint32_t a, uint32_t b, double current, const PosedPoint* point) const {
    const PosedMesh& posed = nodes_.posed;
    const auto [of_a, of_b] =
        energies(accumulatedAt(a), accumulatedAt(b), posed.at(a), posed.at(b), point, posed.blocks);
    return std::max(current, kGuard * (double{of_a} + double{of_b}));
  }

  Symmetric* currentAt(uint32_t slot) { return current_.data() + size_t{slot} * nodes_.posed.blocks; }
  const Symmetric* currentAt(uint32_t slot) const { return current_.data() + size_t{slot} * nodes_.posed.blocks; }
  Quadric* accumulatedAt(uint32_t slot) { return accumulated_.data() + size_t{slot} * nodes_.posed.blocks; }
  const Quadric* accumulatedAt(uint32_t slot) const { return accumulated_.data() + size_t{slot} * nodes_.posed.blocks; }

  const NodeState& nodes_;
  const Surface& surface_;
  EdgeWeights weights_;
  double weight_gain_;
  LargeVector<Symmetric> current_;    // [slot][block] of the triangles as they are
  LargeVector<Quadric> accumulated_;  // [slot][block] of the mesh as it was
  std::vector<uint8_t> stale_, fresh_start_;
  mutable std::vector<PosedPoint> unimproved_;
};

}  // namespace

std::unique_ptr<Metric> makeArticulatedMetric(const MetricInput& input) {
  return std::make_unique<ArticulatedMetric>(input);
}

}  // namespace lithe::bake
