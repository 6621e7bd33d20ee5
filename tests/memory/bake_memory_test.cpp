// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The heap runs out while a character is imported, baked, compared or exported: an exception that says so, from
// whatever thread, and everything given back.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <new>

#include "failing_heap.h"
#include "lithe/bake/bake.h"
#include "lithe/bake/compare.h"
#include "lithe/bake/parallel.h"
#include "shapes.h"

namespace lithe::bake {
namespace {

/// How an attempt on a failing heap ended.
enum class End { kDone, kOutOfMemory, kOther };

End attempt(const std::function<void()>& work, uint64_t calls, test::Failure failure, bool* failed) {
  test::FailingHeap heap(calls, failure);
  End end = End::kDone;
  try {
    work();
  } catch (const std::bad_alloc&) {
    end = End::kOutOfMemory;
  } catch (const Error&) {  // its text is put together after the heap has failed: it may not be there, the type is
    end = End::kOutOfMemory;
  } catch (...) {
    end = End::kOther;
  }
  *failed = heap.hasFailed();
  return end;
}

/// Lets `work` run out of memory at its first calls one after the other, and at some 50 spread over the rest.
void failThroughout(const std::function<void()>& work, test::Failure failure) {
  work();  // what is kept once and for all is there now
  const uint64_t before = test::blocksGiven();
  work();
  const uint64_t all = test::blocksGiven() - before, step = std::max<uint64_t>(1, all / 50);
  uint64_t failures = 0;
  for (uint64_t calls = 0; calls < all; calls += calls < 50 ? 1 : step) {
    const uint64_t held = test::blocksHeld();
    bool failed = false;
    const End end = attempt(work, calls, failure, &failed);
    ASSERT_NE(end, End::kOther) << "after " << calls << " of " << all << " blocks";
    // The standard library sorts and partitions in place where it gets no buffer: once, that is no failure.
    const bool got_by = end == End::kDone && failure == test::Failure::kOnce;
    ASSERT_EQ(failed && !got_by, end == End::kOutOfMemory) << "after " << calls << " of " << all << " blocks";
    ASSERT_EQ(test::blocksHeld(), held) << "after " << calls << " of " << all << " blocks";
    failures += failed;
  }
  EXPECT_GE(failures, std::min<uint64_t>(all, 50));
}

BakeOptions quick(uint32_t threads) {
  BakeOptions options;
  options.poses.count = 3;
  options.levels = {0.5, 0.2};
  options.threads = threads;
  return options;
}

TEST(BakeMemory, ABakeRunsOutAnywhere) {
  const Model model = test::tube(18, 18);
  for (const uint32_t threads : {1u, 3u}) {
    const auto bakeIt = [&] { bake(model, quick(threads), nullptr); };
    failThroughout(bakeIt, threads == 1 ? test::Failure::kOnce : test::Failure::kForGood);
  }
}

TEST(BakeMemory, ACompareRunsOutAnywhere) {
  const Model model = test::tube(8, 6);
  CompareOptions options;
  options.frames = 4;
  options.samples = 50;
  options.threads = 3;
  failThroughout([&] { compare(model, model, options); }, test::Failure::kForGood);
}

TEST(Parallel, WhatAPieceThrowsIsThrownAndTheOthersAreJoined) {
  for (uint32_t thrower = 0; thrower < 4; ++thrower) {
    std::atomic<uint32_t> ended{0};
    const auto piece = [&](uint32_t i) {
      ++ended;
      if (i >= thrower) throw Error("piece " + std::to_string(i));
    };
    try {
      runPieces(4, piece);
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.what(), "piece " + std::to_string(thrower));
    }
    EXPECT_EQ(ended, 4u);
  }
}

TEST(Parallel, AnExceptionEndsTheLoopOverIndices) {
  std::atomic<uint32_t> done{0};
  const auto work = [&](uint32_t i) {
    if (i == 5) throw Error("five");
    ++done;
  };
  EXPECT_THROW(forEachIndex(1u << 30, 3, work), Error);
  EXPECT_LT(done, 1u << 29);
}

TEST(Parallel, EveryIndexIsVisitedOnce) {
  for (const uint32_t threads : {1u, 2u, 5u}) {
    std::vector<uint32_t> visits(2000, 0), in_pieces(2000, 0);
    forEachIndex(2000, threads, [&](uint32_t i) { ++visits[i]; });
    inParallel(2000, threads, [&](uint32_t begin, uint32_t end) {
      for (uint32_t i = begin; i < end; ++i) ++in_pieces[i];
    });
    EXPECT_EQ(visits, std::vector<uint32_t>(2000, 1));
    EXPECT_EQ(in_pieces, visits);
  }
}

}  // namespace
}  // namespace lithe::bake
