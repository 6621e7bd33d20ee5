// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "components.h"

#include <algorithm>
#include <numeric>

namespace lithe::bake {

namespace {

constexpr uint32_t kSampledFaces = 300;
constexpr uint32_t kLeafFaces = 8;

uint32_t rootOf(std::vector<uint32_t>& parent, uint32_t slot) {
  while (parent[slot] != slot) slot = parent[slot] = parent[parent[slot]];
  return slot;
}

/// Per slot the number of its component, by lowest slot.
std::vector<uint32_t> labelComponents(const Surface& surface, uint32_t slot_count, uint32_t& component_count) {
  std::vector<uint32_t> parent(slot_count);
  std::iota(parent.begin(), parent.end(), 0u);
  for (uint32_t id = 0; id < surface.faceCount(); ++id) {
    const Face& f = surface.face(id);
    for (uint32_t k = 1; k < 3; ++k) {
      const uint32_t a = rootOf(parent, f.corner[0]), b = rootOf(parent, f.corner[k]);
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  std::vector<uint32_t> label(slot_count);
  component_count = 0;
  for (uint32_t slot = 0; slot < slot_count; ++slot) {
    const uint32_t root = rootOf(parent, slot);
    label[slot] = root == slot ? component_count++ : label[root];
  }
  return label;
}

double squaredDistanceToBox(const glm::vec3& point, const glm::vec3& lower, const glm::vec3& upper) {
  const glm::dvec3 outside(glm::max(glm::max(lower - point, point - upper), glm::vec3(0.0f)));
  return glm::dot(outside, outside);
}

double squaredDistanceToSegment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 edge = b - a;
  const double length2 = glm::dot(edge, edge);
  const double t = length2 > 0.0 ? std::clamp(glm::dot(p - a, edge) / length2, 0.0, 1.0) : 0.0;
  const glm::dvec3 offset = p - a - t * edge;
  return glm::dot(offset, offset);
}

/// To the plane where the foot point lies inside, else to the nearest side.
double squaredDistanceToTriangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 n = glm::cross(b - a, c - a);
  const bool inside = glm::dot(glm::cross(b - a, p - a), n) >= 0.0 && glm::dot(glm::cross(c - b, p - b), n) >= 0.0 &&
                      glm::dot(glm::cross(a - c, p - c), n) >= 0.0;
  const double n2 = glm::dot(n, n);
  if (inside && n2 > 0.0) {
    const double height = glm::dot(p - a, n);
    return height * height / n2;
  }
  return std::min(
      {squaredDistanceToSegment(p, a, b), squaredDistanceToSegment(p, b, c), squaredDistanceToSegment(p, c, a)});
}

glm::vec3 firstPose(const PosedMesh& posed, uint32_t slot) {
  const PosedPoint& p = posed.at(slot)[0];
  return {p.x[0], p.y[0], p.z[0]};
}

}  // namespace

Components::Components(const Surface& surface, const PosedMesh& posed) : pose_count_(posed.pose_count) {
  const auto slot_count = static_cast<uint32_t>(posed.positions.size() / posed.blocks);
  uint32_t count = 0;
  component_ = labelComponents(surface, slot_count, count);
  loss_.assign(count, -1.0);
  position_.resize(slot_count);
  for (uint32_t slot = 0; slot < slot_count; ++slot) position_[slot] = firstPose(posed, slot);
  corner_.resize(surface.faceCount());
  for (uint32_t id = 0; id < surface.faceCount(); ++id) corner_[id] = surface.face(id).corner;
}

Components::Triangle Components::triangle(uint32_t face) const {
  const auto& [a, b, c] = corner_[face];
  return {position_[a], position_[b], position_[c]};
}

void Components::sortByComponent() {
  first_.assign(loss_.size() + 1, 0);
  for (uint32_t face = 0; face < corner_.size(); ++face) ++first_[componentOf(face) + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  members_.resize(corner_.size());
  std::vector<uint32_t> next(first_.begin(), first_.end() - 1);
  for (uint32_t face = 0; face < corner_.size(); ++face) members_[next[componentOf(face)]++] = face;
}

void Components::startTree() {
  thrice_centre_.resize(corner_.size());
  for (uint32_t face = 0; face < corner_.size(); ++face) {
    const Triangle t = triangle(face);
    thrice_centre_[face] = t.a + t.b + t.c;
  }
  sorted_.resize(corner_.size());
  std::iota(sorted_.begin(), sorted_.end(), 0u);
  addBox(0, static_cast<uint32_t>(sorted_.size()));
}

uint32_t Components::addBox(uint32_t begin, uint32_t end) {
  const glm::vec3 start = triangle(sorted_[begin]).a;
  Box box{start, start, begin, end, kNone, kNone, componentOf(sorted_[begin])};
  for (uint32_t i = begin; i < end; ++i) {
    const Triangle t = triangle(sorted_[i]);
    box.lower = glm::min(box.lower, glm::min(t.a, glm::min(t.b, t.c)));
    box.upper = glm::max(box.upper, glm::max(t.a, glm::max(t.b, t.c)));
    if (componentOf(sorted_[i]) != box.only_component) box.only_component = kNone;
  }
  boxes_.push_back(box);
  return static_cast<uint32_t>(boxes_.size()) - 1;
}

/// False for a leaf.
bool Components::split(uint32_t id) {
  const Box box = boxes_[id];
  if (box.left != kNone) return true;
  if (box.end - box.begin <= kLeafFaces) return false;
  const glm::vec3 extent = box.upper - box.lower;
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  const uint32_t middle = (box.begin + box.end) / 2;
  std::nth_element(sorted_.begin() + box.begin, sorted_.begin() + middle, sorted_.begin() + box.end,
                   [&](uint32_t s, uint32_t t) {
                     const float at_s = thrice_centre_[s][axis], at_t = thrice_centre_[t][axis];
                     return at_s != at_t ? at_s < at_t : s < t;
                   });
  const uint32_t left = addBox(box.begin, middle), right = addBox(middle, box.end);
  boxes_[id].left = left;
  boxes_[id].right = right;
  return true;
}

double Components::squaredDistanceToOthers(const glm::vec3& point, uint32_t component) {
  double nearest = 1.0;  // the posed diagonal, squared
  if (boxes_.empty()) return nearest;
  std::vector<uint32_t> stack{0};
  while (!stack.empty()) {
    const uint32_t id = stack.back();
    const Box box = boxes_[id];
    stack.pop_back();
    if (box.only_component == component || squaredDistanceToBox(point, box.lower, box.upper) >= nearest) continue;
    if (!split(id)) {
      for (uint32_t i = box.begin; i < box.end; ++i) {
        if (componentOf(sorted_[i]) == component) continue;
        const Triangle t = triangle(sorted_[i]);
        nearest = std::min(nearest, squaredDistanceToTriangle(point, t.a, t.b, t.c));
      }
      continue;
    }
    const uint32_t left = boxes_[id].left, right = boxes_[id].right;
    const bool left_first = squaredDistanceToBox(point, boxes_[left].lower, boxes_[left].upper) <=
                            squaredDistanceToBox(point, boxes_[right].lower, boxes_[right].upper);
    stack.push_back(left_first ? right : left);
    stack.push_back(left_first ? left : right);
  }
  return nearest;
}

double Components::lossOf(uint32_t slot) {
  const uint32_t component = component_[slot];
  if (loss_[component] >= 0.0) return loss_[component];
  if (first_.empty()) {
    sortByComponent();
    if (loss_.size() > 1) startTree();
  }
  const uint32_t count = first_[component + 1] - first_[component];
  const uint32_t stride = (count + kSampledFaces - 1) / kSampledFaces;
  double weighted = 0.0, sampled_area = 0.0, area = 0.0;
  for (uint32_t i = 0; i < count; ++i) {
    const Triangle t = triangle(members_[first_[component] + i]);
    const double face_area = 0.5 * glm::length(glm::cross(glm::dvec3(t.b - t.a), glm::dvec3(t.c - t.a)));
    area += face_area;
    if (i % stride != 0) continue;
    sampled_area += face_area;
    weighted += face_area * squaredDistanceToOthers((t.a + t.b + t.c) / 3.0f, component);
  }
  const double mean = sampled_area > 0.0 ? weighted / sampled_area : 0.0;
  return loss_[component] = pose_count_ * area * mean;
}

}  // namespace lithe::bake
