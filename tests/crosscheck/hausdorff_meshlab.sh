#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# What `lithe compare` says of one posed frame, held against MeshLab's filter Hausdorff Distance on the same two posed meshes:
# mean, root mean square and largest distance of both directions must agree within 1 %. Skipped where MeshLab is not
# installed (Debian: meshlab, xvfb, xauth).
#     hausdorff_meshlab.sh TOOL FOLDER POSE_TO_PLY MODELS
for command in meshlabserver xvfb-run; do
  command -v $command >/dev/null || { echo "SKIPPED: $command is not installed"; exit 77; }
done
source "$(dirname "${BASH_SOURCE[0]}")/../tool/tool.sh"
pose_to_ply=$3
models=$(cd "$4" 2>/dev/null && pwd) || models=

# filter SAMPLED TARGET vertices|faces: an action of a filter script. Vertices apart: they would bias the means of the faces.
filter() {
  local vertices=false faces=true
  if [ "$3" = vertices ]; then vertices=true faces=false; fi
  cat <<END
 <filter name="Hausdorff Distance">
  <Param type="RichMesh" value="$1" name="SampledMesh"/> <Param type="RichMesh" value="$2" name="TargetMesh"/>
  <Param type="RichBool" value="false" name="SaveSample"/> <Param type="RichBool" value="$vertices" name="SampleVert"/>
  <Param type="RichBool" value="false" name="SampleEdge"/> <Param type="RichBool" value="false" name="SampleFauxEdge"/>
  <Param type="RichBool" value="$faces" name="SampleFace"/> <Param type="RichInt" value="$samples" name="SampleNum"/>
  <Param type="RichAbsPerc" value="10000" min="0" max="10000" name="MaxDist"/>
 </filter>
END
}

# measured_by_meshlab: "max mean rms" a line: faces and vertices of the original, then of the simplified one
measured_by_meshlab() {
  { echo '<!DOCTYPE FilterScript>'; echo '<FilterScript>'
    filter 0 1 faces; filter 0 1 vertices; filter 1 0 faces; filter 1 0 vertices
    echo '</FilterScript>'; } >filters.mlx
  xvfb-run -a meshlabserver -i original.ply -i simplified.ply -s filters.mlx >meshlab.log 2>&1 || { tail meshlab.log >&2; return 1; }
  # Every result is printed twice: absolute, then in diagonals; and once more in the log.
  sed -nE '/^LOG.*Hausdorff Distance computed/,/Values w/s/.*max ([0-9.]+) +mean : ([0-9.]+) +RMS : ([0-9.]+).*/\1 \2 \3/p' meshlab.log
}

# agree WHAT LITHE MESHLAB
agree() {
  echo "$1: lithe $2, MeshLab $3"
  awk -v a="$2" -v b="$3" 'BEGIN { d = a > b ? a - b : b - a; exit !(b > 0 && d <= 0.01 * b) }' || complain "$1: lithe says $2, MeshLab $3"
}

scaled() { awk -v value="$1" -v factor="$2" 'BEGIN { printf "%.6f", value * factor }'; }
larger() { awk -v a="$1" -v b="$2" 'BEGIN { print (a + 0 > b + 0 ? a : b) }'; }

# MeshLab prints six decimals, so meshes are given to it with a rest diagonal of this.
diagonal=10000

# check NAME ORIGINAL SIMPLIFIED CLIP SAMPLES
check() {
  local name=$1 original=$2 simplified=$3 clip=$4 samples=$5 seconds unit from faces_max mean rms vertices_max
  answers 0 "" compare "$original" "$simplified" --anim "$clip" --frames 1 --samples "$samples" --include-rigid --quiet --json compare.json
  seconds=$(json compare.json "frames[0].time")
  unit=$(awk -v rest="$(json compare.json rest_diagonal)" -v diagonal=$diagonal 'BEGIN { printf "%.17g", rest / diagonal }')
  "$pose_to_ply" "$original" "$clip" "$seconds" "$unit" original.ply
  "$pose_to_ply" "$simplified" "$clip" "$seconds" "$unit" simplified.ply
  measured_by_meshlab >meshlab.txt || { complain "$name: meshlabserver fails"; return; }
  [ "$(wc -l <meshlab.txt)" = 4 ] || { complain "$name: MeshLab gave $(wc -l <meshlab.txt) results instead of 4"; return; }
  for from in original_to_simplified simplified_to_original; do
    { read -r faces_max mean rms; read -r vertices_max _ _; }
    agree "$name, $from, mean" "$(scaled "$(json compare.json "frames[0].$from.mean")" $diagonal)" "$mean"
    agree "$name, $from, rms" "$(scaled "$(json compare.json "frames[0].$from.rms")" $diagonal)" "$rms"
    agree "$name, $from, max" "$(scaled "$(json compare.json "frames[0].$from.max")" $diagonal)" "$(larger "$faces_max" "$vertices_max")"
  done <meshlab.txt
}

# Largest distances may lie inside a face, at a narrow peak: with fewer points each of the two programs misses it its own way.
check column "$characters/column.glb" "$characters/small.glb" test 3000000
# check_model NAME SAMPLES: a shared character, at a tenth of its triangles
check_model() {
  local file=$models/$1.glb
  [ -f "$file" ] || return 0
  answers 0 "" bake "$file" -o baked.lithe --poses 2 --quiet
  answers 0 "" export baked.lithe -o tenth.glb --ratio 0.1 --from "$file" --quiet
  answers 0 "" compare "$file" tenth.glb --frames 1 --samples 1 --json -
  check "$1" "$file" tenth.glb "$(json out "frames[0].clip")" "$2"
}
check_model sintel 500000
check_model mannequiny 3000000
finish
