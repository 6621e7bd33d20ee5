# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""The skins of a split's children (docs/format.md, section 4.6)."""
from integers import between, predicted
from page_streams import MAX_LISTED_JOINTS, SKIN_D, SKIN_E, SKIN_NEW
from refused import demand

UNCHANGED, _, FREE = range(3)


def read_joints(page, split):
    """The node's joints in order, then the new ones."""
    joints = [joint for joint, _ in split.node.skin]
    count = page.streams[SKIN_NEW].value()
    demand(len(joints) + count <= MAX_LISTED_JOINTS, 79, "too many joints are listed")
    for _ in range(count):
        joint = page.streams[SKIN_NEW].value()
        demand(joint < split.hierarchy.joint_count and joint not in joints, 79, "a new joint is invalid")
        joints.append(joint)
    return joints


def prediction_of(page, split, joint, weight):
    """What the ring's weights let expect of a joint's D."""
    if not split.predicts_skins:
        return 0
    skins = [dict(split.hierarchy.nodes[node].skin) for node in split.ring_nodes]
    differences = [skin.get(joint, 0) - weight for skin in skins]
    return predicted(page.parameters.skin_gradient, *split.skin_slope().of(differences))


def sorted_skin(joints, weights):
    kept = [(joint, weight) for joint, weight in zip(joints, weights) if weight != 0]
    return sorted(kept, key=lambda influence: (-influence[1], influence[0]))


def split_skin(page, split, mode):
    """The skins of A and B."""
    if mode == UNCHANGED:
        return split.node.skin, split.node.skin
    one = split.hierarchy.info.one
    joints = read_joints(page, split)
    parent = [dict(split.node.skin).get(joint, 0) for joint in joints]
    d, b = [], []
    for joint, weight in zip(joints[:-1], parent):
        high = page.streams[SKIN_D].value()
        d.append(page.split_value(high, page.parameters.skin_shift) + prediction_of(page, split, joint, weight))
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
