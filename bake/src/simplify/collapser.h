// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The greedy loop: always the edge that costs least, judged anew when something near it has changed.
#pragma once

#include <memory>
#include <vector>

#include "components.h"
#include "edge_queue.h"
#include "edges.h"
#include "fan.h"
#include "large_vector.h"
#include "metric.h"
#include "refit.h"

namespace lithe::bake {

class Collapser {
 public:
  Collapser(const Mesh& mesh, const std::vector<std::vector<glm::dmat4>>& palettes, const SimplifyOptions& options);

  /// Judges every edge, on options.threads threads.
  void placeAllEdges();

  /// Does the cheapest collapse; false when no edge is left.
  bool collapseNext(Collapse& collapse);

  /// What is done where a level ends: nodes made since the last one move closer to the original, here and in the
  /// collapses so far, and nodes without triangles are absorbed by others, by collapses of their own.
  void endLevel(std::vector<Collapse>& collapses);

  uint32_t triangleCount() const { return surface_.triangleCount(); }

 private:
  // Judging
  void placeEdge(uint32_t edge, EdgePlacer& placer);
  double tieBreak(uint32_t a, uint32_t b) const;
  uint32_t stampOf(uint32_t edge) const { return version_[edges_.ends[edge][0]] + version_[edges_.ends[edge][1]]; }
  bool isStale(uint32_t edge) const { return stamp_[edge] != stampOf(edge); }
  void judgeAgain(uint32_t edge);
  void recall(uint32_t edge);
  void prefetchSlots(uint32_t edge) const;
  void prefetchLists(uint32_t edge) const;
  void prefetchFaces(uint32_t edge) const;
  void prefetchAround(uint32_t edge) const;
  void prefetchRing(uint32_t edge);
  void prefetchRingLists(uint32_t edge) const;
  void prefetchRingFaces() const;
  bool mayCollapse(uint32_t edge);
  double lossOf(uint32_t edge);
  bool turnsOver(uint32_t from, uint32_t other) const;
  bool growsHub(uint32_t a, uint32_t b) const;

  // Order
  bool refill();
  void lowerVanishCosts();
  void block(uint32_t edge);
  void unblockAround(uint32_t slot);

  // Doing
  void record(uint32_t edge, const Placement& placement, const QuantizedSkin& skin, Collapse& collapse);
  void moveNode(uint32_t a, uint32_t b, const Placement& placement, const QuantizedSkin& skin);
  void joinEdges(uint32_t a, uint32_t b);
  void keepCheaper(uint32_t twin, uint32_t edge);
  void cutLooseEdges(uint32_t a);
  void refreshAround(uint32_t a);
  void noteFaceless(uint32_t slot);
  void refit(std::vector<Collapse>& collapses);
  void absorbFaceless(std::vector<Collapse>& collapses);
  void dropEdge(uint32_t edge);

  const Mesh& mesh_;
  SimplifyOptions options_;
  NodeState nodes_;
  Surface surface_;
  Components components_;
  Edges edges_;
  EdgeQueue queue_;
  std::unique_ptr<Metric> metric_;
  EdgePlacer placer_;
  std::unique_ptr<Refit> refit_;  // none: nothing is refit

  std::vector<uint32_t> node_of_;     // per slot
  LargeVector<uint32_t> version_;     // per slot: how often its triangles have changed
  std::vector<uint32_t> blocked_at_;  // per slot: how many of its edges wait for a change
  LargeVector<Placement> placement_;  // per edge, as last judged
  LargeVector<uint32_t> stamp_;       // per edge: the versions it was judged at
  std::vector<uint8_t> blocked_;      // per edge
  uint32_t vertex_count_, next_node_;
  uint32_t judged_ = kNone;  // the edge that placer_ holds the answer for
  uint32_t first_triangles_;
  bool coarse_ = false;             // below options.vanish_coarse
  bool relaxed_ = false;            // nothing was left to do without turning a triangle over
  std::vector<uint32_t> faceless_;  // slots without triangles that have not been absorbed
  std::vector<uint32_t> thirds_, scratch_, joined_, neighbours_, ring_;
  std::vector<FanFace> fan_;
};

}  // namespace lithe::bake
