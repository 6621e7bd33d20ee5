// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The C++ heap of this program, which can be told to fail: operator new of any thread throws std::bad_alloc then.
#pragma once

#include <cstdint>

namespace lithe::bake::test {

enum class Failure {
  kOnce,     ///< one call fails: what is given back while the exception travels is there again
  kForGood,  ///< all calls after it too
};

/// While one lives, operator new gives `calls` blocks and then throws. One at a time.
class FailingHeap {
 public:
  FailingHeap(uint64_t calls, Failure failure);
  ~FailingHeap();
  FailingHeap(const FailingHeap&) = delete;
  FailingHeap& operator=(const FailingHeap&) = delete;

  bool hasFailed() const;
};

/// Blocks that operator new has given since the program began; the difference of two is what lay between them.
uint64_t blocksGiven();
/// Of those the ones that have not come back.
uint64_t blocksHeld();

}  // namespace lithe::bake::test
