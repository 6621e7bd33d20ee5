// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// One line on the terminal that says what is being done, how far it is and how long it will take.
#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <string_view>

namespace lithe::tool {

/// Shows nothing when stderr is not a terminal, when asked to be quiet, and for the first second. The line is taken
/// back by finish() and by the destructor, so that what follows starts on a clean line. Any thread may report.
class Progress {
 public:
  explicit Progress(bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// @param what      the stage's name
  /// @param fraction  of this stage [0..1]; the estimate is for the rest of the stage
  void report(std::string_view what, double fraction);
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  std::string line(double fraction, Clock::time_point now) const;

  bool shown_;
  bool line_is_up_ = false;
  std::string what_;
  Clock::time_point begin_, stage_begin_, last_;
  std::mutex mutex_;
};

}  // namespace lithe::tool
