// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/runtime.h"

namespace {

constexpr uint32_t kMajor = 0, kMinor = 1, kPatch = 0;

}  // namespace

const char* lithe_result_name(lithe_result result) {
  switch (result) {
    case LITHE_OK:
      return "LITHE_OK";
    case LITHE_PENDING:
      return "LITHE_PENDING";
    case LITHE_COMPLETE:
      return "LITHE_COMPLETE";
    case LITHE_ERROR_TRUNCATED:
      return "LITHE_ERROR_TRUNCATED";
    case LITHE_ERROR_NOT_THIS_FORMAT:
      return "LITHE_ERROR_NOT_THIS_FORMAT";
    case LITHE_ERROR_VERSION_TOO_NEW:
      return "LITHE_ERROR_VERSION_TOO_NEW";
    case LITHE_ERROR_CORRUPT:
      return "LITHE_ERROR_CORRUPT";
    case LITHE_ERROR_LIMIT:
      return "LITHE_ERROR_LIMIT";
    case LITHE_ERROR_INVALID_ARGUMENT:
      return "LITHE_ERROR_INVALID_ARGUMENT";
    case LITHE_ERROR_BUFFER_TOO_SMALL:
      return "LITHE_ERROR_BUFFER_TOO_SMALL";
    case LITHE_ERROR_NOT_RESIDENT:
      return "LITHE_ERROR_NOT_RESIDENT";
    case LITHE_ERROR_OUT_OF_MEMORY:
      return "LITHE_ERROR_OUT_OF_MEMORY";
  }
  return "unknown";
}

uint32_t lithe_version(void) { return kMajor * 10000 + kMinor * 100 + kPatch; }
