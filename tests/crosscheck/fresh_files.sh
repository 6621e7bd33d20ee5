#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# Files that the bake writes today, read by the runtime and by the second reader: the same buffers, bit by bit. Skipped
# where there is no Python 3.
#     fresh_files.sh TOOL FOLDER DUMP_BUFFERS MODELS
command -v python3 >/dev/null || { echo "SKIPPED: python3 is not installed"; exit 77; }
reader=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/python_reader.sh
source "$(dirname "${BASH_SOURCE[0]}")/../tool/tool.sh"
dump_buffers=$3
models=$(cd "$4" 2>/dev/null && pwd) || models=

# agree FILE.lithe LEVELS: of the levels from the coarsest on, 0 for all
agree() {
  "$reader" compare_runtime.py "$1" "$2" "$dump_buffers" || complain "$(basename "$1"): the two readers differ"
}

# agree_on FILE.glb LEVELS
agree_on() {
  [ -f "$1" ] || return 0
  answers 0 "" bake "$1" -o "$(basename "$1" .glb).lithe" --poses 2 --quiet
  agree "$(basename "$1" .glb).lithe" "$2"
}

# Many levels in one page; a small file whole; many joints, turned in all directions, and several parts.
agree "$characters/column.lithe" 6
agree_on "$characters/small.glb" 0
answers 0 "" generate figure -o figure.glb --quiet
agree_on figure.glb 3
# Nodes with more than eight wedges whose weights are predicted.
agree_on "$models/eight_influences.glb" 0
finish
