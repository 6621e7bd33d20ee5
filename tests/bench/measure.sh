#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# Every figure that lithe is held to, measured now, as one markdown table. Exit code 1 when one is beyond its limit.
#
#     tests/bench/measure.sh [BUILD_DIR]      default build/release; built there in Release when it is not yet
#
# Characters of ../shared/models are measured where they are; rows that need them say "skipped" elsewhere. A few minutes on two cores.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${1:-$root/build/release}
models=$root/../shared/models
lithe=$build/bake/lithe
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0
source "$root/tests/bench/characters.sh"

# ---- The table

# row WHAT MEASURED LIMIT pass|FAIL|skipped|reported
row() {
  printf '| %s | %s | %s | %s |\n' "$@"
  if [ "$4" = FAIL ]; then failures=$((failures + 1)); fi
}

# judge WHAT VALUE LIMIT [UNIT]: passes when VALUE is a number and at most LIMIT; what is shown is rounded, what is judged is not
judge() { row "$1" "$(shown "$2")${4:+ $4}" "$3${4:+ $4}" "$(awk -v value="$2" -v limit="$3" 'BEGIN { print value ~ /^[0-9.]+$/ && value + 0 <= limit + 0 ? "pass" : "FAIL" }')"; }
report() { row "$1" "$(shown "$2")${3:+ $3}" "" reported; }
shown() { awk -v value="$1" 'BEGIN { if (value !~ /^[0-9.]+$/) print "nothing"; else printf "%.5g", value }'; }
skip() { row "$1" "" "$2" skipped; }

# json FILE KEY...: one value
json() {
  local file=$1
  shift
  printf 'file(READ "%s" text)\nstring(JSON value GET "${text}" %s)\nexecute_process(COMMAND ${CMAKE_COMMAND} -E echo "${value}")\n' \
    "$file" "$*" >"$scratch/json.cmake"
  cmake -P "$scratch/json.cmake"
}

# calculate EXPRESSION [FORMAT]
calculate() { awk "BEGIN { printf \"${2:-%.3f}\", ($1) }"; }

# ---- Posed error

# posed_rms ORIGINAL BAKED WHAT... -- COMPARE OPTIONS...: the mean RMS in 1e-4 of the rest diagonal of the export that WHAT asks for
posed_rms() {
  local original=$1 baked=$2 what=()
  shift 2
  while [ "$1" != -- ]; do
    what+=("$1")
    shift
  done
  shift
  "$lithe" export "$baked" -o "$scratch/cut.glb" "${what[@]}" --from "$original" --quiet
  "$lithe" compare "$original" "$scratch/cut.glb" "$@" --json "$scratch/compare.json" --quiet
  calculate "$(json "$scratch/compare.json" rms_mean) * 1e4" %.6f
}

measure_column() {
  local name=$1 file=$2 how='baked on clip examples, judged on 60 frames of clip test'
  "$lithe" bake "$file" -o "$scratch/column.lithe" --clips examples --quiet
  judge "$name, 3,000 triangles: posed RMS ($how)" "$(posed_rms "$file" "$scratch/column.lithe" --triangles 3000 -- --anim test --frames 60)" 0.60 e-4
  report "$name, 1,000 triangles: posed RMS" "$(posed_rms "$file" "$scratch/column.lithe" --triangles 1000 -- --anim test --frames 60)" e-4
}

# The bake takes evenly spaced instants, at most 30 a second, and keys. Distance in ms of the judged instants from the former.
distance_from_training() {
  awk -v first="$(json "$scratch/compare.json" frames 0 time)" -v second="$(json "$scratch/compare.json" frames 1 time)" 'BEGIN {
    slices = 10; duration = slices * (second - first); steps = int(duration * 30 + 0.5); least = duration
    for (frame = 0; frame < slices; ++frame) for (step = 0; step <= steps; ++step) {
      distance = (frame + 0.5) * duration / slices - step * duration / steps
      if (distance < 0) distance = -distance
      if (distance < least) least = distance
    }
    printf "%.1f", 1000 * least }'
}

measure_sintel() {
  local file=$models/sintel.glb baked=$scratch/sintel.lithe share limit how
  [ -f "$file" ] || { skip "sintel: posed RMS" "4 / 9 / 15 e-4"; return; }
  "$lithe" bake "$file" -o "$baked" --quiet
  for share in 0.2:4 0.1:9 0.05:15; do
    limit=${share#*:} share=${share%:*}
    local rms
    rms=$(posed_rms "$file" "$baked" --ratio "$share" -- --anim all --frames 10)
    how="baked on 16 poses of its clip, judged at 10 other instants, $(distance_from_training) ms or more away"
    judge "sintel, $(calculate "$share * 100" %g) %: posed RMS ($how)" "$rms" "$limit" e-4
    judge "sintel, $(calculate "$share * 100" %g) %: posed RMS (the same bake, judged in 10 sampled poses, which no clip has)" \
      "$(posed_rms "$file" "$baked" --ratio "$share" -- --anim sampled --frames 10)" "$limit" e-4
  done
}

# ---- Continuity

# Off by one triangle is as close as a small character gets.
measure_exports() {
  local file total target got worst=0 worst_name='' off
  local title='export of 2 %: farthest from the count asked for, less one triangle'
  [ -n "$(shared_characters)" ] || { skip "$title" "1 %"; return; }
  while IFS= read -r file; do
    "$lithe" bake "$file" -o "$scratch/any.lithe" --quiet
    total=$("$lithe" info "$scratch/any.lithe" --json >"$scratch/info.json" && json "$scratch/info.json" triangles)
    target=$(calculate "$total * 0.02" %.0f)
    got=$("$lithe" export "$scratch/any.lithe" -o "$scratch/any.glb" --triangles "$target" --json >"$scratch/export.json" &&
      json "$scratch/export.json" meshes 0 triangles)
    off=$(awk -v got="$got" -v target="$target" 'BEGIN { off = got > target ? got - target : target - got; printf "%.6f", (off > 1 ? 100 * (off - 1) / target : 0) }')
    if [ -z "$worst_name" ] || [ "$(calculate "$off > $worst" %d)" = 1 ]; then
      worst=$off worst_name="$(name_of "$file"), $got of $target"
    fi
  done < <(shared_characters)
  judge "$title ($worst_name)" "$worst" 1 %
}

# ---- Bytes

# sizes: "name triangles ratio first-picture-%" a line, from bench_size
sizes() {
  local i characters name
  "$build/tests/bench/bench_size" --json >"$scratch/sizes.json"
  characters=$(grep -c '"first_picture_share"' "$scratch/sizes.json")  # one more than there are: the mean's
  for ((i = 0; i < characters - 1; ++i)); do
    name=$(json "$scratch/sizes.json" characters $i name)
    echo "${name// /_}" "$(json "$scratch/sizes.json" characters $i triangles)" "$(json "$scratch/sizes.json" characters $i ratio)" \
      "$(calculate "$(json "$scratch/sizes.json" characters $i first_picture_share) * 100" %.6f)"
  done
}

# The column is flat: its normals and uvs cost the reference nearly nothing, so its quotient says little.
measure_bytes() {
  local name triangles ratio first judged=()
  while read -r name triangles ratio first; do
    if [ "$triangles" -le 10000 ]; then continue; fi
    judge "$name: bytes before the first draw / file" "$first" 10 %
    if [ "$name" = column ]; then
      report "$name: whole file / finest level alone under Draco" "$ratio"
    else
      judge "$name: whole file / finest level alone under Draco" "$ratio" 1.6
      judged+=("$ratio")
    fi
  done < <(sizes)
  judge "the judged ones: whole file / finest level alone under Draco, geometric mean" \
    "$(printf '%s\n' "${judged[@]}" | awk '{ sum += log($1) } END { printf "%.6f", exp(sum / NR) }')" 1.6
  [ -n "$(shared_characters)" ] || skip "shared characters: bytes" "10 % / 1.6"
}

# The whole runtime as one relocatable object, compiled and stripped as tests/rules/runtime_objects.sh does.
measure_runtime() {
  local source objects=() text data bss
  for source in "$root"/runtime/src/*.cpp; do
    objects+=("$scratch/$(basename "$source").o")
    "${CXX:-c++}" -std=c++17 -O2 -DNDEBUG -ffp-contract=off -fno-exceptions -fno-rtti -fno-threadsafe-statics -ffreestanding -nostdinc++ \
      -fno-stack-protector -fvisibility=hidden -ffunction-sections -fdata-sections -I"$root/format/include" -I"$root/runtime/include" \
      -c "$source" -o "${objects[-1]}"
  done
  ld -r "${objects[@]}" -o "$scratch/runtime.o"
  strip --strip-unneeded "$scratch/runtime.o"
  read -r text data bss < <(size "$scratch/runtime.o" | awk 'NR == 2 { print $1, $2, $3 }')
  judge "runtime at -O2: code and constants" "$text" $((120 * 1024)) bytes
  judge "runtime: writable globals" $((data + bss)) 0 bytes
}

# ---- Time

# The best of three: the machine may do other things.
measure_bake_time() {
  local try start best='' seconds
  for try in 1 2 3; do
    start=$(date +%s.%N)
    "$lithe" bake "$scratch/column.glb" -o "$scratch/timed.lithe" --poses 16 --threads 2 --json "$scratch/timed$try.json" --quiet
    seconds=$(calculate "$(date +%s.%N) - $start" %.2f)
    if [ -z "$best" ] || [ "$(calculate "$seconds < $best" %d)" = 1 ]; then best=$seconds; fi
  done
  judge "bake of the column, 16 poses, 2 threads, best of 3" "$best" 10 s
}

if [ ! -f "$build/CMakeCache.txt" ]; then cmake -G Ninja -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release >&2; fi
cmake --build "$build" --target lithe_tool bench_size >&2
grep -q '^CMAKE_BUILD_TYPE:[^=]*=Release$' "$build/CMakeCache.txt" || { echo "$build is no Release build" >&2; exit 2; }

row what measured limit verdict
row --- ---: ---: ---
"$lithe" generate column -o "$scratch/column.glb" --quiet
measure_column "built-in column" "$scratch/column.glb"
if [ -f "$models/column.glb" ]; then measure_column column.glb "$models/column.glb"; else skip "column.glb: posed RMS" "0.60 e-4"; fi
measure_sintel
measure_exports
measure_bytes
measure_runtime
measure_bake_time
if [ $failures -gt 0 ]; then printf '\n%s beyond the limit.\n' $failures; exit 1; fi
