// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// What happens when a caller makes a mistake: LITHE_ASSERT(0) where the build defines it, then an error.
#pragma once

#include "lithe/runtime.h"

namespace lithe::runtime {

inline lithe_result invalidArgument() {
#ifdef LITHE_ASSERT
  LITHE_ASSERT(0);
#endif
  return LITHE_ERROR_INVALID_ARGUMENT;
}

}  // namespace lithe::runtime
