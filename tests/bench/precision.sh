#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# What `lithe bake --precision` buys: bytes and posed RMS at 50, 20, 10, 5 and 2 % of the triangles, as parts of what the default
# gives, one row a precision; geometric means over the characters, then the bytes and the RMS at 10 % of each. Prints markdown.
#
#     tests/bench/precision.sh [BUILD_DIR [NAME|FILE.glb...]]      default build/release; column, figure and four shared characters
#
# Files that are not there are skipped with a message.
#
# Environment: LITHE_PRECISIONS  the precisions (default "0 1 2 3 4 5 6 8 31"); the tool's default, 4, is always measured
#              LITHE_FRAMES      frames of all clips that each cut is judged in (default 4)
# Some ten minutes of processor time.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${1:-$root/build/release}
shift || true
models=$root/../shared/models
lithe=$build/bake/lithe
read -r -a precisions <<<"${LITHE_PRECISIONS:-0 1 2 3 4 5 6 8 31}"
frames=${LITHE_FRAMES:-4}
default=4
ratios=(0.5 0.2 0.1 0.05 0.02)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
source "$root/tests/bench/characters.sh"

characters() {
  if [ $# -gt 0 ]; then printf '%s\n' "$@"; else printf '%s\n' column figure "$models"/{shark,mannequiny,knight,sintel}.glb; fi
}

# source_of NAME|FILE: the glTF file; a built-in character is made
source_of() {
  case $1 in
    */* | *.glb | *.gltf) echo "$1" ;;
    *)
      "$lithe" generate "$1" -o "$scratch/$1.glb" --quiet
      echo "$scratch/$1.glb"
      ;;
  esac
}

# posed_rms ORIGINAL RATIO: of the file that was baked last
posed_rms() {
  "$lithe" export "$scratch/baked.lithe" -o "$scratch/cut.glb" --ratio "$2" --from "$1" --quiet
  "$lithe" compare "$1" "$scratch/cut.glb" --frames "$frames" --samples 10000 --json - | sed -nE 's/^  "rms_mean": ([^,]*),?$/\1/p'
}

# measure NAME FILE PRECISION: a line "NAME PRECISION BYTES RMS..." of the table that `print_tables` reads
measure() {
  local ratio
  echo "$1, precision $3" >&2
  "$lithe" bake "$2" -o "$scratch/baked.lithe" --precision "$3" --quiet 2>/dev/null
  printf '%s %s %s' "$1" "$3" "$(stat -c %s "$scratch/baked.lithe")"
  for ratio in "${ratios[@]}"; do printf ' %s' "$(posed_rms "$2" "$ratio")"; done
  printf '\n'
}

# print_tables: the tables of the lines on stdin; columns 3 .. 8 are bytes and the RMS of each ratio
print_tables() {
  awk -v default="$default" '
    !($1 in seen) { seen[$1]; names[++name_count] = $1 }
    !($2 in listed) { listed[$2]; precisions[++count] = $2 }
    { for (c = 3; c <= 8; ++c) value[$1, $2, c] = $c }
    function part(name, p, c) { return value[name, p, c] / value[name, default, c] }
    function mean(p, c,   i, sum) {
      for (i = 1; i <= name_count; ++i) sum += log(part(names[i], p, c))
      return exp(sum / name_count)
    }
    function rows_by_character(c,   i, p) {
      printf "| character |"; for (p = 1; p <= count; ++p) printf " %s |", precisions[p]
      printf "\n|---|"; for (p = 1; p <= count; ++p) printf "---:|"
      printf "\n"
      for (i = 1; i <= name_count; ++i) {
        printf "| %s |", names[i]; for (p = 1; p <= count; ++p) printf " %.3f |", part(names[i], precisions[p], c)
        printf "\n"
      }
    }
    END {
      print "| precision | bytes | RMS at 50 % | 20 % | 10 % | 5 % | 2 % |\n|---:|---:|---:|---:|---:|---:|---:|"
      for (p = 1; p <= count; ++p) {
        printf "| %s |", precisions[p]; for (c = 3; c <= 8; ++c) printf " %.3f |", mean(precisions[p], c)
        printf "\n"
      }
      print "\nBytes by character and precision:\n"; rows_by_character(3)
      print "\nRMS at 10 % by character and precision:\n"; rows_by_character(6)
    }'
}

if [ ! -f "$build/CMakeCache.txt" ]; then cmake -G Ninja -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release >&2; fi
cmake --build "$build" --target lithe_tool >&2
case " ${precisions[*]} " in *" $default "*) ;; *) precisions+=("$default") ;; esac
while IFS= read -r character; do
  case $character in */*) [ -f "$character" ] || { echo "$character is not here: skipped" >&2; continue; } ;; esac
  file=$(source_of "$character")
  for precision in "${precisions[@]}"; do measure "$(name_of "$character")" "$file" "$precision"; done
done < <(characters "$@") >"$scratch/lines.txt"
print_tables <"$scratch/lines.txt"
