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


def inverse(sums, bits, hold):
    """Cofactors and determinant of the six sums xx, yy, zz, xy, xz, yz with h on the diagonal, and how many bits they lost.

    bits  of the trace that are kept
    hold  h is the 2^hold-th part of the trace, and one
    """
    trace = sum(sums[:3])
    short = max(0, trace.bit_length() - bits)
    h = (trace >> short >> hold) + 1
    xx, yy, zz, xy, xz, yz = [(value >> short) + (h if at < 3 else 0) for at, value in enumerate(sums)]
    cofactors = ((yy * zz - yz * yz, xz * yz - xy * zz, xy * yz - xz * yy),
                 (xz * yz - xy * zz, xx * zz - xz * xz, xy * xz - xx * yz),
                 (xy * yz - xz * yy, xy * xz - xx * yz, xx * yy - xy * xy))
    return cofactors, dot((xx, xy, xz), cofactors[0]), short


def reduced(q):
    """A vector with at most 22 bits, and how many it lost."""
    reduction = max(0, largest(q).bit_length() - 22)
    return [value >> reduction for value in q], reduction


def six_sums(vectors):
    """Of the products of each vector with itself: xx, yy, zz, xy, xz, yz."""
    pairs = (0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)
    return [sum(v[i] * v[j] for v in vectors) for i, j in pairs]
