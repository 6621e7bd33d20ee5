// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "absorb.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace lithe::bake {

namespace {

struct Host {
  uint32_t part;
  int32_t x;
  uint32_t slot;

  auto key() const { return std::tie(part, x, slot); }
  bool operator==(const Host& other) const { return key() == other.key(); }
  bool operator<(const Host& other) const { return key() < other.key(); }
};

/// Every slot with triangles, once per part that they are of; by part, then x.
std::vector<Host> listHosts(const Mesh& mesh, const NodeState& nodes, const Surface& surface) {
  std::vector<Host> hosts;
  for (uint32_t slot = 0; slot < nodes.positions.size(); ++slot) {
    for (uint32_t id : surface.facesAt(slot))
      hosts.push_back({mesh.wedge_part[surface.face(id).wedge[0]], nodes.positions[slot].x, slot});
  }
  std::sort(hosts.begin(), hosts.end());
  hosts.erase(std::unique(hosts.begin(), hosts.end()), hosts.end());
  return hosts;
}

/// The nearest host, and how near it is; kept over several searches.
class Nearest {
 public:
  Nearest(const NodeState& nodes, const glm::ivec3& point) : nodes_(nodes), point_(point) {}

  /// Goes both ways from the point's x until that alone is too far.
  void search(std::vector<Host>::const_iterator begin, std::vector<Host>::const_iterator end) {
    const auto middle = std::lower_bound(begin, end, point_.x, [](const Host& host, int32_t x) { return host.x < x; });
    for (auto it = middle; it != end && squaredX(*it) <= distance_; ++it) consider(it->slot);
    for (auto it = middle; it != begin && squaredX(*(it - 1)) <= distance_; --it) consider((it - 1)->slot);
  }

  uint32_t slot() const { return slot_; }

 private:
  int64_t squaredX(const Host& host) const { return int64_t{host.x - point_.x} * (host.x - point_.x); }

  void consider(uint32_t slot) {
    int64_t distance = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const int64_t d = nodes_.positions[slot][axis] - point_[axis];
      distance += d * d;
    }
    if (std::tie(distance, slot) < std::tie(distance_, slot_)) {
      distance_ = distance;
      slot_ = slot;
    }
  }

  const NodeState& nodes_;
  const glm::ivec3 point_;
  int64_t distance_ = std::numeric_limits<int64_t>::max();
  uint32_t slot_ = kNone;
};

std::vector<uint32_t> firstPartOfSlots(const Mesh& mesh) {
  std::vector<uint32_t> part(mesh.vertexCount(), kNone);
  for (uint32_t wedge = 0; wedge < mesh.wedgeCount(); ++wedge) {
    uint32_t& first = part[mesh.wedge_vertex[wedge]];
    if (first == kNone) first = mesh.wedge_part[wedge];
  }
  return part;
}

}  // namespace

std::vector<uint32_t> nearestHosts(const std::vector<uint32_t>& faceless, const Mesh& mesh, const NodeState& nodes,
                                   const Surface& surface) {
  const std::vector<Host> hosts = listHosts(mesh, nodes, surface);
  const std::vector<uint32_t> part_of_slot = firstPartOfSlots(mesh);
  const auto byPart = [](const Host& a, const Host& b) { return a.part < b.part; };
  std::vector<uint32_t> found;
  for (uint32_t slot : faceless) {
    Nearest nearest(nodes, nodes.positions[slot]);
    const auto [begin, end] = std::equal_range(hosts.begin(), hosts.end(), Host{part_of_slot[slot], 0, 0}, byPart);
    nearest.search(begin, end);
    // Without its own part every other one will do: its wedges stay apart, the node does not.
    for (auto first = hosts.begin(); begin == end && first != hosts.end();) {
      const auto last = std::upper_bound(first, hosts.end(), *first, byPart);
      nearest.search(first, last);
      first = last;
    }
    found.push_back(nearest.slot());
  }
  return found;
}

}  // namespace lithe::bake
