# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# The frame of the tool's tests. Called as TEST.sh TOOL FOLDER: the built tool, and the folder of the character that
# character.sh made (column.glb, column.lithe, small.glb). A test runs in a fresh folder and ends with `finish`.
set -euo pipefail

lithe=$1
characters=$2
failures=0
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

complain() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# answers CODE TEXT ARGUMENTS...: the tool exits with CODE and says TEXT: on stdout when CODE is 0, else on stderr, and then
# in exactly one line that begins with "lithe: ", with nothing on stdout. Leaves both in the files out and err.
answers() {
  local code=$1 text=$2 got=0
  shift 2
  "$lithe" "$@" >out 2>err </dev/null || got=$?
  [ $got = "$code" ] || complain "lithe $*: exit code $got instead of $code: $(head -c 300 err)"
  if [ "$code" = 0 ]; then
    [ -z "$text" ] || grep -qF -- "$text" out || complain "lithe $*: stdout does not say '$text': $(head -c 300 out)"
    return
  fi
  grep -qF -- "$text" err || complain "lithe $*: stderr does not say '$text': $(head -c 300 err)"
  [ "$(wc -l <err)" = 1 ] || complain "lithe $*: stderr is not one sentence: $(head -c 300 err)"
  grep -q '^lithe: ' err || complain "lithe $*: the sentence does not say who speaks: $(head -c 300 err)"
  [ ! -s out ] || complain "lithe $*: stdout is not empty: $(head -c 300 out)"
}

# holds_only FOLDER NAME...: the folder has these files and no others, hidden ones included
holds_only() {
  local folder=$1 there
  shift
  there=$(find "$folder" -mindepth 1 -printf '%f\n' | sort | tr '\n' ' ')
  [ "$there" = "$(printf '%s\n' "$@" | sed '/^$/d' | sort | tr '\n' ' ')" ] || complain "$folder holds '$there' instead of '$*'"
}

# json FILE EXPRESSION: a value of a JSON file, such as .levels[0].triangles, by the tool's own neighbour, CMake
json() {
  local path
  path=$(sed 's/\[\([0-9]*\)\]/ \1/g; s/\./ /g' <<<"$2")
  # shellcheck disable=SC2086
  printf 'file(READ "%s" text)\nstring(JSON value GET "${text}" %s)\nexecute_process(COMMAND ${CMAKE_COMMAND} -E echo "${value}")\n' \
    "$PWD/$1" "$path" >json.cmake
  cmake -P json.cmake
}

finish() {
  [ $failures = 0 ] || { echo "$failures failed"; exit 1; }
}
