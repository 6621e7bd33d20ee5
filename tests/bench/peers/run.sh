#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# lithe beside meshoptimizer and gltfpack on the same skinned characters, at the same triangle counts, as markdown tables: posed
# RMS and Hausdorff distance, normals, flipped area, silhouettes, uvs, seconds, their means, where a peer is better, and the verdict on lithe's targets.
#
#     tests/bench/peers/run.sh --suite [--methods ...]       the built-in figure and column, and the shared characters
#     tests/bench/peers/run.sh FILE... [--ratios 0.5,0.2,0.1,0.05] [--methods meshopt,meshopt-attr,...]
#         [--anim all|NAME] [--frames N]                     what is measured
#         [--train all|CLIP] [--train-frames N] [--phase mid|ends]   poses shown to lithe and to meshopt-poses*
#         [--column]                                         attribute weights tuned for the column
#     either: [--keep FOLDER]                                keep the simplified files and the reports
#         [--json ROWS]                                      write what was measured
#     tests/bench/peers/run.sh --from ROWS                   the tables of what was measured before
#
# Environment: LITHE  the tool (default build/release/bake/lithe, else the one in PATH)
# Needs Node 20; the peers come from npm, in the versions of package-lock.json.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
built=$here/../../../build/release/bake/lithe
if [ -z "${LITHE:-}" ] && [ -x "$built" ]; then LITHE=$built; fi
export LITHE=${LITHE:-lithe}
[ $# -gt 0 ] || { sed -n '7,15s/^# \{0,1\}//p' "$0" >&2; exit 2; }
if [ "$1" != --from ]; then
  command -v "$LITHE" >/dev/null || { echo "there is no tool '$LITHE': build lithe and set LITHE to it" >&2; exit 2; }
  [ -d "$here/node_modules/meshoptimizer" ] || npm ci --silent --no-audit --no-fund --prefix "$here"
fi
exec node "$here/run.mjs" "$@"
