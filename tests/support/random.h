// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Random numbers that are the same with every compiler and library: SplitMix64 (Steele, Lea, Flood 2014).
#pragma once

#include <cmath>
#include <cstdint>

namespace lithe::test {

class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed) {}

  uint64_t next() {
    state_ += 0x9e3779b97f4a7c15u;
    uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  /// 0 .. bound - 1
  uint32_t below(uint32_t bound) { return static_cast<uint32_t>(next() % bound); }

  /// least .. most, both possible
  int32_t between(int32_t least, int32_t most) {
    return least + static_cast<int32_t>(below(static_cast<uint32_t>(most - least + 1)));
  }

  bool chance(uint32_t percent) { return below(100) < percent; }

  /// [0, 1)
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

  /// 1 .. most, with every octave equally likely
  uint32_t octave(uint32_t most) { return static_cast<uint32_t>(std::exp2(unit() * std::log2(most + 0.999))); }

 private:
  uint64_t state_;
};

}  // namespace lithe::test
