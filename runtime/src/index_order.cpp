// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Triangles in an order that a vertex cache likes: Sander, Nehab and Barczak, "Fast Triangle Reordering for Vertex
/// Locality and Reduced Overdraw" (2007), section 3.
#include <string.h>

#include "arguments.h"

namespace lithe::runtime {
namespace {

constexpr uint32_t kCacheSize = 16;   // vertices of a FIFO; caches are as large or behave as if they were
constexpr uint32_t kRemembered = 64;  // vertices to go back to where the walk has come to an end
constexpr uint32_t kMostIndices = 0xffffffffu - 2 * kCacheSize;  // of the clock
constexpr uint32_t kNone = 0xffffffffu;

/// The host's scratch in pieces.
struct Arrays {
  uint32_t* corner;     ///< the indices as they were
  uint32_t* first;      ///< per vertex and one: its triangles in `around`
  uint32_t* around;     ///< one per index
  uint32_t* left;       ///< per vertex: triangles of the range that are not written
  uint32_t* entered;    ///< per vertex: when it entered the cache last
  uint8_t* is_written;  ///< per triangle

  Arrays(void* scratch, size_t index_count, size_t vertex_count) {
    corner = static_cast<uint32_t*>(scratch);
    first = corner + index_count;
    around = first + vertex_count + 1;
    left = around + index_count;
    entered = left + vertex_count;
    is_written = reinterpret_cast<uint8_t*>(entered + vertex_count);
  }

  static uint64_t bytes(uint64_t index_count, uint64_t vertex_count) {
    return (2 * index_count + 3 * vertex_count + 1) * sizeof(uint32_t) + index_count / 3;
  }
};

/// The vertices that the walk has passed last, to go on from where they have triangles left.
struct Trail {
  uint32_t vertex[kRemembered];
  uint32_t count = 0, at = 0;

  void push(uint32_t v) {
    vertex[at] = v;
    at = (at + 1) % kRemembered;
    if (count < kRemembered) ++count;
  }
  uint32_t pop() {
    if (count == 0) return kNone;
    --count;
    at = (at + kRemembered - 1) % kRemembered;
    return vertex[at];
  }
};

void listTriangles(size_t index_count, size_t vertex_count, const Arrays& a) {
  memset(a.first, 0, (vertex_count + 1) * sizeof(uint32_t));
  for (size_t i = 0; i < index_count; ++i) ++a.first[a.corner[i]];
  uint32_t end = 0;
  for (size_t v = 0; v < vertex_count; ++v) a.first[v] = end += a.first[v];
  a.first[vertex_count] = end;
  for (size_t i = index_count; i-- > 0;) a.around[--a.first[a.corner[i]]] = static_cast<uint32_t>(i / 3);
}

template <typename Index>
class Walk {
 public:
  Walk(const Arrays& arrays, Index* out) : a_(arrays), out_(out) {}

  /// Writes the triangles [begin, end) to their places.
  void run(uint32_t begin, uint32_t end) {
    begin_ = begin;
    end_ = end;
    next_ = 3 * size_t{begin};
    trail_ = {};
    for (size_t i = 3 * size_t{begin}; i < 3 * size_t{end}; ++i) a_.left[a_.corner[i]] = 0;
    for (size_t i = 3 * size_t{begin}; i < 3 * size_t{end}; ++i) ++a_.left[a_.corner[i]];
    for (uint32_t cursor = begin, fan = kNone; (fan = goOn(fan, &cursor)) != kNone;) writeFan(fan);
  }

 private:
  bool isLeft(uint32_t triangle) const { return triangle >= begin_ && triangle < end_ && !a_.is_written[triangle]; }

  void writeFan(uint32_t vertex) {
    for (uint32_t i = a_.first[vertex]; i < a_.first[vertex + 1]; ++i) {
      const uint32_t triangle = a_.around[i];
      if (!isLeft(triangle)) continue;
      a_.is_written[triangle] = 1;
      for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t v = a_.corner[3 * size_t{triangle} + k];
        out_[next_++] = static_cast<Index>(v);
        --a_.left[v];
        if (time_ - a_.entered[v] > kCacheSize) a_.entered[v] = time_++;
        trail_.push(v);
      }
    }
  }

  /// The neighbour that has been in the cache longest and will still be there when its triangles are written; else one
  /// that the walk has passed; else what comes next in the old order.
  uint32_t goOn(uint32_t fan, uint32_t* cursor) {
    uint32_t best = fan == kNone ? kNone : bestNeighbour(fan);
    while (best == kNone && trail_.count > 0) {
      const uint32_t passed = trail_.pop();
      if (a_.left[passed] > 0) best = passed;
    }
    for (; best == kNone && *cursor < end_; ++*cursor)
      if (isLeft(*cursor)) best = a_.corner[3 * size_t{*cursor}];
    return best;
  }

  uint32_t bestNeighbour(uint32_t fan) const {
    uint32_t best = kNone, longest = 0;
    for (uint32_t i = a_.first[fan]; i < a_.first[fan + 1]; ++i) {
      for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t v = a_.corner[3 * size_t{a_.around[i]} + k];
        if (a_.left[v] == 0) continue;
        const uint32_t age = time_ - a_.entered[v];
        const uint32_t priority = age + 2 * uint64_t{a_.left[v]} <= kCacheSize ? age + 1 : 1;
        if (priority > longest) longest = priority, best = v;
      }
    }
    return best;
  }

  const Arrays& a_;
  Index* out_;
  size_t next_ = 0;
  uint32_t begin_ = 0, end_ = 0;
  uint32_t time_ = kCacheSize + 1;  // no vertex is in the cache
  Trail trail_;
};

/// Whether the ranges lie one after the other, cover the indices, and hold whole triangles.
bool rangesTile(const lithe_range* ranges, size_t range_count, size_t index_count) {
  uint64_t end = 0;
  for (size_t r = 0; r < range_count; ++r) {
    if (ranges[r].first_index != end || ranges[r].index_count % 3 != 0) return false;
    end += ranges[r].index_count;
  }
  return end == index_count;
}

template <typename Index>
bool takeIndices(const Index* indices, size_t index_count, size_t vertex_count, uint32_t* corner) {
  for (size_t i = 0; i < index_count; ++i) {
    if (indices[i] >= vertex_count) return false;
    corner[i] = indices[i];
  }
  return true;
}

template <typename Index>
lithe_result orderIndices(Index* indices, size_t index_count, const lithe_range* ranges, size_t range_count,
                          size_t vertex_count, const Arrays& arrays) {
  if (!takeIndices(indices, index_count, vertex_count, arrays.corner)) return invalidArgument();
  listTriangles(index_count, vertex_count, arrays);
  memset(arrays.entered, 0, vertex_count * sizeof(uint32_t));
  if (index_count) memset(arrays.is_written, 0, index_count / 3);
  Walk<Index> walk(arrays, indices);
  for (size_t r = 0; r < range_count; ++r) {
    const uint32_t begin = ranges[r].first_index / 3;
    walk.run(begin, begin + ranges[r].index_count / 3);
  }
  return LITHE_OK;
}

}  // namespace
}  // namespace lithe::runtime

using namespace lithe::runtime;  // NOLINT: the C functions below are the outside of this namespace

uint64_t lithe_order_scratch(uint32_t index_count, uint32_t vertex_count) {
  return Arrays::bytes(index_count, vertex_count);
}

lithe_result lithe_order_indices(void* indices, lithe_index_type type, uint32_t index_count, const lithe_range* ranges,
                                 uint32_t range_count, uint32_t vertex_count, void* scratch, size_t scratch_size) {
  if ((!indices && index_count) || (type != LITHE_INDEX_U16 && type != LITHE_INDEX_U32) || (!ranges && range_count) ||
      !rangesTile(ranges, range_count, index_count))
    return invalidArgument();
  if (index_count > kMostIndices || !scratch || reinterpret_cast<uintptr_t>(scratch) % sizeof(uint32_t) ||
      reinterpret_cast<uintptr_t>(indices) % static_cast<uint32_t>(type))
    return invalidArgument();
  if (lithe_order_scratch(index_count, vertex_count) > scratch_size) return LITHE_ERROR_BUFFER_TOO_SMALL;
  const Arrays arrays(scratch, index_count, vertex_count);
  if (type == LITHE_INDEX_U16)
    return orderIndices(static_cast<uint16_t*>(indices), index_count, ranges, range_count, vertex_count, arrays);
  return orderIndices(static_cast<uint32_t*>(indices), index_count, ranges, range_count, vertex_count, arrays);
}
