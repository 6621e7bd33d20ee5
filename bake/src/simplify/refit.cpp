// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "refit.h"

#include <algorithm>
#include <cmath>

#include "kernel_templates.h"
#include "kernels.h"
#include "normal_equations.h"

namespace lithe::bake {

namespace {

constexpr uint32_t kPasses = 3;
constexpr uint32_t kMatchesPerTriangle = 16;  // more samples of the original say nothing new
constexpr float kHold = 0.05f;                // of the distance itself, beside the distance to the tangent plane
constexpr double kStay = 1e-2;                // of the trace
constexpr float kReach = 0.25f;               // squared, of the mean squared length of the edges at a node
constexpr uint32_t kTrials = 3;

/// A point and a triangle in all poses, as one point and one triangle of a space of three dimensions per pose: dot
/// products are all that the nearest point takes.
struct StackedDots {
  float bb, bc, cc, bp, cp, pp;  // of b - a, c - a and p - a
};

LITHE_KERNEL StackedDots stackedDots(const PosedPoint* a, const PosedPoint* b, const PosedPoint* c, const PosedPoint* p,
                                     uint32_t blocks) {
  Lanes bb{}, bc{}, cc{}, bp{}, cp{}, pp{};
  for (uint32_t i = 0; i < blocks; ++i) {
    const PosedPoint ab = b[i] - a[i], ac = c[i] - a[i], ap = p[i] - a[i];
    bb += dot(ab, ab);
    bc += dot(ab, ac);
    cc += dot(ac, ac);
    bp += dot(ab, ap);
    cp += dot(ac, ap);
    pp += dot(ap, ap);
  }
  return {laneSum(bb), laneSum(bc), laneSum(cc), laneSum(bp), laneSum(cp), laneSum(pp)};
}

/// The nearest point of the triangle, as shares of its corners (Ericson 2005, 5.1.5), and its squared distance.
double nearestShares(const StackedDots& s, float share[3]) {
  const double d1 = s.bp, d2 = s.cp, d3 = d1 - s.bb, d4 = d2 - s.bc, d5 = d1 - s.bc, d6 = d2 - s.cc;
  double v = 0.0, w = 0.0;
  const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  if (d1 <= 0.0 && d2 <= 0.0) {
  } else if (d3 >= 0.0 && d4 <= d3) {
    v = 1.0;
  } else if (d6 >= 0.0 && d5 <= d6) {
    w = 1.0;
  } else if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    v = d1 / (d1 - d3);
  } else if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    w = d2 / (d2 - d6);
  } else if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    v = 1.0 - w;
  } else {
    const double sum = va + vb + vc;
    if (sum > 0.0) v = vb / sum, w = vc / sum;
  }
  share[0] = static_cast<float>(1.0 - v - w);
  share[1] = static_cast<float>(v);
  share[2] = static_cast<float>(w);
  return s.pp - 2.0 * (v * d1 + w * d2) + v * v * s.bb + 2.0 * v * w * s.bc + w * w * s.cc;
}

/// A point of the original's surface, and its normal (none for a point of a border), posed.
LITHE_KERNEL void samplePoint(const PosedPoint* a, const PosedPoint* b, const PosedPoint* c, const float* share,
                              bool with_normal, uint32_t blocks, PosedPoint* point, PosedPoint* normal) {
  for (uint32_t i = 0; i < blocks; ++i) {
    point[i] = {a[i].x * share[0] + b[i].x * share[1] + c[i].x * share[2],
                a[i].y * share[0] + b[i].y * share[1] + c[i].y * share[2],
                a[i].z * share[0] + b[i].z * share[1] + c[i].z * share[2]};
    normal[i] = PosedPoint{};
    if (!with_normal) continue;
    const PosedPoint n = cross(b[i] - a[i], c[i] - a[i]);
    const Lanes scale = squareRoot(positiveReciprocal(dot(n, n)));
    normal[i] = {n.x * scale, n.y * scale, n.z * scale};
  }
}

LITHE_KERNEL float meanArea(const PosedPoint* a, const PosedPoint* b, const PosedPoint* c, uint32_t blocks) {
  Lanes area{};
  for (uint32_t i = 0; i < blocks; ++i) {
    const PosedPoint n = cross(b[i] - a[i], c[i] - a[i]);
    area += squareRoot(dot(n, n));
  }
  return 0.5f * laneSum(area);
}

/// Where a match's point lies off its sample and its sample's tangent plane.
struct Residual {
  const PosedPoint *corner[3], *point, *normal;
  float share[3], area, hold;
};

template <class L>
LITHE_INLINE Vec3<L> offset(const Residual& r, uint32_t i) {
  const auto &a = r.corner[0][i], &b = r.corner[1][i], &c = r.corner[2][i], &p = r.point[i];
  return {a.x * r.share[0] + b.x * r.share[1] + c.x * r.share[2] - p.x,
          a.y * r.share[0] + b.y * r.share[1] + c.y * r.share[2] - p.y,
          a.z * r.share[0] + b.z * r.share[1] + c.z * r.share[2] - p.z};
}

LITHE_KERNEL float energyOf(const Residual& r, uint32_t blocks) {
  Lanes sum{};
  for (uint32_t i = 0; i < blocks; ++i) {
    const PosedPoint off = offset<Lanes>(r, i);
    const Lanes height = dot(off, r.normal[i]);
    sum += height * height + dot(off, off) * r.hold;
  }
  return r.area * laneSum(sum);
}

/// Adds to a corner's quadric, about its posed position, what the match costs when the corner moves. The square of a
/// sum of shares is at most the sum of the shares' squares (Jensen), so that corners that move at once never overshoot.
LITHE_KERNEL void addMatch(const Residual& r, float share, uint32_t blocks, Quadric* q) {
  const Lanes weight = Lanes{} + r.area * share, hold = weight * r.hold;
  for (uint32_t i = 0; i < blocks; ++i) {
    const PosedPoint off = offset<Lanes>(r, i);
    addPlane(q[i], r.normal[i], dot(off, r.normal[i]), weight);
    addPoint(q[i], off, hold);
  }
}

}  // namespace

Refit::Refit(const NodeState& nodes, const Surface& surface, const SimplifyOptions& options)
    : weights_(options), blocks_(nodes.posed.blocks), position_(nodes.posed.positions) {
  const auto count = static_cast<uint32_t>(nodes.positions.size());
  into_.resize(count);
  for (uint32_t slot = 0; slot < count; ++slot) into_[slot] = slot;
  made_.resize(count);
  is_new_.assign(count, 0);
  new_index_.resize(count);
  trial_.resize(blocks_);
  point_.resize(blocks_);
  normal_.resize(blocks_);
  blend_.resize(blocks_);
  const float poses = static_cast<float>(nodes.posed.pose_count);
  for (uint32_t id = 0; id < surface.faceCount(); ++id) {
    const Face& face = surface.face(id);
    const float area = meanArea(nodes.posed.at(face.corner[0]), nodes.posed.at(face.corner[1]),
                                nodes.posed.at(face.corner[2]), blocks_) /
                       poses;
    if (area > 0.0f) faces_.push_back({face.corner, area});
    for (uint32_t k = 0; k < 3; ++k) {
      if (!(face.kind[k] & kBorder)) continue;
      const uint32_t from = face.corner[(k + 1) % 3], to = face.corner[(k + 2) % 3];
      const float length2 = squaredDistances(nodes.posed.at(from), nodes.posed.at(to), blocks_) / poses;
      if (length2 > 0.0f) borders_.push_back({{from, to, to}, 0.5f * weights_.border * length2});
    }
  }
}

void Refit::merged(uint32_t a, uint32_t b, const Segment& segment, int32_t t8) {
  into_[b] = a;
  made_[a] = {segment.v, segment.d, t8};
  is_new_[b] = 0;
  if (!is_new_[a]) new_slots_.push_back(a);
  is_new_[a] = 1;
}

uint32_t Refit::slotOf(uint32_t vertex) {
  uint32_t root = vertex;
  while (into_[root] != root) root = into_[root];
  while (into_[vertex] != root) {
    const uint32_t next = into_[vertex];
    into_[vertex] = root;
    vertex = next;
  }
  return root;
}

void Refit::poseSample(const Match& match) {
  const PosedPoint* vertex[3];
  for (uint32_t k = 0; k < 3; ++k) vertex[k] = position_.data() + size_t{match.from.vertex[k]} * blocks_;
  samplePoint(vertex[0], vertex[1], vertex[2], match.at, !match.border, blocks_, point_.data(), normal_.data());
}

bool Refit::findNearest(const NodeState& nodes, const Surface& surface, Match& match) {
  double least = 1e300;
  uint32_t seen[3];
  for (uint32_t k = 0; k < 3; ++k) {
    const uint32_t slot = seen[k] = slotOf(match.from.vertex[k]);
    if ((k > 0 && slot == seen[0]) || (k > 1 && slot == seen[1])) continue;
    for (uint32_t id : surface.facesAt(slot)) {
      const Face& face = surface.face(id);
      if ((k > 0 && face.has(seen[0])) || (k > 1 && face.has(seen[1]))) continue;
      float share[3];
      const StackedDots dots = stackedDots(nodes.posed.at(face.corner[0]), nodes.posed.at(face.corner[1]),
                                           nodes.posed.at(face.corner[2]), point_.data(), blocks_);
      const double distance = nearestShares(dots, share);
      if (!(distance < least)) continue;
      least = distance;
      match.face = id;
      std::copy_n(share, 3, match.share);
    }
  }
  return least < 1e300;
}

double Refit::accumulate(const Match& match, const NodeState& nodes, const Surface& surface) {
  const Face& face = surface.face(match.face);
  Residual residual;
  for (uint32_t k = 0; k < 3; ++k) {
    residual.corner[k] = nodes.posed.at(face.corner[k]);
    residual.share[k] = match.share[k];
  }
  residual.point = point_.data();
  residual.normal = normal_.data();
  residual.area = match.area;
  residual.hold = match.border ? 1.0f : kHold;
  for (uint32_t k = 0; k < 3; ++k)
    if (is_new_[face.corner[k]] && match.share[k] > 0.0f)
      addMatch(residual, match.share[k], blocks_, quadric_.data() + size_t{new_index_[face.corner[k]]} * blocks_);
  return energyOf(residual, blocks_);
}

// Fills the quadrics of the new slots; returns the energy of the surface as it is.
double Refit::matchAll(const NodeState& nodes, const Surface& surface) {
  static constexpr float kCentre[3] = {1.0f / 3.0f, 1.0f / 3.0f, 1.0f / 3.0f};
  static constexpr float kInner[3][3] = {{4.0f / 6.0f, 1.0f / 6.0f, 1.0f / 6.0f},
                                         {1.0f / 6.0f, 4.0f / 6.0f, 1.0f / 6.0f},
                                         {1.0f / 6.0f, 1.0f / 6.0f, 4.0f / 6.0f}};
  static constexpr float kMiddle[3] = {0.5f, 0.5f, 0.0f};
  std::fill(quadric_.begin(), quadric_.end(), Quadric{});
  double energy = 0.0;
  auto add = [&](const Sampled& from, const float* at, float area, bool border) {
    Match match{from, at, area, border, 0, {}};
    poseSample(match);
    if (findNearest(nodes, surface, match)) energy += accumulate(match, nodes, surface);
  };
  const size_t wanted = size_t{kMatchesPerTriangle} * std::max(1u, surface.triangleCount());
  const size_t stride = std::max<size_t>(1, faces_.size() / wanted);
  const bool fine = 3 * faces_.size() <= wanted;
  for (size_t i = 0; i < faces_.size(); i += stride) {
    if (fine)
      for (const float* at : kInner) add(faces_[i], at, faces_[i].area / 3.0f, false);
    else
      add(faces_[i], kCentre, faces_[i].area * static_cast<float>(stride), false);
  }
  for (const Sampled& border : borders_) add(border, kMiddle, border.area, true);
  return energy;
}

bool Refit::mayMove(uint32_t slot, const PosedPoint* to, const NodeState& nodes, const Surface& surface) const {
  const PosedPoint* from = nodes.posed.at(slot);
  float reach = 0.0f;
  uint32_t edges = 0;
  for (uint32_t id : surface.facesAt(slot)) {
    const Face& face = surface.face(id);
    if (countFlips(fanFace(face, slot, nodes.posed, weights_), to, blocks_) > 0) return false;
    for (uint32_t other : face.corner)
      if (other != slot) reach += squaredDistances(from, nodes.posed.at(other), blocks_), ++edges;
  }
  return edges > 0 && squaredDistances(from, to, blocks_) <= kReach * reach / static_cast<float>(edges);
}

bool Refit::step(uint32_t slot, NodeState& nodes, const Surface& surface) {
  const Made& made = made_[slot];
  const Segment segment(made.v, made.v + made.d, nodes.placement_shift, nodes.grid_bits);
  const PosedPoint* from = nodes.posed.at(slot);
  const Affine* blend = blendSkin(nodes.posed, nodes.skins[slot], blend_.data());
  const NormalEquations n =
      normalEquations(quadric_.data() + size_t{new_index_[slot]} * blocks_, blend, from, from, blocks_);
  glm::dvec3 move = solveNormalEquations(n, kStay);
  for (uint32_t trial = 0; trial < kTrials; ++trial, move *= 0.5) {
    const glm::ivec3 place = segment.snap(glm::dvec3(nodes.positions[slot]) + move, made.t8);
    if (place == nodes.positions[slot]) return false;
    transformPoint(blend, blocks_, glm::vec3(place), trial_.data());
    if (!mayMove(slot, trial_.data(), nodes, surface)) continue;
    nodes.positions[slot] = place;
    std::copy(trial_.begin(), trial_.end(), nodes.posed.at(slot));
    return true;
  }
  return false;
}

std::vector<glm::ivec3> Refit::places(const NodeState& nodes) const {
  std::vector<glm::ivec3> places;
  for (uint32_t slot : new_slots_) places.push_back(nodes.positions[slot]);
  return places;
}

void Refit::putBack(const std::vector<glm::ivec3>& places, NodeState& nodes) {
  for (size_t i = 0; i < places.size(); ++i) {
    const uint32_t slot = new_slots_[i];
    nodes.positions[slot] = places[i];
    transformPoint(blendSkin(nodes.posed, nodes.skins[slot], blend_.data()), blocks_, glm::vec3(places[i]),
                   nodes.posed.at(slot));
  }
}

void Refit::run(NodeState& nodes, const Surface& surface,
                const std::function<void(uint32_t, const PosedPoint*)>& moved) {
  std::erase_if(new_slots_, [&](uint32_t slot) { return !is_new_[slot]; });
  for (uint32_t i = 0; i < new_slots_.size(); ++i) new_index_[new_slots_[i]] = i;
  quadric_.resize(new_slots_.size() * blocks_);
  const std::vector<glm::ivec3> first = places(nodes);

  double energy = matchAll(nodes, surface);
  for (uint32_t pass = 0; pass < kPasses; ++pass) {
    const std::vector<glm::ivec3> before = places(nodes);
    for (uint32_t slot : new_slots_) step(slot, nodes, surface);
    const double next = matchAll(nodes, surface);
    if (!(next < energy)) {
      putBack(before, nodes);
      break;
    }
    energy = next;
  }

  for (size_t i = 0; i < first.size(); ++i) {
    const uint32_t slot = new_slots_[i];
    is_new_[slot] = 0;
    if (nodes.positions[slot] == first[i]) continue;
    transformPoint(blendSkin(nodes.posed, nodes.skins[slot], blend_.data()), blocks_, glm::vec3(first[i]),
                   trial_.data());
    moved(slot, trial_.data());
  }
  new_slots_.clear();
}

}  // namespace lithe::bake
