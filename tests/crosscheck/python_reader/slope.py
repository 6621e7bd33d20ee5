# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""How an entry changes over the ring, as a least squares slope (docs/format.md, section 4.4, Slope over the ring)."""
from integers import dot, largest, minus


class RingSlope:
    """The plane that fits the neighbours best, along the way from B to A. Its matrix serves all entries."""

    def __init__(self, position, neighbours, extent, d):
        """position    of the parent
        neighbours  positions, repeated as often as they are neighbours
        extent, d   of section 4.3"""
        shift = max(0, max(extent, largest(d)).bit_length() - 10)
        self.offsets = [tuple(value >> shift for value in minus(other, position)) for other in neighbours]
        xx, yy, zz, xy, xz, yz = self.regular_sums()
        cofactors = ((yy * zz - yz * yz, xz * yz - xy * zz, xy * yz - xz * yy),
                     (xz * yz - xy * zz, xx * zz - xz * xz, xy * xz - xx * yz),
                     (xy * yz - xz * yy, xy * xz - xx * yz, xx * yy - xy * xy))
        along = tuple(value >> shift for value in d)
        weights = tuple(dot(row, along) for row in cofactors)
        reduction = max(0, largest(weights).bit_length() - 22)
        self.weights = tuple(value >> reduction for value in weights)
        denominator = dot((xx, xy, xz), cofactors[0])
        raised = self.sum_shift - reduction
        self.denominator = denominator << raised if raised > 0 else denominator >> -raised

    def regular_sums(self):
        """The six sums of M, shortened, with h on the diagonal."""
        pairs = (0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)
        sums = [sum(r[i] * r[j] for r in self.offsets) for i, j in pairs]
        trace = sum(sums[:3])
        self.sum_shift = max(0, trace.bit_length() - 17)
        h = (trace >> self.sum_shift >> 6) + 1
        return [(value >> self.sum_shift) + (h if at < 3 else 0) for at, value in enumerate(sums)]

    def of(self, differences):
        """num and den of the slope; `differences` are the neighbours' entries less the parent's."""
        m = tuple(sum(r[axis] * e for r, e in zip(self.offsets, differences)) for axis in range(3))
        return dot(self.weights, m), self.denominator
