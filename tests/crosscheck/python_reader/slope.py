# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""How an entry changes over the ring, as a least squares slope (docs/format.md, section 4.4, Slope over the ring)."""
from integers import dot, inverse, largest, minus, reduced, six_sums


class RingSlope:
    """The plane that fits the neighbours best, along the way from B to A. Its matrix serves all entries."""

    def __init__(self, position, neighbours, extent, d):
        """position    of the parent
        neighbours  positions, repeated as often as they are neighbours
        extent, d   of section 4.3"""
        shift = max(0, max(extent, largest(d)).bit_length() - 10)
        self.offsets = [tuple(value >> shift for value in minus(other, position)) for other in neighbours]
        cofactors, determinant, lost = inverse(six_sums(self.offsets), 17, 6)
        along = tuple(value >> shift for value in d)
        self.weights, reduction = reduced([dot(row, along) for row in cofactors])
        raised = lost - reduction
        self.denominator = determinant << raised if raised > 0 else determinant >> -raised

    def of(self, differences):
        """num and den of the slope; `differences` are the neighbours' entries less the parent's."""
        m = tuple(sum(r[axis] * e for r, e in zip(self.offsets, differences)) for axis in range(3))
        return dot(self.weights, m), self.denominator
