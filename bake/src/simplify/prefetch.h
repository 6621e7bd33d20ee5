// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Hints for the memory: they change nothing but when it is waited for.
#pragma once

#include <cstddef>

namespace lithe::bake {

inline constexpr size_t kCacheLine = 64;

/// `count` objects from `first` on.
template <class T>
inline void prefetchAll(const T* first, size_t count) {
  const char* byte = reinterpret_cast<const char*>(first);
  for (size_t at = 0; at < count * sizeof(T); at += kCacheLine) __builtin_prefetch(byte + at);
}

}  // namespace lithe::bake
