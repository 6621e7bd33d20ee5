// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "refit.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "kernel_templates.h"
#include "kernels.h"
#include "lithe/bake/parallel.h"
#include "normal_equations.h"
#include "weight_step.h"

namespace lithe::bake {

namespace {

constexpr uint32_t kPasses = 3;
constexpr uint32_t kMatchesPerTriangle = 16;  // more samples of the original say nothing new
constexpr uint32_t kFacesPerTriangle = 3;     // with fewer faces of the original, each is sampled three times
constexpr float kHold = 0.05f;                // of the distance itself, beside the distance to the tangent plane
constexpr double kStay = 1e-2;                // of the trace
constexpr float kReach = 0.25f;               // squared, of the mean squared length of the edges at a node
constexpr uint32_t kTrials = 3;

LITHE_KERNEL void blendCorners(const PosedPoint* a, const PosedPoint* b, const PosedPoint* c, const float* share,
                               uint32_t blocks, PosedPoint* point) {
  for (uint32_t i = 0; i < blocks; ++i) {
    point[i] = {a[i].x * share[0] + b[i].x * share[1] + c[i].x * share[2],
                a[i].y * share[0] + b[i].y * share[1] + c[i].y * share[2],
                a[i].z * share[0] + b[i].z * share[1] + c[i].z * share[2]};
  }
}

LITHE_KERNEL void unitNormals(const PosedPoint* a, const PosedPoint* b, const PosedPoint* c, uint32_t blocks,
                              PosedPoint* normal) {
  for (uint32_t i = 0; i < blocks; ++i) {
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
    : weights_(options),
      weight_gain_(options.weight_gain),
      threads_(options.threads),
      blocks_(nodes.posed.blocks),
      position_(nodes.posed.positions) {
  const auto count = static_cast<uint32_t>(nodes.positions.size());
  into_.resize(count);
  for (uint32_t slot = 0; slot < count; ++slot) into_[slot] = slot;
  made_.resize(count);
  is_new_.assign(count, 0);
  new_index_.resize(count);
  root_.resize(count);
  lengths_.resize(surface.faceCount());
  face_concerns_.resize(surface.faceCount());
  matched_.resize(blocks_);
  trial_.resize(blocks_);
  reweighted_.resize(blocks_);
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

// ---- Samples

void Refit::chooseSamples(const Surface& surface) {
  const size_t wanted = size_t{kMatchesPerTriangle} * std::max(1u, surface.triangleCount());
  stride_ = static_cast<uint32_t>(std::max<size_t>(1, faces_.size() / wanted));
  per_face_ = faces_.size() < size_t{kFacesPerTriangle} * surface.triangleCount() ? 3 : 1;
  nearest_.assign(sampleCount(), FacePoint{});
  energy_.assign(sampleCount(), 0.0f);
}

uint32_t Refit::sampleCount() const {
  const size_t sampled = (faces_.size() + stride_ - 1) / stride_;
  return static_cast<uint32_t>(sampled * per_face_ + borders_.size());
}

Refit::Sample Refit::sampleAt(uint32_t index) const {
  static constexpr float kCentre[3] = {1.0f / 3.0f, 1.0f / 3.0f, 1.0f / 3.0f};
  static constexpr float kInner[3][3] = {{4.0f / 6.0f, 1.0f / 6.0f, 1.0f / 6.0f},
                                         {1.0f / 6.0f, 4.0f / 6.0f, 1.0f / 6.0f},
                                         {1.0f / 6.0f, 1.0f / 6.0f, 4.0f / 6.0f}};
  static constexpr float kMiddle[3] = {0.5f, 0.5f, 0.0f};
  const auto on_faces = static_cast<uint32_t>(sampleCount() - borders_.size());
  if (index >= on_faces) {
    const Sampled& border = borders_[index - on_faces];
    return {border, kMiddle, border.area, true};
  }
  const Sampled& face = faces_[size_t{index / per_face_} * stride_];
  if (per_face_ == 3) return {face, kInner[index % 3], face.area / 3.0f, false};
  return {face, kCentre, face.area * static_cast<float>(stride_), false};
}

std::array<uint32_t, 3> Refit::slotsOf(const Sample& sample) const {
  const auto& [a, b, c] = sample.from.vertex;
  return {root_[a], root_[b], root_[c]};
}

void Refit::poseSample(const Sample& sample, std::vector<PosedPoint>& point) const {
  const auto& [a, b, c] = sample.from.vertex;
  blendCorners(originalAt(a), originalAt(b), originalAt(c), sample.at, blocks_, point.data());
}

// None for a point of a border.
void Refit::poseNormal(const Sample& sample, std::vector<PosedPoint>& normal) const {
  const auto& [a, b, c] = sample.from.vertex;
  if (sample.border)
    std::fill(normal.begin(), normal.end(), PosedPoint{});
  else
    unitNormals(originalAt(a), originalAt(b), originalAt(c), blocks_, normal.data());
}

// ---- Matching

void Refit::findRoots() {
  for (uint32_t vertex = 0; vertex < into_.size(); ++vertex) {
    uint32_t root = vertex;
    while (into_[root] != root) root = into_[root];
    root_[vertex] = root;
    for (uint32_t next = vertex; into_[next] != root;) {
      const uint32_t after = into_[next];
      into_[next] = root;
      next = after;
    }
  }
}

void Refit::measureEdges(const NodeState& nodes, const Surface& surface) {
  inParallel(surface.faceCount(), threads_, [&](uint32_t begin, uint32_t end) {
    for (uint32_t id = begin; id < end; ++id) {
      const Face& face = surface.face(id);
      const auto& [a, b, c] = face.corner;
      if (face.alive() && (has_changed_[a] || has_changed_[b] || has_changed_[c]))
        lengths_[id] = edgeLengths(face, nodes.posed);
    }
  });
}

void Refit::noteChange(uint32_t slot, const Surface& surface) {
  for (uint32_t id : surface.facesAt(slot))
    for (uint32_t corner : surface.face(id).corner) has_changed_[corner] = 1;
}

// Samples whose faces are what they were keep what was found. Afterwards matches_changed_ tells which slots have other
// matches than before, or the same with another energy.
void Refit::findNearest(const NodeState& nodes, const Surface& surface) {
  measureEdges(nodes, surface);
  matches_changed_ = has_changed_;
  std::mutex mutex;
  inParallel(sampleCount(), threads_, [&](uint32_t begin, uint32_t end) {
    FaceSearch search(nodes, surface, lengths_);
    std::vector<PosedPoint> point(blocks_);
    std::vector<uint32_t> left, entered;  // faces
    for (uint32_t i = begin; i < end; ++i) {
      const Sample sample = sampleAt(i);
      const std::array<uint32_t, 3> slots = slotsOf(sample);
      if (!(has_changed_[slots[0]] || has_changed_[slots[1]] || has_changed_[slots[2]])) continue;
      poseSample(sample, point);
      const FacePoint found = search.nearest(point.data(), slots);
      if (found == nearest_[i]) continue;
      left.push_back(nearest_[i].face);
      entered.push_back(found.face);
      nearest_[i] = found;
    }
    const std::lock_guard<std::mutex> lock(mutex);
    for (const std::vector<uint32_t>* faces : {&left, &entered})
      for (uint32_t id : *faces)
        for (uint32_t k = 0; k < 3 && id != kNone; ++k) matches_changed_[surface.face(id).corner[k]] = 1;
  });
}

// One byte per face is at hand for every sample; the corners' are all over the memory.
void Refit::noteFaces(const Surface& surface) {
  inParallel(surface.faceCount(), threads_, [&](uint32_t begin, uint32_t end) {
    for (uint32_t id = begin; id < end; ++id) {
      const auto& [a, b, c] = surface.face(id).corner;
      face_concerns_[id] = matches_changed_[a] || matches_changed_[b] || matches_changed_[c];
    }
  });
}

// Brings the quadrics of the new slots up to date; returns the energy of the surface as it is.
double Refit::accumulateAll(const NodeState& nodes, const Surface& surface) {
  noteFaces(surface);
  inParallel(static_cast<uint32_t>(into_.size()), threads_, [&](uint32_t begin, uint32_t end) {
    for (uint32_t slot = begin; slot < end; ++slot) {
      if (is_new_[slot] && matches_changed_[slot]) std::fill_n(quadricAt(slot), blocks_, Quadric{});
    }
    accumulateAt(begin, end, nodes, surface);
  });
  double energy = 0.0;
  for (float of_one : energy_) energy += of_one;
  return energy;
}

// Every slot gets its matches in the order of the samples, whichever thread it belongs to; the energy of a match is
// noted with its face's first corner.
void Refit::accumulateAt(uint32_t first_slot, uint32_t end_slot, const NodeState& nodes, const Surface& surface) {
  const auto concerns = [&](uint32_t slot) { return slot >= first_slot && slot < end_slot && matches_changed_[slot]; };
  std::vector<PosedPoint> point(blocks_), normal(blocks_);
  const Sampled* normal_of = nullptr;
  for (uint32_t i = 0; i < nearest_.size(); ++i) {
    if (nearest_[i].face == kNone || !face_concerns_[nearest_[i].face]) continue;
    const auto& corner = surface.face(nearest_[i].face).corner;
    if (std::none_of(corner.begin(), corner.end(), concerns)) continue;

    const Sample sample = sampleAt(i);
    poseSample(sample, point);
    if (normal_of != &sample.from) poseNormal(sample, normal);
    normal_of = &sample.from;
    Residual residual;
    for (uint32_t k = 0; k < 3; ++k) {
      residual.corner[k] = nodes.posed.at(corner[k]);
      residual.share[k] = nearest_[i].share[k];
    }
    residual.point = point.data();
    residual.normal = normal.data();
    residual.area = sample.area;
    residual.hold = sample.border ? 1.0f : kHold;
    for (uint32_t k = 0; k < 3; ++k) {
      if (residual.share[k] > 0.0f && is_new_[corner[k]] && concerns(corner[k]))
        addMatch(residual, residual.share[k], blocks_, quadricAt(corner[k]));
    }
    if (concerns(corner[0])) energy_[i] = energyOf(residual, blocks_);
  }
}

double Refit::match(const NodeState& nodes, const Surface& surface) {
  findNearest(nodes, surface);
  return accumulateAll(nodes, surface);
}

// ---- Moving

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

// To where the quadric is least for this blend, on the grid.
glm::dvec3 Refit::bestMove(uint32_t slot, const Affine* blend, const PosedPoint* from) const {
  return solveNormalEquations(normalEquations(quadricAt(slot), blend, matched_.data(), from, blocks_), kStay);
}

// The place that the file can hold.
glm::ivec3 Refit::placeAfter(uint32_t slot, const glm::dvec3& move, const NodeState& nodes) const {
  const Made& made = made_[slot];
  const Segment segment(made.v, made.v + made.d, nodes.placement_shift, nodes.grid_bits);
  return segment.snap(glm::dvec3(nodes.positions[slot]) + move, made.t8);
}

bool Refit::stepPosition(uint32_t slot, NodeState& nodes, const Surface& surface) {
  const Affine* blend = blendSkin(nodes.posed, nodes.skins[slot], blend_.data());
  glm::dvec3 move = bestMove(slot, blend, nodes.posed.at(slot));
  for (uint32_t trial = 0; trial < kTrials; ++trial, move *= 0.5) {
    const glm::ivec3 place = placeAfter(slot, move, nodes);
    if (place == nodes.positions[slot]) return false;
    transformPoint(blend, blocks_, glm::vec3(place), trial_.data());
    if (!mayMove(slot, trial_.data(), nodes, surface)) continue;
    nodes.positions[slot] = place;
    std::copy(trial_.begin(), trial_.end(), nodes.posed.at(slot));
    return true;
  }
  return false;
}

// The weights that are best where the node is, and the place that is best with these weights.
bool Refit::stepWeights(uint32_t slot, NodeState& nodes, const Surface& surface) {
  const QuantizedSkin& skin = nodes.skins[slot];
  if (skin.count < 2) return false;
  const QuantizedSkin reweighted =
      weightStep(nodes, quadricAt(slot), matched_.data(), jointsOf(skin), skin, nodes.positions[slot], candidates_);
  if (reweighted == skin) return false;

  const Affine* blend = blendSkin(nodes.posed, reweighted, blend_.data());
  const auto energyAt = [&](const glm::ivec3& place, std::vector<PosedPoint>& result) {
    return energyOfPlace(quadricAt(slot), matched_.data(), blend, glm::vec3(place), blocks_, result.data());
  };
  glm::ivec3 place = nodes.positions[slot];
  double cost = energyAt(place, reweighted_);
  const glm::ivec3 moved = placeAfter(slot, bestMove(slot, blend, reweighted_.data()), nodes);
  const double cost_moved = energyAt(moved, trial_);
  if (cost_moved < cost) {
    place = moved;
    cost = cost_moved;
    reweighted_.swap(trial_);
  }
  const double before = energy(quadricAt(slot), matched_.data(), nodes.posed.at(slot), blocks_);
  if (!(cost < before * (1.0 - weight_gain_)) || !mayMove(slot, reweighted_.data(), nodes, surface)) return false;
  nodes.positions[slot] = place;
  nodes.skins[slot] = reweighted;
  std::copy(reweighted_.begin(), reweighted_.end(), nodes.posed.at(slot));
  return true;
}

bool Refit::step(uint32_t slot, NodeState& nodes, const Surface& surface) {
  std::copy_n(nodes.posed.at(slot), blocks_, matched_.begin());
  const bool moved = stepPosition(slot, nodes, surface);
  return stepWeights(slot, nodes, surface) || moved;
}

// A slot that stayed where it is will stay again until its matches or its faces change.
bool Refit::stepAll(NodeState& nodes, const Surface& surface) {
  bool any = false;
  std::fill(has_changed_.begin(), has_changed_.end(), uint8_t{0});
  for (uint32_t slot : new_slots_) {
    if (!(matches_changed_[slot] || has_changed_[slot]) || !step(slot, nodes, surface)) continue;
    noteChange(slot, surface);
    any = true;
  }
  return any;
}

std::vector<Refit::Place> Refit::places(const NodeState& nodes) const {
  std::vector<Place> places;
  for (uint32_t slot : new_slots_) places.push_back({nodes.positions[slot], nodes.skins[slot]});
  return places;
}

const PosedPoint* Refit::pose(const Place& place, const NodeState& nodes) {
  transformPoint(blendSkin(nodes.posed, place.skin, blend_.data()), blocks_, glm::vec3(place.position), trial_.data());
  return trial_.data();
}

void Refit::putBack(const std::vector<Place>& places, NodeState& nodes) {
  for (size_t i = 0; i < places.size(); ++i) {
    const uint32_t slot = new_slots_[i];
    nodes.positions[slot] = places[i].position;
    nodes.skins[slot] = places[i].skin;
    std::copy_n(pose(places[i], nodes), blocks_, nodes.posed.at(slot));
  }
}

void Refit::run(NodeState& nodes, const Surface& surface,
                const std::function<void(uint32_t, const PosedPoint*)>& moved) {
  std::erase_if(new_slots_, [&](uint32_t slot) { return !is_new_[slot]; });
  for (uint32_t i = 0; i < new_slots_.size(); ++i) new_index_[new_slots_[i]] = i;
  quadric_.resize(new_slots_.size() * blocks_);
  const std::vector<Place> first = places(nodes);

  chooseSamples(surface);
  findRoots();
  has_changed_.assign(into_.size(), 1);
  measureEdges(nodes, surface);
  has_changed_.assign(into_.size(), 0);
  for (uint32_t slot : new_slots_) noteChange(slot, surface);
  double energy = match(nodes, surface);
  for (uint32_t pass = 0; pass < kPasses; ++pass) {
    const std::vector<Place> before = places(nodes);
    if (!stepAll(nodes, surface)) break;
    const double next = match(nodes, surface);
    if (!(next < energy)) {
      putBack(before, nodes);
      break;
    }
    energy = next;
  }

  for (size_t i = 0; i < first.size(); ++i) {
    const uint32_t slot = new_slots_[i];
    is_new_[slot] = 0;
    if (Place{nodes.positions[slot], nodes.skins[slot]} != first[i]) moved(slot, pose(first[i], nodes));
  }
  new_slots_.clear();
}

}  // namespace lithe::bake
