// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lithe::tool {
namespace {

constexpr int kBarWidth = 30;
constexpr std::chrono::milliseconds kQuietStart{1000};
constexpr std::chrono::milliseconds kRefresh{100};

double seconds(std::chrono::steady_clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

std::string bar(double fraction) {
  const int full = static_cast<int>(std::lround(fraction * kBarWidth));
  return "[" + std::string(full, '#') + std::string(kBarWidth - full, '.') + "]";
}

}  // namespace

Progress::Progress(bool quiet) : shown_(!quiet && isatty(STDERR_FILENO)), begin_(Clock::now()), stage_begin_(begin_) {}

Progress::~Progress() { finish(); }

void Progress::report(std::string_view what, double fraction) {
  if (!shown_) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  const Clock::time_point now = Clock::now();
  if (what != what_) {
    what_ = what;
    stage_begin_ = now;
  }
  if (now - begin_ < kQuietStart || now - last_ < kRefresh) return;
  last_ = now;
  line_is_up_ = true;
  std::fprintf(stderr, "\r\033[K%s", line(std::clamp(fraction, 0.0, 1.0), now).c_str());
  std::fflush(stderr);
}

void Progress::finish() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (line_is_up_) std::fputs("\r\033[K", stderr);
  line_is_up_ = false;
}

std::string Progress::line(double fraction, Clock::time_point now) const {
  const double spent = seconds(now - stage_begin_);
  char text[160];
  // Below a few percent the estimate is noise.
  if (fraction >= 0.03 && spent >= 0.5) {
    std::snprintf(text, sizeof text, "%-10s %s %3.0f %%  %.0f s left", what_.c_str(), bar(fraction).c_str(),
                  100 * fraction, std::ceil(spent * (1 - fraction) / fraction));
  } else {
    std::snprintf(text, sizeof text, "%-10s %s %3.0f %%", what_.c_str(), bar(fraction).c_str(), 100 * fraction);
  }
  return text;
}

}  // namespace lithe::tool
