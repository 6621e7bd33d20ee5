// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Sorting without the standard library: insertion for the few, heaps for the many (Williams 1964), so that no input is
/// slow.
#pragma once

#include <stdint.h>

namespace lithe::runtime {

template <typename T>
inline void exchange(T& a, T& b) {
  const T c = a;
  a = b;
  b = c;
}

template <typename T, typename Less>
void siftDown(T* values, uint32_t at, uint32_t count, const Less& less) {
  for (uint32_t child = 2 * at + 1; child < count; at = child, child = 2 * at + 1) {
    if (child + 1 < count && less(values[child], values[child + 1])) ++child;
    if (!less(values[at], values[child])) return;
    exchange(values[at], values[child]);
  }
}

/// Ascending by `less`. Not stable. O(n log n) comparisons, no memory.
template <typename T, typename Less>
void sortValues(T* values, uint32_t count, const Less& less) {
  constexpr uint32_t kFew = 24;
  if (count <= kFew) {
    for (uint32_t i = 1; i < count; ++i)
      for (uint32_t j = i; j > 0 && less(values[j], values[j - 1]); --j) exchange(values[j], values[j - 1]);
    return;
  }
  for (uint32_t i = count / 2; i-- > 0;) siftDown(values, i, count, less);
  for (uint32_t end = count; --end > 0;) {
    exchange(values[0], values[end]);
    siftDown(values, 0, end, less);
  }
}

inline void sortValues(uint32_t* values, uint32_t count) {
  sortValues(values, count, [](uint32_t a, uint32_t b) { return a < b; });
}

/// Keeps the first of equal neighbours; returns how many are left.
inline uint32_t dropRepeated(uint32_t* values, uint32_t count) {
  uint32_t kept = 0;
  for (uint32_t i = 0; i < count; ++i)
    if (i == 0 || values[i] != values[i - 1]) values[kept++] = values[i];
  return kept;
}

template <typename T>
constexpr T least(T a, T b) {
  return b < a ? b : a;
}
template <typename T>
constexpr T greatest(T a, T b) {
  return a < b ? b : a;
}

}  // namespace lithe::runtime
