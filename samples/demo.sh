#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# The whole way in one command: builds lithe, makes three characters, bakes them, and streams a crowd of a thousand of
# them. Writes demo/crowd_*.png and demo/report.html. What is missing on a Debian 12 machine is installed first.
#
#     samples/demo.sh             pictures; needs no display and no GPU
#     samples/demo.sh --window    a window, where there is a display
#
# Environment: LITHE_BUILD_DIR     build folder (default build/release)
#              LITHE_JOBS          parallel jobs (default: the number of cores)
#              LITHE_DEMO_QUICK=1  fewer example poses, fewer and smaller pictures: what CI runs
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/packages.sh
source scripts/stages.sh

build=${LITHE_BUILD_DIR:-build/release}
jobs=${LITHE_JOBS:-$(nproc)}
demo=demo
characters=(figure centipede column)
files=("${characters[@]/#/$demo/}")
files=("${files[@]/%/.lithe}")
# Triangles of each level as shares of the finest; the coarsest is for characters of some ten pixels.
levels=0.0012,0.0025,0.005,0.01,0.02,0.04,0.08,0.16,0.32,0.6,1
bake_options=(--levels "$levels" --quiet)
crowd_options=(--instances 1000 --frames 7 --both --width 1280 --height 720)
sheet_options=(--columns 5 --cell-width 320)
if [ "${LITHE_DEMO_QUICK:-0}" = 1 ]; then
  bake_options+=(--poses 4)
  crowd_options=(--instances 1000 --frames 3 --both --width 640 --height 360)
  sheet_options=(--columns 4 --cell-width 200)
fi

window=0
case ${1:-} in
  "") ;;
  --window) window=1 ;;
  *) echo "usage: samples/demo.sh [--window]" >&2; exit 2 ;;
esac
if [ $window = 1 ] && [ -z "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
  echo "There is no display to open a window on: writing pictures instead."
  window=0
fi

build_targets() { cmake --build "$build" -j "$jobs" --target lithe_tool lithe_hello lithe_crowd lithe_levels lithe_report; }

# is_newer FILE THAN...: whether the file is there and newer than all others
is_newer() {
  local file=$1 other
  shift
  for other in "$@"; do [ "$file" -nt "$other" ] || return 1; done
}

generate() {
  local file=$demo/$1.glb
  if is_newer "$file" "$lithe"; then echo "$file is up to date"; else "$lithe" generate "$1" -o "$file"; fi
}

# A bake is kept while the tool, the character and the options are the same.
bake() {
  local file=$demo/$1.lithe options=$demo/$1.options
  [ "$(cat "$options" 2>/dev/null)" = "${bake_options[*]}" ] || echo "${bake_options[*]}" >"$options"
  if is_newer "$file" "$lithe" "$demo/$1.glb" "$options"; then
    echo "$file is up to date"
  else
    "$lithe" bake "$demo/$1.glb" -o "$file" "${bake_options[@]}"
  fi
  "$lithe" info "$file" --json >"$demo/$1_info.json"
  "$lithe" info "$file" | sed -n '1,/^$/p'
}

# How each character shows itself best.
pose_of() {
  case $1 in
    figure) echo --clip walk --fraction 0.2 --turn 35 --cell-height 380 ;;
    centipede) echo --clip walk --fraction 0.3 --turn 65 --elevation 32 --cell-height 240 ;;
    column) echo --clip test --fraction 0.4 --turn 30 --cell-height 380 ;;
  esac
}

draw_levels() {
  local character pose
  for character in "${characters[@]}"; do
    read -r -a pose <<<"$(pose_of "$character")"
    "$samples/lithe_levels" "$demo/$character.lithe" --out "$demo" --each "${sheet_options[@]}" "${pose[@]}"
  done
}

draw_crowd() {
  rm -f "$demo"/crowd_*.png
  "$samples/lithe_crowd" "${files[@]}" --out "$demo" "${crowd_options[@]}"
}

write_report() {
  printf '%s\n' "${lithe_stage_times[@]}" >"$demo/times.txt"
  "$samples/lithe_report" "$demo" "${characters[@]}"
}

mkdir -p "$demo"
stage "install what is missing" lithe_need build display
stage "configure $build" cmake -G Ninja -S . -B "$build" -DCMAKE_BUILD_TYPE=Release
stage "build" build_targets
lithe=$build/bake/lithe
samples=$build/samples
for character in "${characters[@]}"; do stage "generate $character" generate "$character"; done
for character in "${characters[@]}"; do stage "bake $character" bake "$character"; done
stage "what a camera that comes near would draw" "$samples/lithe_hello" "$demo/figure.lithe"
if [ $window = 1 ]; then
  stage "the crowd in a window" "$samples/lithe_crowd" "${files[@]}" --window
else
  stage "pictures of the levels" draw_levels
  stage "the crowd, streamed" draw_crowd
  stage "report" write_report
fi
stage_summary
[ $window = 1 ] || printf '\nLook at %s and %s\n' "$demo/report.html" "$demo/crowd_*.png"
