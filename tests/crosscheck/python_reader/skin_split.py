# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""The skins of a split's children (docs/format.md, section 4.6)."""
from integers import between, low_bits, predicted
from page_streams import (LOW_SKINS, MAX_LISTED_JOINTS, SKIN_D, SKIN_E, SKIN_MODES_ALL, SKIN_MODES_MOST, SKIN_MODES_NONE,
                          SKIN_MODES_SOME, SKIN_NEW)
from refused import demand

UNCHANGED, _, FREE = range(3)


def joints_around(split, known):
    """The ring's joints that the node lacks, the heaviest first; at most 24, the first that are met."""
    greatest = {}
    for node in split.ordered_nodes if split.predicts_skins else ():
        for joint, weight in split.hierarchy.nodes[node].skin:
            if joint not in known and (joint in greatest or len(greatest) < MAX_LISTED_JOINTS):
                greatest[joint] = max(weight, greatest.get(joint, 0))
    return sorted(greatest, key=lambda joint: (-greatest[joint], joint))


def read_joints(page, split):
    """The node's joints in order, then the new ones."""
    joints = [joint for joint, _ in split.node.skin]
    count = page.streams[SKIN_NEW].value()
    demand(len(joints) + count <= MAX_LISTED_JOINTS, 79, "too many joints are listed")
    around = joints_around(split, set(joints)) if count else []
    for _ in range(count):
        value = page.streams[SKIN_NEW].value()
        joint = around[value] if value < len(around) else value - len(around)
        demand(joint < split.hierarchy.joint_count and joint not in joints, 79, "a new joint is invalid")
        joints.append(joint)
    return joints


def read_difference(page, split, joint, weight):
    """A joint's D, with what the ring's weights let expect of it."""
    skins = [dict(split.hierarchy.nodes[node].skin) for node in split.ring_nodes] if split.predicts_skins else []
    steps = [skin.get(joint, 0) - weight for skin in skins]
    spread = max(map(abs, steps)) if steps else split.hierarchy.info.one >> 3
    low = low_bits(spread, page.parameters.skin_bias)
    d = page.split_value(LOW_SKINS, page.streams[SKIN_D].value(), low)
    return d + predicted(page.parameters.skin_gradient, *split.skin_slope().of(steps)) if steps else d


def sorted_skin(joints, weights):
    kept = [(joint, weight) for joint, weight in zip(joints, weights) if weight != 0]
    return sorted(kept, key=lambda influence: (-influence[1], influence[0]))


def read_mode(page, split):
    spokes, nodes = split.fan.spokes, split.hierarchy.nodes
    alike = sum(nodes[spoke.next].skin == split.node.skin for spoke in spokes)
    if alike == len(spokes):
        stream = SKIN_MODES_ALL
    elif 2 * alike >= len(spokes):
        stream = SKIN_MODES_MOST
    else:
        stream = SKIN_MODES_SOME if alike else SKIN_MODES_NONE
    mode = page.streams[stream].value()
    demand(mode <= FREE, 72, "a skin mode is out of range")
    return mode


def split_skin(page, split):
    """The skins of A and B."""
    mode = read_mode(page, split)
    if mode == UNCHANGED:
        return split.node.skin, split.node.skin
    one = split.hierarchy.info.one
    joints = read_joints(page, split)
    parent = [dict(split.node.skin).get(joint, 0) for joint in joints]
    d, b = [], []
    for joint, weight in zip(joints[:-1], parent):
        d.append(read_difference(page, split, joint, weight))
        if mode == FREE:
            b.append(weight + page.streams[SKIN_E].value())
    d.append(-sum(d))
    demand(all(abs(value) <= one for value in d), 79, "a weight's D is beyond one")
    if mode == FREE:
        b.append(one - sum(b))
    else:
        b = [weight - between(difference, split.t8) for weight, difference in zip(parent, d)]
        b[0] += one - sum(b)
    a = [weight + difference for weight, difference in zip(b, d)]
    skins = sorted_skin(joints, a), sorted_skin(joints, b)
    for skin in skins:
        split.hierarchy.check_skin(skin, 79)
    return skins
