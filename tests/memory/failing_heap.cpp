// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "failing_heap.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace lithe::bake::test {
namespace {

std::atomic<uint64_t> given{0}, held{0};
std::atomic<uint64_t> last{UINT64_MAX};  ///< `given` beyond which nothing is given
std::atomic<bool> failed{false}, once{false};

void* take(size_t size, size_t alignment) {
  if (given >= last && !(failed.exchange(true) && once)) throw std::bad_alloc();
  void* memory = alignment ? std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment)
                           : std::malloc(size > 0 ? size : 1);
  if (!memory) throw std::bad_alloc();
  ++given;
  ++held;
  return memory;
}

void giveBack(void* memory) {
  if (memory) --held;
  std::free(memory);
}

}  // namespace

FailingHeap::FailingHeap(uint64_t calls, Failure failure) {
  failed = false;
  once = failure == Failure::kOnce;
  last = given + calls;
}
FailingHeap::~FailingHeap() { last = UINT64_MAX; }
bool FailingHeap::hasFailed() const { return failed; }

uint64_t blocksGiven() { return given; }
uint64_t blocksHeld() { return held; }

}  // namespace lithe::bake::test

// All forms: a sanitizer brings its own of each that is not here.
void* operator new(size_t size) { return lithe::bake::test::take(size, 0); }
void* operator new[](size_t size) { return lithe::bake::test::take(size, 0); }
void* operator new(size_t size, std::align_val_t alignment) {
  return lithe::bake::test::take(size, static_cast<size_t>(alignment));
}
void* operator new(size_t size, const std::nothrow_t&) noexcept {
  try {
    return lithe::bake::test::take(size, 0);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void operator delete(void* memory) noexcept { lithe::bake::test::giveBack(memory); }
void operator delete[](void* memory) noexcept { lithe::bake::test::giveBack(memory); }
void operator delete(void* memory, size_t) noexcept { lithe::bake::test::giveBack(memory); }
void operator delete[](void* memory, size_t) noexcept { lithe::bake::test::giveBack(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { lithe::bake::test::giveBack(memory); }
void operator delete(void* memory, size_t, std::align_val_t) noexcept { lithe::bake::test::giveBack(memory); }
