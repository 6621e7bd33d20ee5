// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Memory for the arrays of a value per slot, face or edge. A collapse reads a few lines here and there in all of them:
// with small pages it looks for the pages longer than it waits for the lines.
#pragma once

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace lithe::bake {

template <class T>
struct HugePages {
  using value_type = T;

  static constexpr size_t kPage = size_t{2} << 20;
  static constexpr size_t kLeast = 4 * kPage;  // what fits less well is rounded up by too much
  static constexpr size_t alignmentFor(size_t bytes) { return bytes >= kLeast ? kPage : alignof(T); }

  HugePages() = default;
  template <class U>
  HugePages(const HugePages<U>&) {}

  T* allocate(size_t count) {
    const size_t bytes = count * sizeof(T);
    void* memory = ::operator new(bytes, std::align_val_t(alignmentFor(bytes)));
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    // A wish: where it is not granted all goes on as before.
    if (bytes >= kLeast) madvise(memory, bytes / kPage * kPage, MADV_HUGEPAGE);
#endif
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, size_t count) {
    ::operator delete(memory, std::align_val_t(alignmentFor(count * sizeof(T))));
  }

  /// Lanes that nobody has given a value have none: what is made to be filled is not filled with zeros first.
  template <class U>
  void construct(U* at) {
    ::new (static_cast<void*>(at)) U;
  }
  template <class U, class First, class... Rest>
  void construct(U* at, First&& first, Rest&&... rest) {
    ::new (static_cast<void*>(at)) U{std::forward<First>(first), std::forward<Rest>(rest)...};
  }

  template <class U>
  bool operator==(const HugePages<U>&) const {
    return true;
  }
};

/// A vector for values of which there are as many as the mesh has vertices, triangles or edges. resize() leaves new
/// ones without a value where their type gives them none.
template <class T>
using LargeVector = std::vector<T, HugePages<T>>;

}  // namespace lithe::bake
