# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""Octahedral points, the chart of a parent, and what leaves the square (docs/format.md, end of section 4.4)."""
from integers import largest, sign


def direction_of(point, c):
    """The direction, with |x| + |y| + |z| = c, that a point of the square stands for."""
    x, y = point[0] - c, point[1] - c
    z = c - abs(x) - abs(y)
    if z < 0:
        x, y = sign(x) * (c - abs(y)), sign(y) * (c - abs(x))
    return x, y, z


def point_of(direction, c):
    """The other way."""
    x, y, z = direction
    if z < 0:
        x, y = sign(x) * (c - abs(y)), sign(y) * (c - abs(x))
    return c + x, c + y


def rounded_point_of(normal, c):
    """The point of a normal of any length."""
    length = sum(abs(value) for value in normal)
    if length == 0:
        return c, c
    p, q = ((2 * abs(value) * c + length) // (2 * length) for value in normal[:2])
    if normal[2] < 0:
        p, q = c - q, c - p
    return c + sign(normal[0]) * p, c + sign(normal[1]) * q


def fold(point, c):
    """Back into the square, through the edge that the point left by."""
    x, y = point
    s = 2 * c
    for _ in range(2):
        if x < 0:
            x, y = -x, s - y
        elif x > s:
            x, y = 2 * s - x, s - y
        if y < 0:
            x, y = s - x, -y
        elif y > s:
            x, y = s - x, 2 * s - y
    return x, y


class Chart:
    """The square whose pole is the axis that a parent's direction is nearest to."""

    def __init__(self, point, c):
        direction = direction_of(point, c)
        self.c = c
        self.pole = [abs(value) for value in direction].index(largest(direction))
        self.side = sign(direction[self.pole])
        self.u, self.v = (axis for axis in range(3) if axis != self.pole)

    def turned(self, vector):
        return vector[self.u], vector[self.v], self.side * vector[self.pole]

    def turned_back(self, vector):
        result = [0, 0, 0]
        result[self.u], result[self.v], result[self.pole] = vector[0], vector[1], self.side * vector[2]
        return tuple(result)

    def enter(self, point):
        """A point of the file's square in this chart."""
        return point_of(self.turned(direction_of(point, self.c)), self.c)

    def leave(self, point):
        return point_of(self.turned_back(direction_of(point, self.c)), self.c)

    def of_normal(self, normal):
        return rounded_point_of(self.turned(normal), self.c)
