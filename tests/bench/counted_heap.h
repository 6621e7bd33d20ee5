// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// How much the program has allocated with new: a program that calls one of these counts it from its start.
#pragma once

#include <cstdint>

namespace lithe::bench {

/// Begins a new peak at what is allocated now, and returns that.
uint64_t startPeak();

/// The most that has been allocated at once since startPeak().
uint64_t peakBytes();

}  // namespace lithe::bench
