#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# How well the stated errors hold where the bake did not look: every level of every character, in frames of its clips halfway
# between those that the bake chooses from, and in sampled poses that no bake takes. One markdown table; exit code 1 when 1 % of
# the samples of a level are farther away than stated, in its clips, or in sampled poses where it has none.
#
#     tests/bench/level_error.sh [BUILD_DIR [NAME|FILE.glb...]]      default build/release, the built-in and the shared characters
#
# Files that are not there are skipped with a message.
#
# Environment: LITHE_FRAMES         poses of each kind (default 6)
#              LITHE_EVERY_LEVEL=1  one row a level instead of one a character
# A few minutes on two cores.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${1:-$root/build/release}
shift || true
models=$root/../shared/models
lithe=$build/bake/lithe
frames=${LITHE_FRAMES:-6}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0
source "$root/tests/bench/characters.sh"

default_characters() {
  printf '%s\n' column centipede figure
  shared_characters | grep -v '/column\.glb$' || true
}

# summarize NAME POSES: the table of `lithe verify --against` on stdin as rows
summarize() {
  awk -v name="$1" -v poses="$2" -v every="${LITHE_EVERY_LEVEL:-}" '
    $1 ~ /^[0-9]+$/ && NF == 8 {
      quotient = $4 > 0 ? $6 / $4 : ($6 > 0 ? 999 : 1); ++levels
      if (every) printf "| %s | %s | %d | %s | %.4g | %.4g | %.2f | %.3f %% |\n", name, poses, $1, $2, $4, $6, quotient, $7
      if (quotient > most) most = quotient
      if (quotient > 1) ++over
      if (levels == 1 || $7 + 0 > beyond) { beyond = $7 + 0; at = $2 }
    }
    END { if (!every) printf "| %s | %s | %d | %.3f %% | %s | %d | %.2f |\n", name, poses, levels, beyond, at, over, most }'
}

# measure NAME POSES: rows for the baked file in `all` frames of its clips or in `sampled` poses; fails when a level breaks its promise
measure() {
  local kind=sampled
  if [ "$2" = all ]; then kind=clips; fi
  if "$lithe" verify "$scratch/baked.lithe" --against "$file" --anim "$2" --frames "$frames" >"$scratch/levels.txt" 2>"$scratch/refusal.txt"; then
    summarize "$1" $kind <"$scratch/levels.txt"
  else
    echo "| $1 | $kind | $(grep -oE 'level [0-9]+: .* stated error' "$scratch/refusal.txt" || tail -n 1 "$scratch/refusal.txt") |"
    return 1
  fi
}

# judge FILE NAME CLIP: the file baked with default options; CLIP is empty where it has none. Turns that the clips do not make are
# no poses of the kind that the bake looked at: reported, not judged.
judge() {
  local file=$1
  "$lithe" bake "$file" -o "$scratch/baked.lithe" --quiet 2>/dev/null
  if [ -n "$3" ]; then
    measure "$2" all || failures=$((failures + 1))
    measure "$2" sampled || true
  else
    measure "$2" sampled || failures=$((failures + 1))
  fi
}

# clip_of FILE: the clip that a first frame is taken from; nothing where there is none
clip_of() {
  "$lithe" compare "$1" "$1" --frames 1 --samples 1 --include-rigid --json - | sed -nE 's/^ +"clip": "(.*)",$/\1/p'
}

if [ -n "${LITHE_EVERY_LEVEL:-}" ]; then
  printf '| character | poses | level | triangles | stated | largest | largest / stated | beyond |\n|---|---|---:|---:|---:|---:|---:|---:|\n'
else
  printf '| character | poses | levels | samples beyond, at most | at triangles | levels exceeded at all | by at most |\n|---|---|---:|---:|---:|---:|---:|\n'
fi
if [ $# -gt 0 ]; then printf '%s\n' "$@"; else default_characters; fi >"$scratch/characters.txt"
while IFS= read -r character; do
  file=$character
  case $file in */*) [ -f "$file" ] || { echo "$file is not here: skipped" >&2; continue; } ;; esac
  if [ ! -f "$file" ]; then
    file=$scratch/$character.glb
    "$lithe" generate "$character" -o "$file" --quiet
  fi
  judge "$file" "$(name_of "$character")" "$(clip_of "$file")"
done <"$scratch/characters.txt"
if [ $failures -gt 0 ]; then printf '\n%s beyond the limit.\n' $failures; exit 1; fi
