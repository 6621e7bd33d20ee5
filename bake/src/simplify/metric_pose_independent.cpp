// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// DeCoro and Rusinkiewicz 2005 as Landreneau and Schaefer 2009 describe it: the posed quadrics are pulled back through
// each vertex's own blended transform and added once; from then on it is Garland and Heckbert's method in the bind
// pose.
#include <algorithm>

#include "fan.h"
#include "metric.h"

namespace lithe::bake {

namespace {

/// x^T A x + 2 b^T x + c about a slot's grid position.
struct RestQuadric {
  glm::dmat3 A{0.0};
  glm::dvec3 b{0.0};
  double c = 0.0;

  double at(const glm::dvec3& x) const { return glm::dot(x, A * x) + 2.0 * glm::dot(b, x) + c; }
  RestQuadric shiftedBy(const glm::dvec3& shift) const { return {A, A * shift + b, at(shift)}; }
};

RestQuadric operator+(const RestQuadric& p, const RestQuadric& q) { return {p.A + q.A, p.b + q.b, p.c + q.c}; }

/// A v = -b, held where A says nothing by a small part of its trace.
glm::dvec3 minimizerOf(const RestQuadric& q, const glm::dvec3& start) {
  const double stay = 1e-4 * (q.A[0][0] + q.A[1][1] + q.A[2][2]);
  const glm::dmat3 held = q.A + glm::dmat3(stay);
  const double determinant = glm::determinant(held);
  if (!(determinant > 0.0)) return start;
  return start - glm::inverse(held) * (q.A * start + q.b);
}

class PoseIndependentMetric : public Metric {
 public:
  explicit PoseIndependentMetric(const MetricInput& input)
      : nodes_(input.nodes), surface_(input.surface), weights_(input.options) {
    quadrics_.resize(nodes_.positions.size());
    known_.assign(nodes_.positions.size(), 0);
  }

  void refresh(uint32_t slot, std::vector<FanFace>& fan) override {
    if (known_[slot]) return;
    known_[slot] = 1;
    const PosedMesh& posed = nodes_.posed;
    gatherFan(surface_, slot, posed, weights_, fan);
    std::vector<Symmetric> symmetric(posed.blocks);
    fanQuadric(fan, posed.blocks, symmetric.data());
    std::vector<Quadric> quadric(posed.blocks);
    for (uint32_t block = 0; block < posed.blocks; ++block) {
      quadric[block] = withoutLinearTerm(symmetric[block]);
    }
    std::vector<Affine> storage(posed.blocks);
    const Affine* blend = blendSkin(posed, nodes_.skins[slot], storage.data());
    const NormalEquations n = normalEquations(quadric.data(), blend, posed.at(slot), posed.at(slot), posed.blocks);
    quadrics_[slot].A = glm::dmat3(n.xx, n.xy, n.xz, n.xy, n.yy, n.yz, n.xz, n.yz, n.zz);
  }

  Placement place(uint32_t a, uint32_t b, EdgePlacer& placer) const override {
    const Segment segment(nodes_.positions[a], nodes_.positions[b], nodes_.placement_shift, nodes_.grid_bits);
    const glm::dvec3 origin(nodes_.positions[a]);
    const RestQuadric sum = quadrics_[a] + quadrics_[b].shiftedBy(glm::dvec3(-segment.d));
    Placement best;
    best.cost = -1.0;
    for (const int32_t t8 : {4, 0, 8}) consider(sum, origin, segment.point(t8), t8, best);
    const glm::dvec3 x = origin + minimizerOf(sum, glm::dvec3(best.position) - origin);
    const int32_t t8 = segment.nearestEighth(x);
    consider(sum, origin, segment.snap(x, t8), t8, best);
    placer.poseBetween(a, b, best);
    return best;
  }

  void improveSkin(uint32_t, uint32_t, EdgePlacer&, Placement&, QuantizedSkin&) const override {}

  void merge(uint32_t a, uint32_t b, const Placement& parent, const PosedPoint*) override {
    const glm::dvec3 to_parent_a(parent.position - nodes_.positions[a]),
        to_parent_b(parent.position - nodes_.positions[b]);
    quadrics_[a] = quadrics_[a].shiftedBy(to_parent_a) + quadrics_[b].shiftedBy(to_parent_b);
  }

  void invalidate(uint32_t) override {}

 private:
  static void consider(const RestQuadric& q, const glm::dvec3& origin, const glm::ivec3& position, int32_t t8,
                       Placement& best) {
    const double cost = std::max(0.0, q.at(glm::dvec3(position) - origin));
    if (best.cost < 0.0 || cost < best.cost) best = {position, t8, cost};
  }

  const NodeState& nodes_;
  const Surface& surface_;
  EdgeWeights weights_;
  std::vector<RestQuadric> quadrics_;  // per slot
  std::vector<uint8_t> known_;         // per slot
};

}  // namespace

std::unique_ptr<Metric> makePoseIndependentMetric(const MetricInput& input) {
  return std::make_unique<PoseIndependentMetric>(input);
}

}  // namespace lithe::bake
