// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "split_encoder.h"

#include <algorithm>
#include <cstdlib>

#include "further_encoder.h"
#include "lithe/format/placement_prediction.h"

namespace lithe::bake {
namespace {

/// Which child owns each edge of a ring, and the new faces at its cut vertices, as a cut states them.
struct RingSplit {
  std::vector<char> edge_at_b;
  struct At {
    uint32_t vertex;
    bool first_is_a;
  };
  std::vector<At> faces;
};

RingSplit closedSplit(uint32_t edges, uint32_t p, uint32_t q) {
  RingSplit split;
  split.edge_at_b.resize(edges);
  for (uint32_t i = 0; i < edges; ++i) split.edge_at_b[i] = p == 0 ? i >= q : i >= p && i < q;
  split.faces = {{p, p != 0}, {q, p == 0}};
  return split;
}

RingSplit openSplit(uint32_t edges, uint32_t cut) {
  RingSplit split;
  split.edge_at_b.resize(edges);
  for (uint32_t i = 0; i < edges; ++i) split.edge_at_b[i] = i >= cut;
  split.faces = {{cut, true}};
  return split;
}

RingSplit openSplitTwice(uint32_t edges, uint32_t p, uint32_t q) {
  RingSplit split;
  split.edge_at_b.resize(edges);
  for (uint32_t i = 0; i < edges; ++i) split.edge_at_b[i] = i >= p && i < q;
  split.faces = {{p, true}, {q, false}};
  return split;
}

uint32_t ringVertexCount(const format::Ring& ring) {
  return ring.kind == format::RingKind::kClosed ? ring.count : ring.count + 1;
}

}  // namespace

SplitEncoder::SplitEncoder(Cut& cut, const SplitSettings& settings)
    : cut_(cut), settings_(settings), page_(makePage(format::kSplitPage, settings.has)) {}

PageData SplitEncoder::finish() {
  residuals_.finish(page_);
  PageData page = makePage(format::kSplitPage, settings_.has);
  std::swap(page, page_);
  residuals_ = {};
  work_ = 0;
  return page;
}

void SplitEncoder::split(uint32_t node) {
  const uint32_t hierarchy_node = cut_.node_hierarchy[node];
  const format::Fan fan = cut_.fanOf(node);
  work_ += fan.count;
  page_.max_fan = std::max({page_.max_fan, fan.count, cut_.node_first_wedge[node + 1] - cut_.node_first_wedge[node]});
  format::Ring ring;
  format::buildRing(fan, ring);
  const Plan plan = planSplit(hierarchy_node, fan, ring);
  fan_wedge_.resize(fan.count);
  for (uint32_t i = 0; i < fan.count; ++i) fan_wedge_[i] = cut_.face_wedges[fan.corner[i] / 3][fan.corner[i] % 3];

  writeConnectivity(node, plan, fan, ring);
  writePosition(hierarchy_node, plan, fan);
  const uint32_t skin_modes = skinModesOf(hierarchy_node, fan);
  const format::RingNeighbours all_neighbours = neighboursOf(node, kNone, plan, fan, ring);
  PickEncoder picks(cut_, node, plan, fan, ring, page_);
  writeClasses(node, picks.classes(), plan);
  addChildren(picks.classes(), plan);
  picks.run();
  work_ += picks.work();
  writeAttributes(node, picks.classes(), plan, fan, ring);
  auto skin_of = [&](uint32_t wedge) -> const QuantizedSkin& {
    return cut_.h.skin[cut_.node_hierarchy[cut_.wedge_node[wedge]]];
  };
  encodeSkins(cut_.h.skin[hierarchy_node], cut_.h.skin[plan.a], cut_.h.skin[plan.b], plan.t8, settings_.weight_one,
              {all_neighbours, skin_of}, page_.streams[skin_modes], page_, residuals_);
  cut_.node_split[node] = 1;
}

uint32_t SplitEncoder::skinModesOf(uint32_t hierarchy_node, const format::Fan& fan) const {
  const auto alike = std::count_if(fan.next, fan.next + fan.count, [&](uint32_t next) {
    return cut_.h.skin[cut_.node_hierarchy[next]] == cut_.h.skin[hierarchy_node];
  });
  return format::skinModeStream(static_cast<uint32_t>(alike), fan.count);
}

SplitEncoder::Plan SplitEncoder::planSplit(uint32_t hierarchy_node, const format::Fan& fan,
                                           const format::Ring& ring) const {
  Plan plans[2] = {assignChildren(hierarchy_node, 0, fan), assignChildren(hierarchy_node, 1, fan)};
  for (Plan& plan : plans)
    if (tryRing(plan, fan, ring, 1) || tryRing(plan, fan, ring, 2)) return plan;
  // Child B's corners are listed: B is the child with fewer, which bounds the lists over the whole hierarchy.
  const auto corners_at_b = std::count(plans[0].at_b.begin(), plans[0].at_b.end(), 1);
  return plans[2 * corners_at_b <= static_cast<int64_t>(fan.count) ? 0 : 1];
}

SplitEncoder::Plan SplitEncoder::assignChildren(uint32_t hierarchy_node, uint32_t which_is_a,
                                                const format::Fan& fan) const {
  Plan plan;
  plan.a = cut_.h.children[hierarchy_node][which_is_a];
  plan.b = cut_.h.children[hierarchy_node][1 - which_is_a];
  plan.t8 = which_is_a ? cut_.h.t8[hierarchy_node] : 8 - cut_.h.t8[hierarchy_node];
  plan.listed = true;
  plan.faces = birthsOf(hierarchy_node, plan.a);
  plan.at_b.resize(fan.count);
  for (uint32_t i = 0; i < fan.count; ++i) plan.at_b[i] = cut_.h.contains(plan.b, cut_.leafVertex(fan.corner[i]));
  return plan;
}

std::vector<SplitEncoder::NewFace> SplitEncoder::birthsOf(uint32_t hierarchy_node, uint32_t a) const {
  const Hierarchy& h = cut_.h;
  std::vector<NewFace> faces;
  for (uint32_t i = h.born_begin[hierarchy_node]; i < h.born_begin[hierarchy_node + 1]; ++i) {
    const uint32_t triangle = h.born[i];
    uint32_t third = 0;
    while (h.contains(hierarchy_node, h.wedge_node[h.face_wedges[triangle][third]])) ++third;
    NewFace face;
    face.triangle = triangle;
    face.rotation = (third + 2) % 3;
    face.third = cut_.nodeAbove(h.wedge_node[h.face_wedges[triangle][third]]);
    face.first_is_a = h.contains(a, h.wedge_node[h.face_wedges[triangle][face.rotation]]);
    face.ring_at = kNone;
    faces.push_back(face);
  }
  return faces;
}

bool SplitEncoder::tryRing(Plan& plan, const format::Fan& fan, const format::Ring& ring, size_t births) const {
  const bool closed = ring.kind == format::RingKind::kClosed;
  if (ring.kind == format::RingKind::kIrregular || (closed && births != 2) || plan.faces.size() != births) return false;
  std::vector<NewFace> faces = plan.faces;
  for (NewFace& face : faces) {
    const uint32_t* end = ring.vertex + ringVertexCount(ring);
    const uint32_t* at = std::find(static_cast<const uint32_t*>(ring.vertex), end, face.third);
    if (at == end) return false;
    face.ring_at = static_cast<uint32_t>(at - ring.vertex);
  }
  std::sort(faces.begin(), faces.end(), [](const NewFace& x, const NewFace& y) { return x.ring_at < y.ring_at; });
  if (births == 2 && faces[0].ring_at == faces[1].ring_at) return false;
  const RingSplit split = closed        ? closedSplit(ring.count, faces[0].ring_at, faces[1].ring_at)
                          : births == 2 ? openSplitTwice(ring.count, faces[0].ring_at, faces[1].ring_at)
                                        : openSplit(ring.count, faces[0].ring_at);
  for (size_t i = 0; i < births; ++i)
    if (split.faces[i].first_is_a != faces[i].first_is_a) return false;
  for (uint32_t i = 0; i < fan.count; ++i)
    if (split.edge_at_b[i] != plan.at_b[ring.edge[i]]) return false;
  plan.faces = std::move(faces);
  plan.listed = false;
  return true;
}

void SplitEncoder::writeConnectivity(uint32_t node, const Plan& plan, const format::Fan& fan,
                                     const format::Ring& ring) {
  writeCut(node, plan, fan, ring);
  if (plan.listed) writeList(plan, fan);
}

void SplitEncoder::writeCut(uint32_t node, const Plan& plan, const format::Fan& fan, const format::Ring& ring) {
  if (ring.kind == format::RingKind::kIrregular) return;
  const bool closed = ring.kind == format::RingKind::kClosed;
  uint32_t value = format::kCutListed;
  if (!plan.listed && closed) {
    const uint32_t from = format::farthestVertex(ring, cut_.filePosition(node),
                                                 [&](uint32_t i) { return cut_.filePosition(fan.next[i]); });
    auto counted = [&](uint32_t vertex) { return (vertex + ring.count - from) % ring.count; };
    const auto [p, q] = std::minmax({counted(plan.faces[0].ring_at), counted(plan.faces[1].ring_at)});
    value = 1 + format::pairIndex(p, q);
  } else if (!plan.listed) {
    const uint32_t first = plan.faces[0].ring_at;
    value =
        1 + (plan.faces.size() == 1 ? first : ringVertexCount(ring) + format::pairIndex(first, plan.faces[1].ring_at));
  }
  page_.streams[closed ? format::cutStream(ring.count) : static_cast<uint32_t>(format::kCutOpen)].put(
      static_cast<int32_t>(value));
}

void SplitEncoder::writeList(const Plan& plan, const format::Fan& fan) {
  StreamData& out = page_.streams[format::kGeneral];
  out.put(static_cast<int32_t>(std::count(plan.at_b.begin(), plan.at_b.end(), 1)));
  uint32_t next = 0;
  for (uint32_t i = 0; i < fan.count; ++i)
    if (plan.at_b[i]) {
      out.put(static_cast<int32_t>(i - next));
      next = i + 1;
    }
  std::vector<uint32_t> neighbours(fan.next, fan.next + fan.count);
  neighbours.insert(neighbours.end(), fan.previous, fan.previous + fan.count);
  std::sort(neighbours.begin(), neighbours.end());
  neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
  out.put(static_cast<int32_t>(plan.faces.size()));
  for (const NewFace& face : plan.faces) {
    out.put(face.first_is_a ? 0 : 1);
    const auto at = std::lower_bound(neighbours.begin(), neighbours.end(), face.third);
    if (at != neighbours.end() && *at == face.third) {
      out.put(static_cast<int32_t>(at - neighbours.begin()) + 1);
    } else {
      out.put(0);
      out.put(static_cast<int32_t>(face.third >> 16));
      out.put(static_cast<int32_t>(face.third & 0xffff));
    }
  }
}

void SplitEncoder::writePosition(uint32_t hierarchy_node, const Plan& plan, const format::Fan& fan) {
  const Hierarchy& h = cut_.h;
  std::array<int64_t, 3> sum_a{}, sum_b{};
  int64_t count_a = 0, count_b = 0;
  glm::ivec3 least = h.position[hierarchy_node], greatest = least;
  format::AreaNormal normal;
  for (uint32_t i = 0; i < fan.count; ++i) {
    normal.add(cut_.positionOf(hierarchy_node), cut_.filePosition(fan.next[i]), cut_.filePosition(fan.previous[i]));
    auto& sum = plan.at_b[i] ? sum_b : sum_a;
    (plan.at_b[i] ? count_b : count_a) += 2;
    for (uint32_t neighbour : {fan.next[i], fan.previous[i]}) {
      const glm::ivec3 p = h.position[cut_.node_hierarchy[neighbour]];
      for (int c = 0; c < 3; ++c) sum[c] += p[c];
      least = glm::min(least, p);
      greatest = glm::max(greatest, p);
    }
  }
  const glm::ivec3 spread = greatest - least;
  const format::Int3 d = format::minus(cut_.positionOf(plan.a), cut_.positionOf(plan.b));
  Residual residual;
  residual.components = 3;
  residual.extent = format::meanEdge(fan, cut_.positionOf(hierarchy_node),
                                     [&](uint32_t i) { return cut_.filePosition(fan.next[i]); });
  residual.difference = {d.x, d.y, d.z};
  for (size_t c = 0; c < 3; ++c) residual.slope[c] = format::meanDifference(sum_a[c], count_a, sum_b[c], count_b);
  residual.normal = {normal.x, normal.y, normal.z};
  residuals_.add(residual);
  extent_ = static_cast<uint32_t>(std::max({spread.x, spread.y, spread.z, format::longest(d)}));
  writePlacement(hierarchy_node, plan, fan);
}

format::PredictedPlacement SplitEncoder::predictPlacement(uint32_t hierarchy_node, const Plan& plan,
                                                          const format::Fan& fan) const {
  if (fan.count > format::kMaxRing) return {};
  const format::Int3 center = cut_.positionOf(hierarchy_node);
  format::PlacementSums sums(format::minus(cut_.positionOf(plan.a), cut_.positionOf(plan.b)), extent_);
  for (uint32_t i = 0; i < fan.count; ++i)
    sums.addFan(plan.at_b[i] ? 1 : 0, format::minus(cut_.filePosition(fan.next[i]), center),
                format::minus(cut_.filePosition(fan.previous[i]), center));
  for (const NewFace& face : plan.faces)
    if (face.ring_at != kNone) sums.addCut(format::minus(cut_.filePosition(face.third), center), face.first_is_a);
  return sums.solve();
}

void SplitEncoder::writePlacement(uint32_t hierarchy_node, const Plan& plan, const format::Fan& fan) {
  const format::PredictedPlacement predicted = predictPlacement(hierarchy_node, plan, fan);
  const format::Int3 b = cut_.positionOf(plan.b), d = format::minus(cut_.positionOf(plan.a), b);
  const int32_t step = format::latticeStep(d, settings_.placement_shift);
  const format::Int3 from = format::minus(cut_.positionOf(hierarchy_node), format::pointBetween(b, d, plan.t8));
  const int32_t k[3] = {from.x / step, from.y / step, from.z / step};
  const format::Plane across(d.x, d.y, d.z);
  Residual lattice;
  lattice.kind = Residual::Kind::kLattice;
  lattice.components = 2;
  lattice.extent = static_cast<uint32_t>(step);
  for (size_t c = 0; c < 2; ++c) {
    lattice.difference[c] = k[across.across[c]];
    lattice.slope[c] = predicted.across[across.across[c]];
  }
  residuals_.add(lattice);
  auto& splits = page_.streams[format::kSplits].attributes;
  splits[format::kSplitT8].values.push_back(format::rankOfEighth(plan.t8, predicted.t8));
  splits[format::kSplitLatticeHeight].values.push_back(
      static_cast<int32_t>(k[across.axis] + across.lift(lattice.difference[0], lattice.difference[1])));
}

void SplitEncoder::writeClass(uint32_t wedge, const WedgeClass& wedge_class, const Plan& plan) {
  const uint32_t count_a = wedge_class.members[0].count, count_b = wedge_class.members[1].count;
  bool at[2] = {false, false};
  for (size_t i = 0; i < fan_wedge_.size(); ++i)
    if (fan_wedge_[i] == wedge) at[plan.at_b[i] ? 1 : 0] = true;
  const uint32_t code = format::classCode({count_a, count_b}, at[0], at[1]);
  StreamData& stream = page_.streams[format::classStream(at[0], at[1])];
  stream.put(static_cast<int32_t>(code));
  if (code < format::kClassListed) return;
  for (uint32_t count : {count_a, count_b}) stream.put(static_cast<int32_t>(count));
}

void SplitEncoder::writeClasses(uint32_t node, const std::vector<WedgeClass>& classes, const Plan& plan) {
  for (uint32_t i = 0; i < classes.size(); ++i) writeClass(cut_.node_first_wedge[node] + i, classes[i], plan);
}

// The children's wedges are numbered class by class, child A's before child B's.
void SplitEncoder::addChildren(const std::vector<WedgeClass>& classes, const Plan& plan) {
  for (const bool of_b : {false, true}) {
    std::vector<uint32_t> wedges;
    for (const WedgeClass& c : classes) wedges.insert(wedges.end(), c.wedges[of_b].begin(), c.wedges[of_b].end());
    cut_.addNode(plan.child(of_b), wedges);
  }
}

namespace {

/// greatest: of either component
template <class Point>
void predictFromRing(Residual& residual, const format::RingNeighbours& neighbours, const Point& point,
                     format::Int2 parent, uint32_t greatest) {
  const format::PairSlope ring = neighbours.slopesOf(point, parent);
  residual.slope = {ring.x, ring.y, {}};
  residual.extent = ring.among(neighbours.count, greatest);
}

}  // namespace

// In the chart around the parent's direction.
Residual SplitEncoder::directionResidual(uint32_t at, uint32_t parent, uint32_t a, uint32_t b, const Plan& plan,
                                         const format::RingNeighbours& neighbours) const {
  const format::Int2 p = cut_.pairAt(parent, at);
  const auto d =
      octahedralDifference(p, cut_.pairAt(b, at), cut_.pairAt(a, at), plan.directionRule(settings_.normal_center));
  if (!d) throw Error("a direction cannot be recovered from its parent: this is a fault of lithe, please report it");
  Residual residual;
  residual.components = 2;
  residual.difference = {d->x, d->y, 0};
  const format::ChartedDirection here(p, settings_.normal_center);
  auto point = [&](uint32_t neighbour) {
    return here.chart.fromSquare(cut_.pairAt(cut_.wedge_hierarchy[neighbour], at));
  };
  predictFromRing(residual, neighbours, point, here.point, 2 * static_cast<uint32_t>(settings_.normal_center));
  return residual;
}

Residual SplitEncoder::uvResidual(uint32_t set, uint32_t parent, uint32_t a, uint32_t b,
                                  const format::RingNeighbours& neighbours) const {
  Residual residual;
  residual.kind = Residual::Kind::kUv;
  residual.set = static_cast<uint8_t>(set);
  residual.components = 2;
  const uint32_t at = cut_.h.record.uv[set];
  for (uint32_t c = 0; c < 2; ++c) residual.difference[c] = cut_.attributes(a)[at + c] - cut_.attributes(b)[at + c];
  predictFromRing(
      residual, neighbours, [&](uint32_t neighbour) { return cut_.pairAt(cut_.wedge_hierarchy[neighbour], at); },
      cut_.pairAt(parent, at), settings_.uv_greatest);
  return residual;
}

bool SplitEncoder::isPredicted(uint32_t node, const format::Fan& fan) const {
  return cut_.node_first_wedge[node + 1] - cut_.node_first_wedge[node] <= format::kMaxPredictedClasses &&
         fan.count <= format::kMaxRing;
}

// Of the corners at one wedge of the split node; kNone: at all of them.
format::RingNeighbours SplitEncoder::neighboursOf(uint32_t node, uint32_t wedge, const Plan& plan,
                                                  const format::Fan& fan, const format::Ring& ring) const {
  format::RingNeighbours neighbours;
  format::gatherNeighbours(
      fan, ring, cut_.filePosition(node), format::minus(cut_.positionOf(plan.a), cut_.positionOf(plan.b)), extent_,
      [&](uint32_t i) { return wedge == kNone || fan_wedge_[i] == wedge; },
      [&](uint32_t i, uint32_t step) { return cut_.filePosition(step == 0 ? fan.next[i] : fan.previous[i]); },
      [&](uint32_t i, uint32_t step) { return neighbourWedge(fan, i, step); }, neighbours);
  return neighbours;
}

format::Int2 SplitEncoder::normalDifference(uint32_t wedge, const Plan& plan, const format::Fan& fan,
                                            const format::OctahedralChart& chart) const {
  format::ChildNormals normals{{cut_.positionOf(plan.a), cut_.positionOf(plan.b)}, {}};
  normals.addFan(
      fan, [&](uint32_t i) { return fan_wedge_[i] == wedge; }, plan.at_b,
      [&](uint32_t i, uint32_t step) { return cut_.filePosition(step == 0 ? fan.next[i] : fan.previous[i]); });
  for (const NewFace& face : plan.faces)
    if (face.ring_at != kNone) normals.addCut(cut_.filePosition(face.third), face.first_is_a);
  return format::normalDifference(normals.normal[0], normals.normal[1], chart);
}

// What lies at one child only has the parent's record.
void SplitEncoder::writeAttributes(uint32_t node, const std::vector<WedgeClass>& classes, const Plan& plan,
                                   const format::Fan& fan, const format::Ring& ring) {
  for (uint32_t i = 0; i < classes.size(); ++i)
    if (classes[i].atBoth())
      writePair(cut_.node_first_wedge[node] + i, classes[i].wedges[0][0], classes[i].wedges[1][0], plan, fan, ring);
  FurtherEncoder(cut_, classes, settings_.normal_center, page_, residuals_).run();
}

// The first wedges of a class.
void SplitEncoder::writePair(uint32_t wedge, uint32_t a, uint32_t b, const Plan& plan, const format::Fan& fan,
                             const format::Ring& ring) {
  const WedgeRecord& record = cut_.h.record;
  const uint32_t parent = cut_.wedge_hierarchy[wedge], node = cut_.wedge_node[wedge];
  const bool predicted = isPredicted(node, fan);
  const format::RingNeighbours neighbours =
      predicted ? neighboursOf(node, wedge, plan, fan, ring) : format::RingNeighbours{};
  if (record.normal != kNone) {
    Residual residual = directionResidual(record.normal, parent, a, b, plan, neighbours);
    residual.kind = Residual::Kind::kNormal;
    const auto chart = format::OctahedralChart::around(cut_.pairAt(parent, record.normal), settings_.normal_center);
    const format::Int2 apart = predicted ? normalDifference(wedge, plan, fan, chart) : format::Int2{0, 0};
    residual.geometry = {apart.x, apart.y, 0};
    residuals_.add(residual);
  }
  if (record.tangent != kNone) {
    Residual residual = directionResidual(record.tangent, parent, a, b, plan, neighbours);
    residual.kind = Residual::Kind::kTangent;
    residuals_.add(residual);
    const uint32_t sign = record.tangent + 2;
    page_.streams[format::kTangents].attributes[1].values.push_back(
        (cut_.attributes(b)[sign] ^ cut_.attributes(parent)[sign]) |
        ((cut_.attributes(a)[sign] ^ cut_.attributes(parent)[sign]) << 1));
  }
  for (uint32_t s = 0; s < settings_.has.uv_sets; ++s) residuals_.add(uvResidual(s, parent, a, b, neighbours));
  for (uint32_t s = 0; s < settings_.has.color_sets; ++s)
    for (uint32_t c = 0; c < 4; ++c)
      page_.streams[format::kColors].put(cut_.attributes(a)[record.color[s] + c] -
                                         cut_.attributes(b)[record.color[s] + c]);
}

}  // namespace lithe::bake
