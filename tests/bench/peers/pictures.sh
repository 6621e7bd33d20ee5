#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# Pictures of a character, of lithe's 5 % of it and of those of the two shipped tools with the least RMS, in the same pose.
#
#     tests/bench/peers/pictures.sh [-o FOLDER]      writes peers_CHARACTER_METHOD.png; FOLDER is build/release/peers if not given
#
# Characters of ../shared/models are drawn where they are. Some three minutes on two cores.
# Environment: LITHE_BUILD_DIR  build folder (default build/release)
#              LITHE            the tool (default the build folder's)
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../../.." && pwd)
build=${LITHE_BUILD_DIR:-$root/build/release}
export LITHE=${LITHE:-$build/bake/lithe}
output=$build/peers
share=0.05
case ${1:-} in
  "") ;;
  -o) output=$2 ;;
  *) sed -n '6,6s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
esac
mkdir -p "$output"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# draw CHARACTER METHOD FILE VIEW...: a sheet shows a file's finest level, so what is drawn is baked as it is
draw() {
  local character=$1 method=$2 file=$3
  shift 3
  cp "$file" "$scratch/drawn.glb"
  "$LITHE" bake "$scratch/drawn.glb" -o "$scratch/drawn.lithe" --levels 1 --quiet
  "$build/samples/lithe_levels" "$scratch/drawn.lithe" --out "$scratch" --columns 1 --rows shaded,wires --plain "$@" >&2
  cp "$scratch/drawn_levels.png" "$output/peers_${character}_$method.png"
  echo "* $character, $method: peers_${character}_$method.png"
}

# character NAME VIEW...
character() {
  local name=$1 method kept=$scratch/$1
  shift
  if [ ! -f "$root/../shared/models/$name.glb" ]; then
    echo "skipped: there is no ../shared/models/$name.glb"
    return
  fi
  "$here/run.sh" "$root/../shared/models/$name.glb" --ratios $share --keep "$kept" --json "$kept.json" >/dev/null
  draw "$name" original "$root/../shared/models/$name.glb" "$@"
  draw "$name" lithe "$kept/0-$name.glb.lithe.lithe.$share.glb" "$@"
  for method in $(node "$here/best.mjs" "$kept.json" 2); do draw "$name" "$method" "$kept/0-$name.glb.lithe.$method.$share.glb" "$@"; done
}

cmake --build "$build" --target lithe_levels >&2
character mannequiny --clip run --fraction 0.3 --turn 30 --cell-width 270 --cell-height 340
character sintel --clip 'm2m-sample-rig|New Custom' --fraction 0.4 --turn 30 --cell-width 200 --cell-height 420
