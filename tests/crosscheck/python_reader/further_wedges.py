# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""The further wedges of a split's classes (docs/format.md, end of section 4.4's list)."""
from integers import cross, dot, minus, plus
from octahedron import Chart, rounded_point_of
from page_streams import EXTRA_MASKS, EXTRAS, LOW_EXTRAS
from refused import demand
from ring import MAX_RING, Spoke

MASK_NORMAL, MASK_TANGENT, MASK_UV, MASK_COLOR, MASK_END = 0, 1, 2, 10, 12


class FurtherReader:
    """Fills the records of the further wedges at a child."""

    def __init__(self, split, side):
        self.split, self.page, self.hierarchy, self.side = split, split.page, split.hierarchy, side
        self.layout, self.parameters = split.hierarchy.layout, split.page.parameters
        self.c = split.hierarchy.info.octahedron
        self.here = split.points[side]
        corners = split.hierarchy.nodes[split.children[side]].corners
        self.spokes = [Spoke(split.hierarchy, corner) for corner in corners] if len(corners) <= MAX_RING else []

    def read(self):
        for one in self.split.classes:
            for wedge in one.members[self.side][1:]:
                first = self.hierarchy.wedges[one.members[self.side][0]].record
                self.hierarchy.set_record(wedge, self.read_record(first, wedge))

    def values(self, count, low):
        return [self.page.split_value(LOW_EXTRAS, self.page.streams[EXTRAS].value(), low) for _ in range(count)]

    def read_record(self, first, wedge):
        mask = self.page.streams[EXTRA_MASKS].value()
        demand(mask < 1 << MASK_END, 69, "a mask names an attribute that does not exist")
        layout, record = self.layout, list(first)
        if mask >> MASK_NORMAL & 1 and layout.normal.stop > layout.normal.start:
            record[layout.normal] = self.turned(self.expected_normal(first, wedge), self.parameters.extra_normal_shift)
        if mask >> MASK_TANGENT & 1 and layout.hand.stop > layout.hand.start:
            record[layout.tangent] = self.turned(first[layout.tangent], self.parameters.extra_tangent_shift)
            record[layout.hand] = plus(first[layout.hand], self.values(1, 0))
        neighbour = self.nearest_neighbour(wedge)
        expected = first if neighbour is None else self.hierarchy.wedges[neighbour].record
        for at, entries in enumerate(layout.uvs):
            if mask >> MASK_UV + at & 1:
                record[entries] = plus(expected[entries], self.values(2, self.parameters.extra_uv_shift))
        for at, entries in enumerate(layout.colors):
            if mask >> MASK_COLOR + at & 1:
                record[entries] = plus(first[entries], self.values(4, 0))
        return record

    def turned(self, expected, low):
        chart = Chart(expected, self.c)
        point = plus(chart.enter(expected), self.values(2, low))
        demand(all(0 <= value <= 2 * self.c for value in point), 69, "a direction lies outside the square")
        return chart.leave(point)

    def expected_normal(self, first, wedge):
        normal, nodes = (0, 0, 0), self.hierarchy.nodes
        for spoke in self.spokes:
            if spoke.wedge == wedge:
                normal = plus(normal, cross(minus(nodes[spoke.next].position, self.here),
                                            minus(nodes[spoke.previous].position, self.here)))
        return rounded_point_of(normal, self.c) if any(normal) else first[self.layout.normal]

    def nearest_neighbour(self, wedge):
        others = [other for spoke in self.spokes if spoke.wedge == wedge for other in spoke.neighbours()]
        known = [other for other in others if self.is_known(*other, wedge)]
        return min(known, key=self.nearness)[1] if known else None

    def nearness(self, other):
        node, wedge = other
        way = minus(self.hierarchy.nodes[node].position, self.here)
        return dot(way, way), wedge

    def is_known(self, node, wedge, further):
        if node not in self.split.children or wedge < further:
            return True
        side = self.split.children.index(node)
        return any(one.members[side][:1] == [wedge] for one in self.split.classes)
