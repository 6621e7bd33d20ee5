# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""The frozen files, read from docs/format.md alone, give the bytes that tests/golden/hashes.txt states.

    golden_hashes.py GOLDEN_FOLDER NAME
"""
import sys
from pathlib import Path

from buffers import index_bytes, vertex_bytes
from levels import DecodedFile
from xxh64 import xxh64


def hash_lines(name, decoded):
    """A line a level: NAME LEVEL XXH64-OF-VERTICES XXH64-OF-INDICES."""
    vertices = vertex_bytes(decoded)
    stride = len(vertices) // len(decoded.hierarchy.wedges)
    for number, level in enumerate(decoded.levels):
        of_level = vertices[: level.wedge_count * stride]
        yield f"{name} {number} {xxh64(of_level):016x} {xxh64(index_bytes(decoded, number)):016x}"


def main(folder, name):
    decoded = DecodedFile((Path(folder) / f"{name}.lithe").read_bytes())
    found = list(hash_lines(name, decoded))
    listed = [line for line in (Path(folder) / "hashes.txt").read_text().splitlines() if line.startswith(f"{name} ")]
    differing = [(ours, theirs) for ours, theirs in zip(found, listed) if ours != theirs]
    for ours, theirs in differing:
        print(f"read {ours}, listed {theirs}")
    print(f"{name}: {len(found)} levels read, {len(listed)} listed, {len(differing)} differ")
    return 1 if differing or len(found) != len(listed) or not found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
