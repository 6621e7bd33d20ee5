#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# The methods of the literature, which are the tool's metrics, side by side: seconds, posed RMS by frame, pictures, and
# what a cap on influences costs. Prints markdown; writes the plots and the pictures.
#
#     tests/bench/methods.sh [PART...] [-o FOLDER]      parts: seconds curves pictures caps; all of them if none is named
#
# FOLDER is build/release/methods if not given. Characters of ../shared/models are measured where they are; what needs
# them says "skipped" elsewhere. Some ten minutes on two cores.
# Environment: LITHE_BUILD_DIR  build folder (default build/release); built there in Release when it is not yet
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${LITHE_BUILD_DIR:-$root/build/release}
models=$root/../shared/models
output=$build/methods
lithe=$build/bake/lithe
bench=$build/tests/bench/bench_methods
methods=(articulated no-refit dsd pose-independent dod rest)  # no-refit: articulated without refits, which no paper has
parts=()
while [ $# -gt 0 ]; do
  case $1 in
    -o) output=$2; shift ;;
    seconds | curves | pictures | caps) parts+=("$1") ;;
    *) echo "usage: tests/bench/methods.sh [seconds|curves|pictures|caps ...] [-o FOLDER]" >&2; exit 2 ;;
  esac
  shift
done
if [ ${#parts[@]} = 0 ]; then parts=(seconds curves pictures caps); fi
mkdir -p "$output"
output=$(cd "$output" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

bake_options_of() { if [ "$1" = no-refit ]; then echo --metric articulated --no-refit; else echo --metric "$1"; fi; }
name_of() { if [ "$1" = no-refit ]; then echo articulated --no-refit; else echo "$1"; fi; }
heading() { printf '\n## %s\n\n' "$1"; }

# ---- Posed RMS by frame

# cut_of METHOD NAME ORIGINAL BAKE_OPTION... -- EXPORT_OPTION...: $scratch/METHOD/NAME.glb
cut_of() {
  local method=$1 name=$2 original=$3 baking
  read -r -a baking <<<"$(bake_options_of "$1")"
  shift 3
  while [ "$1" != -- ]; do
    baking+=("$1")
    shift
  done
  shift
  mkdir -p "$scratch/$method"
  [ ! -f "$scratch/$method/$name.glb" ] || return 0
  "$lithe" bake "$original" -o "$scratch/$method/$name.lithe" "${baking[@]}" --quiet
  "$lithe" export "$scratch/$method/$name.lithe" -o "$scratch/$method/$name.glb" "$@" --from "$original" --quiet
}

# curves NAME ORIGINAL CLIP TITLE: judges the cuts that are there, in 60 frames of a clip
curves() {
  local name=$1 original=$2 clip=$3 title=$4 method reports=()
  for method in "${methods[@]}"; do
    "$lithe" compare "$original" "$scratch/$method/$name.glb" --anim "$clip" --frames 60 --json "$scratch/$method/$name.json" --quiet
    reports+=("$(name_of "$method")=$scratch/$method/$name.json")
  done
  "$bench" curves "$output/methods_$name.svg" "$title" "${reports[@]}"
}

column_cuts() {
  local method
  [ -f "$scratch/column.glb" ] || "$lithe" generate column -o "$scratch/column.glb" --quiet
  for method in "${methods[@]}"; do cut_of "$method" column "$scratch/column.glb" --clips examples -- --triangles 3000; done
}

part_curves() {
  local method others=air_jump_anticipation,dash,fight_kick,idle,air_land,fight_idle,air_jump,fight_punch,idle_to_fight
  heading "Column, 3,000 triangles: baked on its clip examples, judged in 60 frames of its clip test"
  column_cuts
  curves column "$scratch/column.glb" test "column, 3,000 of 114,688 triangles, clip test"
  heading "Mannequiny, 5 %: baked on nine of its clips, judged in 60 frames of the tenth, run"
  if [ ! -f "$models/mannequiny.glb" ]; then
    echo "skipped: there is no ../shared/models/mannequiny.glb"
    return
  fi
  for method in "${methods[@]}"; do cut_of "$method" mannequiny "$models/mannequiny.glb" --clips "$others" -- --ratio 0.05; done
  curves mannequiny "$models/mannequiny.glb" run "mannequiny, 5 % of 13,932 triangles, clip run"
}

# ---- Pictures

# A sheet shows a file's finest level: the cut is baked again, as it is.
part_pictures() {
  local method levels=$build/samples/lithe_levels
  heading "Column, 3,000 triangles, in its clip test"
  if ! cmake --build "$build" --target lithe_levels >&2; then
    echo "skipped: lithe_levels is not built here, see samples/CMakeLists.txt"
    return
  fi
  column_cuts
  for method in "${methods[@]}"; do
    mkdir -p "$scratch/picture"
    cp "$scratch/$method/column.glb" "$scratch/picture/column.glb"
    "$lithe" bake "$scratch/picture/column.glb" -o "$scratch/picture/column.lithe" --levels 1 --quiet
    "$levels" "$scratch/picture/column.lithe" --out "$scratch/picture" --columns 1 --rows wires --cell-width 260 \
      --cell-height 400 --clip test --fraction 0.4 --turn 30 >&2
    cp "$scratch/picture/column_levels.png" "$output/methods_column_$method.png"
    echo "* $method: methods_column_$method.png"
  done
}

# ---- The rest is the bench's

part_seconds() {
  heading "Seconds of simplification, by method"
  "$bench" seconds
}

part_caps() {
  heading "Posed RMS by influence cap, 1e-4 of the rest diagonal"
  "$bench" caps
}

if [ ! -f "$build/CMakeCache.txt" ]; then cmake -G Ninja -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release >&2; fi
cmake --build "$build" --target lithe_tool bench_methods >&2
grep -q '^CMAKE_BUILD_TYPE:[^=]*=Release$' "$build/CMakeCache.txt" || { echo "$build is no Release build" >&2; exit 2; }
for part in "${parts[@]}"; do "part_$part"; done
