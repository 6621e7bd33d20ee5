// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The order of the collapses: a 4-ary heap of edge ids by key, ties by id, so that the order is one on every machine.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "large_vector.h"
#include "lithe/bake/model.h"
#include "prefetch.h"

namespace lithe::bake {

class EdgeQueue {
 public:
  explicit EdgeQueue(uint32_t edge_count) : key_(edge_count, 0.0), place_(edge_count, kNone) {
    heap_.reserve(edge_count);
  }

  bool empty() const { return heap_.empty(); }
  uint32_t top() const { return static_cast<uint32_t>(heap_.front().edge); }
  /// What comes after the top, in order; kNone where nothing is left.
  std::array<uint32_t, 3> afterTop() const {
    std::array<size_t, 12> front;  // places of which one is the next: four, and four more for each that was taken
    size_t count = addChildren(0, front.data(), 0);
    std::array<uint32_t, 3> next{kNone, kNone, kNone};
    for (uint32_t& edge : next) {
      if (count == 0) break;
      size_t least = 0;
      for (size_t i = 1; i < count; ++i) least = heap_[front[i]] < heap_[front[least]] ? i : least;
      const size_t place = front[least];
      edge = static_cast<uint32_t>(heap_[place].edge);
      front[least] = front[--count];
      count = &edge == &next.back() ? count : addChildren(place, front.data(), count);
    }
    return next;
  }
  bool contains(uint32_t edge) const { return place_[edge] != kNone; }
  double key(uint32_t edge) const { return key_[edge]; }

  /// Hint that an edge will be asked for or moved.
  void prefetch(uint32_t edge) const {
    __builtin_prefetch(&key_[edge]);
    __builtin_prefetch(&place_[edge]);
  }

  /// Puts an edge in, or moves it to its new key.
  void set(uint32_t edge, double key) {
    key_[edge] = key;
    uint32_t place = place_[edge];
    if (place == kNone) {
      place = static_cast<uint32_t>(heap_.size());
      heap_.emplace_back();
    }
    put({orderOf(key), edge}, place);
  }

  void remove(uint32_t edge) {
    const uint32_t hole = place_[edge];
    if (hole == kNone) return;
    place_[edge] = kNone;
    const Entry last = heap_.back();
    heap_.pop_back();
    if (last.edge != edge) put(last, hole);
  }

 private:
  /// The key beside its edge: whoever compares children finds them in one line of the cache. As integers of the same
  /// order, so that comparing takes no branch: which child is least nobody can guess.
  struct Entry {
    uint64_t order;
    uint64_t edge;

    bool operator<(const Entry& other) const {
      const uint32_t below = order < other.order, equal = order == other.order, first = edge < other.edge;
      return (below | (equal & first)) != 0;
    }
  };

  static uint64_t orderOf(double key) {
    const auto bits = std::bit_cast<uint64_t>(key + 0.0);  // -0 is 0
    return bits >> 63 ? ~bits : bits | uint64_t{1} << 63;
  }

  size_t addChildren(size_t place, size_t* front, size_t count) const {
    for (size_t child = 4 * place + 1; child < std::min(heap_.size(), 4 * place + 5); ++child) front[count++] = child;
    return count;
  }

  /// Fills a hole with an entry, which moves up or down from there to its place.
  void put(const Entry& entry, uint32_t hole) {
    while (hole > 0 && entry < heap_[(hole - 1) / 4]) {
      move((hole - 1) / 4, hole);
      hole = (hole - 1) / 4;
    }
    const auto size = static_cast<uint32_t>(heap_.size());
    for (uint32_t first; (first = 4 * hole + 1) < size;) {
      prefetchAll(heap_.data() + 4 * size_t{first} + 1, 16);  // the children's children
      const uint32_t end = std::min(first + 4, size);
      uint32_t least = first;
      for (uint32_t child = first + 1; child < end; ++child) {
        least = heap_[child] < heap_[least] ? child : least;
      }
      if (!(heap_[least] < entry)) break;
      move(least, hole);
      hole = least;
    }
    heap_[hole] = entry;
    place_[entry.edge] = hole;
  }

  void move(uint32_t from, uint32_t to) {
    heap_[to] = heap_[from];
    place_[heap_[to].edge] = to;
  }

  LargeVector<double> key_;      // per edge
  LargeVector<uint32_t> place_;  // per edge: where in the heap, or kNone
  LargeVector<Entry> heap_;
};

}  // namespace lithe::bake
