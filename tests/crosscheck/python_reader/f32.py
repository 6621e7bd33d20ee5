# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""IEEE binary32 out of Python's binary64. A sum, product, quotient or root of f32 in f64, rounded once more, is what
f32 arithmetic gives: that takes 2 * 24 + 2 bits, and f64 has 53."""
import math
import struct


PACKER = struct.Struct("<f")


def f32(value):
    """The nearest f32."""
    try:
        return PACKER.unpack(PACKER.pack(value))[0]
    except OverflowError:
        return math.copysign(math.inf, value)


def root(value):
    return f32(math.sqrt(value))
