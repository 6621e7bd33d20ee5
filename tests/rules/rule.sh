# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# The frame of a rule test. A rule script sources this file, defines
#
#     check ROOT      prints one complaint a line about the tree at ROOT; none when the rule holds
#     break_WHAT ROOT writes a small tree (or changes the files given) so that the rule must complain, and sets `expected`
#                     to a part of the complaint; at least one, each is the must-fail twin of a part of the rule
#
# and ends with `run_rule "$@"`. Called as RULE.sh ROOT it checks the tree; as RULE.sh ROOT must-fail it runs every twin.
# Exit code 0: the rule holds (or every twin was caught).
set -euo pipefail

# A folder that is gone when the script ends; checks may write there.
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# sources_in ROOT PATTERN...: the project's files whose names match, without what is built or installed.
sources_in() {
  local root=$1 pattern names=()
  shift
  for pattern in "$@"; do names+=(-o -name "$pattern"); done
  (cd "$root" && find . \( -name .git -o -name 'build*' -o -name node_modules -o -path ./demo \) -prune \
    -o -type f \( "${names[@]:1}" \) -print | sed 's|^\./||' | sort)
}

# write ROOT/FILE: stdin becomes the file, folders are made as needed.
write() {
  mkdir -p "$(dirname "$1")"
  cat >"$1"
}

run_twin() {
  local twin=$1 tree=$scratch/twin complaints
  rm -rf "$tree"
  mkdir -p "$tree"
  expected=
  "$twin" "$tree" || { echo "must-fail twin $twin could not be made"; return 1; }
  complaints=$(check "$tree" 2>&1) || true
  if ! grep -qF -- "${expected:?a twin sets what the complaint must say}" <<<"$complaints"; then
    echo "must-fail twin $twin was not caught: wanted a complaint with '$expected', got: ${complaints:-nothing}"
    return 1
  fi
  echo "$twin: caught"
}

run_rule() {
  local root=$1 mode=${2:-check} complaints
  real_root=$root  # for twins that break a copy of the real thing
  if [ "$mode" = must-fail ]; then
    local twins twin failed=0
    mapfile -t twins < <(compgen -A function break_)
    [ ${#twins[@]} -gt 0 ] || { echo "$0 has no must-fail twin"; return 1; }
    for twin in "${twins[@]}"; do run_twin "$twin" || failed=1; done
    return $failed
  fi
  complaints=$(check "$root")
  [ -z "$complaints" ] || { echo "$complaints"; return 1; }
}
