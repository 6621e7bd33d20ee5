# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""Where a node most likely lies among its children (docs/format.md, section 4.3, T and Q)."""
from integers import between, cross, dot, held, inverse, largest, minus, reduced, six_sums

LIMIT = 1 << 17


class Placement:
    """Planes of the children's faces, summed up; then `t`, the likely eighth, and `index`, the likely lattice index."""

    def __init__(self, d, extent):
        self.shift = max(0, max(extent, largest(d)).bit_length() - 9)
        middle = tuple(between(value, 4) for value in d)
        self.d = self.shortened(d)
        self.children = self.shortened(minus(d, middle)), self.shortened(tuple(-value for value in middle))
        self.normals, self.distances = [], [0, 0, 0]

    def shortened(self, vector):
        return tuple(value >> self.shift for value in vector)

    def add(self, first, second, third):
        """A triangle; places are children or shortened."""
        n = cross(minus(second, first), minus(third, first))
        self.normals.append(n)
        self.distances = [value + along * dot(n, first) for value, along in zip(self.distances, n)]

    def solve(self):
        """Sets t, q and den."""
        cofactors, determinant, lost = inverse(six_sums(self.normals), 13, 8)
        m = [value >> lost for value in self.distances]
        self.q, reduction = reduced([dot(row, m) for row in cofactors])
        self.den = determinant >> reduction
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
