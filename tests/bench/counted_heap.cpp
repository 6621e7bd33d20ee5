// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "counted_heap.h"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace lithe::bench {
namespace {

std::atomic<uint64_t> allocated{0}, peak{0};

void* counted(void* memory) {
  if (!memory) throw std::bad_alloc();
  const uint64_t now = allocated += malloc_usable_size(memory);
  uint64_t known = peak;
  while (now > known && !peak.compare_exchange_weak(known, now)) {
  }
  return memory;
}

void release(void* memory) {
  allocated -= malloc_usable_size(memory);
  std::free(memory);
}

}  // namespace

uint64_t startPeak() { return peak = allocated.load(); }

uint64_t peakBytes() { return peak; }

}  // namespace lithe::bench

void* operator new(size_t size) { return lithe::bench::counted(std::malloc(size)); }
void* operator new(size_t size, std::align_val_t alignment) {
  const auto to = static_cast<size_t>(alignment);
  return lithe::bench::counted(std::aligned_alloc(to, (size + to - 1) / to * to));
}
void operator delete(void* memory) noexcept { lithe::bench::release(memory); }
void operator delete(void* memory, size_t) noexcept { lithe::bench::release(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { lithe::bench::release(memory); }
void operator delete(void* memory, size_t, std::align_val_t) noexcept { lithe::bench::release(memory); }
