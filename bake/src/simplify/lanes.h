// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Eight floats at once, one pose in each: the compiler's vector type, and a plain array that specifies what it
// computes.
//
// Every operation is IEEE-exact and every sum over lanes has one fixed order, so both types give the same bits.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

// Compiles a kernel three times, plain, with AVX2 and with AVX-512's registers, chosen when the program starts;
// contraction is off, so the bits agree. clang refuses to return Lanes from what the clones inline.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define LITHE_KERNEL __attribute__((target_clones("arch=x86-64-v4", "avx2", "default")))
#else
#define LITHE_KERNEL
#endif
#define LITHE_INLINE inline __attribute__((always_inline))

namespace lithe::bake {

inline constexpr uint32_t kLanes = 8;

using Lanes = float __attribute__((vector_size(32)));

/// The specification of Lanes.
struct ScalarLanes {
  std::array<float, kLanes> lane{};

  float& operator[](uint32_t i) { return lane[i]; }
  float operator[](uint32_t i) const { return lane[i]; }

  template <class Op>
  static ScalarLanes each(const ScalarLanes& a, const ScalarLanes& b, Op op) {
    ScalarLanes result;
    for (uint32_t i = 0; i < kLanes; ++i) result.lane[i] = op(a.lane[i], b.lane[i]);
    return result;
  }
  static ScalarLanes all(float value) {
    ScalarLanes result;
    result.lane.fill(value);
    return result;
  }
  friend ScalarLanes operator+(const ScalarLanes& a, const ScalarLanes& b) {
    return each(a, b, [](float x, float y) { return x + y; });
  }
  friend ScalarLanes operator+(const ScalarLanes& a, float b) { return a + all(b); }
  friend ScalarLanes operator-(const ScalarLanes& a, const ScalarLanes& b) {
    return each(a, b, [](float x, float y) { return x - y; });
  }
  friend ScalarLanes operator*(const ScalarLanes& a, const ScalarLanes& b) {
    return each(a, b, [](float x, float y) { return x * y; });
  }
  friend ScalarLanes operator*(const ScalarLanes& a, float b) { return a * all(b); }
  friend ScalarLanes operator*(float a, const ScalarLanes& b) { return all(a) * b; }
  ScalarLanes operator-() const {
    return each(*this, *this, [](float x, float) { return -x; });
  }
  ScalarLanes& operator+=(const ScalarLanes& b) { return *this = *this + b; }
};

/// The lanes' sum in one fixed order.
template <class L>
LITHE_INLINE float laneSum(const L& x) {
  return ((x[0] + x[4]) + (x[2] + x[6])) + ((x[1] + x[5]) + (x[3] + x[7]));
}
#if defined(__SSE2__)
LITHE_INLINE float laneSum(const Lanes& x) {
  const __m128 low = __builtin_shufflevector(x, x, 0, 1, 2, 3), high = __builtin_shufflevector(x, x, 4, 5, 6, 7);
  const __m128 fours = _mm_add_ps(low, high);
  const __m128 pairs = _mm_add_ps(fours, _mm_movehl_ps(fours, fours));
  return _mm_cvtss_f32(_mm_add_ss(pairs, _mm_shuffle_ps(pairs, pairs, 1)));
}
#endif

inline constexpr float kVanishing = 1e-30f;  // squared doubled areas below this are no area (the posed diagonal is 1)

/// 1 / x where x > kVanishing, else 0.
LITHE_INLINE ScalarLanes positiveReciprocal(const ScalarLanes& x) {
  return ScalarLanes::each(x, x, [](float a, float) { return a > kVanishing ? 1.0f / a : 0.0f; });
}
LITHE_INLINE Lanes positiveReciprocal(const Lanes& x) {
  const auto mask = x > kVanishing;
  const Lanes quotient = 1.0f / x;
  decltype(x > kVanishing) bits;
  std::memcpy(&bits, &quotient, sizeof bits);
  bits &= mask;
  Lanes result;
  std::memcpy(&result, &bits, sizeof result);
  return result;
}

/// Square roots, correctly rounded.
LITHE_INLINE ScalarLanes squareRoot(const ScalarLanes& x) {
  return ScalarLanes::each(x, x, [](float a, float) { return std::sqrt(a); });
}
LITHE_INLINE Lanes squareRoot(const Lanes& x) {
#if defined(__SSE2__)
  // Taken apart and joined in registers: two halves that are stored and then loaded as one wait for the memory.
  const __m128 low = _mm_sqrt_ps(__builtin_shufflevector(x, x, 0, 1, 2, 3));
  const __m128 high = _mm_sqrt_ps(__builtin_shufflevector(x, x, 4, 5, 6, 7));
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
#else
  Lanes result = x;
  for (uint32_t i = 0; i < kLanes; ++i) result[i] = std::sqrt(x[i]);
  return result;
#endif
}

/// The lesser of each two lanes; b's where they cannot be compared.
LITHE_INLINE ScalarLanes lesser(const ScalarLanes& a, const ScalarLanes& b) {
  return ScalarLanes::each(a, b, [](float x, float y) { return x < y ? x : y; });
}
LITHE_INLINE Lanes lesser(const Lanes& a, const Lanes& b) { return a < b ? a : b; }

/// The greater of each two lanes; b's where they cannot be compared.
LITHE_INLINE ScalarLanes greater(const ScalarLanes& a, const ScalarLanes& b) {
  return ScalarLanes::each(a, b, [](float x, float y) { return x > y ? x : y; });
}
LITHE_INLINE Lanes greater(const Lanes& a, const Lanes& b) { return a > b ? a : b; }

/// a's lanes where the condition's are below zero, else b's.
LITHE_INLINE ScalarLanes whereNegative(const ScalarLanes& condition, const ScalarLanes& a, const ScalarLanes& b) {
  ScalarLanes result;
  for (uint32_t i = 0; i < kLanes; ++i) result[i] = condition[i] < 0.0f ? a[i] : b[i];
  return result;
}
LITHE_INLINE Lanes whereNegative(const Lanes& condition, const Lanes& a, const Lanes& b) {
  return condition < Lanes{} ? a : b;
}

/// How many lanes of a are less than b's.
LITHE_INLINE uint32_t countLess(const ScalarLanes& a, const ScalarLanes& b) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < kLanes; ++i) count += a[i] < b[i] ? 1 : 0;
  return count;
}
LITHE_INLINE uint32_t countLess(const Lanes& a, const Lanes& b) {
  const auto mask = a < b;
  int32_t count = 0;
  for (uint32_t i = 0; i < kLanes; ++i) count -= static_cast<int32_t>(mask[i]);
  return static_cast<uint32_t>(count);
}

// Without AVX compilers align Lanes to 16 bytes, but a kernel's AVX2 twin relies on 32: every struct of Lanes says so.
inline constexpr uint32_t kLanesAlignment = 32;

/// A point or a vector in eight poses.
template <class L>
struct alignas(kLanesAlignment) Vec3 {
  L x, y, z;
};

template <class L>
LITHE_INLINE Vec3<L> operator-(const Vec3<L>& a, const Vec3<L>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class L>
LITHE_INLINE L dot(const Vec3<L>& a, const Vec3<L>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class L>
LITHE_INLINE Vec3<L> cross(const Vec3<L>& a, const Vec3<L>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace lithe::bake
