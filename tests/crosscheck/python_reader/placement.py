# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""Where a node most likely lies among its children (docs/format.md, section 4.3, T and Q)."""
from integers import between, cross, dot, held, largest, minus

LIMIT = 1 << 17


class Placement:
    """Planes of the children's faces, summed up; then `t`, the likely eighth, and `index`, the likely lattice index."""

    def __init__(self, d, extent):
        self.shift = max(0, max(extent, largest(d)).bit_length() - 9)
        middle = tuple(between(value, 4) for value in d)
        self.d = self.shortened(d)
        self.children = self.shortened(minus(d, middle)), self.shortened(tuple(-value for value in middle))
        self.planes = [[0] * 3 for _ in range(3)]
        self.distances = [0, 0, 0]

    def shortened(self, vector):
        return tuple(value >> self.shift for value in vector)

    def add(self, first, second, third):
        """A triangle; places are children or shortened."""
        n = cross(minus(second, first), minus(third, first))
        for i in range(3):
            self.distances[i] += n[i] * dot(n, first)
            for j in range(3):
                self.planes[i][j] += n[i] * n[j]

    def solve(self):
        """Sets t, q and den."""
        trace = sum(self.planes[i][i] for i in range(3))
        short = max(0, trace.bit_length() - 13)
        h = (trace >> short >> 8) + 1
        (xx, xy, xz), (_, yy, yz), (_, _, zz) = [
            [(value >> short) + (h if i == j else 0) for j, value in enumerate(row)] for i, row in enumerate(self.planes)]
        cofactors = ((yy * zz - yz * yz, xz * yz - xy * zz, xy * yz - xz * yy),
                     (xz * yz - xy * zz, xx * zz - xz * xz, xy * xz - xx * yz),
                     (xy * yz - xz * yy, xy * xz - xx * yz, xx * yy - xy * xy))
        m = [value >> short for value in self.distances]
        q = [dot(row, m) for row in cofactors]
        reduction = max(0, largest(q).bit_length() - 22)
        self.q = [value >> reduction for value in q]
        self.den = dot((xx, xy, xz), cofactors[0]) >> reduction
        self.t = 4
        length2 = dot(self.d, self.d)
        if self.den > 0 and length2 > 0:
            e = dot(self.q, self.d)
            self.t = held(4 + (16 * e + self.den * length2) // (2 * self.den * length2), 0, 8)
            self.q = [value - e * along // length2 for value, along in zip(self.q, self.d)]

    def index(self, axis, strength, step):
        if self.den <= 0:
            return 0
        unit = 16 * self.den * step
        return held(((2 * strength * self.q[axis] << self.shift) + unit) // (2 * unit), -LIMIT, LIMIT)


def eighth_of_rank(rank, t):
    return sorted(range(9), key=lambda eighth: (abs(eighth - t), -eighth))[rank]
