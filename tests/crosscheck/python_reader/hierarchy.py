# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""What the pages build: nodes, wedges and faces, numbered as they appear (docs/format.md, section 1)."""
from dataclasses import dataclass, field

from refused import demand


@dataclass
class Node:
    """A vertex of some level. `corners` (3 * face + position) is kept ascending; `children` is set by its split."""
    position: tuple
    skin: list
    wedges: range = range(0)
    corners: list = field(default_factory=list)
    children: tuple = None


@dataclass
class Wedge:
    """A GPU vertex. Its record is that of section 3 (normal, tangent, uvs, colours); `parent` is where it came from."""
    node: int
    part: int
    record: tuple
    parent: int = None


class RecordLayout:
    """Which entries of a wedge's record are which attribute."""

    def __init__(self, info):
        self.length = 0
        self.normal = self.place(2 * info.has_normals)
        self.tangent = self.place(2 * info.has_tangents)
        self.hand = self.place(1 * info.has_tangents)
        self.uvs = [self.place(2) for _ in range(info.uv_sets)]
        self.colors = [self.place(4) for _ in range(info.color_sets)]
        self.limits = [2 * info.octahedron] * self.tangent.stop + [1] * (self.hand.stop - self.hand.start)
        self.limits += [(1 << info.uv_bits) - 1] * (2 * info.uv_sets) + [255] * (4 * info.color_sets)

    def place(self, entries):
        start = self.length
        self.length += entries
        return slice(start, self.length)


class Hierarchy:
    """Everything that has been decoded so far."""

    def __init__(self, info, part_count, joint_count):
        self.info = info
        self.layout = RecordLayout(info)
        self.part_count, self.joint_count = part_count, joint_count
        self.nodes, self.wedges, self.faces = [], [], []

    def counts(self):
        return len(self.nodes), len(self.wedges), len(self.faces)

    def add_node(self, position, skin, check):
        demand(all(0 <= value < self.info.grid_size for value in position), check, "a node lies outside the grid")
        self.nodes.append(Node(tuple(position), skin))
        return len(self.nodes) - 1

    def add_wedge(self, node, part, record, parent=None):
        """record  None: it is set later"""
        demand(part < self.part_count, 69, "a wedge's part does not exist")
        self.wedges.append(Wedge(node, part, None, parent))
        if record is not None:
            self.set_record(len(self.wedges) - 1, record)
        return len(self.wedges) - 1

    def set_record(self, wedge, record):
        self.check_record(record)
        self.wedges[wedge].record = tuple(record)

    def check_record(self, record):
        """Ranges of section INFO and of the records in section Streams."""
        sound = all(0 <= value <= limit for value, limit in zip(record, self.layout.limits))
        demand(sound, 69, "an attribute is out of its range")

    def add_face(self, wedges):
        """A face whose corners' wedges exist; its corners are noted at their nodes."""
        face = len(self.faces)
        self.faces.append(list(wedges))
        for position, wedge in enumerate(wedges):
            self.nodes[self.wedges[wedge].node].corners.append(3 * face + position)
        return face

    def check_skin(self, skin, check):
        """The influences of a node: sorted, each joint once, weights that sum to `one`."""
        joints = [joint for joint, _ in skin]
        weights = [weight for _, weight in skin]
        demand(1 <= len(skin) <= self.info.max_influences, check, "a node has too many influences")
        demand(max(joints) < self.joint_count and len(set(joints)) == len(joints), check, "a joint is invalid")
        demand(min(weights) > 0 and sum(weights) == self.info.one, check, "weights are invalid")
        demand(skin == sorted(skin, key=lambda influence: (-influence[1], influence[0])), check, "a skin is not sorted")
