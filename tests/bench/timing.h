// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Times on a machine that does other things too: rivals take turns, and the median of many rounds counts.
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <vector>

namespace lithe::bench {

using Work = std::function<void()>;

inline double secondsOf(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

inline double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

/// Median seconds of each work. They run in turns, one round unmeasured and then at least `least_rounds` and
/// `least_seconds` in all.
inline std::vector<double> medianSeconds(const std::vector<Work>& works, size_t least_rounds = 9,
                                         double least_seconds = 0.5) {
  for (const Work& work : works) work();
  std::vector<std::vector<double>> times(works.size());
  for (double total = 0; times.front().size() < least_rounds || total < least_seconds;)
    for (size_t i = 0; i < works.size(); ++i) {
      times[i].push_back(secondsOf(works[i]));
      total += times[i].back();
    }
  std::vector<double> medians;
  for (const std::vector<double>& of_one : times) medians.push_back(median(of_one));
  return medians;
}

}  // namespace lithe::bench
