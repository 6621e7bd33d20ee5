// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "collapser.h"

#include <algorithm>

#include "absorb.h"
#include "lithe/bake/parallel.h"

namespace lithe::bake {

namespace {

// Flat and rigid regions cost nothing anywhere: without a preference for short edges they would be eaten from one
// vertex.
constexpr double kTieBreak = 1e-7;
constexpr uint32_t kHub = 24;                  // triangles: more at one node make slivers and slow everything down
constexpr uint32_t kNeverJudged = 0xffffffff;  // no sum of versions

NodeState nodeState(const Mesh& mesh, const std::vector<std::vector<glm::dmat4>>& palettes,
                    const SimplifyOptions& options) {
  return {mesh.grid.bits, options.placement_shift, mesh.weight_one, mesh.max_influences, mesh.positions,
          mesh.skins,     poseMesh(mesh, palettes)};
}

Surface classifiedSurface(const Mesh& mesh, const PosedMesh& posed) {
  Surface surface(mesh);
  surface.classifyEdges(posed);
  return surface;
}

}  // namespace

Collapser::Collapser(const Mesh& mesh, const std::vector<std::vector<glm::dmat4>>& palettes,
                     const SimplifyOptions& options)
    : mesh_(mesh),
      options_(options),
      nodes_(nodeState(mesh, palettes, options)),
      surface_(classifiedSurface(mesh, nodes_.posed)),
      components_(surface_, nodes_.posed),
      edges_(surface_, mesh.vertexCount()),
      queue_(edges_.count()),
      metric_(makeMetric({nodes_, surface_, options_})),
      placer_(nodes_),
      version_(mesh.vertexCount(), 0),
      blocked_at_(mesh.vertexCount(), 0),
      placement_(edges_.count()),
      stamp_(edges_.count(), kNeverJudged),
      blocked_(edges_.count(), 0),
      vertex_count_(mesh.vertexCount()),
      next_node_(mesh.vertexCount()),
      first_triangles_(surface_.triangleCount()) {
  if (options_.refit && metric_->allowsRefit()) refit_ = std::make_unique<Refit>(nodes_, surface_, options_);
  node_of_.resize(mesh.vertexCount());
  for (uint32_t slot = 0; slot < mesh.vertexCount(); ++slot) node_of_[slot] = slot;
  for (uint32_t slot = 0; slot < mesh.vertexCount(); ++slot) noteFaceless(slot);
}

void Collapser::placeAllEdges() {
  inParallel(static_cast<uint32_t>(node_of_.size()), options_.threads, [&](uint32_t begin, uint32_t end) {
    std::vector<FanFace> fan;
    for (uint32_t slot = begin; slot < end; ++slot) metric_->refresh(slot, fan);
  });
  inParallel(edges_.count(), options_.threads, [&](uint32_t begin, uint32_t end) {
    EdgePlacer placer(nodes_);
    for (uint32_t edge = begin; edge < end; ++edge) placeEdge(edge, placer);
  });
  for (uint32_t edge = 0; edge < edges_.count(); ++edge) queue_.set(edge, placement_[edge].cost);
}

void Collapser::placeEdge(uint32_t edge, EdgePlacer& placer) {
  const auto [a, b] = edges_.ends[edge];
  placement_[edge] = metric_->place(a, b, placer);
  placement_[edge].cost += tieBreak(a, b);
  stamp_[edge] = stampOf(edge);
}

double Collapser::tieBreak(uint32_t a, uint32_t b) const {
  const PosedMesh& posed = nodes_.posed;
  const double sum = squaredDistances(posed.at(a), posed.at(b), posed.blocks);
  return kTieBreak * sum * sum / posed.pose_count;
}

// While this edge is judged, what the next three need is on its way: where they are, the nodes, the nodes' neighbours.
void Collapser::judgeAgain(uint32_t edge) {
  const auto [a, b] = edges_.ends[edge];
  const auto [next, second, third] = queue_.afterTop();
  if (third != kNone) __builtin_prefetch(&edges_.ends[third]);
  prefetchSlots(second);
  prefetchFaces(next);
  metric_->refresh(a, fan_);
  prefetchLists(second);
  metric_->refresh(b, fan_);
  prefetchAround(next);
  placeEdge(edge, placer_);
  judged_ = edge;
}

void Collapser::prefetchSlots(uint32_t edge) const {
  if (edge == kNone) return;
  __builtin_prefetch(&placement_[edge]);
  __builtin_prefetch(&stamp_[edge]);
  for (uint32_t slot : edges_.ends[edge]) {
    surface_.prefetchHead(slot);
    edges_.at.prefetchHead(slot);
    __builtin_prefetch(&version_[slot]);
    metric_->prefetch(slot);
  }
}

void Collapser::prefetchLists(uint32_t edge) const {
  if (edge == kNone) return;
  for (uint32_t slot : edges_.ends[edge]) {
    surface_.prefetchList(slot);
    edges_.at.prefetch(slot);
  }
}

void Collapser::prefetchFaces(uint32_t edge) const {
  if (edge == kNone) return;
  for (uint32_t slot : edges_.ends[edge]) surface_.prefetchFaces(slot);
}

void Collapser::prefetchAround(uint32_t edge) const {
  if (edge == kNone) return;
  for (uint32_t slot : edges_.ends[edge]) metric_->prefetchAround(slot);
}

// A collapse changes the lists of all nodes around it. In three steps, with time in between.
void Collapser::prefetchRing(uint32_t edge) {
  ring_.clear();
  for (uint32_t slot : edges_.ends[edge]) {
    for (uint32_t id : surface_.facesAt(slot)) ring_.push_back(surface_.face(id).nextTo(slot));
    for (uint32_t near : edges_.at[slot]) __builtin_prefetch(&edges_.ends[near]);
  }
  for (uint32_t slot : ring_) {
    surface_.prefetchHead(slot);
    edges_.at.prefetchHead(slot);
    __builtin_prefetch(&version_[slot]);
  }
}

void Collapser::prefetchRingLists(uint32_t edge) const {
  for (uint32_t slot : ring_) {
    surface_.prefetchList(slot);
    edges_.at.prefetch(slot);
  }
  for (uint32_t near : edges_.at[edges_.ends[edge][1]]) queue_.prefetch(near);
}

void Collapser::prefetchRingFaces() const {
  for (uint32_t slot : ring_) surface_.prefetchFaces(slot);
}

// The posed position is not kept per edge.
void Collapser::recall(uint32_t edge) {
  const auto [a, b] = edges_.ends[edge];
  metric_->placeAgain(a, b, placement_[edge], placer_);
  judged_ = edge;
}

bool Collapser::collapseNext(Collapse& collapse) {
  for (;;) {
    if (queue_.empty() && !refill()) return false;
    const uint32_t edge = queue_.top();
    if (isStale(edge)) {
      judgeAgain(edge);
      queue_.set(edge, placement_[edge].cost);
      continue;
    }
    prefetchRing(edge);
    const double loss = lossOf(edge);
    if (queue_.key(edge) < loss) {
      queue_.set(edge, loss);
      continue;
    }
    if (judged_ != edge) recall(edge);
    prefetchRingLists(edge);
    if (!mayCollapse(edge)) {
      block(edge);
      continue;
    }
    const auto [a, b] = edges_.ends[edge];
    if (options_.min_triangles > 0 && surface_.wouldVanish(a, b)) {
      dropEdge(edge);
      continue;
    }
    Placement placement = placement_[edge];
    QuantizedSkin skin = placer_.skinBetween(a, b, placement.t8);
    prefetchRingFaces();
    metric_->improveSkin(a, b, placer_, placement, skin);
    placement.cost = std::max(placement.cost, loss);
    record(edge, placement, skin, collapse);
    moveNode(a, b, placement, skin);
    judged_ = kNone;
    collapse.triangles = surface_.triangleCount();
    lowerVanishCosts();
    return true;
  }
}

double Collapser::lossOf(uint32_t edge) {
  const auto [a, b] = edges_.ends[edge];
  if (!surface_.wouldOrphan(a, b)) return 0.0;
  return (coarse_ ? options_.vanish_factor_coarse : options_.vanish_factor) * components_.lossOf(a);
}

bool Collapser::mayCollapse(uint32_t edge) {
  const auto [a, b] = edges_.ends[edge];
  return relaxed_ || !(growsHub(a, b) || turnsOver(a, b) || turnsOver(b, a));
}

bool Collapser::turnsOver(uint32_t from, uint32_t other) const {
  const EdgeWeights none{SimplifyOptions{}};
  for (uint32_t id : surface_.facesAt(from)) {
    const Face& face = surface_.face(id);
    if (face.has(other)) continue;
    if (countFlips(fanFace(face, from, nodes_.posed, none), placer_.posed.data(), nodes_.posed.blocks) > 0) return true;
  }
  return false;
}

bool Collapser::growsHub(uint32_t a, uint32_t b) const {
  const auto before = static_cast<uint32_t>(std::max(surface_.facesAt(a).size(), surface_.facesAt(b).size()));
  return surface_.valenceAfter(a, b) > std::max(kHub, before);
}

void Collapser::block(uint32_t edge) {
  blocked_[edge] = 1;
  for (uint32_t slot : edges_.ends[edge]) ++blocked_at_[slot];
  queue_.remove(edge);
}

void Collapser::unblockAround(uint32_t slot) {
  if (blocked_at_[slot] == 0) return;
  for (uint32_t edge : edges_.at[slot]) {
    if (!blocked_[edge]) continue;
    blocked_[edge] = 0;
    for (uint32_t end : edges_.ends[edge]) --blocked_at_[end];
    queue_.set(edge, queue_.key(edge));
  }
}

bool Collapser::refill() {
  relaxed_ = true;
  for (uint32_t slot = 0; slot < node_of_.size(); ++slot) unblockAround(slot);
  return !queue_.empty();
}

void Collapser::lowerVanishCosts() {
  if (coarse_ || surface_.triangleCount() > options_.vanish_coarse * first_triangles_) return;
  coarse_ = true;
  for (uint32_t edge = 0; edge < edges_.count(); ++edge) {
    if (queue_.contains(edge)) queue_.set(edge, std::min(queue_.key(edge), placement_[edge].cost));
  }
}

void Collapser::record(uint32_t edge, const Placement& placement, const QuantizedSkin& skin, Collapse& collapse) {
  const auto [a, b] = edges_.ends[edge];
  const double unit2 = nodes_.posed.unit * nodes_.posed.unit;
  collapse.child[0] = node_of_[a];
  collapse.child[1] = node_of_[b];
  collapse.position = placement.position;
  collapse.skin = skin;
  collapse.t8 = static_cast<uint8_t>(placement.t8);
  collapse.cost = placement.cost * unit2 * unit2;
}

void Collapser::moveNode(uint32_t a, uint32_t b, const Placement& placement, const QuantizedSkin& skin) {
  metric_->merge(a, b, placement, placer_.posed.data());
  if (refit_)
    refit_->merged(a, b, {nodes_.positions[a], nodes_.positions[b], nodes_.placement_shift, nodes_.grid_bits},
                   placement.t8);
  nodes_.positions[a] = placement.position;
  nodes_.skins[a] = skin;
  std::copy(placer_.posed.begin(), placer_.posed.end(), nodes_.posed.at(a));
  node_of_[a] = next_node_++;
  surface_.collapse(a, b, thirds_);
  joinEdges(a, b);
  cutLooseEdges(a);
  noteFaceless(a);
  for (uint32_t third : thirds_) noteFaceless(third);
  surface_.classifyAround(a, nodes_.posed);
  refreshAround(a);
}

void Collapser::noteFaceless(uint32_t slot) {
  if (surface_.facesAt(slot).empty()) faceless_.push_back(slot);
}

void Collapser::endLevel(std::vector<Collapse>& collapses) {
  refit(collapses);
  absorbFaceless(collapses);
}

void Collapser::refit(std::vector<Collapse>& collapses) {
  if (!refit_) return;
  std::vector<uint32_t> moved;
  refit_->run(nodes_, surface_, [&](uint32_t slot, const PosedPoint* from) {
    metric_->moved(slot, from);
    Collapse& made = collapses[node_of_[slot] - vertex_count_];
    made.position = nodes_.positions[slot];
    made.skin = nodes_.skins[slot];
    moved.push_back(slot);
  });
  for (uint32_t slot : moved) surface_.classifyAround(slot, nodes_.posed);
  for (uint32_t slot : moved) refreshAround(slot);
  judged_ = kNone;
}

/// The host stays what it is: neither its metric nor the refit need know.
void Collapser::absorbFaceless(std::vector<Collapse>& collapses) {
  if (faceless_.empty() || surface_.triangleCount() == 0) return;
  std::sort(faceless_.begin(), faceless_.end());
  faceless_.erase(std::unique(faceless_.begin(), faceless_.end()), faceless_.end());
  const std::vector<uint32_t> hosts = nearestHosts(faceless_, mesh_, nodes_, surface_);
  for (size_t i = 0; i < faceless_.size(); ++i) {
    Collapse absorption;
    absorption.child[0] = node_of_[hosts[i]];
    absorption.child[1] = node_of_[faceless_[i]];
    absorption.position = nodes_.positions[hosts[i]];
    absorption.skin = nodes_.skins[hosts[i]];
    absorption.t8 = 0;
    absorption.triangles = surface_.triangleCount();
    collapses.push_back(absorption);
    node_of_[hosts[i]] = next_node_++;
  }
  faceless_.clear();
}

/// b's edges become a's; of two edges to one node the cheaper stays.
void Collapser::joinEdges(uint32_t a, uint32_t b) {
  scratch_.assign(edges_.at[b].begin(), edges_.at[b].end());
  neighbours_.clear();
  for (uint32_t edge : edges_.at[a]) neighbours_.push_back(edges_.other(edge, a));
  joined_.assign(edges_.at[a].begin(), edges_.at[a].end());
  for (uint32_t edge : scratch_) {
    const uint32_t far = edges_.other(edge, b);
    const auto twin = std::find(neighbours_.begin(), neighbours_.end(), far);
    if (far == a) {
      joined_.erase(std::find(joined_.begin(), joined_.end(), edge));
      neighbours_.erase(std::find(neighbours_.begin(), neighbours_.end(), b));
      dropEdge(edge);
    } else if (twin != neighbours_.end()) {
      keepCheaper(joined_[static_cast<size_t>(twin - neighbours_.begin())], edge);
    } else {
      edges_.ends[edge] = {std::min(a, far), std::max(a, far)};
      if (blocked_[edge]) {
        --blocked_at_[b];
        ++blocked_at_[a];
      }
      joined_.push_back(edge);
      neighbours_.push_back(far);
    }
  }
  edges_.at.assign(a, joined_);
  edges_.at.assign(b, {});
}

/// The twin stays, for the price of the cheaper of the two.
void Collapser::keepCheaper(uint32_t twin, uint32_t edge) {
  if (queue_.contains(twin) && queue_.contains(edge) && queue_.key(edge) < queue_.key(twin)) {
    queue_.set(twin, queue_.key(edge));
  }
  dropEdge(edge);
}

void Collapser::cutLooseEdges(uint32_t a) {
  for (uint32_t third : thirds_) {
    const uint32_t edge = edges_.find(a, third);
    if (edge != kNone && !surface_.hasEdge(a, third)) dropEdge(edge);
    ++version_[third];
    metric_->invalidate(third);
    unblockAround(third);
  }
}

void Collapser::refreshAround(uint32_t a) {
  ++version_[a];
  metric_->invalidate(a);
  unblockAround(a);
  for (uint32_t edge : edges_.at[a]) {
    const uint32_t far = edges_.other(edge, a);
    ++version_[far];
    metric_->invalidate(far);
    unblockAround(far);
    stamp_[edge] = kNeverJudged;
  }
}

void Collapser::dropEdge(uint32_t edge) {
  if (blocked_[edge]) {
    blocked_[edge] = 0;
    for (uint32_t slot : edges_.ends[edge]) --blocked_at_[slot];
  }
  queue_.remove(edge);
  edges_.remove(edge);
}

}  // namespace lithe::bake
