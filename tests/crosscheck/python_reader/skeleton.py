# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""The scene graph and the palette in floating point (docs/format.md, sections NODE, JOIN and 5), in the layout of
`dump_buffers.cpp`."""
import struct

from f32 import f32
from lithe_file import NONE, NONE_16


def product(a, b):
    return f32(a * b)


def total(first, *rest):
    for value in rest:
        first = f32(first + value)
    return first


def rotation_rows(x, y, z, w):
    """The matrix of a unit quaternion."""
    xx, yy, zz = product(x, x), product(y, y), product(z, z)
    xy, xz, yz = product(x, y), product(x, z), product(y, z)
    xw, yw, zw = product(x, w), product(y, w), product(z, w)
    return ((total(1, -2 * total(yy, zz)), 2 * total(xy, -zw), 2 * total(xz, yw)),
            (2 * total(xy, zw), total(1, -2 * total(xx, zz)), 2 * total(yz, -xw)),
            (2 * total(xz, -yw), 2 * total(yz, xw), total(1, -2 * total(xx, yy))))


def inverse_bind(joint):
    """Three rows of four: the rotation's matrix times the upper triangular one, and the translation."""
    xx, yy, zz, xy, xz, yz = joint.triangular
    rows = []
    for (a, b, c), moved in zip(rotation_rows(*joint.rotation), joint.translation):
        rows += [product(a, xx), total(product(a, xy), product(b, yy)),
                 total(product(a, xz), product(b, yz), product(c, zz)), moved]
    return rows


def node_bytes(decoded):
    """Per node: parent, translation, rotation, scale."""
    blocks = []
    for node in decoded.file.nodes:
        parent = NONE if node.parent == NONE_16 else node.parent
        blocks.append(struct.pack("<I10f", parent, *node.translation, *node.rotation, *node.scale))
    return b"".join(blocks)


def joint_bytes(decoded):
    """Per joint: node, inverse bind matrix."""
    return b"".join(struct.pack("<I12f", joint.node, *inverse_bind(joint)) for joint in decoded.file.joints)
