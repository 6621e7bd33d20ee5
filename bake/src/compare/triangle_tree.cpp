// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "closest_point.h"
#include "lithe/bake/nearest.h"

namespace lithe::bake {

namespace {

constexpr uint32_t kLeafSize = 4;
constexpr uint32_t kBins = 16;
constexpr uint32_t kMaxBinnedDepth = 40;  // below it halves: with 2^32 triangles no path is longer than kStackSize
constexpr uint32_t kStackSize = 80;

struct Box {
  glm::dvec3 low{std::numeric_limits<double>::infinity()};
  glm::dvec3 high{-std::numeric_limits<double>::infinity()};

  void add(const glm::dvec3& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  void add(const Box& box) {
    low = glm::min(low, box.low);
    high = glm::max(high, box.high);
  }
  double area() const {
    const glm::dvec3 size = high - low;
    return size.x >= 0.0 ? size.x * size.y + size.y * size.z + size.z * size.x : 0.0;
  }
};

double distance2ToBox(const glm::dvec3& query, const glm::dvec3& low, const glm::dvec3& high) {
  const glm::dvec3 outside = glm::max(glm::max(low - query, query - high), glm::dvec3(0.0));
  return glm::dot(outside, outside);
}

/// Where to cut a range of triangles: those whose centre falls into bins [0, bin] of `axis` go left.
struct Cut {
  int axis = -1;  ///< -1: the centres coincide
  uint32_t bin = 0;
  double cost = std::numeric_limits<double>::infinity();
};

struct Bin {
  Box box;
  uint32_t count = 0;
};

/// The best of the cuts between bins, by the surface area heuristic.
Cut cheapestCut(const std::array<Bin, kBins>& bins, int axis) {
  std::array<double, kBins> right_cost{};
  Bin right;
  for (uint32_t i = kBins; i-- > 1;) {
    right.box.add(bins[i].box);
    right.count += bins[i].count;
    right_cost[i] = right.box.area() * right.count;
  }
  Cut best;
  Bin left;
  for (uint32_t i = 0; i + 1 < kBins; ++i) {
    left.box.add(bins[i].box);
    left.count += bins[i].count;
    const double cost = left.box.area() * left.count + right_cost[i + 1];
    if (cost < best.cost) best = {axis, i, cost};
  }
  return best;
}

}  // namespace

/// Builds a tree's nodes top down over a permutation of the triangles.
class TreeBuilder {
 public:
  TreeBuilder(TriangleTree& tree, std::span<const glm::dvec3> positions, std::span<const Triangle> triangles)
      : tree_(tree) {
    boxes_.reserve(triangles.size());
    for (const Triangle& triangle : triangles) {
      Box box;
      for (const uint32_t corner : triangle) box.add(positions[corner]);
      boxes_.push_back(box);
    }
    tree_.order_.resize(triangles.size());
    std::iota(tree_.order_.begin(), tree_.order_.end(), 0u);
  }

  void build() {
    tree_.nodes_.reserve(boxes_.size());
    tree_.nodes_.emplace_back();
    std::vector<Work> open{{0, 0, static_cast<uint32_t>(boxes_.size()), 0}};
    while (!open.empty()) {
      const Work work = open.back();
      open.pop_back();
      const uint32_t middle = fillNode(work);
      if (middle == kNone) continue;
      const uint32_t children = static_cast<uint32_t>(tree_.nodes_.size());
      tree_.nodes_[work.node].first = children;
      tree_.nodes_.resize(children + 2);
      open.push_back({children, work.begin, middle, work.depth + 1});
      open.push_back({children + 1, middle, work.end, work.depth + 1});
    }
  }

 private:
  struct Work {
    uint32_t node, begin, end, depth;
  };

  glm::dvec3 centre(uint32_t triangle) const { return 0.5 * (boxes_[triangle].low + boxes_[triangle].high); }

  /// Sets the node's box; makes it a leaf (returns kNone) or returns where its range is divided.
  uint32_t fillNode(const Work& work) {
    Box box, centres;
    for (uint32_t i = work.begin; i < work.end; ++i) {
      box.add(boxes_[tree_.order_[i]]);
      centres.add(centre(tree_.order_[i]));
    }
    TriangleTree::Node& node = tree_.nodes_[work.node];
    node.low = box.low;
    node.high = box.high;
    if (work.end - work.begin <= kLeafSize) {
      node.first = work.begin;
      node.count = work.end - work.begin;
      return kNone;
    }
    return work.depth < kMaxBinnedDepth ? divideByArea(work, centres) : divideInHalves(work, centres);
  }

  uint32_t divideByArea(const Work& work, const Box& centres) {
    Cut best;
    for (int axis = 0; axis < 3; ++axis) {
      if (!(centres.high[axis] > centres.low[axis])) continue;
      std::array<Bin, kBins> bins{};
      for (uint32_t i = work.begin; i < work.end; ++i) {
        Bin& bin = bins[binOf(tree_.order_[i], centres, axis)];
        bin.box.add(boxes_[tree_.order_[i]]);
        ++bin.count;
      }
      const Cut cut = cheapestCut(bins, axis);
      if (cut.cost < best.cost) best = cut;
    }
    if (best.axis < 0) return divideInHalves(work, centres);
    const auto begin = tree_.order_.begin();
    const auto middle = std::stable_partition(begin + work.begin, begin + work.end, [&](uint32_t triangle) {
      return binOf(triangle, centres, best.axis) <= best.bin;
    });
    const uint32_t position = static_cast<uint32_t>(middle - begin);
    return position == work.begin || position == work.end ? divideInHalves(work, centres) : position;
  }

  uint32_t binOf(uint32_t triangle, const Box& centres, int axis) const {
    const double along = (centre(triangle)[axis] - centres.low[axis]) / (centres.high[axis] - centres.low[axis]);
    return std::min(static_cast<uint32_t>(along * kBins), kBins - 1);
  }

  uint32_t divideInHalves(const Work& work, const Box& centres) {
    const glm::dvec3 size = centres.high - centres.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const uint32_t middle = work.begin + (work.end - work.begin) / 2;
    const auto begin = tree_.order_.begin();
    std::nth_element(begin + work.begin, begin + middle, begin + work.end, [&](uint32_t a, uint32_t b) {
      return std::pair(centre(a)[axis], a) < std::pair(centre(b)[axis], b);
    });
    return middle;
  }

  TriangleTree& tree_;
  std::vector<Box> boxes_;
};

TriangleTree::TriangleTree(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles) {
  TreeBuilder(*this, positions, triangles).build();
  corners_.reserve(triangles.size());
  entry_of_.resize(triangles.size());
  for (const uint32_t triangle : order_) {
    const Triangle& t = triangles[triangle];
    entry_of_[triangle] = static_cast<uint32_t>(corners_.size());
    corners_.push_back({positions[t[0]], positions[t[1]], positions[t[2]]});
  }
}

void TriangleTree::move(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles) {
  for (size_t entry = 0; entry < order_.size(); ++entry) {
    const Triangle& t = triangles[order_[entry]];
    corners_[entry] = {positions[t[0]], positions[t[1]], positions[t[2]]};
  }
  // Children come behind their parent.
  for (size_t i = nodes_.size(); i-- > 0;) {
    Node& node = nodes_[i];
    Box box;
    for (uint32_t entry = node.first; entry < node.first + node.count; ++entry)
      for (const glm::dvec3& corner : {corners_[entry].a, corners_[entry].b, corners_[entry].c}) box.add(corner);
    if (node.count == 0)
      for (uint32_t child = node.first; child < node.first + 2; ++child)
        box.add(Box{nodes_[child].low, nodes_[child].high});
    node.low = box.low;
    node.high = box.high;
  }
}

/// Calls visit(leaf entry) for the triangles of every leaf whose box is within bound2, nearer boxes first; visit may
/// lower bound2.
template <typename Visit>
void TriangleTree::traverse(const glm::dvec3& query, const double& bound2, Visit&& visit) const {
  struct Open {
    uint32_t node;
    double distance2;
  };
  std::array<Open, kStackSize> open;
  uint32_t depth = 0;
  open[depth++] = {0, distance2ToBox(query, nodes_[0].low, nodes_[0].high)};
  while (depth > 0) {
    const Open top = open[--depth];
    if (top.distance2 > bound2) continue;
    const Node& node = nodes_[top.node];
    for (uint32_t i = 0; i < node.count; ++i) visit(node.first + i);
    if (node.count > 0) continue;
    Open near{node.first, distance2ToBox(query, nodes_[node.first].low, nodes_[node.first].high)};
    Open far{node.first + 1, distance2ToBox(query, nodes_[node.first + 1].low, nodes_[node.first + 1].high)};
    if (far.distance2 < near.distance2) std::swap(near, far);
    if (far.distance2 <= bound2) open[depth++] = far;
    if (near.distance2 <= bound2) open[depth++] = near;
  }
}

NearestPoint TriangleTree::nearest(const glm::dvec3& query, uint32_t hint) const {
  NearestPoint best;
  best.distance2 = std::numeric_limits<double>::infinity();
  const auto consider = [&](uint32_t entry) {
    const Corners& t = corners_[entry];
    const ClosestPoint point = closestPoint(query, t.a, t.b, t.c);
    const bool nearer = point.distance2 < best.distance2;
    if (nearer || (point.distance2 == best.distance2 && order_[entry] < best.triangle)) {
      best = {order_[entry], point.distance2, point.barycentric};
    }
  };
  if (hint != kNone) consider(entry_of_[hint]);
  traverse(query, best.distance2, consider);
  return best;
}

void TriangleTree::nearestWithin(const glm::dvec3& query, double slack, std::vector<NearestPoint>& found,
                                 uint32_t hint) const {
  found.clear();
  double nearest2 = std::numeric_limits<double>::infinity();
  double bound2 = nearest2;
  const auto lowerBound = [&](double distance2) {
    if (distance2 >= nearest2) return;
    nearest2 = distance2;
    const double bound = std::sqrt(distance2) + slack;
    bound2 = bound * bound;
  };
  if (hint != kNone) lowerBound(distance2(query, hint));
  traverse(query, bound2, [&](uint32_t entry) {
    const Corners& t = corners_[entry];
    const ClosestPoint point = closestPoint(query, t.a, t.b, t.c);
    lowerBound(point.distance2);
    if (point.distance2 <= bound2) found.push_back({order_[entry], point.distance2, point.barycentric});
  });
  std::erase_if(found, [&](const NearestPoint& point) { return point.distance2 > bound2; });
  std::sort(found.begin(), found.end(), [](const NearestPoint& a, const NearestPoint& b) {
    return std::pair(a.distance2, a.triangle) < std::pair(b.distance2, b.triangle);
  });
}

double TriangleTree::distance2(const glm::dvec3& query, uint32_t triangle) const {
  const Corners& t = corners_[entry_of_[triangle]];
  return closestPoint(query, t.a, t.b, t.c).distance2;
}

}  // namespace lithe::bake
