// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The C library's memory as a lithe_allocator, and one that fails at a chosen call and counts what is not given back.
#pragma once

#include <cstdlib>

#include "lithe/runtime.h"

namespace lithe::test {

inline const lithe_allocator* mallocAllocator() {
  static const lithe_allocator allocator = {nullptr,
                                            [](void*, size_t size, size_t alignment) -> void* {
                                              return std::aligned_alloc(alignment,
                                                                        (size + alignment - 1) / alignment * alignment);
                                            },
                                            [](void*, void* memory, size_t) { std::free(memory); }};
  return &allocator;
}

/// Gives NULL at the fail_at-th call (from 0; SIZE_MAX: never) and keeps account.
struct FailingAllocator {
  size_t fail_at = SIZE_MAX;
  size_t calls = 0;
  size_t bytes = 0;  ///< handed out and not yet given back
  size_t peak = 0;

  lithe_allocator get() {
    return {this,
            [](void* user, size_t size, size_t alignment) -> void* {
              auto* self = static_cast<FailingAllocator*>(user);
              if (self->calls++ == self->fail_at) return nullptr;
              self->bytes += size;
              if (self->bytes > self->peak) self->peak = self->bytes;
              return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
            },
            [](void* user, void* memory, size_t size) {
              static_cast<FailingAllocator*>(user)->bytes -= size;
              std::free(memory);
            }};
  }
};

}  // namespace lithe::test
