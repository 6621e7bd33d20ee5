// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Many short lists of ids in one flat array; a list that outgrows its place moves to the end.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "large_vector.h"

namespace lithe::bake {

class ListPool {
 public:
  /// Lists of the given capacities, empty.
  explicit ListPool(std::span<const uint32_t> capacities = {}) {
    lists_.resize(capacities.size());
    uint32_t begin = 0;
    for (size_t i = 0; i < capacities.size(); ++i) {
      lists_[i] = {begin, 0, capacities[i]};
      begin += capacities[i];
    }
    ids_.resize(begin);
  }

  std::span<uint32_t> operator[](uint32_t list) { return {ids_.data() + lists_[list].begin, lists_[list].count}; }
  std::span<const uint32_t> operator[](uint32_t list) const {
    return {ids_.data() + lists_[list].begin, lists_[list].count};
  }

  void prefetchHead(uint32_t list) const { __builtin_prefetch(&lists_[list]); }
  /// Once its head has arrived.
  void prefetch(uint32_t list) const { __builtin_prefetch(ids_.data() + lists_[list].begin); }

  /// Appends within the capacity the list was made with.
  void append(uint32_t list, uint32_t id) { ids_[lists_[list].begin + lists_[list].count++] = id; }

  void assign(uint32_t list, std::span<const uint32_t> ids) {
    List& l = lists_[list];
    if (ids.size() > l.capacity) {
      l.begin = static_cast<uint32_t>(ids_.size());
      l.capacity = static_cast<uint32_t>(ids.size());
      ids_.resize(ids_.size() + ids.size());
    }
    l.count = static_cast<uint32_t>(ids.size());
    std::copy(ids.begin(), ids.end(), ids_.begin() + l.begin);
  }

  /// Removes an id, keeping the order; it must be there, once. Without branches: where it is nobody can guess.
  void remove(uint32_t list, uint32_t id) {
    uint32_t kept = 0;
    for (uint32_t& each : (*this)[list]) {
      ids_[lists_[list].begin + kept] = each;
      kept += each != id ? 1 : 0;
    }
    lists_[list].count = kept;
  }

 private:
  struct List {
    uint32_t begin, count, capacity;
  };
  LargeVector<List> lists_;
  LargeVector<uint32_t> ids_;
};

}  // namespace lithe::bake
