# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""A file read from docs/format.md alone gives bit by bit what the runtime makes of it.

    compare_runtime.py FILE.lithe LEVELS DUMP_BUFFERS      LEVELS: how many levels, from the coarsest on; 0 for all
"""
import sys
from pathlib import Path

from claims import broken_claims
from levels import DecodedFile
from runtime_dump import blocks_of, differences, runtime_blocks


def main(path, levels, program):
    decoded = DecodedFile(Path(path).read_bytes(), int(levels) or None)
    ours = blocks_of(decoded)
    theirs, refusal = runtime_blocks(program, path, levels)
    complaints = [refusal] if refusal else [*differences(ours, theirs), *broken_claims(decoded)]
    for complaint in complaints:
        print(complaint)
    print(f"{Path(path).name}: {len(decoded.levels)} levels, {len(ours)} blocks, {sum(map(len, ours.values()))} bytes, "
          f"{len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
