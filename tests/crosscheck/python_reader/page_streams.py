# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""A page taken apart: kind, parameters, streams, low bits and hidden faces (docs/format.md, section 3)."""
from draco_cloud import read_cloud
from refused import demand

BASE, SPLITS = 0, 1
SIGNED, UNSIGNED = True, False
PARAMETER_BYTES = 30
MAX_SETS = 8
NODES, INFLUENCES, WEDGES, FACES = range(4)
(FLAGS_OLD, FLAGS_NEW, SPLIT, CUT_3, CUT_4, CUT_5, CUT_6, CUT_7, CUT_8, CUT_9, CUT_OPEN, GENERAL, CLASSES_BOTH,
 CLASSES_ONE, CLASSES_NONE, CLASS_PICKS, CLASS_CHOICES, MEMBER_PICKS, MEMBER_CHOICES, THIRD_PICKS, THIRD_CHOICES,
 NORMALS, TANGENTS, COLORS, SKIN_MODES_ALL, SKIN_MODES_MOST, SKIN_MODES_SOME, SKIN_MODES_NONE, SKIN_D, SKIN_E, SKIN_NEW,
 EXTRA_MASKS, EXTRAS, UV_0) = range(34)
MAX_LISTED_JOINTS = 24
LOW_POSITIONS, LOW_NORMALS, LOW_TANGENTS, LOW_UVS, LOW_SKINS, LOW_EXTRAS, LOW_KINDS = range(7)
MAX_LEVELS = 64
MAX_RECORDS = 1 << 24


class Parameters:
    """The strengths, biases and shifts of a page."""

    def __init__(self, data, info, kind):
        (self.position_mean, self.position_bias, self.height_bias, self.placement, self.normal_gradient,
         self.normal_geometry, self.normal_bias, self.tangent_gradient, self.tangent_bias, self.skin_gradient,
         self.skin_bias, self.extra_normal_shift, self.extra_tangent_shift, self.extra_uv_shift) = data[:14]
        self.uv_gradient, self.uv_bias = data[14:22], data[22:30]
        self.strengths = [self.position_mean, self.placement, self.normal_gradient, self.normal_geometry,
                          self.tangent_gradient, self.skin_gradient, *self.uv_gradient]
        self.check_ranges()
        self.check_absent(info)
        if kind == BASE:
            self.check_base()

    def check_ranges(self):
        biases = [self.position_bias, self.height_bias, self.normal_bias, self.tangent_bias, self.skin_bias,
                  *self.uv_bias]
        sound = max(self.strengths) <= 32 and max(biases) <= 31 and max(self.extra_shifts()) <= 15
        demand(sound, 63, "a parameter is out of its range")

    def extra_shifts(self):
        return self.extra_normal_shift, self.extra_tangent_shift, self.extra_uv_shift

    def check_absent(self, info):
        absent = [*self.uv_gradient[info.uv_sets :], *self.uv_bias[info.uv_sets :]]
        if not info.has_normals:
            absent += [self.normal_gradient, self.normal_geometry, self.normal_bias, self.extra_normal_shift]
        if not info.has_tangents:
            absent += [self.tangent_gradient, self.tangent_bias, self.extra_tangent_shift]
        if not info.uv_sets:
            absent += [self.extra_uv_shift]
        demand(not any(absent), 63, "a parameter of an attribute that the asset lacks is not 0")

    def check_base(self):
        zeros = [*self.strengths, self.height_bias, self.skin_bias, *self.extra_shifts()]
        demand(not any(zeros), 63, "a base page predicts")
        biases = self.position_bias, self.normal_bias, self.tangent_bias, *self.uv_bias
        demand(max(biases) <= 15, 63, "a parameter is out of its range")


def base_attributes(info):
    """Attributes of the base page's streams as (components, signed)."""
    wedge = [(1, UNSIGNED)]
    wedge += [(2, SIGNED)] * info.has_normals + [(3, SIGNED)] * info.has_tangents
    wedge += [(2, SIGNED)] * info.uv_sets + [(4, SIGNED)] * info.color_sets
    return [[(3, SIGNED), (1, UNSIGNED), (1, UNSIGNED)], [(1, UNSIGNED), (1, UNSIGNED)], wedge, [(3, SIGNED)]]


def split_attributes():
    """The same for split pages."""
    streams = [[(1, UNSIGNED)] for _ in range(UV_0)] + [[(2, SIGNED)] for _ in range(MAX_SETS)]
    streams[SPLIT] = [(1, UNSIGNED), (2, SIGNED), (1, SIGNED), (2, SIGNED), (1, SIGNED)]
    streams[NORMALS] = [(2, SIGNED)]
    streams[TANGENTS] = [(2, SIGNED), (1, UNSIGNED)]
    streams[COLORS] = [(4, SIGNED)]
    streams[SKIN_D] = streams[SKIN_E] = streams[EXTRAS] = [(1, SIGNED)]
    return streams


def base_limits(info, page):
    """The most records of each stream of a base page."""
    return [page.node_count, info.max_influences * page.node_count, page.wedge_count, page.face_count]


def record_length(info):
    return 2 * info.has_normals + 3 * info.has_tangents + 2 * info.uv_sets + 4 * info.color_sets


def split_limits(info, page, before, levels):
    """The same for split pages; `before` is the page before, `levels` how many end with the page."""
    splits = (page.node_count - before.node_count) // 2
    new_wedges = page.wedge_count - before.wedge_count
    picks = 32 * (splits + page.face_count)
    limits = [page.node_count * max(1, levels)] * 2 + [splits] * 9
    limits += [picks] + [2 * page.wedge_count] * 3 + [picks] * 6
    limits += [new_wedges * info.has_normals, new_wedges * info.has_tangents, new_wedges * info.color_sets]
    limits += [splits] * 4
    limits += [MAX_LISTED_JOINTS * splits] * 3 + [new_wedges, new_wedges * record_length(info)]
    return limits + [new_wedges * (uv_set < info.uv_sets) for uv_set in range(MAX_SETS)]


def most_values(info, page, before):
    """The most integers that a page's streams can have by the counts of the page table (section PAGE)."""
    if before is None:
        attributes, limits = base_attributes(info), base_limits(info, page)
    else:
        attributes, limits = split_attributes(), split_limits(info, page, before, MAX_LEVELS)
        # A wedge has its class in one stream only, and a corner its pick in one of two.
        for stream in (CLASSES_ONE, CLASSES_NONE, CLASS_CHOICES, MEMBER_CHOICES, THIRD_CHOICES):
            limits[stream] = 0
    return sum(limit * components_of(columns) for limit, columns in zip(limits, attributes))


def components_of(columns):
    return sum(components for components, _ in columns)


class PageReader:
    """Integers of a page's fixed part and tables."""

    def __init__(self, data):
        self.data, self.at = data, 0

    def varint(self, check):
        value, shift = 0, 0
        while True:
            demand(self.at < len(self.data), check, "a varint is cut short")
            byte = self.data[self.at]
            self.at += 1
            value |= (byte & 127) << shift
            shift += 7
            if byte < 128:
                break
        demand(value < 1 << 32 and (byte != 0 or shift == 7), check, "a varint is too large or too long")
        return value

    def take(self, count, check):
        demand(count <= len(self.data) - self.at, check, "bytes are missing")
        self.at += count
        return self.data[self.at - count : self.at]


class LowBits:
    """Fields of 0 to 15 bits, first field in the lowest bits of the first byte."""

    def __init__(self, data):
        self.pool, self.left, self.size = int.from_bytes(data, "little"), 8 * len(data), len(data)
        self.used = 0

    def field(self, bits):
        demand(bits <= self.left, 80, "the low bits are used up")
        value = self.pool & ((1 << bits) - 1)
        self.pool >>= bits
        self.left -= bits
        return value

    def demand_end(self):
        demand(self.left < 8 and self.pool == 0, 80, "low bits are left over")


class Stream:
    """Records that are read front to back."""

    def __init__(self, rows):
        self.rows, self.at = rows, 0

    def row(self):
        demand(self.at < len(self.rows), 80, "a stream is used up")
        self.at += 1
        return self.rows[self.at - 1]

    def value(self):
        return self.row()[0]

    def demand_end(self):
        demand(self.at == len(self.rows), 80, "a stream is not used up")


class PageStreams:
    """A page before what it says is carried out."""

    def __init__(self, data, info, page, before):
        """before  the page before, None for page 0"""
        kind = BASE if before is None else SPLITS
        demand(len(data) > PARAMETER_BYTES and data[0] == kind, 62, "a page's kind is wrong or the page is too short")
        self.parameters = Parameters(data[1 : 1 + PARAMETER_BYTES], info, kind)
        source = PageReader(data)
        source.at = 1 + PARAMETER_BYTES
        attributes = base_attributes(info) if kind == BASE else split_attributes()
        limits = base_limits(info, page) if kind == BASE else split_limits(info, page, before, len(page.ending))
        table, low_sizes = self.read_table(source, attributes, limits, page)
        self.streams = []
        for (records, size), columns in zip(table, attributes):
            self.streams.append(Stream(read_cloud(source.take(size, 64), records, columns) if records else []))
        self.low = [LowBits(source.take(size, 64)) for size in low_sizes]
        self.rest = source

    def read_table(self, source, attributes, limits, page):
        """(records, bytes) of each stream, and the bytes of each kind of low bits."""
        table = []
        for limit in limits:
            records = source.varint(64)
            demand(records <= min(limit, MAX_RECORDS), 64, "a stream states more records than allowed")
            table.append((records, source.varint(64) if records else 0))
        low_sizes = [source.varint(64) for _ in range(LOW_KINDS)]
        values = sum(records * components_of(columns) for (records, _), columns in zip(table, attributes))
        demand(values == page.values, 64, "the streams have another number of integers than the page table states")
        stated = sum(size for _, size in table) + sum(low_sizes)
        demand(stated <= len(source.data) - source.at, 64, "streams have more bytes than there are")
        return table, low_sizes

    def split_value(self, kind, high, low):
        """`high` and, below it, a field of `low` bits of this kind (section Streams)."""
        return high << low | self.low[kind].field(low)

    def demand_end(self):
        for stream in self.streams:
            stream.demand_end()
        for bits in self.low:
            bits.demand_end()

    def hidden_faces(self, levels):
        """The hidden faces of the levels that end with this page, as sets; nothing may follow them."""
        hidden = []
        for level in levels:
            faces, face = [], 0
            for index in range(level.hidden_count):
                step = self.rest.varint(83)
                demand(step > 0 or index == 0, 83, "hidden faces do not ascend")
                face += step
                faces.append(face)
            demand(not faces or faces[-1] < level.face_count, 83, "a hidden face does not exist")
            hidden.append(frozenset(faces))
        demand(self.rest.at == len(self.rest.data), 83, "bytes follow the hidden faces")
        return hidden
