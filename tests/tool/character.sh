#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# Makes what the other tests of the tool work on, along the way that a user takes.
#     character.sh TOOL FOLDER
set -euo pipefail
lithe=$1
mkdir -p "$2"
cd "$2"
"$lithe" generate column -o column.glb
"$lithe" bake column.glb -o column.lithe --clips examples --poses 4 --json bake.json
"$lithe" export column.lithe -o small.glb --triangles 2000 --from column.glb
