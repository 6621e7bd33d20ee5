# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""What a renderer gets: vertices and indices (docs/format.md, section 5), in the layout of `dump_buffers.cpp`."""
import struct

from f32 import f32, root
from octahedron import direction_of

MAX_INFLUENCES = 8


def unit_of(point, c):
    """The unit vector of an octahedral point."""
    direction = direction_of(point, c)
    length = root(f32(sum(value * value for value in direction)))
    return [f32(value / length) for value in direction]


class VertexWriter:
    """Vertices as bytes: position 3 f32, joints 8 u16, weights 8 f32, normal 3 f32, tangent 4 f32, uvs 2 f32 each,
    colours 4 f32 each; what the asset lacks is left out."""

    def __init__(self, decoded):
        self.file, self.hierarchy = decoded.file, decoded.hierarchy
        self.info, self.layout = decoded.file.info, decoded.hierarchy.layout

    def vertex(self, wedge):
        values = self.position(self.hierarchy.nodes[wedge.node].position)
        weights = self.weights(self.hierarchy.nodes[wedge.node].skin)
        joints = [joint for joint, _ in self.hierarchy.nodes[wedge.node].skin]
        joints += [0] * (MAX_INFLUENCES - len(joints))
        attributes = self.directions(wedge.record) + self.uvs(wedge) + self.colors(wedge.record)
        return struct.pack(f"<3f8H8f{len(attributes)}f", *values, *joints, *weights, *attributes)

    def position(self, grid):
        return [f32(origin + f32(self.info.grid_step * value)) for origin, value in zip(self.info.grid_origin, grid)]

    def weights(self, skin):
        return [f32(weight / self.info.one) for _, weight in skin] + [0.0] * (MAX_INFLUENCES - len(skin))

    def directions(self, record):
        values = []
        if self.info.has_normals:
            values += unit_of(record[self.layout.normal], self.info.octahedron)
        if self.info.has_tangents:
            values += unit_of(record[self.layout.tangent], self.info.octahedron)
            values.append(1.0 if record[self.layout.hand][0] else -1.0)
        return values

    def uvs(self, wedge):
        values = []
        for entries, (offset_u, offset_v, scale) in zip(self.layout.uvs, self.file.uv_grids[wedge.part]):
            u, v = wedge.record[entries]
            values += [f32(offset_u + f32(scale * u)), f32(offset_v + f32(scale * v))]
        return values

    def colors(self, record):
        return [f32(value / 255) for entries in self.layout.colors for value in record[entries]]


def vertex_bytes(decoded):
    """All vertices that have been decoded; a level's are the first ones."""
    writer = VertexWriter(decoded)
    return b"".join(writer.vertex(wedge) for wedge in decoded.hierarchy.wedges)


def index_bytes(decoded, level):
    indices = [wedge for triangle in decoded.triangles(level) for wedge in triangle]
    return struct.pack(f"<{len(indices)}I", *indices)


def range_bytes(decoded, level):
    """First index and number of indices of each part."""
    counts = [0] * len(decoded.file.parts)
    for triangle in decoded.triangles(level):
        counts[decoded.hierarchy.wedges[triangle[0]].part] += 3
    ranges = [value for part, count in enumerate(counts) for value in (sum(counts[:part]), count)]
    return struct.pack(f"<{len(ranges)}I", *ranges)


def morph_source_bytes(decoded, level):
    """The wedge of the level before that each wedge of this one came from."""
    wedges, end = decoded.hierarchy.wedges, decoded.levels[level - 1].wedge_count
    sources = []
    for index, wedge in enumerate(wedges[: decoded.levels[level].wedge_count]):
        sources.append(index if index < end else sources[wedge.parent])
    return struct.pack(f"<{len(sources)}I", *sources)
