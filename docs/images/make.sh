#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# Makes the pages' pictures from what samples/demo.sh has built and baked; run that first.
#
#     docs/images/make.sh
#
# Environment: LITHE_BUILD_DIR  build folder (default build/release)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
samples=${LITHE_BUILD_DIR:-build/release}/samples
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

"$samples/lithe_levels" demo/figure.lithe --out "$folder" --rows shaded,wires --columns 5 --cell-width 300 --cell-height 350 \
  --clip walk --fraction 0.2 --turn 35
cp "$folder/figure_levels.png" docs/images/levels.png
"$samples/lithe_levels" demo/figure.lithe --out "$folder" --rows checker,shaded --columns 5 --cell-width 300 --cell-height 350 \
  --clip walk --fraction 0.2 --turn 35
cp "$folder/figure_levels.png" docs/images/checker.png
"$samples/lithe_crowd" demo/figure.lithe demo/centipede.lithe demo/column.lithe --out "$folder" --instances 1000 --frames 7 \
  --width 1120 --height 630
cp "$folder/crowd_003.png" docs/images/crowd.png
ls -l docs/images/*.png
