# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
"""Damaged files are refused by the check that docs/format.md states; and where checksums hide the damage, the runtime
and this reader agree on whether there is a file, and on what is in it.

    refusals.py FILE.lithe COUNT DUMP_BUFFERS      COUNT: files with a bit turned, and as many with a value changed
"""
import random
import sys
import tempfile
from collections import Counter
from pathlib import Path

from damage import Original
from levels import DecodedFile
from refused import Refused
from rewrite_page import values_changed
from runtime_dump import blocks_of, differences, runtime_blocks

STRIDE = 97


def check_that_refuses(data):
    """The number of the check; None when the file is taken."""
    try:
        DecodedFile(data)
    except Refused as refusal:
        return refusal.check
    return None


def wrong_cuts(original):
    for size, expected in original.cuts():
        found = check_that_refuses(original.data[:size])
        if found != expected:
            yield f"cut to {size} bytes: check {found} instead of {expected}"


def wrong_flips(original):
    for at in range(0, len(original.data), STRIDE):
        expected = original.check_of_byte(at)
        found = check_that_refuses(bytes(original.flipped(at, at % 8)))
        if found not in expected:
            yield f"byte {at} changed: check {found} instead of one of {sorted(expected)}"


def read_here(data):
    """(blocks, None), or (None, why the file is refused)."""
    try:
        return blocks_of(DecodedFile(data)), None
    except Refused as refusal:
        return None, str(refusal)


def disagreements(files, program, verdicts):
    """A line for every file (what was done, bytes) on which the two readers differ; `verdicts` counts ours."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "damaged.lithe"
        for done, data in files:
            path.write_bytes(data)
            theirs, their_reason = runtime_blocks(program, path, 0)
            ours, our_reason = read_here(data)
            verdicts[our_reason.split(":")[0] if our_reason else "taken"] += 1
            if (ours is None) != (theirs is None):
                yield f"{done}: here {our_reason or 'taken'}, runtime {their_reason or 'taken'}"
            elif ours is not None:
                yield from (f"{done}: {line}" for line in differences(ours, theirs))


def main(path, count, program):
    original = Original(Path(path).read_bytes())
    verdicts, source = Counter(), random.Random(1)
    complaints = [*wrong_cuts(original), *wrong_flips(original)]
    complaints += disagreements(original.bits_turned(int(count), source), program, verdicts)
    complaints += disagreements(values_changed(original, int(count), source), program, verdicts)
    for complaint in complaints:
        print(complaint)
    print(f"{Path(path).name}: {len(complaints)} complaints; whole again:",
          ", ".join(f"{count} {verdict}" for verdict, count in sorted(verdicts.items())))
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
