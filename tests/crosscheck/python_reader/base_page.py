# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""Page 0: the base, node by node, wedge by wedge, face by face (docs/format.md, section Streams, Base page)."""
from page_streams import (FACES, INFLUENCES, LOW_EXTRAS, LOW_NORMALS, LOW_POSITIONS, LOW_TANGENTS, LOW_UVS, NODES,
                          WEDGES)
from refused import demand


def read_nodes(page, hierarchy, node_count):
    """Positions; returns each node's (wedges, influences)."""
    bias = page.parameters.position_bias
    position, sizes = [0, 0, 0], []
    for _ in range(node_count):
        row = page.streams[NODES].row()
        position = [value + page.split_value(LOW_POSITIONS, high, bias) for value, high in zip(position, row[:3])]
        hierarchy.add_node(position, [], 67)
        sizes.append((row[3] + 1, row[4] + 1))
    return sizes


def read_skins(page, hierarchy, sizes):
    one = hierarchy.info.one
    for node, (_, influences) in zip(hierarchy.nodes, sizes):
        demand(influences <= hierarchy.info.max_influences, 67, "a node has too many influences")
        rows = [page.streams[INFLUENCES].row() for _ in range(influences)]
        demand(rows[-1][1] == 0, 68, "the last weight is stated")
        weights = [weight for _, weight in rows[:-1]]
        weights.append(one - sum(weights))
        node.skin = [(joint, weight) for (joint, _), weight in zip(rows, weights)]
        hierarchy.check_skin(node.skin, 68)


def low_bits_of_record(page, layout):
    """Of each entry of a record the kind and the number of its low bits."""
    low = [(LOW_EXTRAS, 0)] * layout.length
    low[layout.normal] = [(LOW_NORMALS, page.parameters.normal_bias)] * (layout.normal.stop - layout.normal.start)
    low[layout.tangent] = [(LOW_TANGENTS, page.parameters.tangent_bias)] * (layout.tangent.stop - layout.tangent.start)
    for uv, bias in zip(layout.uvs, page.parameters.uv_bias):
        low[uv] = [(LOW_UVS, bias)] * 2
    return low


def read_wedges(page, hierarchy, sizes, wedge_count):
    demand(sum(wedges for wedges, _ in sizes) == wedge_count, 67, "the nodes' wedges do not add up")
    record = [0] * hierarchy.layout.length
    low = low_bits_of_record(page, hierarchy.layout)
    for index, (wedges, _) in enumerate(sizes):
        first = len(hierarchy.wedges)
        for _ in range(wedges):
            part, *differences = page.streams[WEDGES].row()
            record = [value + page.split_value(kind, high, bits)
                      for value, high, (kind, bits) in zip(record, differences, low)]
            hierarchy.add_wedge(index, part, record)
        hierarchy.nodes[index].wedges = range(first, len(hierarchy.wedges))


def read_faces(page, hierarchy, face_count):
    first = 0
    for _ in range(face_count):
        step, second, third = page.streams[FACES].row()
        first += step
        wedges = [first, first + second, first + third]
        demand(all(0 <= wedge < len(hierarchy.wedges) for wedge in wedges), 70, "a face's wedge does not exist")
        ends = [hierarchy.wedges[wedge] for wedge in wedges]
        demand(len({end.node for end in ends}) == 3, 70, "two corners of a face are at one node")
        demand(len({end.part for end in ends}) == 1, 70, "a face mixes parts")
        hierarchy.add_face(wedges)


def decode_base(page, hierarchy, entry):
    """page       PageStreams of page 0
    hierarchy  is filled
    entry      page 0's record of PAGE"""
    sizes = read_nodes(page, hierarchy, entry.node_count)
    read_skins(page, hierarchy, sizes)
    read_wedges(page, hierarchy, sizes, entry.wedge_count)
    read_faces(page, hierarchy, entry.face_count)
