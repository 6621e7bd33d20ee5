# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""The fan of a node and the ring that its far edges form (docs/format.md, section 4.1)."""

CLOSED, OPEN, IRREGULAR = "closed", "open", "irregular"
MAX_RING = 64


class Spoke:
    """One corner of the fan: its wedge, and wedge and node of the face's two other corners."""

    def __init__(self, hierarchy, corner):
        face = hierarchy.faces[corner // 3]
        position = corner % 3
        self.corner = corner
        self.wedge = face[position]
        self.next_wedge, self.previous_wedge = face[(position + 1) % 3], face[(position + 2) % 3]
        self.next = hierarchy.wedges[self.next_wedge].node
        self.previous = hierarchy.wedges[self.previous_wedge].node

    def neighbours(self):
        return (self.next, self.next_wedge), (self.previous, self.previous_wedge)


class Fan:
    """A node's spokes in ascending order of their corners, and the ring: `order` lists the spokes by edge number."""

    def __init__(self, hierarchy, node):
        self.spokes = [Spoke(hierarchy, corner) for corner in hierarchy.nodes[node].corners]
        self.kind, self.order = find_ring(self.spokes)

    def vertices(self):
        """The ring's vertices in the order of their numbers, as nodes."""
        vertices = [self.spokes[index].next for index in self.order]
        return vertices + [self.spokes[self.order[-1]].previous] if self.kind == OPEN else vertices

    def neighbours(self):
        """The different next and previous nodes, ascending."""
        return sorted({node for spoke in self.spokes for node in (spoke.next, spoke.previous)})


def find_ring(spokes):
    """The kind of the ring and its edges in order, as indices of spokes."""
    starts = {spoke.next: index for index, spoke in enumerate(spokes)}
    ends = {spoke.previous for spoke in spokes}
    if not 1 <= len(spokes) <= MAX_RING or len(starts) < len(spokes) or len(ends) < len(spokes):
        return IRREGULAR, []
    free = [index for index, spoke in enumerate(spokes) if spoke.next not in ends]
    kind = OPEN if free else CLOSED
    order = [free[0] if free else 0]
    while len(order) < len(spokes):
        following = starts.get(spokes[order[-1]].previous)
        if following is None or following == order[0]:
            return IRREGULAR, []
        order.append(following)
    return kind, order
