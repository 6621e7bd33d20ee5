# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""Integer vectors, and predictions from slopes (docs/format.md, section 4.3).

Python's // and >> round towards minus infinity, as the conventions of docs/format.md say.
"""

PREDICTION_LIMIT = 1 << 17


def plus(a, b):
    return tuple(x + y for x, y in zip(a, b))


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def largest(vector):
    return max(abs(value) for value in vector)


def sign(value):
    """sign(0) = 1."""
    return -1 if value < 0 else 1


def held(value, low, high):
    return min(high, max(low, value))


def predicted(strength, numerator, denominator):
    """P(l, num / den)."""
    if denominator <= 0:
        return 0
    return held(strength * numerator // (16 * denominator), -PREDICTION_LIMIT, PREDICTION_LIMIT)


def between(d, eighths):
    """How far a parent lies from B on the way to A."""
    return (eighths * d + 4) >> 3


def low_bits(value, bias):
    """min(15, max(0, bits(value) - bias))."""
    return held(value.bit_length() - bias, 0, 15)


def main_axis(vector):
    """The axis in which |vector| is greatest, the first of those that tie, and the two others in order."""
    axis = max(range(3), key=lambda i: (abs(vector[i]), -i))
    return axis, *(i for i in range(3) if i != axis)


def from_plane(normal, in_plane, height):
    """The vector with the two components `in_plane` in the plane of `normal` and the given height over it."""
    m, a, b = main_axis(normal)
    vector = [0, 0, 0]
    vector[a], vector[b] = in_plane
    rest = 0
    if normal[m]:
        turn = sign(normal[m])
        rest = turn * (normal[a] * vector[a] + normal[b] * vector[b]) // (turn * normal[m])
    vector[m] = height - rest
    return tuple(vector)
