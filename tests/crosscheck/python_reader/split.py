# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""One split: sides of its fan, positions of its children, new faces (docs/format.md, sections 4.1 to 4.3)."""
from attribute_split import read_attributes, split_wedges
from integers import between, cross, from_plane, largest, low_bits, main_axis, minus, plus, predicted
from page_streams import CUT_3, CUT_9, CUT_OPEN, GENERAL, LOW_POSITIONS, SPLIT
from picks import Picks
from placement import Placement, eighth_of_rank
from refused import demand
from ring import CLOSED, IRREGULAR, MAX_RING, OPEN, Fan
from skin_split import split_skin
from slope import RingSlope

A, B = 0, 1
MAX_PREDICTED_WEDGES = 8


class NewFace:
    """A face (first child, c, other child)."""

    def __init__(self, first, c):
        self.first, self.c = first, c


class Split:
    """What is known of the split of node `index` while it is read from `page`."""

    def __init__(self, hierarchy, page, index, entry):
        self.hierarchy, self.page, self.entry = hierarchy, page, entry
        self.node = hierarchy.nodes[index]
        self.fan = Fan(hierarchy, index)
        size = max(len(self.fan.spokes), len(self.node.wedges))
        demand(size <= entry.max_fan, 81, "a node's fan or wedges exceed max_fan")
        self.ring_nodes = [node for spoke in self.fan.spokes for node, _ in spoke.neighbours()]
        in_order = [self.fan.spokes[at] for at in self.fan.order] or self.fan.spokes
        self.ordered_nodes = [node for spoke in in_order for node, _ in spoke.neighbours()]
        self.ring_positions = [hierarchy.nodes[node].position for node in self.ring_nodes]
        self.extent = self.measure_extent()
        self.predicts_skins = len(self.fan.spokes) <= MAX_RING
        self.predicts_attributes = self.predicts_skins and len(self.node.wedges) <= MAX_PREDICTED_WEDGES
        self.all_slope = None

    def measure_extent(self):
        points = [self.node.position, *self.ring_positions]
        return max(max(values) - min(values) for values in zip(*points))

    def skin_slope(self):
        """The slope over all of the fan's corners."""
        if self.all_slope is None:
            self.all_slope = RingSlope(self.node.position, self.ring_positions, self.extent, self.d)
        return self.all_slope

    def carry_out(self):
        """Reads everything and adds the children, their wedges and faces."""
        rank, *rest = self.page.streams[SPLIT].row()
        demand(rank <= 8, 72, "the rank of t8 is out of range")
        self.read_sides()
        self.place(rank, rest[:3], rest[3:])
        hierarchy = self.hierarchy
        self.children = [hierarchy.add_node(point, [], 73) for point in self.points]
        self.node.children = tuple(self.children)
        self.classes = split_wedges(self)
        room = self.entry.face_count - len(hierarchy.faces)
        demand(len(self.new_faces) <= room, 82, "there are more faces than the page's")
        self.picks = Picks(self)
        self.picks.move_fan(range(len(self.sides)) if self.is_listed else self.fan.order)
        for face in self.new_faces:
            self.picks.add_face(face)
        for face in self.listed_faces():
            self.picks.add_face(face)
        read_attributes(self)
        for child, skin in zip(self.children, split_skin(self.page, self)):
            hierarchy.nodes[child].skin = skin

    # Section 4.2

    def read_sides(self):
        """The side of each spoke, and the new faces of a ring."""
        self.new_faces, self.listed_count = [], 0
        value = self.cut_value()
        self.is_listed = value == 0
        if self.is_listed:
            self.read_list()
        elif self.fan.kind == CLOSED:
            self.cut_between(*self.counted_from_farthest(self.pair(value - 1)))
        elif value <= len(self.fan.vertices()):
            self.cut_at(value - 1)
        else:
            self.cut_between(*self.pair(value - 1 - len(self.fan.vertices())))

    def cut_value(self):
        if self.fan.kind == IRREGULAR:
            return 0
        edges = len(self.fan.order)
        stream = CUT_OPEN if self.fan.kind == OPEN else min(CUT_9, CUT_3 + max(0, edges - 3))
        return self.page.streams[stream].value()

    def counted_from_farthest(self, pair):
        """The numbers in the ring of two vertices that were counted from the farthest, the lower first."""
        ways = [largest(minus(self.hierarchy.nodes[node].position, self.node.position)) for node in self.fan.vertices()]
        return sorted((number + ways.index(max(ways))) % len(ways) for number in pair)

    def pair(self, number):
        q = 1
        while q * (q + 1) // 2 <= number:
            q += 1
            demand(q < len(self.fan.vertices()), 74, "a pair is not in the ring")
        demand(q < len(self.fan.vertices()), 74, "a pair is not in the ring")
        return number - q * (q - 1) // 2, q

    def ring_face(self, first, vertex):
        self.new_faces.append(NewFace(first, self.fan.vertices()[vertex]))

    def set_sides(self, is_at_a):
        self.sides = [B] * len(self.fan.spokes)
        for edge, spoke in enumerate(self.fan.order):
            self.sides[spoke] = A if is_at_a(edge) else B

    def cut_at(self, p):
        self.set_sides(lambda edge: edge < p)
        self.ring_face(A, p)

    def cut_between(self, p, q):
        if p == 0 and self.fan.kind == CLOSED:
            self.set_sides(lambda edge: edge < q)
            self.ring_face(B, 0)
            self.ring_face(A, q)
        else:
            self.set_sides(lambda edge: not p <= edge < q)
            self.ring_face(A, p)
            self.ring_face(B, q)

    def read_list(self):
        general = self.page.streams[GENERAL]
        self.sides = [A] * len(self.fan.spokes)
        at = -1
        for _ in range(general.value()):
            at += general.value() + 1
            demand(at < len(self.sides), 75, "a list names corners beyond the fan")
            self.sides[at] = B
        self.listed_count = general.value()
        room = self.entry.face_count - len(self.hierarchy.faces)
        demand(self.listed_count <= room, 75, "a list has more faces than the page")

    def listed_faces(self):
        """The faces of a list, read one at a time as they are added."""
        general, neighbours = self.page.streams[GENERAL], self.fan.neighbours()
        for _ in range(self.listed_count):
            first, rank = general.value(), general.value()
            demand(first in (A, B) and rank <= len(neighbours), 75, "a rank or an orientation is out of range")
            yield NewFace(first, neighbours[rank - 1] if rank else self.stated_node())

    def stated_node(self):
        high, low = (self.page.streams[GENERAL].value() for _ in range(2))
        demand(max(high, low) < 1 << 16, 75, "a node's number has too many bits")
        return high << 16 | low

    def makes_faces(self):
        return len(self.new_faces) + self.listed_count > 0

    # Section 4.3

    def side_sums(self, side):
        """S and N of one side."""
        points = [point for at, point in enumerate(self.ring_positions) if self.sides[at // 2] == side]
        return tuple(map(sum, zip(*points))) if points else (0, 0, 0), len(points)

    def area_normal(self):
        normal = (0, 0, 0)
        for following, previous in zip(self.ring_positions[::2], self.ring_positions[1::2]):
            normal = plus(normal, cross(minus(following, self.node.position), minus(previous, self.node.position)))
        return normal

    def mean_edge(self):
        lengths = [largest(minus(following, self.node.position)) for following in self.ring_positions[::2]]
        return sum(lengths) // len(lengths) if lengths else 0

    def read_d(self, position):
        parameters, page = self.page.parameters, self.page
        edge = self.mean_edge()
        in_plane = [page.split_value(LOW_POSITIONS, high, low_bits(edge, parameters.position_bias))
                    for high in position[:2]]
        height = page.split_value(LOW_POSITIONS, position[2], low_bits(edge, parameters.height_bias))
        demand(largest(in_plane) < 1 << 18, 73, "R is too large")
        (sum_a, count_a), (sum_b, count_b) = self.side_sums(A), self.side_sums(B)
        prediction = [predicted(parameters.position_mean, a * count_b - b * count_a, count_a * count_b)
                      for a, b in zip(sum_a, sum_b)]
        return plus(from_plane(self.area_normal(), in_plane, height), prediction)

    def likely_placement(self):
        """None with too many corners."""
        if len(self.fan.spokes) > MAX_RING:
            return None
        placement = Placement(self.d, self.extent)
        places = [placement.shortened(minus(point, self.node.position)) for point in self.ring_positions]
        for side, following, previous in zip(self.sides, places[::2], places[1::2]):
            placement.add(placement.children[side], following, previous)
        for face in self.new_faces:
            c = placement.shortened(minus(self.hierarchy.nodes[face.c].position, self.node.position))
            placement.add(placement.children[face.first], c, placement.children[1 - face.first])
        placement.solve()
        return placement

    def place(self, rank, lattice, position):
        """D, t8 and the children's positions."""
        self.d = self.read_d(position)
        demand(largest(self.d) < self.hierarchy.info.grid_size, 73, "D is beyond the grid")
        length = largest(self.d) >> self.hierarchy.info.placement_shift
        step = 1 << max(0, length.bit_length() - 1)
        likely = self.likely_placement()
        self.t8 = eighth_of_rank(rank, likely.t if likely else 4)
        in_plane = lattice[:2]
        if likely:
            axes = main_axis(self.d)[1:]
            in_plane = [value + likely.index(axis, self.page.parameters.placement, step)
                        for value, axis in zip(in_plane, axes)]
        k = from_plane(self.d, in_plane, lattice[2])
        b = tuple(w - factor * step - between(d, self.t8) for w, factor, d in zip(self.node.position, k, self.d))
        self.points = plus(b, self.d), b
