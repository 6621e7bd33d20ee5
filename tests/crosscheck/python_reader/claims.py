# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""What the head states and only decoded pages show (docs/format.md, sections INFO, JOIN and LEVL).

A reader need not check it.
"""
from lithe_file import NONE_8


def box_of(positions):
    return tuple(map(min, zip(*positions))), tuple(map(max, zip(*positions)))


def influenced(nodes):
    """Positions of the nodes that each joint influences, by joint."""
    positions = {}
    for node in nodes:
        for joint, _ in node.skin:
            positions.setdefault(joint, []).append(node.position)
    return positions


def cut_joints(nodes, node_count):
    """The joints of the cut at which `node_count` nodes are known."""
    joints = set()
    for node in nodes[:node_count]:
        if node.children is None or node.children[0] >= node_count:
            joints.update(joint for joint, _ in node.skin)
    return joints


def broken_claims(decoded):
    """A line for every statement that does not hold."""
    info, nodes = decoded.file.info, decoded.hierarchy.nodes
    for number, level in enumerate(decoded.levels):
        count = len(cut_joints(nodes, level.node_count))
        if count != level.joint_count:
            yield f"level {number} has {count} joints, LEVL says {level.joint_count}"
    if len(decoded.levels) < len(decoded.file.levels):
        return
    if box_of([node.position for node in nodes]) != (info.grid_min, info.grid_max):
        yield "INFO's box is not that of the nodes"
    positions = influenced(nodes)
    for number, joint in enumerate(decoded.file.joints):
        cells = [tuple(value >> info.position_bits - 8 for value in point) for point in positions.get(number, ())]
        box = box_of(cells) if cells else ((NONE_8,) * 3, (0,) * 3)
        if box != (joint.box_min, joint.box_max):
            yield f"joint {number}'s box is not that of the nodes it influences"
