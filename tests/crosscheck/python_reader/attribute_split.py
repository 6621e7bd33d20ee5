# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""What the wedges of a split node become, and the children's attributes (docs/format.md, section 4.4)."""
from further_wedges import FurtherReader
from integers import between, cross, largest, low_bits, minus, plus, predicted
from octahedron import Chart, fold
from page_streams import (CLASSES_BOTH, CLASSES_NONE, CLASSES_ONE, COLORS, LOW_NORMALS, LOW_TANGENTS, LOW_UVS, NORMALS,
                          TANGENTS, UV_0)
from refused import demand
from slope import RingSlope

A, B = 0, 1
STATED = 90
CLASS_STREAMS = CLASSES_NONE, CLASSES_ONE, CLASSES_BOTH


class WedgeClass:
    """A wedge of the split node: how many wedges it becomes at A and B, and in the end their ids."""

    def __init__(self, split, index):
        self.index, self.wedge = index, split.hierarchy.wedges[index]
        self.spokes = [at for at, spoke in enumerate(split.fan.spokes) if spoke.wedge == index]
        self.counts = self.read_counts(split.page, {split.sides[at] for at in self.spokes})
        self.members = [], []

    def read_counts(self, page, sides):
        stream = page.streams[CLASS_STREAMS[len(sides)]]
        value = stream.value()
        demand(value <= STATED, 76, "a wedge class is unknown")
        if value == STATED:
            return stream.value(), stream.value()
        counts = numbered_pair(value)
        return counts[::-1] if sides == {B} else counts


def numbered_pair(value):
    """The pair of this number: by sum from 1 on, then by the second."""
    total = 1
    while value > total:
        value -= total + 1
        total += 1
    return total - value, value


def split_wedges(split):
    """Reads the classes, adds the wedges of both children, still without records, and returns the classes."""
    hierarchy = split.hierarchy
    classes = [WedgeClass(split, index) for index in split.node.wedges]
    totals = [sum(one.counts[side] for one in classes) for side in (A, B)]
    demand(min(totals) > 0, 76, "a child gets no wedge")
    demand(all(sum(one.counts) > 0 for one in classes), 76, "a wedge class is empty")
    room = split.entry.wedge_count - len(hierarchy.wedges)
    demand(sum(totals) <= room, 76, "there are more wedges than the page's")
    for side, child in enumerate(split.children):
        first = len(hierarchy.wedges)
        for one in classes:
            one.members[side].extend(
                hierarchy.add_wedge(child, one.wedge.part, None, one.index) for _ in range(one.counts[side]))
        hierarchy.nodes[child].wedges = range(first, len(hierarchy.wedges))
    return classes


def read_attributes(split):
    """The records of the children's wedges, once all corners are there: first ones, then further ones."""
    for one in split.classes:
        AttributeReader(split, one).read()
    for side in (A, B):
        FurtherReader(split, side).read()


class AttributeReader:
    """Fills the records of one class."""

    def __init__(self, split, wedge_class):
        self.split, self.page, self.target = split, split.page, wedge_class
        self.layout, self.parameters = split.hierarchy.layout, split.page.parameters
        self.parent = wedge_class.wedge.record
        self.c = split.hierarchy.info.octahedron
        self.ring_records = []
        self.slope = self.ring_slope() if split.predicts_attributes else None

    def ring_slope(self):
        split = self.split
        neighbours = [pair for at in self.target.spokes for pair in split.fan.spokes[at].neighbours()]
        positions = [split.hierarchy.nodes[node].position for node, _ in neighbours]
        self.ring_records = [split.hierarchy.wedges[wedge].record for _, wedge in neighbours]
        return RingSlope(split.node.position, positions, split.extent, split.d)

    def difference(self, kind, row, bias, strength, steps, greatest):
        """Two entries of D: `steps` are the neighbours' pairs less the parent's, none where nothing is predicted."""
        spread = max(map(largest, steps)) if steps else greatest >> 3
        d = [self.page.split_value(kind, high, low_bits(spread, bias)) for high in row]
        if steps:
            d = [value + predicted(strength, *self.slope.of([step[axis] for step in steps]))
                 for axis, value in enumerate(d)]
        return d

    def read(self):
        target, hierarchy = self.target, self.split.hierarchy
        records = self.read_pair() if all(target.counts) else (self.parent, self.parent)
        for side in (A, B):
            if target.counts[side]:
                hierarchy.set_record(target.members[side][0], records[side])

    # The first wedges of a class at both children

    def read_pair(self):
        a, b = [0] * self.layout.length, [0] * self.layout.length
        if self.layout.normal.stop > self.layout.normal.start:
            a[self.layout.normal], b[self.layout.normal] = self.read_normal()
        if self.layout.hand.stop > self.layout.hand.start:
            row = self.page.streams[TANGENTS].row()
            a[self.layout.tangent], b[self.layout.tangent] = self.read_tangent(row)
            hand = self.parent[self.layout.hand][0]
            demand(row[2] <= 3, 69, "flips are out of range")
            a[self.layout.hand], b[self.layout.hand] = [hand ^ row[2] >> 1], [hand ^ row[2] & 1]
        for uv_set, entries in enumerate(self.layout.uvs):
            a[entries], b[entries] = self.read_uv(uv_set, entries)
        for entries in self.layout.colors:
            a[entries], b[entries] = self.moved(self.parent[entries], self.page.streams[COLORS].row())
        return a, b

    def moved(self, parent, d):
        b = [value - between(difference, self.split.t8) for value, difference in zip(parent, d)]
        return plus(b, d), b

    def read_normal(self):
        chart = Chart(self.parent[self.layout.normal], self.c)
        geometry = self.geometry(chart)
        row = self.page.streams[NORMALS].row()
        d = self.chart_difference(LOW_NORMALS, chart, self.layout.normal, row, self.parameters.normal_bias,
                                  self.parameters.normal_gradient)
        d = [value + (self.parameters.normal_geometry * change >> 4) for value, change in zip(d, geometry)]
        return self.unfolded(chart, self.layout.normal, d)

    def read_tangent(self, row):
        chart = Chart(self.parent[self.layout.tangent], self.c)
        d = self.chart_difference(LOW_TANGENTS, chart, self.layout.tangent, row[:2], self.parameters.tangent_bias,
                                  self.parameters.tangent_gradient)
        return self.unfolded(chart, self.layout.tangent, d)

    def chart_difference(self, kind, chart, entries, row, bias, strength):
        """D of a normal or tangent in the parent's chart."""
        parent = chart.enter(self.parent[entries])
        steps = [minus(chart.enter(record[entries]), parent) for record in self.ring_records]
        return self.difference(kind, row, bias, strength, steps, 2 * self.c)

    def unfolded(self, chart, entries, d):
        """The points of A and B in the file's square."""
        demand(largest(d) <= 4 * self.c, 69, "D of a direction is too large")
        h = self.eighths(d)
        x = [value - between(difference, h) for value, difference in zip(chart.enter(self.parent[entries]), d)]
        points = fold(plus(x, d), self.c), fold(x, self.c)
        for point in points:
            demand(all(0 <= value <= 2 * self.c for value in point), 69, "a direction lies outside the square")
        return [chart.leave(point) for point in points]

    def eighths(self, d):
        """Where between B and A the parent's direction is."""
        if self.split.makes_faces() and 2 * (abs(d[0]) + abs(d[1])) <= 3 * self.c:
            return 4
        if self.split.t8 != 4:
            return 0 if self.split.t8 < 4 else 8
        return 0 if d[0] > 0 or d[0] == 0 and d[1] > 0 else 8

    def geometry(self, chart):
        """G: the difference of the area normals' points."""
        if not self.slope:
            return 0, 0
        g = minus(*(chart.of_normal(self.area_normal(side)) for side in (A, B)))
        return g if largest(g) <= self.c else (0, 0)

    def area_normal(self, side):
        """Of a child, over the corners at the parent wedge that go to it, and over the new faces of a ring."""
        split, nodes = self.split, self.split.hierarchy.nodes
        normal, here = (0, 0, 0), split.points[side]
        for at in self.target.spokes:
            if split.sides[at] == side:
                spoke = split.fan.spokes[at]
                normal = plus(normal, cross(minus(nodes[spoke.next].position, here),
                                            minus(nodes[spoke.previous].position, here)))
        for face in split.new_faces:
            x, y = split.points[face.first], split.points[1 - face.first]
            normal = plus(normal, cross(minus(nodes[face.c].position, x), minus(y, x)))
        return normal

    def read_uv(self, uv_set, entries):
        steps = [minus(record[entries], self.parent[entries]) for record in self.ring_records]
        d = self.difference(LOW_UVS, self.page.streams[UV_0 + uv_set].row(), self.parameters.uv_bias[uv_set],
                            self.parameters.uv_gradient[uv_set], steps, self.split.hierarchy.info.uv_greatest)
        return self.moved(self.parent[entries], d)
