/* SPDX-FileCopyrightText: 2026 the lithe authors
 * SPDX-License-Identifier: MIT
 * The smallest C program that proves the library is linked: it refuses bytes that are no character. */
#include <lithe/runtime.h>
#include <stdio.h>

int main(void) {
  const unsigned char bytes[LITHE_PEEK_BYTES] = {1, 2, 3};
  uint64_t head_bytes = 0;
  const lithe_result result = lithe_peek(bytes, sizeof bytes, &head_bytes);
  printf("%u %s\n", (unsigned)lithe_version(), lithe_result_name(result));
  return result == LITHE_ERROR_NOT_THIS_FORMAT ? 0 : 1;
}
