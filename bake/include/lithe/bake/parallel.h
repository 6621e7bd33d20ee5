// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Loops over several threads. What a piece of work writes must not depend on which thread does it, or when.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <thread>
#include <vector>

namespace lithe::bake {

/// 0 stands for as many threads as the machine has.
inline uint32_t threadCount(uint32_t wanted) {
  return wanted > 0 ? wanted : std::max(1u, std::thread::hardware_concurrency());
}

/// Runs piece(0) to piece(count - 1) at the same time, and returns when all have ended. What a piece throws is thrown
/// here, that of the lowest piece where several do; where the system gives no further thread, this one does its piece.
template <class Piece>
void runPieces(uint32_t count, const Piece& piece) {
  std::vector<std::exception_ptr> thrown(count);
  const auto run = [&](uint32_t i) {
    try {
      piece(i);
    } catch (...) {
      thrown[i] = std::current_exception();
    }
  };
  std::vector<std::thread> workers;
  workers.reserve(count);  // from here on nothing may leave this function before the workers are joined
  for (uint32_t i = 1; i < count; ++i) {
    try {
      workers.emplace_back(run, i);
    } catch (...) {
      run(i);
    }
  }
  if (count > 0) run(0);
  for (std::thread& worker : workers) worker.join();
  for (const std::exception_ptr& exception : thrown)
    if (exception) std::rethrow_exception(exception);
}

/// Runs job(begin, end) over [0, count) in as many pieces as there are threads.
/// @param threads  0: as many as the machine has
template <class Job>
void inParallel(uint32_t count, uint32_t threads, const Job& job) {
  constexpr uint32_t kLeast = 256;  // fewer are not worth a thread
  const uint32_t pieces = std::max(1u, std::min(threadCount(threads), count / kLeast));
  const auto startOf = [&](uint32_t piece) { return static_cast<uint32_t>(uint64_t{count} * piece / pieces); };
  runPieces(pieces, [&](uint32_t piece) { job(startOf(piece), startOf(piece + 1)); });
}

/// Calls work(i) for all i below count, each where a thread is free; the order is not fixed. After an exception the
/// other threads end with the indices that they are at.
/// @param threads  0: as many as the machine has
template <class Work>
void forEachIndex(uint32_t count, uint32_t threads, const Work& work) {
  std::atomic<uint32_t> next{0};
  runPieces(std::min(threadCount(threads), count), [&](uint32_t) {
    try {
      for (uint32_t i = next++; i < count; i = next++) work(i);
    } catch (...) {
      next = count;
      throw;
    }
  });
}

}  // namespace lithe::bake
