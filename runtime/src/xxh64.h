// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// XXH64, the checksum of a file's head and pages, as specified in Collet's "xxHash fast digest algorithm", version
/// 0.1.1.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace lithe::runtime {

/// The XXH64 of size bytes. Same result on every platform; bytes needs no alignment and may be null when size is zero.
uint64_t xxh64(const void* bytes, size_t size, uint64_t seed = 0);

}  // namespace lithe::runtime
