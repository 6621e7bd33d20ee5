// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Loops over several threads. What a job writes must not depend on where its piece begins and ends.
#pragma once

#include <algorithm>
#include <cstdint>
#include <thread>
#include <vector>

namespace lithe::bake {

/// Runs job(begin, end) over [0, count) in as many pieces as there are threads; 0 threads: as many as the machine has.
template <class Job>
void inParallel(uint32_t count, uint32_t threads, const Job& job) {
  constexpr uint32_t kLeast = 256;  // fewer are not worth a thread
  if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
  threads = std::max(1u, std::min(threads, count / kLeast));
  const auto startOf = [&](uint32_t piece) { return static_cast<uint32_t>(uint64_t{count} * piece / threads); };
  std::vector<std::thread> workers;
  for (uint32_t i = 1; i < threads; ++i) workers.emplace_back([&, i] { job(startOf(i), startOf(i + 1)); });
  job(0, startOf(1));
  for (std::thread& worker : workers) worker.join();
}

}  // namespace lithe::bake
