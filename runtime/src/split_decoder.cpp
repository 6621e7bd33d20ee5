// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "split_decoder.h"

#include <string.h>

#include "further_decoder.h"
#include "lithe/format/file.h"
#include "lithe/format/octahedral_chart.h"
#include "page_base.h"
#include "skin_decoder.h"
#include "sort.h"

namespace lithe::runtime {
namespace {

using format::kNoIndex;

constexpr int64_t kMostResidual = 1 << 18;  // of a component of D; keeps the arithmetic of planes within 64 bits

}  // namespace

SplitDecoder::SplitDecoder(const PageFormat& format, const PagePlan& plan, PageStreams* streams,
                           const FanScratch& scratch, Decoded* decoded)
    : format_(format), plan_(plan), streams_(streams), scratch_(scratch), out_(decoded) {
  attributeLimits(format, greatest_);
}

uint32_t SplitDecoder::run(uint32_t* cursor) {
  uint32_t first_node = plan_.level_first_node;
  for (uint32_t l = 0; l < plan_.ended_levels; ++l) {
    const LevelEnd& end = plan_.ends[l];
    if (const uint32_t check = visitNodes(cursor, first_node, end.node_count, true)) return check;
    if (out_->node_count != end.node_count || out_->wedge_count != end.wedge_count ||
        out_->face_count != end.face_count)
      return kCheckCounts;
    *cursor = 0;
    first_node = end.node_count;
  }
  return plan_.ended_levels ? 0 : visitNodes(cursor, first_node, plan_.node_count, false);
}

uint32_t SplitDecoder::visitNodes(uint32_t* cursor, uint32_t first_node, uint32_t node_end, bool to_the_last) {
  uint32_t node = *cursor;
  for (; node < out_->node_count && (out_->node_count < node_end || to_the_last); ++node) {
    if (out_->node_first_child[node] != kNoIndex) continue;
    const int32_t flag = streams_->values[node < first_node ? format::kFlagsOld : format::kFlagsNew][0].next();
    if (flag == 0) continue;
    if (flag != 1 || out_->node_count + 2 > node_end) return kCheckFlags;
    if (const uint32_t check = splitNode(node)) return check;
  }
  *cursor = node;
  return 0;
}

uint32_t SplitDecoder::splitNode(uint32_t node) {
  if (!gatherFan(node)) return kCheckWork;
  format::buildRing(fan_, ring_);
  uint32_t check = readSides();
  if (check == 0) check = placeChildren(node);
  if (check == 0) check = readClasses(node);
  if (check == 0) check = moveFan();
  if (check == 0) check = addFaces();
  if (check == 0) check = readAttributes();
  if (check == 0) check = readSkins(node);
  return check;
}

bool SplitDecoder::gatherFan(uint32_t node) {
  // Corners are linked in ascending order, each in front of the others: the list fills the fan from its end.
  uint32_t* const corner_end = scratch_.corner + scratch_.capacity;
  uint32_t* first = corner_end;
  const uint32_t* const corner_next = out_->corner_next;
  for (uint32_t corner = out_->node_first_corner[node]; corner != kNoIndex; corner = corner_next[corner]) {
    if (first == scratch_.corner) return false;
    *--first = corner;
  }
  const uint32_t count = static_cast<uint32_t>(corner_end - first);
  work_ += count;
  if (work_ > format::kMaxPageWork) return false;
  fan_ = {count, first, scratch_.next, scratch_.previous};
  gatherFaces(position(node));
  return true;
}

/// What stands at the fan's faces.
/// center  the split node
void SplitDecoder::gatherFaces(format::Int3 center) {
  constexpr uint8_t kAfter[] = {1, 2, 0, 1};
  const FanScratch to = scratch_;
  const uint32_t count = fan_.count;
  const uint32_t *const corners = fan_.corner, *const face_wedges = out_->face_wedges, *const nodes = out_->wedge_node;
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t corner = corners[i], k = corner % 3;
    const uint32_t* const wedges = face_wedges + (corner - k);
    const uint32_t next = wedges[kAfter[k]], previous = wedges[kAfter[k + 1]];
    const uint32_t next_node = nodes[next], previous_node = nodes[previous];
    to.wedge[i] = wedges[k];
    to.other_wedge[0][i] = next;
    to.other_wedge[1][i] = previous;
    to.next[i] = next_node;
    to.previous[i] = previous_node;
    to.other_at[0][i] = format::minus(position(next_node), center);
    to.other_at[1][i] = format::minus(position(previous_node), center);
  }
}

/// Which corners go to child B, and the new faces.
uint32_t SplitDecoder::readSides() {
  listed_ = ring_.kind == format::RingKind::kIrregular;
  if (listed_) return readList();
  const uint32_t stream = ring_.kind == format::RingKind::kClosed ? format::cutStream(ring_.count)
                                                                  : static_cast<uint32_t>(format::kCutOpen);
  const uint32_t value = readUnsigned(stream);
  listed_ = value == format::kCutListed;
  return listed_ ? readList() : cutRing(value - 1);
}

uint32_t SplitDecoder::cutRing(uint32_t value) {
  const bool closed = ring_.kind == format::RingKind::kClosed;
  const uint32_t edges = ring_.count, vertices = closed ? edges : edges + 1;
  uint32_t p = value, q = edges;  // child B owns the edges [p, q)
  bool inside_is_b = true;
  face_count_ = 1;
  if (closed || value >= vertices) {
    const uint32_t pair = closed ? value : value - vertices;
    if (pair >= vertices * (vertices - 1) / 2) return kCheckCut;
    format::pairOf(pair, &p, &q);
    if (closed) countFromFarthest(&p, &q);
    // In a closed ring child A owns edge 0.
    inside_is_b = !closed || p != 0;
    face_count_ = 2;
  }
  for (uint32_t i = 0; i < edges; ++i) scratch_.at_b[ring_.edge[i]] = (i >= p && i < q) == inside_is_b;
  const uint32_t at[2] = {p, q};
  for (uint32_t i = 0; i < face_count_; ++i) ring_faces_[i] = {ring_.vertex[at[i]], (i == 0) == inside_is_b};
  return 0;
}

/// A pair of a closed ring's vertices as the ring numbers them.
void SplitDecoder::countFromFarthest(uint32_t* p, uint32_t* q) const {
  const uint32_t from = format::farthestVertex(ring_, {0, 0, 0}, [&](uint32_t i) { return scratch_.other_at[0][i]; });
  const uint32_t a = (*p + from) % ring_.count, b = (*q + from) % ring_.count;
  *p = least(a, b);
  *q = greatest(a, b);
}

uint32_t SplitDecoder::readList() {
  const uint32_t count_b = readUnsigned(format::kGeneral);
  if (count_b > fan_.count) return kCheckGeneral;
  if (fan_.count > 0) memset(scratch_.at_b, 0, fan_.count);
  uint64_t next = 0;
  for (uint32_t i = 0; i < count_b; ++i) {
    next += readUnsigned(format::kGeneral);
    if (next >= fan_.count) return kCheckGeneral;
    scratch_.at_b[next++] = 1;
  }
  face_count_ = readUnsigned(format::kGeneral);
  return failUnless(face_count_ <= plan_.face_count - out_->face_count, kCheckGeneral);
}

/// The third node of a listed face: by rank among the fan's neighbours, or by id.
uint32_t SplitDecoder::listedNode(uint32_t neighbour_count, uint32_t* node) {
  const uint32_t rank = readUnsigned(format::kGeneral);
  if (rank > neighbour_count) return kCheckGeneral;
  if (rank > 0) {
    *node = scratch_.sorted[rank - 1];
    return 0;
  }
  const uint64_t high = readUnsigned(format::kGeneral), low = readUnsigned(format::kGeneral);
  if (high > 0xffff || low > 0xffff) return kCheckGeneral;
  *node = static_cast<uint32_t>(high << 16 | low);
  return 0;
}

/// D: what is left over the ring's plane and in it, plus the difference of the neighbourhoods' means.
bool SplitDecoder::readDifference(uint32_t mean_edge, const format::Plane& plane, int32_t* d) {
  IntReader* split = streams_->values[format::kSplits];
  const uint8_t* parameters = streams_->parameters;
  const int32_t low = format::lowBits(mean_edge, parameters[format::kPositionBias]);
  const int32_t low_height = format::lowBits(mean_edge, parameters[format::kHeightBias]);
  int64_t left[3];
  for (uint32_t across : plane.across) {
    left[across] = residual(&split[format::kSplitPosition], format::kLowPositions, low);
    if (left[across] >= kMostResidual || left[across] <= -kMostResidual) return false;
  }
  left[plane.axis] = residual(&split[format::kSplitPositionHeight], format::kLowPositions, low_height) -
                     plane.lift(left[plane.across[0]], left[plane.across[1]]);
  // Larger differences cannot lie between two points of the grid, and would overflow further on.
  const int64_t most = int64_t{1} << format_.position_bits;
  for (int c = 0; c < 3; ++c) {
    const format::Slope means =
        format::meanDifference(side_[0].neighbours(c), 2 * side_[0].count, side_[1].neighbours(c), 2 * side_[1].count);
    const int64_t exact = left[c] + format::scaled(parameters[format::kPositionMean], means);
    if (exact >= most || exact <= -most) return false;
    d[c] = static_cast<int32_t>(exact);
  }
  return true;
}

/// From the planes of the children's faces, as far as they are known: those of lists are not.
format::PredictedPlacement SplitDecoder::predictPlacement(format::Int3 center, format::Int3 d) const {
  if (fan_.count > format::kMaxRing) return {};
  format::PlacementSums sums(d, ring_extent_);
  for (uint32_t i = 0; i < fan_.count; ++i)
    sums.addFan(scratch_.at_b[i], scratch_.other_at[0][i], scratch_.other_at[1][i]);
  for (uint32_t i = 0; !listed_ && i < face_count_; ++i)
    sums.addCut(format::minus(position(ring_faces_[i].third), center), ring_faces_[i].first_is_a);
  return sums.solve();
}

/// Lattice indices: two across D, and the third as the height over the plane that D is perpendicular to.
void SplitDecoder::readLattice(format::Int3 d, int32_t step, const format::PredictedPlacement& predicted, int64_t* k) {
  IntReader* split = streams_->values[format::kSplits];
  const int32_t strength = streams_->parameters[format::kPlacement];
  const format::Plane plane(d.x, d.y, d.z);
  for (uint32_t across : plane.across)
    k[across] =
        int64_t{split[format::kSplitLattice].next()} + format::latticeIndex(strength, predicted.across[across], step);
  k[plane.axis] = split[format::kSplitLatticeHeight].next() - plane.lift(k[plane.across[0]], k[plane.across[1]]);
}

/// Sums over the fan. Returns the longest side of its box with the split node.
int32_t SplitDecoder::sumSides() {
  side_[0] = side_[1] = {};
  format::Int3 low{0, 0, 0}, high{0, 0, 0};
  const bool closed = ring_.kind == format::RingKind::kClosed;
  for (uint32_t i = 0; i < fan_.count; ++i) {
    const format::Int3 next = scratch_.other_at[0][i], previous = scratch_.other_at[1][i];
    SideSum& side = side_[scratch_.at_b[i]];
    ++side.count;
    side.next[0] += next.x;
    side.next[1] += next.y;
    side.next[2] += next.z;
    side.previous[0] += previous.x;
    side.previous[1] += previous.y;
    side.previous[2] += previous.z;
    side.normal.add({0, 0, 0}, next, previous);
    low = {least(low.x, next.x), least(low.y, next.y), least(low.z, next.z)};
    high = {greatest(high.x, next.x), greatest(high.y, next.y), greatest(high.z, next.z)};
    if (closed) continue;
    low = {least(low.x, previous.x), least(low.y, previous.y), least(low.z, previous.z)};
    high = {greatest(high.x, previous.x), greatest(high.y, previous.y), greatest(high.z, previous.z)};
  }
  return greatest(high.x - low.x, greatest(high.y - low.y, high.z - low.z));
}

uint32_t SplitDecoder::placeChildren(uint32_t node) {
  const format::Int3 center = position(node);
  const int32_t w[3] = {center.x, center.y, center.z};
  const int32_t extent = sumSides();
  const format::AreaNormal &a_side = side_[0].normal, &b_side = side_[1].normal;
  int32_t d[3];
  const uint32_t mean_edge = format::meanEdge(fan_, {0, 0, 0}, [&](uint32_t i) { return scratch_.other_at[0][i]; });
  if (!readDifference(mean_edge, {a_side.x + b_side.x, a_side.y + b_side.y, a_side.z + b_side.z}, d))
    return kCheckPosition;
  const format::Int3 difference{d[0], d[1], d[2]};
  const int32_t step = format::latticeStep(difference, format_.placement_shift);
  ring_extent_ = static_cast<uint32_t>(greatest(extent, format::longest(difference)));

  const format::PredictedPlacement predicted = predictPlacement(center, difference);
  const int32_t rank = streams_->values[format::kSplits][format::kSplitT8].next();
  if (rank > 8) return kCheckSplit;
  t8_ = format::eighthOfRank(rank, predicted.t8);
  int64_t k[3];
  readLattice(difference, step, predicted, k);
  const uint32_t child_a = out_->node_count, child_b = child_a + 1;
  for (uint32_t c = 0; c < 3; ++c) {
    const int64_t b = static_cast<int64_t>(w[c]) - k[c] * step - format::eighths(d[c], t8_);
    const int64_t a = b + d[c];
    if (b < 0 || a < 0 || b >> format_.position_bits || a >> format_.position_bits) return kCheckPosition;
    out_->node_position[3 * static_cast<size_t>(child_a) + c] = static_cast<uint16_t>(a);
    out_->node_position[3 * static_cast<size_t>(child_b) + c] = static_cast<uint16_t>(b);
  }
  for (uint32_t child = child_a; child <= child_b; ++child) {
    out_->node_parent[child] = node;
    out_->node_first_child[child] = kNoIndex;
  }
  return 0;
}

uint32_t SplitDecoder::readClasses(uint32_t node) {
  first_parent_wedge_ = out_->node_first_wedge[node];
  const uint32_t count = class_count_ = out_->node_first_wedge[node + 1] - first_parent_wedge_;
  if (count > scratch_.capacity) return kCheckWork;
  for (uint32_t i = 0; i < count; ++i) scratch_.classes[i] = {};
  if (count == 1)
    for (uint32_t side = 0; side < 2; ++side) scratch_.classes[0].has_corners[side] = side_[side].count > 0;
  else
    for (uint32_t i = 0; i < fan_.count; ++i) scratch_.classes[classOf(i)].has_corners[scratch_.at_b[i]] = true;
  uint64_t total_a = 0, total_b = 0;
  has_further_wedges_ = false;
  for (uint32_t i = 0; i < count; ++i) {
    WedgeClass& wedge_class = scratch_.classes[i];
    uint32_t &count_a = wedge_class.members[0].count, &count_b = wedge_class.members[1].count;
    const bool at_a = wedge_class.has_corners[0], at_b = wedge_class.has_corners[1];
    const uint32_t stream = format::classStream(at_a, at_b), code = readUnsigned(stream);
    if (code > format::kClassListed) return kCheckClasses;
    if (code == format::kClassListed) {
      count_a = readUnsigned(stream);
      count_b = readUnsigned(stream);
    } else {
      const format::ClassCounts counts = format::classCounts(code, at_a, at_b);
      count_a = counts.a;
      count_b = counts.b;
    }
    if (count_a == 0 && count_b == 0) return kCheckClasses;
    has_further_wedges_ |= count_a > 1 || count_b > 1;
    total_a += count_a;
    total_b += count_b;
    if (total_a + total_b > plan_.wedge_count - out_->wedge_count) return kCheckClasses;
  }
  if (total_a == 0 || total_b == 0) return kCheckClasses;

  const uint32_t child_a = out_->node_count, first_a = out_->wedge_count;
  const uint32_t first_b = first_a + static_cast<uint32_t>(total_a), end = first_b + static_cast<uint32_t>(total_b);
  uint32_t next[2] = {first_a, first_b};
  for (uint32_t i = 0; i < count; ++i) {
    WedgeClass& wedge_class = scratch_.classes[i];
    const uint32_t parent = first_parent_wedge_ + i;
    for (uint32_t side = 0; side < 2; ++side) {
      wedge_class.first[side] = next[side];
      next[side] += wedge_class.members[side].count;
      for (uint32_t wedge = wedge_class.first[side]; wedge < next[side]; ++wedge) {
        out_->wedge_node[wedge] = child_a + side;
        out_->wedge_parent[wedge] = parent;
        out_->wedge_part[wedge] = out_->wedge_part[parent];
      }
    }
  }
  out_->node_first_wedge[child_a] = first_a;
  out_->node_first_wedge[child_a + 1] = first_b;
  out_->node_first_wedge[child_a + 2] = end;
  out_->node_first_child[node] = child_a;
  out_->node_count += 2;
  out_->wedge_count = end;
  return 0;
}

/// The neighbours along the faces at one wedge of the split node (kNoIndex: at all of them).
void SplitDecoder::gatherRing(uint32_t wedge) {
  const uint32_t child_a = out_->node_count - 2;
  const format::Int3 d = format::minus(position(child_a), position(child_a + 1));
  auto gather = [&](auto includes) {
    format::gatherNeighbours(
        fan_, ring_, {0, 0, 0}, d, ring_extent_, includes,
        [&](uint32_t i, uint32_t step) { return scratch_.other_at[step][i]; },
        [&](uint32_t i, uint32_t step) { return scratch_.other_wedge[step][i]; }, neighbours_);
  };
  if (wedge == kNoIndex)
    gather([](uint32_t) { return true; });
  else
    gather([&](uint32_t i) { return scratch_.wedge[i] == wedge; });
}

/// Of the faces at one wedge of the split node.
format::Int2 SplitDecoder::normalDifference(uint32_t wedge, const format::OctahedralChart& chart) const {
  const uint32_t child_a = out_->node_count - 2, parent = out_->node_parent[child_a];
  const format::Int3 from = position(parent);
  format::ChildNormals normals{{format::minus(position(child_a), from), format::minus(position(child_a + 1), from)},
                               {}};
  if (class_count_ == 1) {
    // All of them: their sums seen from the split node are known, and (n - c) x (p - c) = n x p + c x (n - p).
    for (uint32_t side = 0; side < 2; ++side) {
      const format::Int3 c = normals.child[side];
      const int64_t chord[3] = {side_[side].chord(0), side_[side].chord(1), side_[side].chord(2)};
      normals.normal[side] = side_[side].normal;
      normals.normal[side].x += c.y * chord[2] - c.z * chord[1];
      normals.normal[side].y += c.z * chord[0] - c.x * chord[2];
      normals.normal[side].z += c.x * chord[1] - c.y * chord[0];
    }
  } else {
    normals.addFan(
        fan_, [&](uint32_t i) { return scratch_.wedge[i] == wedge; }, scratch_.at_b,
        [&](uint32_t i, uint32_t step) { return scratch_.other_at[step][i]; });
  }
  for (uint32_t i = 0; !listed_ && i < face_count_; ++i)
    normals.addCut(format::minus(position(ring_faces_[i].third), from), ring_faces_[i].first_is_a);
  return format::normalDifference(normals.normal[0], normals.normal[1], chart);
}

/// Of two entries of the records.
SplitDecoder::Expected SplitDecoder::expectPair(const uint16_t* parent, uint32_t at, int32_t strength) const {
  const uint32_t stride = format_.layout.stride;
  auto pair = [&](uint32_t wedge) -> format::Int2 {
    const uint16_t* p = out_->wedge_attributes + static_cast<size_t>(wedge) * stride + at;
    return {p[0], p[1]};
  };
  const format::PairSlope ring = neighbours_.slopesOf(pair, {parent[at], parent[at + 1]});
  return {{format::scaled(strength, ring.x), format::scaled(strength, ring.y)},
          ring.among(neighbours_.count, static_cast<uint32_t>(greatest_[at]))};
}

/// Of the two entries of a direction, in the chart around the parent's.
SplitDecoder::Expected SplitDecoder::expectDirection(const format::ChartedDirection& parent, uint32_t at,
                                                     int32_t strength) const {
  const uint32_t stride = format_.layout.stride;
  auto point = [&](uint32_t wedge) {
    const uint16_t* p = out_->wedge_attributes + static_cast<size_t>(wedge) * stride + at;
    return parent.chart.fromSquare({p[0], p[1]});
  };
  const format::PairSlope ring = neighbours_.slopesOf(point, parent.point);
  return {{format::scaled(strength, ring.x), format::scaled(strength, ring.y)},
          ring.among(neighbours_.count, static_cast<uint32_t>(greatest_[at]))};
}

bool SplitDecoder::readDirection(IntReader* high, format::LowBits kind, uint32_t bias, const Expected& expected,
                                 const format::ChartedDirection& parent, uint16_t* a, uint16_t* b) {
  const int32_t size = 2 * parent.chart.center;
  const int32_t low = format::lowBits(expected.spread, bias);
  const int64_t exact_x = int64_t{residual(high, kind, low)} + expected.difference.x;
  const int64_t exact_y = int64_t{residual(high, kind, low)} + expected.difference.y;
  if (exact_x < -2 * size || exact_x > 2 * size || exact_y < -2 * size || exact_y > 2 * size) return false;
  const format::Int2 d{static_cast<int32_t>(exact_x), static_cast<int32_t>(exact_y)};
  const format::ChildDirections children = format::splitDirection(parent, d, t8_, face_count_ > 0);
  a[0] = static_cast<uint16_t>(children.a.x);
  a[1] = static_cast<uint16_t>(children.a.y);
  b[0] = static_cast<uint16_t>(children.b.x);
  b[1] = static_cast<uint16_t>(children.b.y);
  return children.valid;
}

uint32_t SplitDecoder::readAttributes() {
  const uint32_t stride = format_.layout.stride, count = class_count_;
  auto record = [&](uint32_t wedge) { return out_->wedge_attributes + static_cast<size_t>(wedge) * stride; };
  for (uint32_t i = 0; i < count; ++i) {
    const WedgeClass& c = scratch_.classes[i];
    const uint16_t* parent = record(first_parent_wedge_ + i);
    if (c.atBoth()) {
      const bool predicted = count <= format::kMaxPredictedClasses && fan_.count <= format::kMaxRing;
      neighbours_.count = 0;
      if (predicted) gatherRing(count > 1 ? first_parent_wedge_ + i : kNoIndex);
      if (!readPair(first_parent_wedge_ + i, predicted, parent, record(c.first[0]), record(c.first[1])))
        return kCheckWedge;
    } else {
      memcpy(record(c.first[c.members[0].count > 0 ? 0 : 1]), parent, stride * sizeof(uint16_t));
    }
  }
  if (!has_further_wedges_) return 0;
  FurtherDecoder further(format_, streams_, out_, greatest_, scratch_.classes, class_count_, first_parent_wedge_);
  return failUnless(further.run(), kCheckWedge);
}

/// The records of a class's first wedges at either child.
bool SplitDecoder::readPair(uint32_t wedge, bool predicted, const uint16_t* parent, uint16_t* a, uint16_t* b) {
  const uint8_t* parameters = streams_->parameters;
  uint32_t at = 0;
  auto direction = [&]() -> format::ChartedDirection {
    return {{parent[at], parent[at + 1]}, static_cast<int32_t>(format_.normal_center)};
  };
  if (format_.has.normals) {
    const int32_t strength = parameters[format::kNormalGradient], geometry = parameters[format::kNormalGeometry];
    const format::ChartedDirection normal = direction();
    const format::Int2 apart = predicted && geometry > 0 ? normalDifference(wedge, normal.chart) : format::Int2{0, 0};
    Expected expected = expectDirection(normal, at, strength);
    expected.difference.x += (geometry * apart.x) >> 4;
    expected.difference.y += (geometry * apart.y) >> 4;
    IntReader* normals = streams_->values[format::kNormals];
    if (!readDirection(normals, format::kLowNormals, parameters[format::kNormalBias], expected, normal, a, b))
      return false;
    at += 2;
  }
  if (format_.has.tangents) {
    IntReader* tangents = streams_->values[format::kTangents];
    const int32_t strength = parameters[format::kTangentGradient];
    const format::ChartedDirection tangent = direction();
    const Expected expected = expectDirection(tangent, at, strength);
    if (!readDirection(&tangents[0], format::kLowTangents, parameters[format::kTangentBias], expected, tangent, a + at,
                       b + at))
      return false;
    const uint32_t flips = static_cast<uint32_t>(tangents[1].next());
    if (flips > 3) return false;
    b[at + 2] = static_cast<uint16_t>(parent[at + 2] ^ (flips & 1));
    a[at + 2] = static_cast<uint16_t>(parent[at + 2] ^ (flips >> 1));
    at += 3;
  }
  auto linear = [&](int64_t d) {
    if (d < -greatest_[at] || d > greatest_[at]) return false;
    const int32_t at_b = parent[at] - format::eighths(static_cast<int32_t>(d), t8_),
                  at_a = at_b + static_cast<int32_t>(d);
    if (at_a < 0 || at_a > greatest_[at] || at_b < 0 || at_b > greatest_[at]) return false;
    a[at] = static_cast<uint16_t>(at_a);
    b[at++] = static_cast<uint16_t>(at_b);
    return true;
  };
  for (uint32_t s = 0; s < format_.has.uv_sets; ++s) {
    const int32_t strength = parameters[format::kUvGradient0 + s];
    const Expected expected = expectPair(parent, at, strength);
    const int32_t low = format::lowBits(expected.spread, parameters[format::kUvBias0 + s]);
    IntReader* uvs = streams_->values[format::kUv0 + s];
    auto difference = [&](int32_t of_ring) { return int64_t{residual(uvs, format::kLowUvs, low)} + of_ring; };
    if (!linear(difference(expected.difference.x)) || !linear(difference(expected.difference.y))) return false;
  }
  for (uint32_t c = 0; c < 4 * format_.has.color_sets; ++c)
    if (!linear(streams_->values[format::kColors][0].next())) return false;
  return true;
}

bool SplitDecoder::childWedge(uint32_t wedge_class, bool at_b, format::MemberGuess guess, uint32_t* wedge) {
  WedgeClass& c = scratch_.classes[wedge_class];
  format::Members& members = c.members[at_b];
  uint32_t member = 0;
  if (members.count > 1)
    member = format::memberOf(readUnsigned(guess.sure ? format::kMemberPicks : format::kMemberChoices), guess.member);
  if (member >= members.choices()) return false;
  members.meet(member);
  *wedge = c.first[at_b] + member;
  return true;
}

uint32_t SplitDecoder::moveFan() {
  if (class_count_ == 1 && !has_further_wedges_) {
    if (!moveToOnlyWedges()) return kCheckPick;
  } else {
    for (uint32_t e = 0; e < fan_.count; ++e) {
      const uint32_t i = listed_ ? e : ring_.edge[e], at_b = scratch_.at_b[i], wedge_class = classOf(i);
      uint32_t wedge;
      if (!childWedge(wedge_class, at_b, scratch_.classes[wedge_class].members[at_b].guessForFan(), &wedge))
        return kCheckPick;
      out_->face_wedges[fan_.corner[i]] = wedge;
    }
  }
  linkFan();
  return 0;
}

/// Of children with at most one wedge each: nothing is read.
bool SplitDecoder::moveToOnlyWedges() {
  WedgeClass& only = scratch_.classes[0];
  for (uint32_t side = 0; side < 2; ++side) {
    if (!only.has_corners[side]) continue;
    if (only.members[side].count == 0) return false;
    only.members[side].meet(0);
  }
  const uint32_t first[2] = {only.first[0], only.first[1]}, count = fan_.count;
  uint32_t* const face_wedges = out_->face_wedges;
  for (uint32_t i = 0; i < count; ++i) face_wedges[fan_.corner[i]] = first[scratch_.at_b[i]];
  return true;
}

/// As linkCorner does with each corner, but both children's lists begin here.
void SplitDecoder::linkFan() {
  uint32_t first_corner[2] = {kNoIndex, kNoIndex};
  uint32_t* const corner_next = out_->corner_next;
  const uint32_t count = fan_.count;
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t corner = fan_.corner[i], at_b = scratch_.at_b[i];
    corner_next[corner] = first_corner[at_b];
    first_corner[at_b] = corner;
  }
  const uint32_t child_a = out_->node_count - 2;
  out_->node_first_corner[child_a] = first_corner[0];
  out_->node_first_corner[child_a + 1] = first_corner[1];
}

uint32_t SplitDecoder::addFaces() {
  if (face_count_ > plan_.face_count - out_->face_count) return kCheckCounts;
  if (!listed_) {
    for (uint32_t i = 0; i < face_count_; ++i)
      if (const uint32_t check = addFace(ring_faces_[i])) return check;
    return 0;
  }
  uint32_t* sorted = scratch_.sorted;
  if (fan_.count > 0) {
    memcpy(sorted, fan_.next, fan_.count * sizeof(uint32_t));
    memcpy(sorted + fan_.count, fan_.previous, fan_.count * sizeof(uint32_t));
  }
  sortValues(sorted, 2 * fan_.count);
  const uint32_t neighbours = dropRepeated(sorted, 2 * fan_.count);
  for (uint32_t i = 0; i < face_count_; ++i) {
    const uint32_t orientation = readUnsigned(format::kGeneral);
    NewFace face{0, orientation == 0};
    if (orientation > 1) return kCheckGeneral;
    if (const uint32_t check = listedNode(neighbours, &face.third)) return check;
    if (const uint32_t check = addFace(face)) return check;
  }
  return 0;
}

uint32_t SplitDecoder::addFace(const NewFace& face) {
  if (face.third >= out_->node_count - 2 || out_->node_first_child[face.third] != kNoIndex) return kCheckFace;
  const uint32_t first_corner = 3 * out_->face_count;
  uint32_t* wedges = out_->face_wedges + first_corner;
  if (const uint32_t check = pickWedges(face, wedges)) return check;
  if (out_->wedge_part[wedges[1]] != out_->wedge_part[wedges[0]]) return kCheckPick;
  for (uint32_t k = 0; k < 3; ++k) linkCorner(out_, first_corner + k);
  ++out_->face_count;
  return 0;
}

/// The wedges of a new face's corners. Where there is nothing to choose nothing is looked for.
uint32_t SplitDecoder::pickWedges(const NewFace& face, uint32_t* wedges) {
  const uint32_t third_first = out_->node_first_wedge[face.third];
  const uint32_t third_count = out_->node_first_wedge[face.third + 1] - third_first;
  const WedgeClass& only = scratch_.classes[0];
  format::CornersBeside beside;
  if (class_count_ > 1 || third_count > 1 || only.members[0].count > 1 || only.members[1].count > 1)
    beside = format::cornersBeside(
        fan_, [&](uint32_t i) { return scratch_.at_b[i] != 0; }, face.third, face.first_is_a);
  work_ += (class_count_ > 1 ? class_count_ : 0) + (third_count > 1 ? third_count : 0);
  if (work_ > format::kMaxPageWork) return kCheckWork;
  const uint32_t wedge_class = class_count_ > 1 ? pickClass(beside) : 0;
  if (wedge_class == kNoIndex || !scratch_.classes[wedge_class].atBoth()) return kCheckPick;
  if (!pickFaceMember(wedge_class, !face.first_is_a, beside.ends, &wedges[0]) ||
      !pickFaceMember(wedge_class, face.first_is_a, beside.starts, &wedges[2]))
    return kCheckPick;
  wedges[1] = third_count > 1 ? pickThird(face.third, wedge_class, beside) : third_first;
  return failUnless(wedges[1] != kNoIndex, kCheckPick);
}

/// The wedge of a new face's corner at a child, beside a corner of the fan that has gone there (kNoIndex: none).
bool SplitDecoder::pickFaceMember(uint32_t wedge_class, bool at_b, uint32_t beside, uint32_t* wedge) {
  WedgeClass& c = scratch_.classes[wedge_class];
  if (c.members[at_b].count == 1) {
    c.members[at_b].meet(0);
    *wedge = c.first[at_b];
    return true;
  }
  const bool same_class = beside != kNoIndex && classOf(beside) == wedge_class;
  const uint32_t member = same_class ? out_->face_wedges[fan_.corner[beside]] - c.first[at_b] : kNoIndex;
  return childWedge(wedge_class, at_b, c.members[at_b].guessForFace(member), wedge);
}

/// kNoIndex when the pick is out of range.
uint32_t SplitDecoder::pickClass(const format::CornersBeside& beside) {
  format::PickList list(class_count_, [&](uint32_t i) {
    const WedgeClass& c = scratch_.classes[i];
    if (!c.atBoth()) return format::Standing::kNoChoice;
    return c.lacksCorners() ? format::Standing::kLacksCorners : format::Standing::kOther;
  });
  uint32_t candidates[2] = {kNoIndex, kNoIndex};
  if (beside.starts != kNoIndex) candidates[0] = classOf(beside.starts);
  if (beside.ends != kNoIndex) candidates[1] = classOf(beside.ends);
  list.propose(candidates[0], candidates[1]);
  if (list.size() < 2) return list.entryAt(0);
  return list.entryAt(readUnsigned(list.candidates() == 1 ? format::kClassPicks : format::kClassChoices));
}

/// A wedge of the third node, of the class's part; kNoIndex when there is none or the pick is out of range.
uint32_t SplitDecoder::pickThird(uint32_t node, uint32_t wedge_class, const format::CornersBeside& beside) {
  const uint32_t first = out_->node_first_wedge[node];
  const uint16_t part = out_->wedge_part[first_parent_wedge_ + wedge_class];
  const format::WedgesInUse in_use = wedgesInUse(node);
  format::PickList list(out_->node_first_wedge[node + 1] - first, [&](uint32_t i) {
    if (out_->wedge_part[first + i] != part) return format::Standing::kNoChoice;
    return in_use.has(i) ? format::Standing::kOther : format::Standing::kLacksCorners;
  });
  auto candidate = [&](uint32_t corner, uint32_t step) {
    if (corner == kNoIndex || classOf(corner) != wedge_class) return kNoIndex;
    return scratch_.other_wedge[step][corner] - first;
  };
  list.propose(candidate(beside.starts, 0), candidate(beside.ends, 1));
  const bool sure = list.candidates() == 1 && !list.othersLackCorners();
  const uint32_t entry = list.size() < 2
                             ? list.entryAt(0)
                             : list.entryAt(readUnsigned(sure ? format::kThirdPicks : format::kThirdChoices));
  return entry == kNoIndex ? kNoIndex : first + entry;
}

format::WedgesInUse SplitDecoder::wedgesInUse(uint32_t node) const {
  format::WedgesInUse in_use;
  const uint32_t first = out_->node_first_wedge[node];
  for (uint32_t corner = out_->node_first_corner[node]; corner != kNoIndex; corner = out_->corner_next[corner])
    if (!in_use.add(out_->face_wedges[corner] - first)) break;
  return in_use;
}

uint32_t SplitDecoder::readSkins(uint32_t node) {
  SkinDecoder skins(format_, streams_, out_, neighbours_);
  const int32_t mode = skins.readMode(node, fan_);
  if (mode > format::kSkinFree) return kCheckSplit;
  // With one wedge the attributes' ring is the whole fan's: it is still at hand.
  if (mode != format::kSkinSame && class_count_ > 1) gatherRing(kNoIndex);
  return failUnless(skins.readChildren(node, mode, t8_), kCheckChildSkin);
}

}  // namespace lithe::runtime
