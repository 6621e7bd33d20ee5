// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The order of the collapses: a 4-ary heap of edge ids by key, ties by id, so that the order is one on every machine.
#pragma once

#include <cstdint>
#include <vector>

#include "lithe/bake/model.h"

namespace lithe::bake {

class EdgeQueue {
 public:
  explicit EdgeQueue(uint32_t edge_count) : key_(edge_count, 0.0), place_(edge_count, kNone) {}

  bool empty() const { return heap_.empty(); }
  uint32_t top() const { return heap_.front(); }
  bool contains(uint32_t edge) const { return place_[edge] != kNone; }
  double key(uint32_t edge) const { return key_[edge]; }

  /// Puts an edge in, or moves it to its new key.
  void set(uint32_t edge, double key) {
    key_[edge] = key;
    if (place_[edge] == kNone) {
      place_[edge] = static_cast<uint32_t>(heap_.size());
      heap_.push_back(edge);
    }
    siftUp(place_[edge]);
    siftDown(place_[edge]);
  }

  void remove(uint32_t edge) {
    const uint32_t hole = place_[edge];
    if (hole == kNone) return;
    place_[edge] = kNone;
    const uint32_t last = heap_.back();
    heap_.pop_back();
    if (last == edge) return;
    heap_[hole] = last;
    place_[last] = hole;
    siftUp(hole);
    siftDown(place_[last]);
  }

 private:
  bool before(uint32_t a, uint32_t b) const { return key_[a] != key_[b] ? key_[a] < key_[b] : a < b; }

  void siftUp(uint32_t place) {
    const uint32_t edge = heap_[place];
    for (; place > 0 && before(edge, heap_[(place - 1) / 4]); place = (place - 1) / 4) {
      heap_[place] = heap_[(place - 1) / 4];
      place_[heap_[place]] = place;
    }
    heap_[place] = edge;
    place_[edge] = place;
  }

  void siftDown(uint32_t place) {
    const uint32_t edge = heap_[place];
    const auto size = static_cast<uint32_t>(heap_.size());
    for (;;) {
      const uint32_t first = 4 * place + 1;
      if (first >= size) break;
      const uint32_t end = first + 4 < size ? first + 4 : size;
      uint32_t best = first;
      for (uint32_t child = first + 1; child < end; ++child) {
        if (before(heap_[child], heap_[best])) best = child;
      }
      if (!before(heap_[best], edge)) break;
      heap_[place] = heap_[best];
      place_[heap_[place]] = place;
      place = best;
    }
    heap_[place] = edge;
    place_[edge] = place;
  }

  std::vector<double> key_;      // per edge
  std::vector<uint32_t> place_;  // per edge: where in the heap, or kNone
  std::vector<uint32_t> heap_;
};

}  // namespace lithe::bake
