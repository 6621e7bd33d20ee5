# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""The blocks that `dump_buffers` writes, from the runtime and from this reader."""
import struct
import subprocess
import tempfile
from pathlib import Path

from buffers import index_bytes, morph_source_bytes, range_bytes, vertex_bytes
from lithe_file import NONE
from skeleton import joint_bytes, node_bytes


def words(values):
    return struct.pack(f"<{len(values)}I", *values)


def half_words(values):
    return struct.pack(f"<{len(values)}H", *values)


def node_parents(nodes):
    parents = [NONE] * len(nodes)
    for index, node in enumerate(nodes):
        for child in node.children or ():
            parents[child] = index
    return parents


def blocks_of(decoded):
    """The blocks that dump_buffers.cpp lists, by name."""
    nodes, wedges = decoded.hierarchy.nodes, decoded.hierarchy.wedges
    blocks = {
        "scene nodes": node_bytes(decoded),
        "joints": joint_bytes(decoded),
        "node positions": half_words([value for node in nodes for value in node.position]),
        "node parents": words(node_parents(nodes)),
        "node children": words([node.children[0] if node.children else NONE for node in nodes]),
        "wedge nodes": words([wedge.node for wedge in wedges]),
        "wedge parents": words([NONE if wedge.parent is None else wedge.parent for wedge in wedges]),
        "wedge parts": words([wedge.part for wedge in wedges]),
        "vertices": vertex_bytes(decoded),
    }
    for level in range(len(decoded.levels)):
        blocks[f"level {level} indices"] = index_bytes(decoded, level)
        blocks[f"level {level} ranges"] = range_bytes(decoded, level)
        if level:
            blocks[f"level {level} morph sources"] = morph_source_bytes(decoded, level)
    return blocks


def blocks_in(data):
    """Name to bytes."""
    blocks, at = {}, 0
    while at < len(data):
        name, size, _ = data[at : at + 80].split(b"\n", 2)
        begin = at + len(name) + len(size) + 2
        at = begin + int(size)
        blocks[name.decode()] = data[begin:at]
    return blocks


def runtime_blocks(program, path, levels):
    """(blocks, None), or (None, what the runtime says of the file).

    levels  how many, from the coarsest on; 0 for all
    """
    with tempfile.TemporaryDirectory() as folder:
        dump = Path(folder) / "dump"
        done = subprocess.run([program, path, str(levels), dump], capture_output=True, text=True, check=False)
        if done.returncode == 0:
            return blocks_in(dump.read_bytes()), None
    if done.returncode == 1 and " check " in done.stderr:
        return None, done.stderr.strip()
    raise RuntimeError(f"{program} ends with {done.returncode}: {done.stderr}")


def differences(ours, theirs):
    """A line for every block in which the two differ."""
    for name in sorted(ours.keys() | theirs.keys()):
        mine, other = ours.get(name), theirs.get(name)
        if mine is None or other is None:
            yield f"{name}: only one of the two has it"
        elif mine != other:
            at = next((i for i, (a, b) in enumerate(zip(mine, other)) if a != b), min(len(mine), len(other)))
            yield f"{name}: {len(mine)} and {len(other)} bytes, which differ from byte {at} on"
