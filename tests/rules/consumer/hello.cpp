// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The same from C++, with a header of the format beside it.
#include <lithe/format/placement.h>
#include <lithe/runtime.h>

#include <cstdio>

int main() {
  static_assert(lithe::format::eighths(8, 4) == 4);
  const unsigned char bytes[LITHE_PEEK_BYTES] = {1, 2, 3};
  uint64_t head_bytes = 0;
  const lithe_result result = lithe_peek(bytes, sizeof bytes, &head_bytes);
  std::printf("%u %s\n", static_cast<unsigned>(lithe_version()), lithe_result_name(result));
  return result == LITHE_ERROR_NOT_THIS_FORMAT ? 0 : 1;
}
