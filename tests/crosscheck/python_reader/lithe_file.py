# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""What the head of a file says of its skeleton, parts, levels and pages (docs/format.md, sections INFO to NAME)."""
import math
from dataclasses import dataclass

from f32 import f32, root
from head_tables import Header, name_at, read_chunks, read_directory, read_names
from page_streams import most_values
from refused import demand
from xxh64 import xxh64

NONE, NONE_16, NONE_8 = 0xFFFFFFFF, 65535, 255
MAX_COUNT = 1 << 26
MAX_BASE_WEDGES = 1 << 17
MAX_FAN = 1 << 18
MAX_PAGE_BYTES = 64 << 20


def finite(values):
    return all(math.isfinite(value) for value in values)


class Info:
    """INFO's only record."""

    def __init__(self, record):
        self.grid_origin, self.grid_step = record[0:3], record[3]
        (self.position_bits, self.weight_bits, self.normal_bits, self.uv_bits, self.max_influences, self.uv_sets,
         self.color_sets, attributes, self.placement_shift) = record[4:13]
        self.node_count, self.wedge_count, self.face_count, self.rest_diagonal, self.posed_diagonal = record[13:18]
        self.grid_min, self.grid_max = record[18:21], record[21:24]
        self.check(attributes)
        self.has_normals, self.has_tangents = bool(attributes & 1), bool(attributes & 2)
        self.one = (1 << self.weight_bits) - 1
        self.octahedron = (1 << (self.normal_bits - 1)) - 1
        self.uv_greatest = (1 << self.uv_bits) - 1
        self.grid_size = 1 << self.position_bits

    def check(self, attributes):
        bits_fit = (8 <= self.position_bits <= 16 and 4 <= self.weight_bits <= 16 and 4 <= self.normal_bits <= 15
                    and 4 <= self.uv_bits <= 16)
        demand(bits_fit, 12, "a quantisation field is out of its range")
        sets_fit = 1 <= self.max_influences <= 8 and self.uv_sets <= 8 and self.color_sets <= 2
        demand(sets_fit and attributes <= 3 and self.placement_shift <= 31, 13, "a field of INFO is out of its range")
        counts = self.node_count, self.wedge_count, self.face_count
        demand(self.node_count and self.wedge_count and max(counts) <= MAX_COUNT, 14, "a count is out of its range")
        lengths = self.grid_step, self.rest_diagonal, self.posed_diagonal
        demand(finite(self.grid_origin + lengths) and min(lengths) > 0, 15, "the grid or a diagonal is invalid")
        ordered = all(low <= high < 1 << self.position_bits for low, high in zip(self.grid_min, self.grid_max))
        demand(ordered, 15, "the box is not ordered")


def read_rotation(fields, form, check):
    """The unit quaternion, whole, of three components and the form, whose upper bits name the other (section NODE)."""
    demand(fields >> 63 == 0, check, "the highest bit of a rotation is not zero")
    kept = tuple(3 * ((fields >> 21 * i & 0x1FFFFF) - (1 << 20)) / (1 << 22) for i in range(3))
    x, y, z = (f32(value * value) for value in kept)
    demand(f32(f32(x + y) + z) <= 1, check, "a rotation is invalid")
    quaternion = list(kept)
    quaternion.insert(form >> 14, root(max(0.0, f32(f32(f32(1 - x) - y) - z))))
    return tuple(quaternion)


@dataclass
class SceneNode:
    """A record of NODE."""
    name: str
    parent: int
    translation: tuple
    rotation: tuple
    scale: tuple


@dataclass
class Joint:
    """A record of JOIN."""
    node: int
    box_min: tuple
    box_max: tuple
    translation: tuple
    rotation: tuple
    triangular: tuple


@dataclass
class Part:
    """A record of PART."""
    name: str
    material: int
    rigid_node: int


def read_nodes(records, triangulars, names):
    nodes = []
    for index, record in enumerate(records):
        parent, form, scale = record[1], record[2], record[2] & 0x3FFF
        demand(parent < index or parent == NONE_16, 17, "a node comes before its parent")
        demand(scale < len(triangulars) and not any(triangulars[scale][3:]), 17, "a node's scale is invalid")
        demand(finite(record[3:6]), 17, "a node's translation is not finite")
        nodes.append(SceneNode(name_at(names, record[0], 17), parent, record[3:6], read_rotation(record[6], form, 17),
                               triangulars[scale][:3]))
    return nodes


def read_joints(records, triangulars, node_count):
    joints = []
    for record in records:
        node, form = record[:2]
        demand(node < node_count and form & 0x3FFF < len(triangulars), 18, "a joint's node or form is invalid")
        demand(finite(record[8:11]), 18, "a joint's translation is not finite")
        for low, high in zip(record[2:5], record[5:8]):
            demand((low, high) == (NONE_8, 0) or low <= high, 18, "a joint's box is not ordered")
        joints.append(Joint(node, record[2:5], record[5:8], record[8:11], read_rotation(record[11], form, 18),
                            triangulars[form & 0x3FFF]))
    return joints


def read_parts(records, material_count, node_count, names):
    parts = []
    for name, material, rigid_node in records:
        demand(material < material_count or material == NONE, 20, "a part's material does not exist")
        demand(rigid_node < node_count or rigid_node == NONE, 20, "a part's node does not exist")
        parts.append(Part(name_at(names, name, 20), material, rigid_node))
    return parts


@dataclass
class Level:
    """A record of LEVL."""
    page_end: int
    node_count: int
    wedge_count: int
    face_count: int
    hidden_count: int
    error: float
    error_rms: float
    joint_count: int


@dataclass
class Page:
    """A record of PAGE, with where its bytes begin and the levels that end with it."""
    size: int
    level: int
    checksum: int
    node_count: int
    wedge_count: int
    face_count: int
    values: int
    max_fan: int
    offset: int = 0
    ending: range = range(0)

    def counts(self):
        return self.node_count, self.wedge_count, self.face_count


def check_levels(levels, info, page_count, joint_count):
    """Section LEVL."""
    for index, level in enumerate(levels):
        demand((level.page_end == 1) == (index == 0), 22, "level 0 alone ends with page 0")
        demand(level.node_count > 0 and level.wedge_count > 0, 22, "a level is empty")
        demand(level.hidden_count <= level.face_count and level.joint_count <= joint_count, 23, "a count is too large")
        errors = level.error, level.error_rms
        demand(finite(errors) and min(errors) >= 0, 23, "an error is invalid")
        if index == 0:
            continue
        before = levels[index - 1]
        grows = (level.page_end >= before.page_end and level.node_count > before.node_count
                 and level.wedge_count > before.wedge_count and level.face_count >= before.face_count)
        demand(grows, 22, f"level {index} does not grow")
        demand(level.error <= before.error, 23, "an error is greater than the level before")
    last = levels[-1]
    counts = last.node_count, last.wedge_count, last.face_count, last.page_end
    demand(counts == (info.node_count, info.wedge_count, info.face_count, page_count), 22, "the last level is not all")


def check_pages(pages, levels, info):
    """Section PAGE."""
    for index, page in enumerate(pages):
        demand(1 <= page.size <= MAX_PAGE_BYTES, 24, "a page's size is out of its range")
        first = next(k for k, level in enumerate(levels) if level.page_end > index)
        demand(page.level == first, 24, "a page's level is wrong")
        demand(page.max_fan <= MAX_FAN, 26, "max_fan of a page is too large")
        if index > 0:
            growth = [now - then for now, then in zip(page.counts(), pages[index - 1].counts())]
            demand(min(growth) >= 0 and growth[0] % 2 == 0, 25, "a page's counts shrink, or its nodes are not in pairs")
        most = most_values(info, page, pages[index - 1] if index else None)
        demand(page.values <= most, 26, "a page has more integers than its counts allow")
        if page.ending:
            finest = levels[page.ending[-1]]
            ends = finest.node_count, finest.wedge_count, finest.face_count
            demand(page.counts() == ends, 25, "a page's counts are not those of the level that ends with it")
    demand(pages[0].wedge_count <= MAX_BASE_WEDGES, 26, "page 0 has too many wedges")


class LitheFile:
    """A file whose head has passed its checks; its pages are there as bytes."""

    def __init__(self, data):
        self.data = data
        self.header = Header(data)
        chunks = read_chunks(data, read_directory(data, self.header))
        self.info = Info(chunks[b"INFO"][0])
        names = read_names(chunks[b"NAME"])
        triangulars = chunks[b"SCAL"]
        demand(finite(value for record in triangulars for value in record), 27, "SCAL: a number is not finite")
        self.nodes = read_nodes(chunks[b"NODE"], triangulars, names)
        self.joints = read_joints(chunks[b"JOIN"], triangulars, len(self.nodes))
        self.materials = [name_at(names, name, 19) for name, in chunks[b"MATL"]]
        self.parts = read_parts(chunks[b"PART"], len(self.materials), len(self.nodes), names)
        self.read_uv_grids(chunks[b"UVGR"])
        self.levels = [Level(*record) for record in chunks[b"LEVL"]]
        self.pages = [Page(*record) for record in chunks[b"PAGE"]]
        check_levels(self.levels, self.info, len(self.pages), len(self.joints))
        self.place_pages()
        check_pages(self.pages, self.levels, self.info)

    def read_uv_grids(self, records):
        sets = self.info.uv_sets
        demand(len(records) == len(self.parts) * sets, 21, "UVGR has another number of records than parts and sets")
        demand(finite(value for record in records for value in record), 21, "UVGR: a number is not finite")
        self.uv_grids = [records[part * sets : (part + 1) * sets] for part in range(len(self.parts))]

    def place_pages(self):
        offset = self.header.head_bytes
        for index, page in enumerate(self.pages):
            page.offset = offset
            offset += page.size
            ending = [k for k, level in enumerate(self.levels) if level.page_end == index + 1]
            page.ending = range(ending[0], ending[-1] + 1) if ending else range(0)
        demand(offset == self.header.file_bytes, 4, "file_bytes is not the head and the pages")

    def page_bytes(self, index):
        """A page's bytes, when they are all there and as they were."""
        page = self.pages[index]
        data = self.data[page.offset : page.offset + page.size]
        demand(len(data) == page.size, 60, f"page {index} is cut short")
        demand(xxh64(data) == page.checksum, 61, f"page {index}: the checksum differs")
        return data
