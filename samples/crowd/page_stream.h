// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Pages from disk over a link of limited bandwidth. A thread reads; the frame loop says which levels it would like and
/// supplies what has arrived, between frames, when nobody else looks at the asset.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <vector>

#include "character.h"

/// Reads one range at a time on its own thread.
class PageReader {
 public:
  PageReader();
  ~PageReader();

  /// There must be no read under way.
  void start(const std::filesystem::path& path, uint64_t offset, size_t size);
  /// The bytes of the read under way: waits for them, or gives nothing while they are not there.
  /// Throws what the read threw.
  std::optional<std::vector<uint8_t>> take(bool wait);

 private:
  enum class State { kIdle, kAsked, kDone, kEnding };

  void run();

  std::mutex mutex_;
  std::condition_variable changed_;
  State state_ = State::kIdle;
  std::filesystem::path path_;
  uint64_t offset_ = 0;
  size_t size_ = 0;
  std::vector<uint8_t> bytes_;
  std::exception_ptr failure_;
  std::thread thread_;  // last: it starts when everything else is there
};

class PageStream {
 public:
  PageStream(std::span<sample::Character> characters, double bytes_per_second);

  /// Lets simulated time pass and supplies the pages that have arrived by then.
  /// wanted   per character, the level it would like
  /// wait     for the disk too, so that the same calls give the same pictures; otherwise a late page comes later
  void advance(double seconds, std::span<const uint32_t> wanted, bool wait);

  uint64_t bytesStreamed() const { return bytes_streamed_; }

 private:
  bool startNext(std::span<const uint32_t> wanted);
  void supply(const std::vector<uint8_t>& bytes);

  std::span<sample::Character> characters_;
  double bytes_per_second_;
  double now_ = 0, arrival_ = 0;  ///< simulated seconds
  size_t coming_for_ = 0;         ///< the character the page in flight belongs to
  lithe_request coming_{};
  bool in_flight_ = false;
  uint64_t bytes_streamed_ = 0;
  PageReader reader_;
};
