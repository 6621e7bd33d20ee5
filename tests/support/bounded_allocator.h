// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The C library's memory up to a limit, as a lithe_allocator that counts, fails on demand, and aborts when a block
/// comes back with another size than it went out with.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <map>

#include "lithe/runtime.h"

namespace lithe::test {

class BoundedAllocator {
 public:
  explicit BoundedAllocator(size_t most = SIZE_MAX) : limit(most) {}
  BoundedAllocator(const BoundedAllocator&) = delete;
  BoundedAllocator& operator=(const BoundedAllocator&) = delete;

  lithe_allocator get() { return {this, allocate, release}; }

  size_t limit;               ///< of all blocks together
  size_t fail_at = SIZE_MAX;  ///< the call that gets NULL, from 0
  size_t calls = 0;
  size_t held = 0, peak = 0;  ///< bytes
  size_t asked = 0;           ///< the most bytes that a call would have had held, granted or not

 private:
  static void* allocate(void* user, size_t size, size_t alignment) {
    auto* self = static_cast<BoundedAllocator*>(user);
    const size_t wanted = size > SIZE_MAX - self->held ? SIZE_MAX : self->held + size;
    if (wanted > self->asked) self->asked = wanted;
    if (self->calls++ == self->fail_at || wanted > self->limit) return nullptr;
    void* memory = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
    if (!memory) return nullptr;
    self->held = wanted;
    if (self->held > self->peak) self->peak = self->held;
    self->sizes_[memory] = size;
    return memory;
  }

  static void release(void* user, void* memory, size_t size) {
    auto* self = static_cast<BoundedAllocator*>(user);
    const auto block = self->sizes_.find(memory);
    if (block == self->sizes_.end() || block->second != size) std::abort();
    self->sizes_.erase(block);
    self->held -= size;
    std::free(memory);
  }

  std::map<void*, size_t> sizes_;
};

}  // namespace lithe::test
