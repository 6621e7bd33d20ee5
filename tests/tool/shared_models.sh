#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# Real characters through the whole tool: bake, verify, info, and export at shares of their triangles, which must be hit
# within a percent (or within the one triangle that a split of a closed surface cannot avoid).
#     shared_models.sh TOOL FOLDER MODELS
models=$(cd "$3" 2>/dev/null && pwd) || { echo "SKIPPED: there is no folder $3 with characters"; exit 77; }
source "$(dirname "${BASH_SOURCE[0]}")/tool.sh"

# close GOT WANTED: within a percent or a triangle
close() { awk -v a="$1" -v b="$2" 'BEGIN { d = a > b ? a - b : b - a; exit !(d <= 1 || d <= 0.01 * b) }'; }
zero() { awk -v a="$1" 'BEGIN { exit !(a == 0) }'; }
tiny() { awk -v a="$1" 'BEGIN { exit !(a <= 1e-6) }'; }

# exports NAME PERCENT TRIANGLES: to NAME.glb, and complains about another count
exports() {
  local wanted=$(($3 * $2 / 100))
  [ $wanted -gt 0 ] || wanted=1
  answers 0 '"triangles"' export file.lithe -o file.glb --triangles $wanted --json
  local got
  got=$(json out "meshes[0].triangles")
  close "$got" $wanted || complain "$1 at $2 %: asked for $wanted triangles, got $got"
}

count=0
while IFS= read -r model; do
  name=${model#"$models"/}
  answers 0 "" bake "$model" -o file.lithe --poses 2 --quiet --json bake.json
  answers 0 "all checks passed" verify file.lithe
  answers 0 "triangles" info file.lithe
  triangles=$(json bake.json source.triangles)
  for percent in 50 20 5 2 10; do exports "$name" $percent "$triangles"; done
  # What the last one wrote is a whole character: no seam opens in any pose, and weights sum to one.
  answers 0 "" compare "$model" file.glb --frames 2 --samples 100 --include-rigid --quiet --json compare.json
  zero "$(json compare.json seam_gap)" || complain "$name: seams open by $(json compare.json seam_gap)"
  tiny "$(json compare.json weight_sum_error)" || complain "$name: weights miss one by $(json compare.json weight_sum_error)"
  count=$((count + 1))
done < <(find "$models" \( -name '*.glb' -o -name '*.gltf' \) | sort)
[ $count -gt 0 ] || complain "$models holds no characters"
echo "$count characters"
finish
