// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Vectors for values of which there are as many as the mesh has vertices, triangles or edges.
#pragma once

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace lithe::bake {

/// Makes values that nobody has given a value without one: what is made to be filled is not filled with zeros first.
/// Starts at a line of the cache, so that what fits n lines lies in n and not in n + 1.
template <class T>
struct Unfilled {
  using value_type = T;
  static constexpr std::align_val_t kLine{64};

  T* allocate(size_t count) { return static_cast<T*>(::operator new(count * sizeof(T), kLine)); }
  void deallocate(T* memory, size_t) { ::operator delete(memory, kLine); }

  Unfilled() = default;
  template <class U>
  Unfilled(const Unfilled<U>&) {}

  template <class U>
  void construct(U* at) {
    ::new (static_cast<void*>(at)) U;
  }
  template <class U, class First, class... Rest>
  void construct(U* at, First&& first, Rest&&... rest) {
    ::new (static_cast<void*>(at)) U{std::forward<First>(first), std::forward<Rest>(rest)...};
  }

  template <class U>
  bool operator==(const Unfilled<U>&) const {
    return true;
  }
};

/// resize() leaves new values without one where their type gives them none.
template <class T>
using LargeVector = std::vector<T, Unfilled<T>>;

}  // namespace lithe::bake
