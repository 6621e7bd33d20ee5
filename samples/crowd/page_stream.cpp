// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "page_stream.h"

#include <utility>

#include "error.h"

PageReader::PageReader() : thread_([this] { run(); }) {}

PageReader::~PageReader() {
  {
    const std::lock_guard lock(mutex_);
    state_ = State::kEnding;
  }
  changed_.notify_all();
  thread_.join();
}

void PageReader::start(const std::filesystem::path& path, uint64_t offset, size_t size) {
  {
    const std::lock_guard lock(mutex_);
    path_ = path;
    offset_ = offset;
    size_ = size;
    state_ = State::kAsked;
  }
  changed_.notify_all();
}

std::optional<std::vector<uint8_t>> PageReader::take(bool wait) {
  std::unique_lock lock(mutex_);
  if (wait) changed_.wait(lock, [this] { return state_ != State::kAsked; });
  if (state_ != State::kDone) return std::nullopt;
  state_ = State::kIdle;
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
  return std::move(bytes_);
}

void PageReader::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return state_ == State::kAsked || state_ == State::kEnding; });
    if (state_ == State::kEnding) return;
    lock.unlock();
    // Nobody else touches the request and its answer until the state says that it is done.
    try {
      bytes_ = sample::readBytes(path_, offset_, size_);
    } catch (...) {
      failure_ = std::current_exception();
    }
    lock.lock();
    if (state_ == State::kEnding) return;
    state_ = State::kDone;
    changed_.notify_all();
  }
}

PageStream::PageStream(std::span<sample::Character> characters, double bytes_per_second)
    : characters_(characters), bytes_per_second_(bytes_per_second) {}

/// Characters with the fewest levels come first, so that nobody stays coarse because of somebody else.
bool PageStream::startNext(std::span<const uint32_t> wanted) {
  uint32_t fewest = LITHE_NO_LEVEL;
  for (size_t i = 0; i < characters_.size(); ++i) {
    lithe_asset* asset = characters_[i].asset.get();
    const uint32_t levels = lithe_asset_resident_level(asset) + 1;  // LITHE_NO_LEVEL + 1 is 0
    lithe_request request{};
    if (levels >= fewest || lithe_asset_next_request(asset, wanted[i], &request) != LITHE_OK) continue;
    fewest = levels;
    coming_for_ = i;
    coming_ = request;
  }
  if (fewest == LITHE_NO_LEVEL) return false;
  reader_.start(characters_[coming_for_].path, coming_.offset, coming_.size);
  arrival_ += coming_.size / bytes_per_second_;
  in_flight_ = true;
  return true;
}

void PageStream::supply(const std::vector<uint8_t>& bytes) {
  const sample::Character& character = characters_[coming_for_];
  sample::check(lithe_asset_supply(character.asset.get(), coming_.page, bytes.data(), bytes.size(), nullptr),
                character.name + ", page " + std::to_string(coming_.page));
  bytes_streamed_ += bytes.size();
  in_flight_ = false;
}

void PageStream::advance(double seconds, std::span<const uint32_t> wanted, bool wait) {
  if (!in_flight_) arrival_ = now_;  // the link was idle: nothing has come over it since
  now_ += seconds;
  while (in_flight_ || startNext(wanted)) {
    if (arrival_ > now_) return;
    const std::optional<std::vector<uint8_t>> bytes = reader_.take(wait);
    if (!bytes) return;
    supply(*bytes);
  }
}
